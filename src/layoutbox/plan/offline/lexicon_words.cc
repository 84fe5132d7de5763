// What stands in the lists: the catalogue's names, the word lists and the relation phrases.
#include "layoutbox/plan/offline/lexicon.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/kin.h"
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
    PlainList{"room", "niches", WordClass::kNiche},
    PlainList{"room", "cut_niches", WordClass::kCutNiche},
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

PhraseSense sense_of(RelationType type, PhraseSense::Direction direction, const Json& item) {
  PhraseSense sense{type, direction, {}, {}, {}};
  if (item.is_object()) {
    sense.part = item.value("part", "");
    sense.region = item.value("region", "");
    if (item.contains("side")) sense.side = side_from_name(item.at("side").get<std::string>());
  }
  return sense;
}

// As words_of parts them, and at least one.
std::size_t number_of_words(std::string_view words) {
  std::size_t count = 0;
  bool open = false;
  for (const char c : words) {
    if (c == '\'') continue;
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
    if (letter && !open) ++count;
    open = letter;
  }
  return count;
}

// As words_of parts them, lower case, with single signs between them.
std::string plain_words(std::string_view listed) {
  std::string text;
  text.reserve(listed.size());
  for (const char c : listed) {
    if (c == '\'') continue;
    const bool letter = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
    const bool capital = c >= 'A' && c <= 'Z';
    text += capital ? static_cast<char>(c - 'A' + 'a') : letter ? c : ' ';
  }
  return text;
}

std::string text_of(const Json& item) { return item.is_string() ? item.get<std::string>() : item.at("say").get<std::string>(); }

}  // namespace

Lexicon::Lexicon(const Catalog& catalog) : catalog_(&catalog) {
  constexpr std::size_t kWords = 24000, kLetters = 400000;
  words_.reserve(kWords);
  listed_.reserve(kLetters);
  for (const CatalogEntry& entry : catalog.entries()) {
    const Meaning meaning{WordClass::kObject, &entry, nullptr, 0, entry.id};
    add(entry.id, meaning);
    add(entry.name, meaning);
    for (const std::string& word : entry.synonyms) add(word, meaning);
  }
  for (const auto& [word, id] : like_words()) {
    if (const CatalogEntry* entry = catalog.find(id)) add(word, {WordClass::kObject, entry, nullptr, 0, word});
  }
  for (const RoomKind& room : catalog.rooms()) {
    const Meaning meaning{WordClass::kRoom, nullptr, &room, 0, room.id};
    add(room.id, meaning);
    add(room.name, meaning);
    for (const std::string& word : room.synonyms) add(word, meaning);
  }
  read_words();
  read_room_knowledge();
  read_phrases();
}

void Lexicon::add(std::string_view words, Meaning meaning) {
  std::string key = key_of(words);
  if (key.empty()) key = words;
  if (key.empty()) return;
  listed_.append(words) += '\n';
  Entry& entry = words_[std::move(key)];
  entry.words = std::max(entry.words, number_of_words(words));
  auto& meanings = entry.meanings;
  const auto same = [&](const Meaning& other) {
    return other.word_class == meaning.word_class && other.entry == meaning.entry && other.room == meaning.room;
  };
  if (std::none_of(meanings.begin(), meanings.end(), same)) meanings.push_back(meaning);
}

void Lexicon::add_phrase(std::string_view words, PhraseSense sense) {
  std::string key(words);
  listed_.append(words) += '\n';
  phrases_[key].push_back(std::move(sense));
  for (std::size_t space = key.find(' '); space != std::string::npos; space = key.find(' ', space + 1))
    phrase_starts_[key.substr(0, space)] = true;
  phrase_starts_[key] = true;
}

const Lexicon::Vocabulary& Lexicon::vocabulary() const {
  std::call_once(vocabulary_made_, [&] {
    constexpr std::size_t kWords = 16000;
    vocabulary_.words.reserve(kWords);
    vocabulary_.text = plain_words(listed_);
    const std::string_view text = vocabulary_.text;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find(' ', at), text.size());
      const std::string_view word = text.substr(at, end - at);
      at = end + 1;
      if (!word.empty() && vocabulary_.words.insert(word).second && word.size() >= 2)
        vocabulary_.by_shape[Vocabulary::shape(word.front(), word.size())].push_back(word);
    }
  });
  return vocabulary_;
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
  for (const Json& word : word_list("grammar").at("plural_only")) plural_only_.insert(word.get<std::string>());
  for (const auto& [word, meant] : word_list("grammar").at("pairs_meant").items()) pairs_meant_[word] = meant.get<std::string>();
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

// What rooms need for each person, what one sits on, and what plain words mean in a room.
void Lexicon::read_room_knowledge() {
  const Json& room = word_list("room");
  for (const Json& word : room.at("persons")) persons_.insert(word.get<std::string>());
  for (const Json& word : room.at("young_persons")) young_persons_.insert(word.get<std::string>());
  for (const auto& [kind, members] : room.at("people").items()) {
    Set set;
    for (const auto& [id, persons] : members.items()) {
      if (const CatalogEntry* entry = catalog_->find(id)) set.emplace_back(entry, persons.get<int>());
    }
    if (set.size() == members.size()) needs_[kind] = std::move(set);
  }
  for (const auto& [kind, words] : room.at("activities").items()) {
    for (const Json& word : words) activities_.try_emplace(word.get<std::string>(), kind);
  }
  for (const auto& [kind, young] : room.at("people_rooms").items()) young_rooms_[kind] = young.get<std::string>();
  for (const Seating& seating : Groups::builtin().seatings) {
    const CatalogEntry* entry = seating.rooms.empty() ? catalog_->find(seating.at) : nullptr;
    if (entry != nullptr) seats_.emplace_back(entry, catalog_->find(seating.seat));
  }
  for (const Json& sense : room.at("room_senses")) {
    for (const Json& kind : sense.at("rooms")) {
      for (const auto& [word, id] : sense.at("words").items())
        room_senses_.try_emplace(kind.get<std::string>() + "|" + word, catalog_->find(id.get_ref<const std::string&>()));
    }
  }
}

void Lexicon::read_phrases() {
  using Way = PhraseSense::Direction;
  constexpr std::array<std::pair<const char*, Way>, 3> kKeys = {
      {{"phrases", Way::kDirect}, {"inverse", Way::kInverse}, {"alone", Way::kAlone}}};
  for (const auto& [name, ways] : word_list("phrases").at("relations").items()) {
    const RelationRow* row = find_relation(name);
    if (row == nullptr) continue;
    for (const auto& [key, direction] : kKeys) {
      if (!ways.contains(key)) continue;
      for (const Json& item : ways.at(key)) add_phrase(text_of(item), sense_of(row->type, direction, item));
    }
  }
}

}  // namespace layoutbox::offline
