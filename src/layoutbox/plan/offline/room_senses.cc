// What plain words mean in a kind of room.
#include <algorithm>
#include <array>
#include <memory>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/catalog/word_lists.h"
#include "layoutbox/plan/offline/people.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {

namespace {

// "A hallway with a console table": what a text begins with is the room, not one beside it.
void settle_first_room(const Lexicon& lexicon, Document& document) {
  for (Chunk& chunk : document.chunks) {
    if (chunk.kind != ChunkKind::kNoun) continue;
    NounPhrase& noun = chunk.noun;
    for (std::size_t i = noun.first; noun.kind == NounKind::kOutsideRoom && i < noun.last; ++i) {
      const Match match = lexicon.find(document.tokens, i, WordClass::kRoom);
      if (match.length == 0) continue;
      const auto meaning = std::find_if(match.meanings.begin(), match.meanings.end(), [](const Meaning& m) { return m.room != nullptr; });
      if (meaning == match.meanings.end()) continue;
      noun.kind = NounKind::kRoom;
      noun.room = meaning->room;
    }
    return;
  }
}

// "A bar.": where one noun is all there is, and rooms are called so, it is the room.
void settle_only_noun(const Lexicon& lexicon, Document& document) {
  Chunk* only = nullptr;
  for (Chunk& chunk : document.chunks) {
    if (chunk.kind == ChunkKind::kStop || chunk.kind == ChunkKind::kIgnored || chunk.kind == ChunkKind::kCommand) continue;
    if (chunk.kind != ChunkKind::kNoun || only != nullptr) return;
    only = &chunk;
  }
  if (only == nullptr || only->noun.kind != NounKind::kObject || only->noun.count > 1) return;
  NounPhrase& noun = only->noun;
  for (std::size_t i = noun.first; i < noun.last; ++i) {
    const Match match = lexicon.find(document.tokens, i);
    const auto room = std::find_if(match.meanings.begin(), match.meanings.end(), [](const Meaning& m) { return m.room != nullptr; });
    if (room == match.meanings.end() || i + match.length != noun.last) continue;
    noun.kind = NounKind::kRoom;
    noun.room = room->room;
    return;
  }
}

// The chunk that follows `at`, but for what says nothing and for whom or what it is for.
const Chunk* next_said(const std::vector<Chunk>& chunks, std::size_t at) {
  bool purpose = false;
  for (std::size_t k = at + 1; k < chunks.size(); ++k) {
    purpose = purpose || chunks[k].kind == ChunkKind::kPurpose;
    const bool goes_on = purpose && (chunks[k].kind == ChunkKind::kPurpose || chunks[k].kind == ChunkKind::kNoun);
    if (chunks[k].kind != ChunkKind::kIgnored && !goes_on) return &chunks[k];
  }
  return nullptr;
}

// "Inside the yurt a stove stands in the middle. …": where no room is named, what a text begins by going into is the room, unless it is a
// thing that is known.
void settle_gone_into(const Lexicon& lexicon, Document& document) {
  std::vector<Chunk>& chunks = document.chunks;
  std::size_t first = 0;
  while (first < chunks.size() && chunks[first].kind == ChunkKind::kIgnored) ++first;
  if (first + 1 >= chunks.size() || chunks[first].kind != ChunkKind::kRelation || chunks[first + 1].kind != ChunkKind::kNoun) return;
  if (!says_one_of(document, chunks[first].first, {"in", "inside", "within"}) || chunks[first].last != chunks[first].first + 1) return;
  NounPhrase& noun = chunks[first + 1].noun;
  const Match match = lexicon.find(document.tokens, noun.last - 1);
  const auto room = std::ranges::find_if(match.meanings, [](const Meaning& m) { return m.room != nullptr; });
  const bool place = room != match.meanings.end() || !noun.exact;
  if (noun.kind != NounKind::kObject || !place || noun.determiner != Determiner::kDefinite || noun.is_plural() || noun.count > 1) return;
  noun.kind = NounKind::kRoom;
  noun.entry = nullptr;
  noun.head = noun.name;
  if (room != match.meanings.end()) noun.room = room->room;
}

// "A chemistry lab module": the room that is named within it.
const RoomKind* room_within(const Lexicon& lexicon, const std::vector<Token>& tokens, const NounPhrase& noun) {
  for (std::size_t i = noun.first; i < noun.last; ++i) {
    const Match match = lexicon.find(tokens, i, WordClass::kRoom);
    const Meaning* room = meaning_of(match, WordClass::kRoom);
    if (room != nullptr && i + match.length <= noun.last) return room->room;
  }
  return nullptr;
}

// "Cell of a monk who copies books: …", "Booth of a ticket seller: …": whose it is, and then what is in it.
bool is_somebodys(const Document& document, std::size_t topic) {
  const NounPhrase& noun = document.chunks[topic].noun;
  bool owned = false;
  for (std::size_t i = noun.first + 1; i < noun.last; ++i) owned |= document.tokens[i].text == "of";
  const std::string& who = document.tokens[noun.last - 1].text;
  if (!owned || (word_form(who) != WordForm::kPerson && noun_form(who) != WordForm::kPerson)) return false;
  constexpr double kHoldsPeople = 1e6;  // mm² of floor: a bust of somebody is no room
  if (noun.exact && noun.entry != nullptr && double(noun.entry->size.usual.width) * noun.entry->size.usual.depth < kHoldsPeople)
    return false;
  for (std::size_t k = topic + 1; k < document.chunks.size() && document.chunks[k].kind != ChunkKind::kStop; ++k) {
    if (document.chunks[k].kind == ChunkKind::kComma) return document.tokens[document.chunks[k].first].text == ":";
  }
  return false;
}

// "A cell for prayer. …", "Storage unit, 10 x 10 ft. …": where no room is named, what a text opens with is the room, if it is nothing to
// put into one or is given a room's size (`size_said_at`).
void settle_topic(const Lexicon& lexicon, Document& document) {
  const auto names_room = [](const Chunk& c) {
    return c.kind == ChunkKind::kNoun && c.noun.kind == NounKind::kRoom && c.noun.room != nullptr;
  };
  if (std::ranges::any_of(document.chunks, names_room)) return;
  settle_gone_into(lexicon, document);
  std::size_t first = 0;
  while (first < document.chunks.size() && document.chunks[first].kind == ChunkKind::kIgnored) ++first;
  const Chunk* next = next_said(document.chunks, first);
  if (next == nullptr || document.chunks[first].kind != ChunkKind::kNoun) return;
  NounPhrase& noun = document.chunks[first].noun;
  const bool new_here =
      noun.determiner == Determiner::kNone || noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kPossessive;
  const bool thing = noun.kind == NounKind::kObject || (noun.kind == NounKind::kAbstract && noun.doubted);
  if (!thing || !new_here || noun.is_plural() || noun.count > 1) return;
  const std::vector<Token>& tokens = document.tokens;
  const bool sized = std::ranges::any_of(document.size_said_at, [&](std::size_t at) {
    return at >= tokens[noun.last - 1].end && at < tokens[std::min(next->last, tokens.size() - 1)].begin;
  });
  const bool unknown =
      !noun.exact && kin_of(lexicon.catalog(), noun.head) == nullptr && next->kind == ChunkKind::kStop && next != &document.chunks.back();
  const bool ends = next->kind == ChunkKind::kStop || next->kind == ChunkKind::kComma;
  if (!(ends && (unknown || sized)) && !is_somebodys(document, first)) return;
  noun.kind = NounKind::kRoom;
  noun.entry = nullptr;
  noun.head = noun.name;
  noun.room = room_within(lexicon, tokens, noun);
}

// Does an item of a list begin with the chunk at `k`?
bool opens_item(const std::vector<Chunk>& chunks, std::size_t k) {
  return k == 0 ||
         std::ranges::count(std::array{ChunkKind::kComma, ChunkKind::kStop, ChunkKind::kHave, ChunkKind::kAnd}, chunks[k - 1].kind) > 0;
}

// "boxing gym, ring in the middle": what is mostly a verb is a thing where such rooms have one.
void name_listed_words(const Lexicon& lexicon, Document& document, const RoomKind& room, const std::string& name) {
  for (std::size_t k = 0; k < document.chunks.size(); ++k) {
    Chunk& chunk = document.chunks[k];
    if ((chunk.kind != ChunkKind::kVerb && chunk.kind != ChunkKind::kUnknown) || chunk.last != chunk.first + 1 ||
        !opens_item(document.chunks, k))
      continue;
    const std::string& word = document.tokens[chunk.first].text;
    if (lexicon.meant_in(room, name, word) == nullptr) continue;
    chunk.kind = ChunkKind::kNoun;
    chunk.noun = {};
    chunk.noun.name = chunk.noun.head = word;
    chunk.noun.first = chunk.first;
    chunk.noun.last = chunk.last;
  }
}

NounPhrase* first_known_room(Document& document) {
  for (Chunk& chunk : document.chunks) {
    const bool known = chunk.kind == ChunkKind::kNoun && chunk.noun.kind == NounKind::kRoom && chunk.noun.room != nullptr;
    if (known && !names_another_place(document, chunk.noun)) return &chunk.noun;
  }
  return nullptr;
}

bool is_in(const WordList& list, std::string_view text) {
  for (const WordList::Member one : list) {
    if (one.value.text() == text) return true;
  }
  return false;
}

// Is one of those words said in the sentence of the room that [first, last) names, and not far from it?
bool is_told(const std::vector<Token>& tokens, const NounPhrase& room, const WordList& words) {
  constexpr std::size_t kNear = 12;  // tokens
  std::size_t first = room.first, last = room.last;
  while (first > 0 && room.first - first < kNear && !tokens[first - 1].ends_sentence) --first;
  while (last < tokens.size() && last - room.last < kNear && !tokens[last - 1].ends_sentence) ++last;
  return std::any_of(tokens.begin() + static_cast<std::ptrdiff_t>(first), tokens.begin() + static_cast<std::ptrdiff_t>(last),
                     [&](const Token& token) { return is_in(words, token.text) || is_in(words, singular_of(token.text)); });
}

// "Vet clinic exam room", "the tea room of a samurai house": what a room's name means by the words that stand by it.
void settle_told_room(const Lexicon& lexicon, Document& document) {
  NounPhrase* room = first_known_room(document);
  const auto plain = std::ranges::find_if(document.chunks, [](const Chunk& c) {
    return c.kind == ChunkKind::kNoun && c.noun.kind == NounKind::kRoom && c.noun.room == nullptr;
  });
  if (room == nullptr && plain != document.chunks.end()) room = &plain->noun;
  if (room == nullptr) return;
  const std::string_view named = room->room == nullptr ? std::string_view() : std::string_view(room->room->id);
  for (const WordList::Member row : word_list("words_room").at("rooms_told")) {
    if (!is_in(row.value.at("of"), named) || !is_told(document.tokens, *room, row.value.at("by"))) continue;
    room->room = lexicon.catalog().find_room(row.value.at("is").text());
    return;
  }
}

// What the words mean in that room, by the whole name (`named`) or by its last word. "A minimalist Japanese bedroom" is a Japanese bedroom.
const CatalogEntry* meant_here(const Lexicon& lexicon, const RoomKind& room, std::string called, const NounPhrase& noun,
                               const std::string& last_word, bool named) {
  for (;; called.erase(0, called.find(' ') + 1)) {
    const CatalogEntry* entry = lexicon.meant_in(room, called, named ? noun.name : last_word);  // "benches"
    if (entry == nullptr && !named) entry = lexicon.meant_in(room, called, noun.head);
    if (entry != nullptr || called.find(' ') == std::string::npos) return entry;
  }
}

// "a pottery studio with six wheels": no part of something, and none of a car.
void mean_part(const Lexicon& lexicon, const RoomKind& room, const std::string& name, NounPhrase& part) {
  const CatalogEntry* entry = meant_here(lexicon, room, name, *part.as_object, part.as_object->head, false);
  if (entry == nullptr) return;
  auto object = std::make_shared<NounPhrase>(*part.as_object);
  object->entry = entry;
  object->category = entry->id;
  object->exact = true;
  part.as_object = std::move(object);
}

// On its top, or beside its bowl.
bool carries_things(const CatalogEntry& entry) {
  return entry.top_carries || std::ranges::any_of(entry.spaces, [](const SpaceFormula& space) { return space.carries; });
}

constexpr double kPupilsWidth = 0.7, kPupilsDepth = 0.5;  // m (EN 1729-1: 600 x 500 mm at least)

// "desks in groups of four, my desk by the board": whoever teaches there has one of another kind.
void name_own_desk(const Lexicon& lexicon, Document& document, const RoomKind& room) {
  const Lexicon::Set* needs = lexicon.needs_in(room.id);
  const CatalogEntry* own = lexicon.catalog().find("teacher_desk");
  if (needs == nullptr || needs->front().first->id != "school_desk" || own == nullptr) return;
  for (Chunk& chunk : document.chunks) {
    NounPhrase& noun = chunk.noun;
    if (chunk.kind != ChunkKind::kNoun || noun.name != "desk" || noun.plural || noun.determiner != Determiner::kPossessive) continue;
    if (!one_of(document.tokens[noun.first].text, {"my", "our", "her", "his"})) continue;
    noun.entry = own;
    noun.category = own->id;
    noun.name = own->name;
  }
}

// "a long wooden bench" of a gym: a plain one, not the kind that nobody rests on.
bool is_to_sit_on(const Lexicon& lexicon, const NounPhrase& noun, const CatalogEntry& meant) {
  const bool other_use =
      noun.entry != nullptr && noun.entry->is(Trait::kSeat) && !meant.is(Trait::kSeat) && lexicon.catalog().is_a(meant.id, noun.entry->id);
  return other_use && std::ranges::any_of(noun.attributes, [](const std::string& a) { return one_of(a, WordSet::kSeatLooks); });
}

// "a small table" of a clinic is none to lie on.
bool is_said_small(const NounPhrase& noun) {
  return std::ranges::any_of(noun.attributes, [](const std::string& a) { return one_of(a, {"small", "little", "tiny", "low", "round"}); });
}

// Whether the noun at chunk k stays what it is, though its word means `entry` in such a room.
bool keeps_its_kind(const Lexicon& lexicon, Document& document, std::size_t k, const CatalogEntry& entry) {
  NounPhrase& noun = document.chunks[k].noun;
  // "a changing mat" is another kind of mat.
  const bool of_use = std::any_of(noun.attributes.begin(), noun.attributes.end(), [](const std::string& a) { return a.ends_with("ing"); });
  if (of_use) return true;
  // "a bench with a towel on it" is none to train on.
  const bool has = k + 2 < document.chunks.size() && document.chunks[k + 1].kind == ChunkKind::kHave;
  const CatalogEntry* first = has ? document.chunks[k + 2].noun.entry : nullptr;
  const bool has_things = has && (first == nullptr || first->mount != Mount::kWall);  // "a vanity with a mirror"
  if (has_things && noun.entry != nullptr && noun.entry->top_carries && !carries_things(entry)) return true;
  if (entry.is(Trait::kLieOn) && is_said_small(noun)) return true;
  if (is_to_sit_on(lexicon, noun, entry)) return true;
  if (noun.seats > 1 && noun.head == "desk") return true;                 // of a class, put together to a table
  if ((noun.together > 3 || noun.clusters > 1) && noun.head == "desk") {  // … or in islands, each with its chair before it
    if (!noun.size.any()) noun.size.width = kPupilsWidth, noun.size.depth = kPupilsDepth;
    return true;
  }
  return false;
}

}  // namespace

