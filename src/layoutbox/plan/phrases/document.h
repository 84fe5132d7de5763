// What a text says, before it is a scene: things, mentions of them, and links between mentions.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "layoutbox/plan/phrases/chunks.h"
#include "layoutbox/plan/planner.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

// One object of the scene to be.
struct TextItem {
  NounPhrase noun;         // the words that brought it in
  int group = 0;           // items brought in together
  bool concluded = false;  // follows from the words ("a table for eight") without being named
};

// A place in the text that speaks of things or of a part of the room.
struct Mention {
  NounPhrase noun;
  std::vector<int> items;    // indices; empty for walls, corners, the room …
  bool introduces = false;   // its items are new here
  bool distributes = false;  // "each desk": what is said holds for every single one
  bool reciprocal = false;   // "each other": the targets themselves
};

struct Link {
  static constexpr int kAllSides = -1;
  enum class Kind {
    kRelation,  // targets stand PHRASE references
    kHave,      // references have targets: on, in, at or by them
    kHang,      // targets hang: on a wall or from the ceiling
  };
  Kind kind = Kind::kRelation;
  PhraseSenses senses;                   // as for TARGET phrase REFERENCE
  std::vector<int> targets, references;  // mentions
  bool each = false;                     // one (or as many as said) for every reference or side
  int sides = 0;                         // … so many sides; 0: not said, kAllSides: "on every side"
  bool sides_shared = false;             // … at each of them as many
  bool holding = false;                  // a have that says that the host carries ("holding", "filled with")
  bool one_side = false;                 // "on one side of": "on the other" may follow
  bool other_side = false;               // … and did
  bool weak = false;                     // a have that another link of the target makes needless
  bool soft = false;
  bool concluded = false;    // follows from the words without being said: support carried on, seats for so many
  bool assumed = false;      // does not follow, but is usual
  bool implied = false;      // the reference is not said: what was spoken of
  bool after_comma = false;  // ", with …"
  std::optional<double> distance;
  int rows = 0, columns = 0;  // of a grid
  bool gap = false;           // a distance between the references
  bool at_least = false, at_most = false;
  std::size_t first = 0, last = 0;  // tokens
};

// A part that goes out of the room's rectangle, or is cut out of it.
struct Niche {
  double width = 0, depth = 0;  // metres, as seen from the room
  bool cut = false;             // a notch
  std::string walls;            // "back right": in that corner; "left": in the middle of that wall; empty: not said
};

// A named part of the room: "a reading corner".
struct Zone {
  std::vector<int> items;           // that belong there
  bool corner = false;              // it is in a corner of the room
  std::size_t first = 0, last = 0;  // tokens
};

// What a wish wants of all of the room's things ("nothing in front of the window"), as it was said.
struct Ban {
  enum class Kind { kBackTo, kFreeOpening, kFreeWall, kFreeRegion, kFreeSide };
  Kind kind = Kind::kFreeRegion;
  std::string of;  // the opening ("door"), the wall's word, the thing by its name; empty: what was named last
  RoomRegion region = RoomRegion::kMiddle;
  std::vector<Side> sides;  // kFreeSide
  double depth = 0;         // metres; kFreeSide
  std::size_t first = 0;    // where it is said: a place in the prompt
  std::string words;
};

// "at (2, 1)", "x=2": where the middle of something is, metres from the room's left and from its front wall.
struct CoordinatesSaid {
  std::size_t begin = 0;  // byte place in the prompt
  std::optional<double> x, y;
};

// A thing that what somebody wants to do needs: "cook" a stove.
struct Wanted {
  const CatalogEntry* entry = nullptr;
  int count = 1;
};

