#include "layoutbox/plan/words/lexicon.h"

#include <algorithm>
#include <array>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

// Words within a relation phrase that do not change it.
bool is_article(std::string_view word) {
  static constexpr std::array<std::string_view, 9> kArticles = {"the", "a", "an", "one", "their", "its", "other", "opposite", "two"};
  return std::find(kArticles.begin(), kArticles.end(), word) != kArticles.end();
}

// "two" … "eight": of sides.
int number_of(std::string_view word) {
  static constexpr std::array<std::string_view, 9> kNumbers = {"", "", "two", "three", "four", "five", "six", "seven", "eight"};
  const auto found = std::find(kNumbers.begin() + 2, kNumbers.end(), word);
  return found == kNumbers.end() ? 0 : static_cast<int>(found - kNumbers.begin());
}

// "cans" are no modal verbs: small words have no plurals.
bool has_plural(std::span<const Meaning> meanings) {
  static constexpr std::array kSmall = {WordClass::kBe,         WordClass::kThere,    WordClass::kDefinite, WordClass::kIndefinite,
                                        WordClass::kPossessive, WordClass::kEach,     WordClass::kPronoun,  WordClass::kAnd,
                                        WordClass::kClause,     WordClass::kRelative, WordClass::kAdverb,   WordClass::kFiller};
  return std::any_of(meanings.begin(), meanings.end(),
                     [](const Meaning& m) { return std::find(kSmall.begin(), kSmall.end(), m.word_class) == kSmall.end(); });
}

// "chestof" of "chests of": no rows or pairs, which are counts of what stands in them.
std::string several_of(const std::string& word) {
  const std::string one = singular_of(word);
  return one == word || one_of(word, WordSet::kRowsOfThings) ? std::string() : one + "of";
}

bool is_distributor(std::string_view word) { return word == "each" || word == "every" || word == "either" || word == "both"; }

}  // namespace

std::span<const std::string_view> Lexicon::words_like(char first, std::size_t length) const {
  const auto& by_shape = vocabulary().by_shape;
  const auto found = by_shape.find(Vocabulary::shape(first, length));
  return found == by_shape.end() ? std::span<const std::string_view>{} : std::span<const std::string_view>(found->second);
}

const Lexicon::Set* Lexicon::set_called(std::string_view name) const {
  const Set* set = set_of(name);
  for (std::size_t space = 0; set == nullptr && (space = name.find(' ')) != std::string_view::npos;) {
    name.remove_prefix(space + 1);
    set = set_of(name);
  }
  return set;
}

const Lexicon::Set* Lexicon::set_of(std::string_view words) const {
  const auto found = sets_.find(key_of(words));
  return found == sets_.end() ? nullptr : &found->second;
}

const Lexicon::Set* Lexicon::needs_in(std::string_view room) const {
  const auto found = needs_.find(std::string(room));
  return found == needs_.end() ? nullptr : &found->second;
}

std::string_view Lexicon::young_room(std::string_view room) const {
  const auto found = young_rooms_.find(std::string(room));
  return found == young_rooms_.end() ? room : std::string_view(found->second);
}

std::pair<std::string_view, std::size_t> Lexicon::room_suggested(std::span<const Token> tokens, std::size_t at) const {
  constexpr std::size_t kLongest = 4;
  std::pair<std::string_view, std::size_t> best{};
  std::string words, bare;  // `bare`: "play drums" of "play the drums"
  for (std::size_t length = 1; length <= kLongest && at + length <= tokens.size(); ++length) {
    const Token& token = tokens[at + length - 1];
    if (token.kind == Token::Kind::kPunctuation) break;
    words += (words.empty() ? "" : " ") + token.text;
    const bool names = length > 1 && (is(token, WordClass::kDefinite) || is(token, WordClass::kPossessive));
    if (!names) bare += (bare.empty() ? "" : " ") + token.text;
    auto found = activities_.find(words);
    if (found == activities_.end()) found = activities_.find(singular_of(words));
    if (found == activities_.end() && !names) found = activities_.find(bare);
    if (found != activities_.end()) best = {found->second, length};
  }
  return best;
}

