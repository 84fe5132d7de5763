// What words may mean: the catalogue's names, the relation phrases and the word lists of catalog/words_*.json, found by longest match.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/catalog/word_lists.h"
#include "layoutbox/plan/words/text_map.h"
#include "layoutbox/plan/words/tokens.h"

namespace layoutbox::offline {

// What a word or phrase does in a sentence.
enum class WordClass {
  kObject,  // a catalogue entry
  kRoom,    // a kind of room
  kWall,
  kCorner,
  kCenter,
  kFloor,
  kCeiling,
  kDoor,
  kWindow,
  kRoomNoun,
  kOutsideRoom,
  kSide,
  kPart,
  kAbstract,
  kZone,
  kNiche,     // a part of the room's outline
  kCutNiche,  // … that is taken out of it: a notch
  kDefinite,
  kIndefinite,
  kPossessive,
  kEach,
  kBoth,
  kAnother,
  kOther,
  kPronoun,
  kNumber,
  kVague,
  kAtLeast,
  kMoreThan,
  kAtMost,
  kExactly,
  kAnd,
  kClause,
  kRelative,
  kBe,
  kThere,
  kCommand,
  kPurpose,
  kAdverb,
  kFiller,
  kVerb,
  kDoer,  // who does something: "we", "guests"
  kParticiple,
  kPlaceVerb,
  kHang,
  kHave,
  kWithout,
  kSoft,
  kWallWord,
  kWallRelation,
  kSizeWord,
  kColor,
  kMaterial,
  kShape,
  kStyle,
  kQuality,
  kUnit,
  kAreaUnit,
  kDimension,
};

struct Meaning {
  WordClass word_class;
  const CatalogEntry* entry = nullptr;
  const RoomKind* room = nullptr;
  double value = 0;       // numbers, units
  std::string_view word;  // what stands in the list: "left" for "western", the dimension's letter; of an object its category
};

// One way to say a relation. The direction tells who stands before the phrase.
struct PhraseSense {
  enum class Direction { kDirect, kInverse, kAlone };
  RelationType type;
  Direction direction = Direction::kDirect;
  ThingPart part;
  std::optional<RoomRegion> region;
  std::optional<Side> side;
  enum class Order { kNone, kAsSaid, kReversed } order = Order::kNone;  // of a row: "from left to right"
  bool of_room = false;                                                 // "in the corner of" a room, not of a thing
};

using PhraseSenses = std::vector<PhraseSense>;

// What a place says that no listed phrase stands for: what is placed before it, one sense for each type. One object for the whole run.
template <RelationType... types>
const PhraseSenses& direct_senses() {
  static const PhraseSenses senses{{types, PhraseSense::Direction::kDirect, {}, {}, {}}...};
  return senses;
}
// "two steps from the door", "a chair 50 cm away".
inline const PhraseSenses& distance_senses() {
  static const PhraseSenses senses{{RelationType::kDistance, PhraseSense::Direction::kDirect, {}, {}, {}},
                                   {RelationType::kDistance, PhraseSense::Direction::kAlone, {}, {}, {}}};
  return senses;
}

struct Match {
  std::size_t length = 0;  // tokens; 0 = none
  std::span<const Meaning> meanings;
  bool plural = false;  // matched by its singular
};

struct PhraseMatch {
  std::size_t length = 0;  // tokens, with those left out
  const PhraseSenses* senses = nullptr;
  bool each = false;        // "on each side of": every, each, both, either
  bool possessive = false;  // "on its left side": the reference is spoken of
  bool all = false;         // … every, all
  bool shared = false;      // … at each of so many, not just on so many
  int sides = 0;            // "on three sides of", "at each of its six sides": how many
  bool plural = false;      // "in the corners"
  bool one = false;         // "on one side of"
  bool other = false;       // "on the other side"
};

class Lexicon {
 public:
  explicit Lexicon(const Catalog& catalog);

