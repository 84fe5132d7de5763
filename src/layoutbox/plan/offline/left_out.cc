#include "layoutbox/plan/offline/left_out.h"

#include <algorithm>

#include "layoutbox/plan/offline/english.h"

namespace layoutbox::offline {
namespace {

bool was_used(const Document& document, const Chunk& chunk) {
  return std::any_of(document.readings.begin() + static_cast<std::ptrdiff_t>(chunk.first),
                     document.readings.begin() + static_cast<std::ptrdiff_t>(chunk.last),
                     [](const WordReading& r) { return r.use == WordReading::Use::kUsed; });
}

// A noun that might be furniture: named or counted, and not only what something is like or is for.
bool is_missed(const Document& document, const Chunk& chunk) {
  if (chunk.kind != ChunkKind::kNoun || was_used(document, chunk)) return false;
  const NounPhrase& noun = chunk.noun;
  const bool brought_in = noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kAnother || noun.count > 0;
  if (noun.kind == NounKind::kObject) return brought_in || noun.exact;
  return noun.kind == NounKind::kAbstract && noun.doubted && brought_in;
}

}  // namespace

void note_left_out(const Lexicon& lexicon, const Document& document, SceneGraph& scene) {
  (void)lexicon;
  std::string missed;
  std::size_t first = 0, last = 0;
  for (const Chunk& chunk : document.chunks) {
    if (!is_missed(document, chunk)) continue;
    if (missed.empty()) first = document.tokens[chunk.first].begin;
    last = document.tokens[chunk.last - 1].end;
    missed += (missed.empty() ? "\"" : ", \"") + words_between(document, chunk.first, chunk.last) + "\"";
  }
  if (!missed.empty())
    scene.notes.push_back({"left-out", "not placed: " + missed, "prompt:" + std::to_string(first) + "-" + std::to_string(last)});
  if (scene.objects.empty()) scene.notes.push_back({"warning", "nothing is named that stands in the room: it stays empty", "prompt"});
}

}  // namespace layoutbox::offline