const CatalogEntry* Lexicon::meant_in(const RoomKind& room, std::string_view name, std::string_view word) const {
  for (const std::string_view kind : {name, std::string_view(room.id)}) {
    if (const auto found = room_senses_.find(std::string(kind) + "|" + std::string(word)); found != room_senses_.end())
      return found->second;
  }
  return nullptr;
}

std::string_view Lexicon::meant_by_pair(std::string_view word) const {
  const auto found = pairs_meant_.find(std::string(word));
  return found == pairs_meant_.end() ? std::string_view{} : std::string_view(found->second);
}

std::string_view Lexicon::meant_by(std::string_view word) const {
  const auto found = typing_errors_.find(std::string(word));
  return found == typing_errors_.end() ? std::string_view{} : std::string_view(found->second);
}

// "book shelf" is a bookshelf, "are a" is no area: small words do not run together with others.
bool Lexicon::may_run_together(std::span<const Token> tokens, std::size_t at, std::size_t length, const Entry& entry) const {
  if (length <= std::max<std::size_t>(entry.words, 1)) return true;
  constexpr std::size_t kShortest = 3;
  return std::all_of(
      tokens.begin() + static_cast<std::ptrdiff_t>(at), tokens.begin() + static_cast<std::ptrdiff_t>(at + length), [&](const Token& token) {
        return (token.text.size() >= kShortest || token.kind == Token::Kind::kNumber || token.glued) && !is(token, WordClass::kBe) &&
               !is(token, WordClass::kEach) && !is(token, WordClass::kAnd) && !is(token, WordClass::kDefinite);
      });
}

// "barber's pole", "nurses' station": also what is known as "barber pole", "nurse station". Things own nothing here: "the bed's head".
std::string Lexicon::without_owner(const std::string& key) const {
  if (has(words_.find(key), WordClass::kObject)) return {};
  return key.ends_with('s') ? key.substr(0, key.size() - 1) : key;
}

bool Lexicon::may_stand(const Stretch& here, const Entry& entry) const {
  return here.length == 1 || may_run_together(here.tokens, here.at, here.length, entry);
}

// As it is listed: `key` and the last word.
Match Lexicon::find_listed(const std::string& key, const Stretch& here) const {
  const std::string& last = here.last().text;
  const Entry* found = words_.find(key + last);
  if (found == nullptr || !may_stand(here, *found)) return {};
  Match match{here.length, meanings_of(*found), false};
  // A plural that is listed as such: "bunk beds" beside "bunk bed".
  const std::string singular = singular_of(last);
  const Entry* single = singular == last ? nullptr : words_.find(key + singular);
  const CatalogEntry* entry = match.meanings.front().entry;
  match.plural = single != nullptr && entry != nullptr && meanings_of(*single).front().entry == entry;
  return match;
}

// … by the singular of the last word.
Match Lexicon::find_by_singular(const std::string& key, const Stretch& here) const {
  for (const std::string& form : singular_forms(here.last().text)) {
    if (form == here.last().text) continue;
    const Entry* found = words_.find(key + form);
    if (found != nullptr && has_plural(meanings_of(*found)) && may_stand(here, *found)) return {here.length, meanings_of(*found), true};
  }
  return {};
}

// … a thing whose owner has no 's in the list.
Match Lexicon::find_owned(const std::string& plain, const Stretch& here) const {
  for (const std::string& form : {here.last().text, singular_of(here.last().text)}) {
    const Entry* found = words_.find(plain + form);
    if (has(found, WordClass::kObject) && may_stand(here, *found)) return {here.length, meanings_of(*found), form != here.last().text};
  }
  return {};
}

Match Lexicon::find(std::span<const Token> tokens, std::size_t at) const {
  constexpr std::size_t kLongest = 6;
  Match best;
  std::string key, plain, several;  // plain: without the 's of an owner; several: "chest of" of "chests of drawers"
  for (std::size_t length = 1; length <= kLongest && at + length <= tokens.size(); ++length) {
    const Stretch here{tokens, at, length};
    const Token& token = here.last();
    if (token.kind == Token::Kind::kPunctuation && length > 1) break;
    if (token.text == "'s" && length > 1) {  // "children's room", "boys' room"
      plain = without_owner(key);
      if (!key.ends_with('s')) key += 's';
      continue;
    }
    Match match = find_listed(key, here);
    if (match.length == 0) match = find_by_singular(key, here);
    if (!several.empty()) {
      several += token.text;
      const Entry* found = words_.find(several);
      if (match.length == 0 && has(found, WordClass::kObject) && may_stand(here, *found)) match = {length, meanings_of(*found), true};
    }
    if (!plain.empty() && match.length == 0) match = find_owned(plain, here);
    if (match.length > 0) best = match;
    if (!plain.empty()) plain += token.text;
    if (token.text == "of" && length == 2) several = several_of(tokens[at].text);
    key += token.text;
  }
  return best;
}

