#include "layoutbox/plan/room/size_owner.h"

#include <algorithm>
#include <ranges>

#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/room/bare_sides.h"

namespace layoutbox::offline {
namespace {

constexpr double kSmallestRoom = 4;         // m²: less is a thing's size where one was named
constexpr double kSmallestAfterRoom = 1.6;  // m²: "wc 0.9 x 1.8 m", right after the room
constexpr std::size_t kLookBack = 100;      // tokens looked back; keeps endless sentences linear
constexpr std::size_t kEarly = 12;          // tokens: a size so early is the room's unless a thing claims it

// Do the first two sides make several times the floor that the largest such thing takes?
bool beyond(const Match& match, const std::vector<double>& sides) {
  constexpr double kTimes = 2.5;
  return sides.size() >= 2 && std::all_of(match.meanings.begin(), match.meanings.end(), [&](const Meaning& m) {
           if (m.word_class != WordClass::kObject || m.entry == nullptr) return true;
           const Size& most = m.entry->size.greatest;
           return sides[0] * sides[1] > kTimes * m_from_mm(most.width) * m_from_mm(most.depth);
         });
}

}  // namespace

bool SizeOwner::speaks_of_room(std::size_t first, std::size_t last, const std::vector<double>& sides) const {
  if (follows_room(first) && sides.size() >= 2 && sides[0] * sides[1] >= kSmallestAfterRoom) return true;
  if (const std::optional<bool> room = room_follows(last)) return *room;
  // "…, hamper, ironing board, 6 feet by 5 feet": what the text closes with
  const bool closes =
      first > 0 && tokens_[first - 1].text == "," &&
      std::ranges::all_of(tokens_ | std::views::drop(last), [](const Token& t) { return t.kind == Token::Kind::kPunctuation; });
  constexpr double kWidestDoor = 2, kHighestGlass = 2.7;  // m, where it is as wide
  const bool no_opening = sides.size() >= 2 && std::min(sides[0], sides[1]) > (closes ? kWidestDoor : kHighestGlass);
  const double smallest = closes && known_.width == 0 ? kSmallestAfterRoom : kSmallestRoom;
  std::size_t begin = first;
  while (begin > 0 && first - begin < kLookBack && !tokens_[begin - 1].ends_sentence) --begin;
  const std::vector<Named> named = named_in(begin, first);
  for (const Named& name : std::views::reverse(named)) {
    if (has_class(name.match, WordClass::kRoom) || has_class(name.match, WordClass::kRoomNoun)) return !fits_thing_before(name.at, sides);
    if (name.at > begin && (tokens_[name.at - 1].text == "no" || tokens_[name.at - 1].text == "without"))
      continue;  // "no car, 5.5 x 2.8 m"
    const Meaning* thing = meaning_of(name.match, WordClass::kObject);
    if (thing != nullptr && thing->entry != nullptr && thing->entry->mount == Mount::kCeiling)
      continue;                                                                  // "a sloping ceiling, 3 m wide and …"
    const bool for_thing = sides.size() >= 2 && sides[0] * sides[1] < smallest;  // "a mat of 2 x 1.5 m"
    const bool in_centimetres = name.at + name.match.length == first && says_centimetres(first);
    if (has_class(name.match, WordClass::kObject) && (for_thing || in_centimetres || !beyond(name.match, sides))) return false;
    // "a mudroom off the back door, 10 by 8 feet"
    const bool referred = tokens_[first - 1].text == "," && is_referred_to(name);
    if ((has_class(name.match, WordClass::kWindow) || has_class(name.match, WordClass::kDoor)) && !no_opening && !referred)
      return false;  // "a wall's windows, each 1.5 m wide"
  }
  return known_.width == 0 && (first < kEarly || exceeds_last_thing(begin, sides, smallest));
}

// "a 4 x 3 m bedroom", "a 4 x 3 m rug": what comes right after the size; nothing where that is neither.
std::optional<bool> SizeOwner::room_follows(std::size_t last) const {
  for (std::size_t i = last; i < std::min(last + 4, tokens_.size()); ++i) {
    if (tokens_[i].kind == Token::Kind::kPunctuation) break;
    const Match match = lexicon_.find(tokens_, i);
    if (has_class(match, WordClass::kHave) || has_class(match, WordClass::kBe) || lexicon_.find_phrase(tokens_, i).length > 0) break;
    if (has_class(match, WordClass::kRoom) || has_class(match, WordClass::kRoomNoun)) return true;
    if (has_class(match, WordClass::kObject)) return false;
  }
  return std::nullopt;
}

// "off the back door", "next to the window": a place by what is there already.
bool SizeOwner::is_referred_to(const Named& name) const {
  constexpr std::size_t kFarthest = 2;  // words from the article to the noun
  for (std::size_t the = name.at; the-- > 1 && name.at - the <= kFarthest;) {
    if (tokens_[the].text == "the") return tokens_[the - 1].text == "off" || lexicon_.find_phrase(tokens_, the - 1).length > 0;
  }
  return false;
}

// "a table 80x60": of a thing no feet.
bool SizeOwner::says_centimetres(std::size_t at) const {
  constexpr double kFewest = 30;
  const SidesRead read = read_sides(lexicon_, tokens_, at);
  return !read.united && !read.numbers.empty() && *std::ranges::min_element(read.numbers) >= kFewest;
}

bool SizeOwner::says_free_floor(std::size_t size) const {
  constexpr std::size_t kWords = 5;
  for (std::size_t back = 1; back <= std::min(size, kWords) && !tokens_[size - back].ends_sentence; ++back) {
    if (has_class(lexicon_.find(tokens_, size - back), WordClass::kRoomNoun)) return is_left_free(size - back);
  }
  return false;
}

bool SizeOwner::is_left_free(std::size_t space) const {
  constexpr std::size_t kWords = 4;
  for (std::size_t back = 1; back <= std::min(space, kWords) && !tokens_[space - back].ends_sentence; ++back) {
    const std::string& word = tokens_[space - back].text;
    if (word == "leave" || word == "leaving" || word == "keep" || word == "keeping" || word == "reserve") return true;
  }
  return false;
}

bool SizeOwner::follows_room(std::size_t at) const {
  constexpr std::size_t kLongestName = 3;  // words
  for (std::size_t back = 1; back <= std::min(at, kLongestName) && !tokens_[at - back].ends_sentence; ++back) {
    const Match match = lexicon_.find(tokens_, at - back);
    if (match.length == back && (has_class(match, WordClass::kRoom) || has_class(match, WordClass::kRoomNoun))) return true;
  }
  return false;
}

bool SizeOwner::stands_alone(std::size_t first, std::size_t last) const {
  const auto parts = [&](std::size_t i) { return tokens_[i].kind == Token::Kind::kPunctuation; };
  return (first == 0 || parts(first - 1) || tokens_[first - 1].ends_sentence) &&
         (last >= tokens_.size() || parts(last) || tokens_[last - 1].ends_sentence);
}

std::vector<SizeOwner::Named> SizeOwner::named_in(std::size_t begin, std::size_t end) const {
  std::vector<Named> named;
  for (std::size_t i = begin; i < end;) {
    named.push_back({i, lexicon_.find(tokens_, i)});
    i += std::max<std::size_t>(named.back().match.length, 1);
  }
  return named;
}

// "A bed and a wardrobe. Size 4 x 3.5 m.": the floor of a room, and far more than the thing named last before that sentence can take.
bool SizeOwner::exceeds_last_thing(std::size_t begin, const std::vector<double>& sides, double smallest) const {
  if (sides.size() < 2 || sides[0] * sides[1] < smallest) return false;
  for (const Named& name : std::views::reverse(named_in(begin > kLookBack ? begin - kLookBack : 0, begin))) {
    if (has_class(name.match, WordClass::kObject)) return beyond(name.match, sides);
  }
  return true;
}

// "A table in the middle of the room, 1.6 by 0.9 m": what is too small for a room and right for what the sentence spoke of before.
bool SizeOwner::fits_thing_before(std::size_t end, const std::vector<double>& sides) const {
  constexpr double kMore = 1.1;
  if (sides.size() < 2 || sides[0] * sides[1] >= kSmallestRoom) return false;
  for (std::size_t i = end; i-- > 0 && !tokens_[i].ends_sentence;) {
    for (const Meaning& m : lexicon_.find(tokens_, i).meanings) {
      if (m.word_class != WordClass::kObject || m.entry == nullptr) continue;
      const Size& most = m.entry->size.greatest;
      const double longer = kMore * m_from_mm(std::max(most.width, most.depth)),
                   other = kMore * m_from_mm(std::min(most.width, most.depth));
      if (std::max(sides[0], sides[1]) <= longer && std::min(sides[0], sides[1]) <= other) return true;
    }
  }
  return false;
}

}  // namespace layoutbox::offline