struct Document {
  std::string prompt;
  std::vector<Token> tokens;
  std::vector<Chunk> chunks;
  std::vector<TextItem> items;
  std::vector<Mention> mentions;
  std::vector<Link> links;
  std::vector<NounPhrase> excluded;         // "no coffee table"
  std::vector<NounPhrase> rooms;            // kinds of room that were named, in order
  std::vector<NounPhrase> rooms_elsewhere;  // where somebody works
  std::vector<NounPhrase> openings;         // doors and windows that were spoken of
  std::vector<WordReading> readings;        // one a token
  std::vector<CloseReading> close;          // words that may as well mean something else
  std::vector<Note> notes;
  std::vector<Zone> zones;
  std::vector<Ban> bans;
  std::vector<std::size_t> size_said_at;  // places in the prompt of the words that said the room's size
  std::optional<Niche> niche;
  std::vector<CoordinatesSaid> coordinates;
  std::vector<Wanted> wanted;
  std::string wanted_room;  // the kind of room in which that is done; empty: nothing is wanted
  int people = 0;           // "an office for three": for how many the room is; 0: not said
  bool young = false;       // … children
  int groups = 0;
  StopFlag stop = nullptr;
};

// The words of tokens [first, last) as they were written.
std::string words_between(const Document& document, std::size_t first, std::size_t last);

// Reads the chunks of `document` into mentions, items and links.
void read_document(const Lexicon& lexicon, Document& document);

// One of these words stands at token `i`.
inline bool says_one_of(const Document& document, std::size_t i, std::initializer_list<std::string_view> words) {
  return i < document.tokens.size() && std::ranges::find(words, std::string_view(document.tokens[i].text)) != words.end();
}

inline bool says_one_of(const Document& document, std::size_t i, WordSet set) {
  return i < document.tokens.size() && one_of(document.tokens[i].text, set);
}

// "above the bakery is …", "next to the kitchen": where the room is, which is no such room itself; and "storage for diapers" is none.
inline bool names_another_place(const Document& document, const NounPhrase& room) {
  if (room.head == "storage" && says_one_of(document, room.last, {"for"})) return true;
  const std::size_t at = room.first;
  const bool definite = says_one_of(document, at, {"the", "my", "our", "his", "her", "their"});
  if (!definite || at == 0) return false;
  // "a teaching room in our community center"
  if (at > 1 && says_one_of(document, at - 1, {"in", "at", "inside"}) && says_one_of(document, at - 2, {"room", "office", "area"}))
    return true;
  const bool opens = at == 1 || document.tokens[at - 2].ends_sentence;
  if (opens && says_one_of(document, at - 1, {"above", "below", "over", "behind", "beside", "under", "opposite"})) return true;
  return at > 1 && (at == 2 || document.tokens[at - 3].ends_sentence) && says_one_of(document, at - 2, {"next", "close"}) &&
         says_one_of(document, at - 1, {"to"});
}

// The chunks that begin at tokens [first, last) have said what they had to say, in that role.
inline void take_chunks(Document& document, std::size_t first, std::size_t last, std::string_view role) {
  for (Chunk& chunk : document.chunks) {
    if (chunk.first < first || chunk.first >= last || chunk.kind == ChunkKind::kStop) continue;
    chunk.kind = ChunkKind::kIgnored;
    for (std::size_t i = chunk.first; i < chunk.last; ++i) {
      document.readings[i].use = WordReading::Use::kUsed;
      document.readings[i].role = role;
    }
  }
}

// Brings in `count` things of a kind that no words name ("for eight", "a reading corner"), at the words [first, last): their mention.
inline int bring_in(Document& document, const CatalogEntry& entry, int count, std::size_t first, std::size_t last) {
  Mention added;
  added.introduces = true;
  NounPhrase& noun = added.noun;
  noun.entry = &entry;
  noun.exact = true;
  noun.category = entry.id;
  noun.name = entry.name;
  noun.head = entry.name.substr(entry.name.rfind(' ') + 1);
  noun.count = count;
  noun.plural = count > 1;
  noun.first = first;
  noun.last = last;
  const int group = document.groups++;
  for (int i = 0; i < count; ++i) {
    added.items.push_back(static_cast<int>(document.items.size()));
    document.items.push_back({noun, group, true});
  }
  document.mentions.push_back(std::move(added));
  return static_cast<int>(document.mentions.size()) - 1;
}

}  // namespace layoutbox::offline
