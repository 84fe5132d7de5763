#include "layoutbox/plan/passes/bans.h"

#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/passes/ban_places.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"

namespace layoutbox::offline {
namespace {

constexpr double kUsualSide = 0.9;  // metres: where only "free" is said

class BanReader : public BanPlaces {
 public:
  BanReader(const Lexicon& lexicon, const Document& document, std::vector<Token>& tokens, std::vector<bool>& skip)
      : BanPlaces(lexicon, tokens, skip), document_(document) {}

  std::vector<Ban> read() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (skip_[i]) continue;
      kept_ = 0;
      if (read_back_to(i) || pass_none(i) || read_nothing(i) || read_nothing_by(i) || read_kept(i) || read_staying(i) || read_side(i) ||
          read_room_round(i) || read_accessible(i) || read_reached(i) || read_room_for(i) || read_plain_room_round(i))
        continue;
    }
    return std::move(bans_);
  }

 private:
  void take(Ban ban, std::size_t first, std::size_t last) {
    ban.first = tokens_[first].begin;
    ban.words = words_between(document_, first, last);
    bans_.push_back(std::move(ban));
    leave_out(first, kept_ > first ? std::min(kept_, last) : last);
    kept_ = 0;
  }

  bool is_over(std::size_t i) const { return ends(i) || is(i, WordSet::kBannedEnds); }

  // "Nobody (should sit) with the back to the door", "no chair with its back to the window", "I hate to have my back to the door".
  bool read_back_to(std::size_t i) {
    if (!is(i, WordSet::kRefusing)) return false;
    constexpr std::size_t kReach = 10;
    std::size_t at = i + 1;
    while (at < std::min(tokens_.size(), i + kReach) && !ends(at) && !is(at, {"back", "backs"})) ++at;
    if (!is(at, {"back", "backs"})) return false;
    ++at;
    if (is(at, {"turned"})) ++at;
    if (!is(at, {"to", "toward", "towards"})) return false;
    const std::optional<PlaceSaid> place = place_at(at + 1);
    if (!place || place->ban.kind != Ban::Kind::kFreeOpening) return false;
    Ban ban = place->ban;
    ban.kind = Ban::Kind::kBackTo;
    std::size_t first = i;
    while (first > 0 && is(first - 1, WordSet::kBeforeRefusing)) --first;
    take(std::move(ban), first, place->last);
    return true;
  }

  // "…, none of them facing the door", "none at the window side": said of no one.
  bool pass_none(std::size_t i) {
    if (!is(i, {"none"}) || i == 0 || !is(i - 1, WordSet::kSaidAside)) return false;
    std::size_t at = i + 1;
    if (is(at, {"of"})) at += is(at + 1, {"the"}) ? 3 : 2;
    if (lexicon_.find_phrase(tokens_, at).length == 0) return false;
    while (!ends(at)) ++at;
    leave_out(i, at);
    return true;
  }

  // "nothing in front of the window", "no furniture against the left wall"
  bool read_nothing(std::size_t i) {
    std::size_t at = i;
    if (is(at, {"nothing"})) {
      ++at;
    } else if (is(at, {"no"}) && is(at + 1, WordSet::kWhateverStands)) {
      at += 2;
    } else {
      return false;
    }
    at = past(at, WordSet::kStanding);
    const std::size_t from = at;
    at = past(at, WordSet::kBeforeBannedPlaces);
    const std::optional<PlaceSaid> place = at > from ? place_at(at) : std::nullopt;
    if (!place || !is_over(place->last)) return false;
    take(place->ban, i, place->last);
    return true;
  }

  // "with nothing in front of it", "nothing on the desk": that side stays free; nothing is left to say of what is on, over or under it.
  bool read_nothing_by(std::size_t i) {
    if (!is(i, {"nothing"})) return false;
    std::size_t at = past(i + 1, WordSet::kStanding);
    Ban ban;
    ban.kind = Ban::Kind::kFreeSide;
    ban.depth = kUsualSide;
    if (is(at, {"in"}) && is(at + 1, {"front"}) && is(at + 2, {"of"})) {
      ban.sides = {Side::kFront};
      at += 3;
    } else if (is(at, {"behind"})) {
      ban.sides = {Side::kBack};
      ++at;
    } else if (is(at, {"on", "above", "over", "under", "below", "beneath", "underneath"}) && is(at + 1, {"it", "them"})) {
      ++at;
    } else {
      return false;
    }
    if (!read_object(at, ban) || !is_over(at)) return false;
    const std::size_t first = i > 0 && is(i - 1, {"with", "and"}) ? i - 1 : i;
    ban.sides.empty() ? leave_out(first, at) : take(std::move(ban), first, at);
    return true;
  }