bool Lexicon::has(const Entry* entry, WordClass word_class) const {
  if (entry == nullptr) return false;
  const std::span<const Meaning> meanings = meanings_of(*entry);
  return std::any_of(meanings.begin(), meanings.end(), [&](const Meaning& m) { return m.word_class == word_class; });
}

Match Lexicon::find(std::span<const Token> tokens, std::size_t at, WordClass word_class) const {
  constexpr std::size_t kLongest = 6;
  Match best;
  std::string key;
  for (std::size_t length = 1; length <= kLongest && at + length <= tokens.size(); ++length) {
    const Token& token = tokens[at + length - 1];
    if (token.kind == Token::Kind::kPunctuation && length > 1) break;
    if (token.text == "'s" && length > 1) {
      if (!key.ends_with('s')) key += 's';
      continue;
    }
    key += token.text;
    if (const Entry* found = words_.find(key); has(found, word_class) && (length == 1 || may_run_together(tokens, at, length, *found)))
      best = {length, meanings_of(*found), false};
  }
  return best;
}

bool Lexicon::is(const Token& token, WordClass word_class) const { return has(words_.find(token.text), word_class); }

namespace {

bool is_sides_at(std::span<const Token> tokens, std::size_t side) {
  return side < tokens.size() && (tokens[side].text == "sides" || tokens[side].text == "edges");
}

}  // namespace

// "at each of its six sides", "on three of its sides", "at each of its sides": as at each side.
void Lexicon::extend_by_sides(std::span<const Token> tokens, std::size_t at, std::size_t i, const std::string& key,
                              const PhraseMatch& so_far, PhraseMatch& best) const {
  if (const int sides = number_of(tokens[i].text); sides > 1) {
    std::size_t side = i + 1;
    if (side + 1 < tokens.size() && tokens[side].text == "of") side += 2;
    const std::string each = key.ends_with(" each") ? key : key + " each";
    if (is_sides_at(tokens, side) && phrase_starts_.contains(each + " side")) {
      PhraseMatch counted = so_far;
      counted.sides = sides;
      counted.shared = so_far.each;
      counted.each = true;
      extend_phrase(tokens, at, side, each, counted, best);
    }
  }
  const bool of_its = tokens[i].text == "of" && so_far.each && i + 1 < tokens.size() && is_article(tokens[i + 1].text);
  if (of_its && (is_sides_at(tokens, i + 2) || is_sides_at(tokens, i + 3))) {
    PhraseMatch next = so_far;
    next.possessive |= tokens[i + 1].text == "its" || tokens[i + 1].text == "their";
    extend_phrase(tokens, at, i + 2, key, next, best);
  }
}

