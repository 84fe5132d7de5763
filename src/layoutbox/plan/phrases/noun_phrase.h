// Noun phrases: determiner, count, attributes, compound head, "of" phrases, sizes.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "layoutbox/plan/words/lexicon.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox::offline {

enum class NounKind {
  kObject,
  kWall,
  kCorner,
  kCenter,
  kFloor,
  kCeiling,
  kDoor,
  kWindow,
  kRoom,         // the room itself, by its kind or as "room", "space"
  kOutsideRoom,  // "walk-in closet": not in this room
  kPart,         // of a thing: legs, drawers, its left side
  kAbstract,     // comfort, seating area, touch
  kPronoun,      // it, them, which
  kMember,       // "one", "the other one", "the left one", "each", "two of them"
};

enum class Determiner { kNone, kDefinite, kIndefinite, kPossessive, kEach, kBoth, kAnother, kOther, kNo };

// Which of several, by where they stand among each other.
enum class Rank { kAny, kFirst, kMiddle, kLast, kEnds };

// Lengths said of a thing, in metres.
struct SaidSize {
  std::optional<double> width, depth, height, length;
  std::optional<double> span;  // "a 60-inch desk": its longest side; of a screen the diagonal
  bool either = false;         // width and depth as they came ("4 x 6 ft"): the longer one is the thing's own longer side
  bool any() const { return width || depth || height || length || span; }
};

struct NounPhrase {
  NounKind kind = NounKind::kObject;
  Determiner determiner = Determiner::kNone;
  const CatalogEntry* entry = nullptr;  // what it is, or what it most resembles
  bool exact = false;                   // the entry is that very kind
  const RoomKind* room = nullptr;
  std::string owner_word;            // "dentist" of "the dentist's stool"
  std::string category, name, head;  // head: the last word in the singular
  std::vector<std::string> attributes;
  std::vector<WordClass> attribute_classes;
  int count = 0;           // 0: not said
  int ordinal = 0;         // "the second bed"; -1: the last
  Rank rank = Rank::kAny;  // "the middle one", "the outer two"
  int share = 0;           // "half of them": 2, "a third of the jars": 3
  int every = 0;           // "every other chair": 2
  int rows = 0;            // "two rows of chairs", "a row of three stools"
  int seats = 0;           // "a table for six"
  int clusters = 0;        // "two clusters of four desks"
  int together = 0;        // "desks in groups of four"
  int apart = 0;           // "between the groups": one of each group, which has so many
  bool at_least = false, vague = false, plural = false;
  bool filling = false;        // "a shelf full of cans": as many as look like it, two of them for certain
  bool everywhere = false;     // "books everywhere": on tops, and on the floor as well
  bool assorted = false;       // "plants of all sizes"
  bool heaped = false;         // "a stack of menus": several that lie as one thing
  bool subset = false;         // "two of the beds"
  bool reciprocal = false;     // "each other"
  bool doubted = false;        // taken for no thing by what English says of the word alone: no list of ours has it
  bool unplaced = false;       // … or by what the text says of it: neither where it is nor that it is there
  bool collective = false;     // "items", "essentials": things where something holds them
  bool niche = false;          // an alcove, a notch: a part of the room's outline
  std::string wall_word;       // left, right, back, front
  std::optional<double> sill;  // of a window: how high, metres
  SaidPlace place;             // in figures, or of a door or window along that wall
  std::string wall_relation;   // opposite, other, adjacent, same
  SaidSize size;
  std::optional<double> hangs_at;         // "a shelf at 1.2 m": metres above the floor
  std::shared_ptr<NounPhrase> of;         // "the corner of the desk", "two of the beds"
  std::shared_ptr<NounPhrase> contents;   // "a rack of dumbbells": what is in it
  std::shared_ptr<NounPhrase> as_object;  // of a part: the thing that has its name ("two sinks"), should no host be there
  bool owner = false;                     // followed by 's
  std::size_t first = 0, last = 0;        // tokens [first, last)
  std::vector<int> items;                 // of the document, where it is known beforehand what is meant: things that are in the room
  bool is_plural() const { return count > 1 || (count == 0 && plural); }
};

// Reads the noun phrase that begins at `at`, or nothing. `bare` allows one without a determiner or count.
std::optional<NounPhrase> read_noun_phrase(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at, bool bare);

// A number in digits or words ("5", "five", "5 and a half", "5 1/2", "half a") and the tokens it takes, 0 for none.
struct NumberRead {
  double value = 0;
  std::size_t length = 0;
};
NumberRead read_number(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at);

// "1.2 m", "120 cm", "4 feet": metres and the tokens it takes.
struct Measure {
  double metres = 0;
  std::size_t length = 0;
};
std::optional<Measure> read_measure(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at);

constexpr double kFoot = 0.3048, kInch = 0.0254;  // metres

// "6 x 5 m", "12 by 14 feet", "4 m wide by 3 m deep": the sides in the order they stand; empty where `at` begins no such thing. Numbers
// without a unit take that of another one; without any it is metres, or feet where a side would be longer than 20, or centimetres (90).
struct SidesRead {
  std::vector<double> sides;    // metres
  std::vector<double> numbers;  // as they stand
  std::size_t length = 0;       // tokens
  bool united = false;          // a unit is said
};
SidesRead read_sides(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at);

// "120 cm wide": adds to `size`; the tokens it takes, 0 for none.
std::size_t read_size(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at, SaidSize& size);

// "with a diameter of 1.2 m", "of at least 1.6 m width", "no wider than 1 m": adds to `size`; the tokens it takes, 0 for none.
std::size_t read_size_of(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at, SaidSize& size);

// Whether a noun phrase may go on at `at`: no preposition, no verb, no punctuation.
bool noun_goes_on(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at);

// A size before its noun: "4x6 ft", "120 x 60 cm", "60 inch", "120-cm", "2 m wide". Adds to `size`; the tokens it takes, 0 for none.
std::size_t read_size_before(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at, SaidSize& size);

// "and" at that token, before one more wall: "the north AND east walls".
bool joins_walls(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at);

}  // namespace layoutbox::offline
