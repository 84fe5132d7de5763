// What plain words mean in a kind of room.
#include <algorithm>

#include "layoutbox/plan/offline/people.h"

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

}  // namespace

void settle_room_senses(const Lexicon& lexicon, Document& document) {
  settle_first_room(lexicon, document);
  settle_only_noun(lexicon, document);
  const NounPhrase* room = nullptr;
  for (const Chunk& chunk : document.chunks) {
    if (chunk.kind != ChunkKind::kNoun || chunk.noun.kind != NounKind::kRoom || chunk.noun.room == nullptr) continue;
    room = &chunk.noun;
    break;
  }
  if (room == nullptr) return;
  std::string name = room->name;
  for (const std::string_view article : {"a ", "an ", "the ", "my ", "our ", "this "}) {
    if (name.starts_with(article)) name.erase(0, article.size());
  }
  for (std::size_t k = 0; k < document.chunks.size(); ++k) {
    const Chunk& chunk = document.chunks[k];
    NounPhrase& noun = document.chunks[k].noun;
    if (chunk.kind != ChunkKind::kNoun || noun.head.empty()) continue;
    const bool plain = noun.kind == NounKind::kObject && noun.exact && noun.name == noun.head;
    const bool said = noun.determiner != Determiner::kNone || noun.count > 0 || noun.plural;
    const bool unknown = noun.entry == nullptr && said && (noun.kind == NounKind::kObject || noun.kind == NounKind::kAbstract) &&
                         (noun.name == noun.head || noun.name.ends_with(" " + noun.head)) && noun.last <= noun.first + 3;
    if (!plain && !unknown) continue;
    const CatalogEntry* entry = lexicon.meant_in(*room->room, name, document.tokens[noun.last - 1].text);  // "benches"
    if (entry == nullptr) entry = lexicon.meant_in(*room->room, name, noun.head);
    if (entry == nullptr) continue;
    // "a changing mat" is another kind of mat.
    const bool of_use =
        std::any_of(noun.attributes.begin(), noun.attributes.end(), [](const std::string& a) { return a.ends_with("ing"); });
    if (of_use) continue;
    // "a bench with a towel on it" is none to train on.
    const bool has_things = k + 1 < document.chunks.size() && document.chunks[k + 1].kind == ChunkKind::kHave;
    if (has_things && noun.entry != nullptr && noun.entry->top_carries && !entry->top_carries) continue;
    noun.kind = NounKind::kObject;
    noun.entry = entry;
    noun.category = entry->id;
    noun.name = noun.head;
    noun.exact = true;
  }
}

}  // namespace layoutbox::offline
