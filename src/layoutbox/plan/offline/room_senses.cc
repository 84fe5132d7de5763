// What plain words mean in a kind of room.
#include "layoutbox/plan/offline/people.h"

namespace layoutbox::offline {

void settle_room_senses(const Lexicon& lexicon, Document& document) {
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
