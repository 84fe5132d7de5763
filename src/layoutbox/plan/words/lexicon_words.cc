// What stands in the lists: the catalogue's names, the word lists and the relation phrases.
#include "layoutbox/plan/words/lexicon.h"

#include <algorithm>
#include <array>
#include <utility>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/word_lists.h"

namespace layoutbox::offline {
namespace {

struct PlainList {
  std::string_view file, key;
  WordClass word_class;
};

// Lists of words_grammar.json that say nothing of grammar (Lexicon::is_in).
constexpr std::array<std::string_view, 13> kSmallLists = {"wishing", "closings", "closing_leads", "money",  "name_verbs",
                                                          "looking", "watching", "turning",       "aiming", "parting",
                                                          "filling", "full",     "assorting"};

constexpr std::array kPlainLists = {
    PlainList{"words_room", "wall", WordClass::kWall},
    PlainList{"words_room", "corner", WordClass::kCorner},
    PlainList{"words_room", "center", WordClass::kCenter},
    PlainList{"words_room", "floor", WordClass::kFloor},
    PlainList{"words_room", "ceiling", WordClass::kCeiling},
    PlainList{"words_room", "door", WordClass::kDoor},
    PlainList{"words_room", "window", WordClass::kWindow},
    PlainList{"words_room", "room_nouns", WordClass::kRoomNoun},
    PlainList{"words_room", "outside_rooms", WordClass::kOutsideRoom},
    PlainList{"words_room", "sides", WordClass::kSide},
    PlainList{"words_room", "parts", WordClass::kPart},
    PlainList{"words_room", "abstract", WordClass::kAbstract},
    PlainList{"words_room", "zones", WordClass::kZone},
    PlainList{"words_room", "niches", WordClass::kNiche},
    PlainList{"words_room", "cut_niches", WordClass::kCutNiche},
    PlainList{"words_grammar", "definite", WordClass::kDefinite},
    PlainList{"words_grammar", "indefinite", WordClass::kIndefinite},
    PlainList{"words_grammar", "possessive", WordClass::kPossessive},
    PlainList{"words_grammar", "each", WordClass::kEach},
    PlainList{"words_grammar", "both", WordClass::kBoth},
    PlainList{"words_grammar", "another", WordClass::kAnother},
    PlainList{"words_grammar", "other", WordClass::kOther},
    PlainList{"words_grammar", "pronouns", WordClass::kPronoun},
    PlainList{"words_grammar", "at_least", WordClass::kAtLeast},
    PlainList{"words_grammar", "more_than", WordClass::kMoreThan},
    PlainList{"words_grammar", "at_most", WordClass::kAtMost},
    PlainList{"words_grammar", "exactly", WordClass::kExactly},
    PlainList{"words_grammar", "and", WordClass::kAnd},
    PlainList{"words_grammar", "clause", WordClass::kClause},
    PlainList{"words_grammar", "relative", WordClass::kRelative},
    PlainList{"words_grammar", "be", WordClass::kBe},
    PlainList{"words_grammar", "there", WordClass::kThere},
    PlainList{"words_grammar", "commands", WordClass::kCommand},
    PlainList{"words_grammar", "purpose", WordClass::kPurpose},
    PlainList{"words_grammar", "doers", WordClass::kDoer},
    PlainList{"words_grammar", "adverbs", WordClass::kAdverb},
    PlainList{"words_grammar", "fillers", WordClass::kFiller},
    PlainList{"words_grammar", "verbs_other", WordClass::kVerb},
    PlainList{"words_attributes", "size", WordClass::kSizeWord},
    PlainList{"words_attributes", "material", WordClass::kMaterial},
    PlainList{"words_attributes", "shape", WordClass::kShape},
    PlainList{"words_attributes", "style", WordClass::kStyle},
    PlainList{"words_attributes", "quality", WordClass::kQuality},
    PlainList{"relation_phrases", "without", WordClass::kWithout},
    PlainList{"relation_phrases", "soft", WordClass::kSoft},
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

PhraseSense sense_of(RelationType type, PhraseSense::Direction direction, const WordList& item) {
  PhraseSense sense{type, direction, {}, {}, {}};
  if (!item.is_object()) return sense;
  for (const WordList::Member member : item) {
    if (member.key == "part") sense.part = ThingPart(std::string(member.value.text()));
    if (member.key == "region") sense.region = region_from_words(member.value.text());
    if (member.key == "order")
      sense.order = member.value.text() == "reversed" ? PhraseSense::Order::kReversed : PhraseSense::Order::kAsSaid;
    if (member.key == "of") sense.of_room = member.value.text() == "room";
    if (member.key == "side") sense.side = side_from_name(member.value.text());
  }
  return sense;
}

// What a letter or digit is in a key, lower case; 0: none.
constexpr auto kKeyLetters = [] {
  std::array<char, 256> letters{};
  for (std::size_t c = 0; c < letters.size(); ++c) {
    const char sign = static_cast<char>(c);
    const bool capital = sign >= 'A' && sign <= 'Z';
    const bool plain = (sign >= 'a' && sign <= 'z') || (sign >= '0' && sign <= '9') || c >= 0x80;
    letters[c] = capital ? static_cast<char>(c - 'A' + 'a') : plain ? sign : '\0';
  }
  return letters;
}();

// As key_of makes it; the number of words as words_of parts them.
std::uint32_t make_key(std::string_view words, std::string& key) {
  key.resize(words.size());
  std::uint32_t count = 0;
  std::size_t length = 0;
  bool open = false;
  for (const char c : words) {
    if (c == '\'') continue;
    const char letter = kKeyLetters[static_cast<unsigned char>(c)];
    count += letter != 0 && !open ? 1 : 0;
    open = letter != 0;
    key[length] = letter;
    length += open ? 1 : 0;
  }
  key.resize(length);
  return count;
}

// As words_of parts them, lower case, with single signs between them.
std::string plain_words(std::string_view listed) {
  std::string text;
  text.reserve(listed.size());
  for (const char c : listed) {
    const char letter = kKeyLetters[static_cast<unsigned char>(c)];
    if (c != '\'') text += letter != 0 ? letter : ' ';
  }
  return text;
}

std::string_view text_of(const WordList& item) { return item.is_text() ? item.text() : item.at("say").text(); }

constexpr std::size_t kListedWords = 24000, kPhrases = 2000, kLetters = 400000;

}  // namespace

Lexicon::Lexicon(const Catalog& catalog) : catalog_(&catalog), words_(kListedWords), phrases_(kPhrases), phrase_starts_(kPhrases) {
  listed_meanings_.reserve(kListedWords);
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
  settle_meanings();
}

// Those of one word stand together, in the order in which they came, none twice.
void Lexicon::settle_meanings() {
  for (const auto& [place, meaning] : listed_meanings_) ++words_.at_place(place).count;
  std::uint32_t first = 0;
  for (std::size_t place = 0; place < words_.size(); ++place) {
    Entry& entry = words_.at_place(place);
    entry.first = first;
    first += std::exchange(entry.count, 0);
  }
  meanings_.resize(first);
  for (const auto& [place, meaning] : listed_meanings_) {
    Entry& entry = words_.at_place(place);
    const std::span<const Meaning> before = meanings_of(entry);
    const auto same = [&, &meant = meaning](const Meaning& other) {
      return other.word_class == meant.word_class && other.entry == meant.entry && other.room == meant.room;
    };
    if (std::none_of(before.begin(), before.end(), same)) meanings_[entry.first + entry.count++] = meaning;
  }
  listed_meanings_ = {};
}

void Lexicon::add(std::string_view words, const Meaning& meaning) {
  const std::uint32_t count = make_key(words, key_);
  if (key_.empty()) key_ = words;
  if (key_.empty()) return;
  listed_.append(words) += '\n';
  const std::size_t place = words_.place_of(key_);
  Entry& entry = words_.at_place(place);
  entry.words = std::max(entry.words, count);
  listed_meanings_.emplace_back(static_cast<std::uint32_t>(place), meaning);
}

void Lexicon::add_phrase(std::string_view words, PhraseSense sense) {
  listed_.append(words) += '\n';
  phrases_[words].push_back(std::move(sense));
  for (std::size_t space = words.find(' '); space != std::string_view::npos; space = words.find(' ', space + 1))
    phrase_starts_[words.substr(0, space)] = 1;
  phrase_starts_[words] = 1;
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
  const WordList grammar = word_list("words_grammar"), room = word_list("words_room"), colors = word_list("colors").at("colors");
  for (const PlainList& list : kPlainLists) {
    for (const WordList::Member word : word_list(list.file).at(list.key)) {
      const std::string_view text = word.value.text();
      add(text, {list.word_class, nullptr, nullptr, 0, text});
    }
  }
  for (const ValueList& list : kValueLists) {
    for (const WordList::Member word : grammar.at(list.key)) add(word.key, {list.word_class, nullptr, nullptr, word.value.number(), {}});
  }
  for (const WordList::Member wrong : grammar.at("typing_errors")) typing_errors_[std::string(wrong.key)] = wrong.value.text();
  for (const WordList::Member word : grammar.at("plural_only")) plural_only_.emplace(word.value.text());
  // What is looked up by its letters is known to spelling too.
  const auto know = [&](std::string_view word) { listed_.append(word) += '\n'; };
  for (const std::string_view list : kSmallLists) {
    for (const WordList::Member word : grammar.at(list)) {
      small_lists_[std::string(list)].emplace(word.value.text());
      know(word.value.text());
    }
  }
  for (const std::string_view list : {"absent", "replaced", "absent_yet"}) {
    for (const WordList::Member word : grammar.at(list)) know(word.value.text());
  }
  for (const WordList::Member word : grammar.at("pasts")) pasts_[std::string(word.key)] = word.value.text();
  for (const WordList::Member word : grammar.at("strides")) strides_[std::string(word.key)] = word.value.number();
  for (const WordList::Member word : grammar.at("place_verbs")) place_verbs_.emplace(word.value.text());
  for (const WordList::Member word : grammar.at("pairs_meant")) pairs_meant_[std::string(word.key)] = word.value.text();
  for (const WordList::Member listed : room.at("sets")) {
    add_set(sets_, key_of(listed.key), listed.value);
    add(listed.key, {WordClass::kAbstract, nullptr, nullptr, 0, {}});
  }
  const auto add_named = [&](const WordList& words, WordClass word_class) {
    for (const WordList::Member word : words) add(word.key, {word_class, nullptr, nullptr, 0, word.value.text()});
  };
  add_named(room.at("wall_words"), WordClass::kWallWord);
  add_named(room.at("wall_relations"), WordClass::kWallRelation);
  add_named(grammar.at("dimension_words"), WordClass::kDimension);
  const Meaning color{WordClass::kColor, nullptr, nullptr, 0, {}};
  for (const WordList::Member word : colors) {
    const std::string name(word.key);
    add(name, color);
    for (const char* shade : {"light ", "dark ", "pale ", "deep ", "bright ", "soft "}) add(shade + name, color);
    add(name + " colored", color);
  }
  for (const WordList::Member surface : word_list("materials").at("surfaces")) {
    for (const WordList::Member word : surface.value.at("words")) {
      const std::string_view text = word.value.text();
      // "wooden floor" is a floor that is wooden.
      if (text.ends_with("floor") || text.ends_with("wall") || text.ends_with("boards")) continue;
      add(text, {WordClass::kMaterial, nullptr, nullptr, 0, {}});
      add("light " + std::string(text), {WordClass::kMaterial, nullptr, nullptr, 0, {}});  // no lamp
    }
  }
  const WordList phrases = word_list("relation_phrases");
  const auto add_group = [&](const WordList& words, WordClass word_class) {
    for (const WordList::Member word : words) add(word.value.text(), {word_class, nullptr, nullptr, 0, {}});
  };
  add_group(phrases.at("placing").at("participles"), WordClass::kParticiple);
  add_group(phrases.at("placing").at("verbs"), WordClass::kPlaceVerb);
  add_group(phrases.at("hanging").at("words"), WordClass::kHang);
  add_group(phrases.at("having").at("words"), WordClass::kHave);
}

// Things of the catalogue and how many; nothing where it lacks one.
void Lexicon::add_set(std::unordered_map<std::string, Set>& sets, const std::string& key, const WordList& members) {
  Set set;
  for (const WordList::Member member : members) {
    const CatalogEntry* entry = catalog_->find(member.key);
    if (entry == nullptr) return;
    set.emplace_back(entry, static_cast<int>(member.value.number()));
  }
  sets[key] = std::move(set);
}

// What rooms need for each person, and what plain words mean in a room.
void Lexicon::read_room_knowledge() {
  const WordList room = word_list("words_room");
  for (const WordList::Member word : room.at("persons")) persons_.emplace(word.value.text());
  for (const WordList::Member word : room.at("young_persons")) young_persons_.emplace(word.value.text());
  for (const WordList::Member kind : room.at("people")) add_set(needs_, std::string(kind.key), kind.value);
  for (const WordList::Member kind : room.at("activities")) {
    for (const WordList::Member word : kind.value) activities_.try_emplace(std::string(word.value.text()), kind.key);
  }
  for (const WordList::Member kind : room.at("people_rooms")) young_rooms_[std::string(kind.key)] = kind.value.text();
  for (const WordList::Member sense : room.at("room_senses")) {
    for (const WordList::Member kind : sense.value.at("rooms")) {
      for (const WordList::Member word : sense.value.at("words"))
        room_senses_.try_emplace(std::string(kind.value.text()) + "|" + std::string(word.key), catalog_->find(word.value.text()));
    }
  }
}

void Lexicon::read_phrases() {
  using Way = PhraseSense::Direction;
  constexpr std::array<std::pair<std::string_view, Way>, 3> kKeys = {
      {{"phrases", Way::kDirect}, {"inverse", Way::kInverse}, {"alone", Way::kAlone}}};
  for (const WordList::Member relation : word_list("relation_phrases").at("relations")) {
    const RelationRow* row = find_relation(relation.key);
    if (row == nullptr) continue;
    for (const auto& [key, direction] : kKeys) {
      if (!relation.value.contains(key)) continue;
      for (const WordList::Member item : relation.value.at(key))
        add_phrase(text_of(item.value), sense_of(row->type, direction, item.value));
    }
  }
}

}  // namespace layoutbox::offline