  // The longest run of tokens from `at` that is a word of the lists. Hyphens and spaces count alike; the last word may be a plural.
  Match find(std::span<const Token> tokens, std::size_t at) const;
  // Only of one class, whatever else it may mean; length 0 if it is not.
  Match find(std::span<const Token> tokens, std::size_t at, WordClass word_class) const;
  // The longest relation phrase from `at`, articles, possessives and adverbs within it left out.
  PhraseMatch find_phrase(std::span<const Token> tokens, std::size_t at) const;

  // What a listed phrase says, or null.
  const PhraseSenses* senses_of(std::string_view phrase) const { return phrases_.find(phrase); }
  // "holds" of "held", or empty.
  std::string_view present_of(std::string_view word) const {
    const auto found = pasts_.find(std::string(word));
    return found == pasts_.end() ? std::string_view{} : std::string_view(found->second);
  }
  // "step", "arm length": how far that is in metres, 0 where it is no such thing.
  double stride_of(std::string_view words) const {
    const auto found = strides_.find(std::string(words));
    return found == strides_.end() ? 0 : found->second;
  }

  bool is(const Token& token, WordClass word_class) const;
  // "guest", "student", and the young of them: who a room is for.
  bool is_person(std::string_view word) const { return persons_.contains(std::string(word)) || is_young(word); }
  bool is_young(std::string_view word) const { return young_persons_.contains(std::string(word)); }
  // Whether the word stands in any list or phrase, by itself or as a part.
  bool knows(const std::string& word) const { return lists(word) || vocabulary().words.contains(word); }
  // … by itself, or as the beginning of a phrase; needs no vocabulary.
  bool lists(const std::string& word) const { return words_.contains(word) || phrase_starts_.contains(word); }
  // The known words of that many letters that begin with that letter.
  std::span<const std::string_view> words_like(char first, std::size_t length) const;
  // "scissors", "tongs": one thing, though the word is a plural.
  bool is_plural_only(std::string_view word) const { return plural_only_.contains(std::string(word)); }
  // "hang", "flank": a relation phrase that is a finite verb as it stands.
  bool is_place_verb(std::string_view word) const { return place_verbs_.contains(std::string(word)); }
  // Whether a list of words_grammar.json that says nothing of grammar has the word: "wishing" (who does that brings something in),
  // "closings" and "closing_leads" (of letters), "money", "name_verbs" (before a quoted name), "looking", "watching", "turning".
  bool is_in(std::string_view list, std::string_view word) const {
    const auto found = small_lists_.find(std::string(list));
    return found != small_lists_.end() && found->second.contains(std::string(word));
  }
  // What "a pair of" so called is, where it is one thing ("glasses"), or empty.
  std::string_view meant_by_pair(std::string_view word) const;
  // What a set consists of, the host first ("dining set": table, chairs), or nothing.
  using Set = std::vector<std::pair<const CatalogEntry*, int>>;
  const Set* set_of(std::string_view words) const;
  // The set that a name ends with, whatever goes before ("a round dining set"), or null.
  const Set* set_called(std::string_view name) const;
  // Who needs what in a kind of room, the main thing first, and for how many one is (0: one for all); nothing where that is not listed.
  const Set* needs_in(std::string_view room) const;
  // The kind of room that one kind becomes for children: a bedroom for two of them is a kids' room.
  std::string_view young_room(std::string_view room) const;
  // The kind of room that what begins at `at` is done in or is for ("watch movies", "my grandmother"), and the tokens it takes; 0 for none.
  std::pair<std::string_view, std::size_t> room_suggested(std::span<const Token> tokens, std::size_t at) const;
  // What a plain word means in rooms of that kind or name ("mat" in a gym), or null.
  const CatalogEntry* meant_in(const RoomKind& room, std::string_view name, std::string_view word) const;
  // What a common typing error stands for ("teh" → the, "infront" → in front), or empty.
  std::string_view meant_by(std::string_view word) const;
  const Catalog& catalog() const { return *catalog_; }
  // The entry that has exactly these words as one of its names; null: none.
  const CatalogEntry* entry_called(const std::string& words) const;

