#include "layoutbox/plan/offline/lexicon.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "layoutbox/base/words.h"
#include "layoutbox/embedded/catalog_data.h"

namespace layoutbox::offline {
namespace {

using Json = nlohmann::ordered_json;  // the order of the relations counts

// The lists' texts are kept for the life of the program, so that meanings can point into them.
const Json& word_list(std::string_view name) {
  static const Json grammar = Json::parse(embedded::words_grammar_json);
  static const Json room = Json::parse(embedded::words_room_json);
  static const Json attributes = Json::parse(embedded::words_attributes_json);
  static const Json phrases = Json::parse(embedded::relation_phrases_json);
  static const Json colors = Json::parse(embedded::colors_json);
  static const Json materials = Json::parse(embedded::materials_json);
  if (name == "grammar") return grammar;
  if (name == "room") return room;
  if (name == "attributes") return attributes;
  if (name == "phrases") return phrases;
  return name == "colors" ? colors : materials;
}

struct PlainList {
  std::string_view file, key;
  WordClass word_class;
};

constexpr std::array kPlainLists = {
    PlainList{"room", "wall", WordClass::kWall},
    PlainList{"room", "corner", WordClass::kCorner},
    PlainList{"room", "center", WordClass::kCenter},
    PlainList{"room", "floor", WordClass::kFloor},
    PlainList{"room", "ceiling", WordClass::kCeiling},
    PlainList{"room", "door", WordClass::kDoor},
    PlainList{"room", "window", WordClass::kWindow},
    PlainList{"room", "room_nouns", WordClass::kRoomNoun},
    PlainList{"room", "outside_rooms", WordClass::kOutsideRoom},
    PlainList{"room", "sides", WordClass::kSide},
    PlainList{"room", "parts", WordClass::kPart},
    PlainList{"room", "abstract", WordClass::kAbstract},
    PlainList{"room", "zones", WordClass::kZone},
    PlainList{"grammar", "definite", WordClass::kDefinite},
    PlainList{"grammar", "indefinite", WordClass::kIndefinite},
    PlainList{"grammar", "possessive", WordClass::kPossessive},
    PlainList{"grammar", "each", WordClass::kEach},
    PlainList{"grammar", "both", WordClass::kBoth},
    PlainList{"grammar", "another", WordClass::kAnother},
    PlainList{"grammar", "other", WordClass::kOther},
    PlainList{"grammar", "pronouns", WordClass::kPronoun},
    PlainList{"grammar", "at_least", WordClass::kAtLeast},
    PlainList{"grammar", "more_than", WordClass::kMoreThan},
    PlainList{"grammar", "at_most", WordClass::kAtMost},
    PlainList{"grammar", "exactly", WordClass::kExactly},
    PlainList{"grammar", "and", WordClass::kAnd},
    PlainList{"grammar", "clause", WordClass::kClause},
    PlainList{"grammar", "relative", WordClass::kRelative},
    PlainList{"grammar", "be", WordClass::kBe},
    PlainList{"grammar", "there", WordClass::kThere},
    PlainList{"grammar", "commands", WordClass::kCommand},
    PlainList{"grammar", "purpose", WordClass::kPurpose},
    PlainList{"grammar", "own_clause", WordClass::kOwnClause},
    PlainList{"grammar", "adverbs", WordClass::kAdverb},
    PlainList{"grammar", "fillers", WordClass::kFiller},
    PlainList{"grammar", "verbs_other", WordClass::kVerb},
    PlainList{"attributes", "size", WordClass::kSizeWord},
    PlainList{"attributes", "material", WordClass::kMaterial},
    PlainList{"attributes", "shape", WordClass::kShape},
    PlainList{"attributes", "style", WordClass::kStyle},
    PlainList{"attributes", "quality", WordClass::kQuality},
    PlainList{"phrases", "without", WordClass::kWithout},
    PlainList{"phrases", "soft", WordClass::kSoft},
};

struct ValueList {
  std::string_view key;
  WordClass word_class;
};

constexpr std::array kValueLists = {
    ValueList{"numbers", WordClass::kNumber},
    ValueList{"vague", WordClass::kVague},
    ValueList{"units", WordClass::kUnit},
    ValueList{"area_units", WordClass::kAreaUnit},
};

// Words within a relation phrase that do not change it.
bool is_article(std::string_view word) {
  static constexpr std::array<std::string_view, 9> kArticles = {"the", "a", "an", "one", "their", "its", "other", "opposite", "two"};
  return std::find(kArticles.begin(), kArticles.end(), word) != kArticles.end();
}

bool is_distributor(std::string_view word) { return word == "each" || word == "every" || word == "either" || word == "both"; }

PhraseSense sense_of(RelationType type, PhraseSense::Direction direction, const Json& item) {
  PhraseSense sense{type, direction, {}, {}, {}};
  if (item.is_object()) {
    sense.part = item.value("part", "");
    sense.region = item.value("region", "");
    if (item.contains("side")) sense.side = side_from_name(item.at("side").get<std::string>());
  }
  return sense;
}

std::string text_of(const Json& item) { return item.is_string() ? item.get<std::string>() : item.at("say").get<std::string>(); }

}  // namespace

Lexicon::Lexicon(const Catalog& catalog) : catalog_(&catalog) {
  for (const CatalogEntry& entry : catalog.entries()) {
    const Meaning meaning{WordClass::kObject, &entry, nullptr, 0, entry.id};
    add(entry.id, meaning);
    add(entry.name, meaning);
    for (const std::string& word : entry.synonyms) add(word, meaning);
  }
  for (const RoomKind& room : catalog.rooms()) {
    const Meaning meaning{WordClass::kRoom, nullptr, &room, 0, room.id};
    add(room.id, meaning);
    add(room.name, meaning);
    for (const std::string& word : room.synonyms) add(word, meaning);
  }
  read_words();
  read_phrases();
}

void Lexicon::add(std::string_view words, Meaning meaning) {
  const std::vector<std::string> parts = words_of(words);
  const std::string key = parts.empty() ? std::string(words) : key_of(words);
  if (key.empty()) return;
  for (const std::string& part : parts) learn(part);
  Entry& entry = words_[key];
  entry.words = std::max(entry.words, parts.size());
  auto& meanings = entry.meanings;
  const auto same = [&](const Meaning& other) {
    return other.word_class == meaning.word_class && other.entry == meaning.entry && other.room == meaning.room;
  };
  if (std::none_of(meanings.begin(), meanings.end(), same)) meanings.push_back(meaning);
}

void Lexicon::add_phrase(std::string_view words, PhraseSense sense) {
  std::string key(words);
  for (const std::string& word : words_of(words)) learn(word);
  phrases_[key].push_back(std::move(sense));
  for (std::size_t space = key.find(' '); space != std::string::npos; space = key.find(' ', space + 1))
    phrase_starts_[key.substr(0, space)] = true;
  phrase_starts_[key] = true;
}

void Lexicon::learn(std::string_view word) {
  if (!vocabulary_.emplace(word).second || word.size() < 2) return;
  by_shape_[std::string(1, word.front()) + std::to_string(word.size())].emplace_back(word);
}

std::span<const std::string> Lexicon::words_like(char first, std::size_t length) const {
  const auto found = by_shape_.find(std::string(1, first) + std::to_string(length));
  return found == by_shape_.end() ? std::span<const std::string>{} : std::span<const std::string>(found->second);
}

const Lexicon::Set* Lexicon::set_of(std::string_view words) const {
  const auto found = sets_.find(key_of(words));
  return found == sets_.end() ? nullptr : &found->second;
}

std::string_view Lexicon::meant_by(std::string_view word) const {
  const auto found = typing_errors_.find(std::string(word));
  return found == typing_errors_.end() ? std::string_view{} : std::string_view(found->second);
}

void Lexicon::read_words() {
  for (const PlainList& list : kPlainLists) {
    for (const Json& word : word_list(list.file).at(std::string(list.key))) {
      const auto& text = word.get_ref<const std::string&>();
      add(text, {list.word_class, nullptr, nullptr, 0, text});
    }
  }
  for (const ValueList& list : kValueLists) {
    for (const auto& [word, value] : word_list("grammar").at(std::string(list.key)).items()) {
      add(word, {list.word_class, nullptr, nullptr, value.get<double>(), {}});
    }
  }
  for (const auto& [wrong, right] : word_list("grammar").at("typing_errors").items()) typing_errors_[wrong] = right.get<std::string>();
  for (const auto& [words, members] : word_list("room").at("sets").items()) {
    Set set;
    for (const auto& [id, count] : members.items()) {
      if (const CatalogEntry* entry = catalog_->find(id)) set.emplace_back(entry, count.get<int>());
    }
    if (set.size() == members.size()) sets_[key_of(words)] = std::move(set);
    add(words, {WordClass::kAbstract, nullptr, nullptr, 0, {}});
  }
  const auto add_named = [&](std::string_view file, std::string_view key, WordClass word_class) {
    for (const auto& [word, value] : word_list(file).at(std::string(key)).items())
      add(word, {word_class, nullptr, nullptr, 0, value.get_ref<const std::string&>()});
  };
  add_named("room", "wall_words", WordClass::kWallWord);
  add_named("room", "wall_relations", WordClass::kWallRelation);
  add_named("grammar", "dimension_words", WordClass::kDimension);
  for (const auto& [word, value] : word_list("colors").at("colors").items()) {
    add(word, {WordClass::kColor, nullptr, nullptr, 0, {}});
    for (const char* shade : {"light ", "dark ", "pale ", "deep ", "bright ", "soft "})
      add(shade + word, {WordClass::kColor, nullptr, nullptr, 0, {}});
    add(word + " colored", {WordClass::kColor, nullptr, nullptr, 0, {}});
  }
  for (const Json& surface : word_list("materials").at("surfaces")) {
    for (const Json& word : surface.at("words")) {
      const auto text = word.get<std::string>();
      // "wooden floor" is a floor that is wooden.
      if (!text.ends_with("floor") && !text.ends_with("wall") && !text.ends_with("boards"))
        add(text, {WordClass::kMaterial, nullptr, nullptr, 0, {}});
    }
  }
  const Json& phrases = word_list("phrases");
  const auto add_group = [&](const Json& words, WordClass word_class) {
    for (const Json& word : words) add(word.get<std::string>(), {word_class, nullptr, nullptr, 0, {}});
  };
  add_group(phrases.at("placing").at("participles"), WordClass::kParticiple);
  add_group(phrases.at("placing").at("verbs"), WordClass::kPlaceVerb);
  add_group(phrases.at("hanging").at("words"), WordClass::kHang);
  add_group(phrases.at("having").at("words"), WordClass::kHave);
}

void Lexicon::read_phrases() {
  using Direction = PhraseSense::Direction;
  constexpr std::array<std::pair<const char*, Direction>, 3> kKeys = {
      {{"phrases", Direction::kDirect}, {"inverse", Direction::kInverse}, {"alone", Direction::kAlone}}};
  for (const auto& [name, ways] : word_list("phrases").at("relations").items()) {
    const RelationRow* row = find_relation(name);
    if (row == nullptr) continue;
    for (const auto& [key, direction] : kKeys) {
      if (!ways.contains(key)) continue;
      for (const Json& item : ways.at(key)) add_phrase(text_of(item), sense_of(row->type, direction, item));
    }
  }
}

// "book shelf" is a bookshelf, "are a" is no area: small words do not run together with others.
bool Lexicon::may_run_together(std::span<const Token> tokens, std::size_t at, std::size_t length, const Entry& entry) const {
  if (length <= std::max<std::size_t>(entry.words, 1)) return true;
  constexpr std::size_t kShortest = 3;
  return std::all_of(tokens.begin() + static_cast<std::ptrdiff_t>(at), tokens.begin() + static_cast<std::ptrdiff_t>(at + length),
                     [&](const Token& token) {
                       return (token.text.size() >= kShortest || token.kind == Token::Kind::kNumber || token.glued) &&
                              !is(token, WordClass::kBe) && !is(token, WordClass::kAnd) && !is(token, WordClass::kDefinite);
                     });
}

Match Lexicon::find(std::span<const Token> tokens, std::size_t at) const {
  constexpr std::size_t kLongest = 6;
  Match best;
  std::string key;
  for (std::size_t length = 1; length <= kLongest && at + length <= tokens.size(); ++length) {
    const Token& token = tokens[at + length - 1];
    if (token.kind == Token::Kind::kPunctuation && length > 1) break;
    if (token.text == "'s" && length > 1) break;
    std::string with_plural = key + token.text;
    if (const auto found = words_.find(with_plural);
        found != words_.end() && (length == 1 || may_run_together(tokens, at, length, found->second))) {
      best = {length, found->second.meanings, false};
      // A plural that is listed as such: "bunk beds" beside "bunk bed".
      const std::string singular = singular_of(token.text);
      const auto single = singular == token.text ? words_.end() : words_.find(key + singular);
      best.plural = single != words_.end() && single->second.meanings.front().entry == best.meanings.front().entry &&
                    best.meanings.front().entry != nullptr;
    }
    if (best.length != length) {
      for (const std::string& form : singular_forms(token.text)) {
        if (form == token.text) continue;
        if (const auto found = words_.find(key + form);
            found != words_.end() && (length == 1 || may_run_together(tokens, at, length, found->second))) {
          best = {length, found->second.meanings, true};
          break;
        }
      }
    }
    key = std::move(with_plural);
  }
  return best;
}

Match Lexicon::find(std::span<const Token> tokens, std::size_t at, WordClass word_class) const {
  constexpr std::size_t kLongest = 6;
  Match best;
  std::string key;
  const auto has = [&](const Entry& entry) {
    return std::any_of(entry.meanings.begin(), entry.meanings.end(), [&](const Meaning& m) { return m.word_class == word_class; });
  };
  for (std::size_t length = 1; length <= kLongest && at + length <= tokens.size(); ++length) {
    const Token& token = tokens[at + length - 1];
    if (token.kind == Token::Kind::kPunctuation && length > 1) break;
    if (token.text == "'s" && length > 1) break;
    key += token.text;
    if (const auto found = words_.find(key);
        found != words_.end() && has(found->second) && (length == 1 || may_run_together(tokens, at, length, found->second)))
      best = {length, found->second.meanings, false};
  }
  return best;
}

bool Lexicon::is(const Token& token, WordClass word_class) const {
  const auto found = words_.find(token.text);
  return found != words_.end() && std::any_of(found->second.meanings.begin(), found->second.meanings.end(),
                                              [&](const Meaning& m) { return m.word_class == word_class; });
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
    next.each |= is_distributor(word);
    next.plural |= plural;
    next.other |= word == "other";
    // "on the left wall" is on a wall, not on the left of something.
    const bool adjective = (word == "left" || word == "right" || word == "back" || word == "front" || word == "top" || word == "bottom") &&
                           i + 1 < tokens.size() && names_place(tokens, i + 1);
    if (const auto found = phrases_.find(extended); found != phrases_.end() && i + 1 - at > best.length && !adjective) {
      best = next;
      best.length = i + 1 - at;
      best.senses = &found->second;
    }
    extend_phrase(tokens, at, i + 1, extended, next, best);
    return true;
  };
  if (!consume(token.text, false)) {
    const std::string singular = singular_of(token.text);
    if (singular != token.text) consume(singular, true);
  }
  // Articles, distributors and adverbs within a phrase are passed over; adverbs may also stand before it.
  const bool adverb = is(token, WordClass::kAdverb);
  if (!adverb && (!inside || !(is_article(token.text) || is_distributor(token.text)))) return;
  so_far.each |= is_distributor(token.text);
  so_far.possessive |= token.text == "its" || token.text == "their";
  so_far.one |= token.text == "one";
  so_far.other |= token.text == "other";
  extend_phrase(tokens, at, i + 1, key, so_far, best);
}

bool Lexicon::names_place(std::span<const Token> tokens, std::size_t at) const {
  const Match match = find(tokens, at);
  return std::any_of(match.meanings.begin(), match.meanings.end(), [](const Meaning& m) {
    return m.word_class == WordClass::kWall || m.word_class == WordClass::kCorner || m.word_class == WordClass::kObject ||
           m.word_class == WordClass::kWallWord || m.word_class == WordClass::kDoor || m.word_class == WordClass::kWindow;
  });
}

PhraseMatch Lexicon::find_phrase(std::span<const Token> tokens, std::size_t at) const {
  PhraseMatch best;
  extend_phrase(tokens, at, at, {}, {}, best);
  return best;
}

}  // namespace layoutbox::offline