void settle_room_senses(const Lexicon& lexicon, Document& document) {
  settle_first_room(lexicon, document);
  settle_only_noun(lexicon, document);
  settle_topic(lexicon, document);
  settle_told_room(lexicon, document);
  const NounPhrase* room = first_known_room(document);
  if (room == nullptr) return;
  std::string name = room->name;
  for (const std::string_view article : {"a ", "an ", "the ", "my ", "our ", "this "}) {
    if (name.starts_with(article)) name.erase(0, article.size());
  }
  name_listed_words(lexicon, document, *room->room, name);
  name_own_desk(lexicon, document, *room->room);
  for (std::size_t k = 0; k < document.chunks.size(); ++k) {
    const Chunk& chunk = document.chunks[k];
    NounPhrase& noun = document.chunks[k].noun;
    if (chunk.kind != ChunkKind::kNoun || noun.head.empty()) continue;
    if (noun.as_object != nullptr) mean_part(lexicon, *room->room, name, noun);
    // A name of several words only where the table has all of it: "swivel chair".
    const bool named = noun.kind == NounKind::kObject && noun.exact && noun.name != noun.head;
    const bool plain = noun.kind == NounKind::kObject && noun.exact && noun.name == noun.head;
    const bool said = opens_item(document.chunks, k) || noun.determiner != Determiner::kNone || noun.count > 0 || noun.plural;
    const bool unknown = (noun.entry == nullptr || (!noun.exact && noun.name == noun.head)) && said &&
                         (noun.kind == NounKind::kObject || noun.kind == NounKind::kAbstract) &&
                         (noun.name == noun.head || noun.name.ends_with(" " + noun.head)) && noun.last <= noun.first + 4;
    // "an island bench": a kind of bench that the catalogue does not know
    const bool compound =
        noun.kind == NounKind::kObject && noun.entry != nullptr && noun.entry->name == noun.head && noun.name.ends_with(" " + noun.head);
    // "a salon with a sofa by the reception": no room of its own
    const bool other_room =
        noun.kind == NounKind::kRoom && noun.room != nullptr && noun.room != room->room && noun.name.ends_with(noun.head);
    if (!plain && !unknown && !compound && !other_room && !named) continue;
    const CatalogEntry* entry = meant_here(lexicon, *room->room, name, noun, document.tokens[noun.last - 1].text, named);
    if (entry == nullptr) continue;
    if (keeps_its_kind(lexicon, document, k, *entry)) continue;
    noun.kind = NounKind::kObject;
    noun.entry = entry;
    noun.category = entry->id;
    noun.name = noun.head;
    noun.exact = true;
  }
}

}  // namespace layoutbox::offline