 private:
  struct Entry {
    std::uint32_t first = 0, count = 0;  // of meanings_
    std::uint32_t words = 0;             // in how many words it was listed, at most
  };
  std::span<const Meaning> meanings_of(const Entry& entry) const { return std::span(meanings_).subspan(entry.first, entry.count); }
  bool has(const Entry* entry, WordClass word_class) const;
  std::string without_owner(const std::string& key) const;
  void settle_meanings();
  // Words of a text: `length` of them from `at`.
  struct Stretch {
    std::span<const Token> tokens;
    std::size_t at, length;
    const Token& last() const { return tokens[at + length - 1]; }
  };
  bool may_stand(const Stretch& here, const Entry& entry) const;
  Match find_listed(const std::string& key, const Stretch& here) const;
  Match find_by_singular(const std::string& key, const Stretch& here) const;
  Match find_owned(const std::string& plain, const Stretch& here) const;
  bool may_run_together(std::span<const Token> tokens, std::size_t at, std::size_t length, const Entry& entry) const;
  void add(std::string_view words, const Meaning& meaning);
  void extend_phrase(std::span<const Token> tokens, std::size_t at, std::size_t i, const std::string& key, PhraseMatch so_far,
                     PhraseMatch& best) const;
  void extend_by_sides(std::span<const Token> tokens, std::size_t at, std::size_t i, const std::string& key, const PhraseMatch& so_far,
                       PhraseMatch& best) const;
  bool names_place(std::span<const Token> tokens, std::size_t at) const;
  void add_phrase(std::string_view words, PhraseSense sense);
  // The single words of all lists, which only spelling asks for; made when it first does.
  struct Vocabulary {
    std::string text;  // what the views look at
    std::unordered_set<std::string_view> words;
    std::unordered_map<std::size_t, std::vector<std::string_view>> by_shape;  // first letter and length
    static std::size_t shape(char first, std::size_t length) { return static_cast<unsigned char>(first) + (length << 8); }
  };
  const Vocabulary& vocabulary() const;
  void add_set(std::unordered_map<std::string, Set>& sets, const std::string& key, const WordList& members);
  void read_words();
  void read_room_knowledge();
  void read_phrases();

  const Catalog* catalog_;
  TextMap<Entry> words_;  // key_of
  std::vector<Meaning> meanings_;
  std::vector<std::pair<std::uint32_t, Meaning>> listed_meanings_;  // of which word, as they come; empty once all are read
  TextMap<PhraseSenses> phrases_;                                   // words joined by spaces
  TextMap<char> phrase_starts_;                                     // every beginning of a phrase
  std::unordered_map<std::string, Set> sets_;                       // key_of
  std::unordered_map<std::string, Set> needs_;                      // by room
  std::unordered_map<std::string, std::string> young_rooms_;
  std::unordered_map<std::string, std::string> activities_;           // words joined by spaces, room
  std::unordered_map<std::string, const CatalogEntry*> room_senses_;  // "room word"
  std::unordered_set<std::string> persons_, young_persons_, plural_only_, place_verbs_;
  std::unordered_map<std::string, std::unordered_set<std::string>> small_lists_;  // by the list's name
  std::unordered_map<std::string, std::string> pasts_;                            // what is no form by rule
  std::unordered_map<std::string, double> strides_;                               // metres
  std::unordered_map<std::string, std::string> pairs_meant_;
  std::string listed_;  // all that was listed, a line each
  std::string key_;     // of the word that is listed just now
  mutable std::once_flag vocabulary_made_;
  mutable Vocabulary vocabulary_;
  std::unordered_map<std::string, std::string> typing_errors_;
};

}  // namespace layoutbox::offline