  // "keep the middle free", "leave the left wall empty"
  bool read_kept(std::size_t i) {
    if (!is(i, WordSet::kKeeping)) return false;
    const std::optional<PlaceSaid> place = place_at(i + 1);
    if (!place || !is(place->last, WordSet::kFree) || !is_over(place->last + 1)) return false;
    take(place->ban, i, place->last + 1);
    return true;
  }

  // "the middle should stay free", "the left half of the room is empty"
  bool read_staying(std::size_t i) {
    if (!is(i, {"the", "with"})) return false;
    const std::optional<PlaceSaid> place = place_at(i + (is(i, {"with"}) ? 1 : 0));
    if (!place || is(place->last - 1, {"side"})) return false;  // "the right side clear": of a thing
    std::size_t at = place->last;
    at = past(at, WordSet::kStayingFree);
    if (!is(at, WordSet::kFree) || !is_over(at + 1)) return false;
    take(place->ban, i, at + 1);
    return true;
  }

  // What is named here for the first time is there.
  std::size_t past_known(const NamedThing& thing, std::size_t from) const {
    for (std::size_t k = 0; k < from; ++k) {
      if (singular_of(tokens_[k].text) == singular_of(tokens_[thing.noun].text)) return thing.last;
    }
    return from;
  }

  // "of the bed"; false: of something that is not named so
  bool read_of(std::size_t& i, Ban& ban) {
    if (!is(i, {"of"})) return true;
    if (is(i + 1, {"it", "them"})) return i += 2, true;
    const auto thing = thing_named_at(i + 1);
    if (!thing) return false;
    ban.of = singular_of(tokens_[thing->noun].text);
    kept_ = past_known(*thing, i + 1);
    i = thing->last;
    return true;
  }

  // "the right side clear", "with both sides of the bed free", "its left side must stay free for transfers"
  bool read_side(std::size_t i) {
    if (!is(i, WordSet::kOpeningSides)) return false;
    std::size_t at = i;
    at = past(at, WordSet::kBeforeSides);
    Ban ban;
    ban.kind = Ban::Kind::kFreeSide;
    ban.depth = kUsualSide;
    ban.sides = sides_at(at);
    if (ban.sides.empty() || !read_of(at, ban)) return false;
    at = past(at, WordSet::kStayingFree);
    if (!is(at, WordSet::kFree) && !is(at, {"accessible", "reachable"})) return false;
    if (!is_over(at + 1)) return false;
    take(std::move(ban), i, at + 1);
    return true;
  }

  // "a couch accessible from both sides"
  bool read_accessible(std::size_t i) {
    if (!is(i, {"accessible", "reachable", "free", "clear"}) || !is(i + 1, {"from", "on", "at"})) return false;
    return take_sides(i + 2, i > 0 && is(i - 1, {"is", "are", "be"}) ? i - 1 : i);
  }

  // What was named last has the sides free that are said at `at`; the words that say so begin at `first`.
  bool take_sides(std::size_t at, std::size_t first) {
    Ban ban;
    ban.kind = Ban::Kind::kFreeSide;
    ban.depth = kUsualSide;
    ban.sides = sides_at(at);
    if (ban.sides.empty() || !is_over(at)) return false;
    take(std::move(ban), first, at);
    return true;
  }

  // "a bed she can get into from both sides"
  bool read_reached(std::size_t i) {
    constexpr std::size_t kReach = 5;  // tokens
    if (i == 0 || !is(i, {"can", "could"}) || !is(i - 1, {"she", "he", "one", "you", "they", "we", "i", "people"})) return false;
    if (!is(i + 1, {"reach", "get", "access", "approach", "use", "walk"})) return false;
    std::size_t from = i + 2;
    while (from < i + kReach && is(from, {"into", "to", "at", "in", "out", "of", "around", "round", "it"})) ++from;
    return is(from, {"from"}) && take_sides(from + 1, i > 1 && is(i - 2, {"that", "which"}) ? i - 2 : i - 1);
  }