void Lexicon::extend_phrase(std::span<const Token> tokens, std::size_t at, std::size_t i, const std::string& key, PhraseMatch so_far,
                            PhraseMatch& best) const {
  constexpr std::size_t kMostTokens = 9;
  if (i >= tokens.size() || i >= at + kMostTokens) return;
  const Token& token = tokens[i];
  if (token.kind != Token::Kind::kWord || token.text == "'s") return;
  const bool inside = !key.empty();
  const auto consume = [&](const std::string& word, bool plural) {
    std::string extended = inside ? key + " " + word : word;
    if (!phrase_starts_.contains(extended)) return false;
    PhraseMatch next = so_far;
    next.each |= is_distributor(word) || (inside && word == "all");  // "on all sides"
    next.each |= word == "right" && key.ends_with("left and");       // "a lamp on the left and right of the bed"
    next.all |= inside && (word == "every" || word == "all");
    if (const int sides = number_of(word); inside && sides > 1) next.sides = sides;
    next.possessive |= word == "its" || word == "their";
    next.plural |= plural;
    next.other |= word == "other";
    // "on the left wall" is on a wall, not on the left of something.
    static constexpr std::array<std::string_view, 7> kSides = {"left", "right", "back", "rear", "front", "top", "bottom"};
    const bool adjective =
        std::find(kSides.begin(), kSides.end(), word) != kSides.end() && i + 1 < tokens.size() && names_place(tokens, i + 1);
    // "on the side tables" are things on tables.
    const auto begins_name = [&] {
      const Match name = find(tokens, i);
      return i > at && name.length > 1 &&
             std::any_of(name.meanings.begin(), name.meanings.end(), [](const Meaning& m) { return m.word_class == WordClass::kObject; });
    };
    if (const PhraseSenses* found = phrases_.find(extended); found != nullptr && i + 1 - at > best.length && !adjective && !begins_name()) {
      best = next;
      best.length = i + 1 - at;
      best.senses = found;
    }
    extend_phrase(tokens, at, i + 1, extended, next, best);
    return true;
  };
  if (inside) extend_by_sides(tokens, at, i, key, so_far, best);
  if (!consume(token.text, false)) {
    const std::string singular = singular_of(token.text);
    if (singular != token.text) consume(singular, true);
  }
  // Articles, distributors and adverbs within a phrase are passed over; adverbs may also stand before it.
  const bool adverb = is(token, WordClass::kAdverb);
  // "to its left a side table": the article opens what stands there.
  if (inside && (token.text == "a" || token.text == "an") && best.length == i - at && best.senses != nullptr &&
      std::any_of(best.senses->begin(), best.senses->end(), [](const PhraseSense& s) {
        return s.direction == PhraseSense::Direction::kAlone && (s.type == RelationType::kLeftOf || s.type == RelationType::kRightOf);
      }))
    return;
  if (adverb && inside && token.text == "right" && i + 1 < tokens.size() && names_place(tokens, i + 1)) return;  // "along the right wall"
  if (!adverb && (!inside || !(is_article(token.text) || is_distributor(token.text)))) return;
  so_far.each |= is_distributor(token.text);
  so_far.possessive |= token.text == "its" || token.text == "their";
  so_far.one |= token.text == "one";
  so_far.other |= token.text == "other";
  extend_phrase(tokens, at, i + 1, key, so_far, best);
}

bool Lexicon::names_place(std::span<const Token> tokens, std::size_t at) const {
  const Match match = find(tokens, at);
  // "to the left stand two machines": the verb.
  if (at + 1 < tokens.size() && is(tokens[at], WordClass::kPlaceVerb) &&
      (tokens[at + 1].kind == Token::Kind::kNumber || is(tokens[at + 1], WordClass::kIndefinite) || is(tokens[at + 1], WordClass::kNumber)))
    return false;
  // "a table on the left near the window": no near wall
  const PhraseSenses* by = at < tokens.size() ? phrases_.find(tokens[at].text) : nullptr;
  if (by != nullptr && std::ranges::find(*by, RelationType::kNear, &PhraseSense::type) != by->end() && match.length == 1 &&
      at + 1 < tokens.size() && !names_place(tokens, at + 1))
    return false;
  return std::any_of(match.meanings.begin(), match.meanings.end(), [](const Meaning& m) {
    return m.word_class == WordClass::kWall || m.word_class == WordClass::kCorner || m.word_class == WordClass::kObject ||
           m.word_class == WordClass::kWallWord || m.word_class == WordClass::kDoor || m.word_class == WordClass::kWindow;
  });
}

const CatalogEntry* Lexicon::entry_called(const std::string& words) const {
  const CatalogEntry* entry = catalog_->find_by_words(words);
  return entry != nullptr && (entry->name == words || std::ranges::find(entry->synonyms, words) != entry->synonyms.end()) ? entry : nullptr;
}

PhraseMatch Lexicon::find_phrase(std::span<const Token> tokens, std::size_t at) const {
  PhraseMatch best;
  extend_phrase(tokens, at, at, {}, {}, best);
  return best;
}

}  // namespace layoutbox::offline
