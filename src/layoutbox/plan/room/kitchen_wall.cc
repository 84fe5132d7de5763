#include "layoutbox/plan/room/kitchen_wall.h"

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

std::string wall_of_kitchen(const Document& document) {
  const std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 0; k + 2 < chunks.size(); ++k) {
    const NounPhrase& room = chunks[k].noun;
    if (chunks[k].kind != ChunkKind::kNoun || room.room == nullptr || room.room->id != "kitchen") continue;
    std::size_t n = k + 1;
    while (n < chunks.size() && (chunks[n].kind == ChunkKind::kIgnored || chunks[n].kind == ChunkKind::kVerb)) ++n;
    if (n + 1 >= chunks.size() || chunks[n].kind != ChunkKind::kRelation) continue;
    const std::string& side = document.tokens[chunks[n].last - (document.tokens[chunks[n].last - 1].text == "side" ? 2 : 1)].text;
    if (one_of(side, {"left", "right"})) return side;
    if (side == "end" && chunks[n].phrase.one) return "left";  // "the kitchen is at one end"
    if (chunks[n + 1].kind != ChunkKind::kNoun) continue;
    if (chunks[n + 1].noun.kind == NounKind::kWall) return chunks[n + 1].noun.wall_word;
  }
  return {};
}

}  // namespace layoutbox::offline