  // "room for a walker on both sides of the bed"
  bool read_room_for(std::size_t i) {
    constexpr std::size_t kReach = 4;  // words of whom or what it is for
    if (!is(i, {"space", "room"}) || !is(i + 1, {"for"})) return false;
    std::size_t at = i + 2;
    while (at < i + 2 + kReach && !ends(at) && !is(at, {"on", "at"})) ++at;
    if (!is(at, {"on", "at"})) return false;
    Ban ban;
    ban.kind = Ban::Kind::kFreeSide;
    ban.depth = kUsualSide;
    ban.sides = sides_at(++at);
    if (ban.sides.empty() || !read_of(at, ban) || !is_over(at)) return false;
    std::size_t first = i;
    while (first > 0 && is(first - 1, WordSet::kBeforeRoomRound)) --first;
    if (is(first, {"and"})) ++first;
    take(std::move(ban), first, at);
    return true;
  }

  // A length: "1.5 m", "a metre", "90 cm".
  std::optional<double> length_at(std::size_t& i) const {
    i = past(i, WordSet::kBeforeLengths);
    const bool one = is(i, {"a", "one"});
    const NumberRead number = read_number(lexicon_, tokens_, i);
    const std::size_t unit = i + std::max<std::size_t>(number.length, one ? 1 : 0);
    const Match match = lexicon_.find(tokens_, unit, WordClass::kUnit);
    if ((number.length == 0 && !one) || match.length == 0) return std::nullopt;
    i = unit + match.length;
    return (number.length > 0 ? number.value : 1) * meaning_of(match, WordClass::kUnit)->value;
  }

  // "a metre all round it", "1.5 m of free space on all sides", "90 cm free on both sides of the bed"
  bool read_room_round(std::size_t i) {
    std::size_t at = i;
    const std::optional<double> length = length_at(at);
    constexpr double kLeast = 0.3, kMost = 4;
    if (!length || *length < kLeast || *length > kMost) return false;
    Ban ban;
    ban.kind = Ban::Kind::kFreeSide;
    ban.depth = *length;
    const std::size_t said = at;
    at = past(at, WordSet::kFreeFloor);
    const bool free = at > said;
    std::size_t side = at;
    if (is(side, {"on", "at", "along"})) ++side;
    ban.sides = sides_at(side);
    const bool around = is(at, {"all"}) && is(at + 1, {"round", "around"});
    const bool round = is(at, {"around", "round"}) && (free || is(at + 1, {"it", "them", "the"}));
    if (around || round) {
      ban.sides = {Side::kFront, Side::kBack, Side::kLeft, Side::kRight};
      at += around ? 2 : 1;
      if (!ends(at) && !is_over(at) && !read_object(at, ban)) return false;
    } else {
      if (ban.sides.empty() || side == at) return false;
      at = side;
      if (!read_of(at, ban)) return false;
    }
    if (!is_over(at) && !ends(at)) return false;
    std::size_t first = i;
    while (first > 0 && is(first - 1, WordSet::kBeforeFreeFloor)) --first;
    take(std::move(ban), first, at);
    return true;
  }

  // "with space all round", "room to walk all around it"
  bool read_plain_room_round(std::size_t i) {
    if (!is(i, {"space", "room"})) return false;
    std::size_t at = i + 1;
    at = past(at, WordSet::kGoingRound);
    if (is(at, {"all"}) && is(at + 1, {"the"}) && is(at + 2, {"way"})) at += 2;
    const bool all = is(at, {"all", "way"});
    if (all) ++at;
    const bool of_it = is(at + 1, {"it", "them"}) && i > 0;  // "a saw in the middle with space around it"
    if (!is(at, {"round", "around"}) || (!all && at == i + 1 && !of_it)) return false;
    ++at;
    Ban ban;
    ban.kind = Ban::Kind::kFreeSide;
    ban.depth = kUsualSide;
    ban.sides = {Side::kFront, Side::kBack, Side::kLeft, Side::kRight};
    if (!is_over(at) && !read_object(at, ban)) return false;
    if (!is_over(at)) return false;
    std::size_t first = i;
    while (first > 0 && is(first - 1, WordSet::kBeforeRoomRound)) --first;
    if (is(first, {"and"})) ++first;
    take(std::move(ban), first, at);
    return true;
  }

  // "around it", "around the bed"
  bool read_object(std::size_t& i, Ban& ban) {
    if (is(i, {"it", "them"})) return ++i, true;
    const auto thing = thing_named_at(i);
    if (!thing) return false;
    ban.of = singular_of(tokens_[thing->noun].text);
    kept_ = past_known(*thing, i);
    i = thing->last;
    return true;
  }

  const Document& document_;
  std::size_t kept_ = 0;  // where the name begins that is read on, of a thing that is named for the first time
  std::vector<Ban> bans_;
};

}  // namespace

void read_bans(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  std::vector<Token> tokens = document.tokens;
  document.bans = BanReader(lexicon, document, tokens, skip).read();
}

}  // namespace layoutbox::offline
