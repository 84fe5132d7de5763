#include "layoutbox/plan/offline/left_out.h"

#include <algorithm>

#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {
namespace {

bool was_used(const Document& document, const Chunk& chunk) {
  const bool brought_in = std::any_of(document.items.begin(), document.items.end(),
                                      [&](const TextItem& item) { return item.noun.first >= chunk.first && item.noun.first < chunk.last; });
  return brought_in || std::any_of(document.readings.begin() + static_cast<std::ptrdiff_t>(chunk.first),
                                   document.readings.begin() + static_cast<std::ptrdiff_t>(chunk.last),
                                   [](const WordReading& r) { return r.use == WordReading::Use::kUsed; });
}

// "a 1.5 m turning circle": so large, and so not told by the way.
bool is_measured(const Lexicon& lexicon, const Document& document, const Chunk& chunk) {
  for (std::size_t i = chunk.first; i + 1 < chunk.last; ++i) {
    if (document.tokens[i].kind == Token::Kind::kNumber && lexicon.is(document.tokens[i + 1], WordClass::kUnit)) return true;
  }
  return false;
}

// "an office with a desk and cables": what the room has, though elsewhere it is a part of things.
bool is_part_of_no_thing(const Document& document, std::size_t k) {
  const NounPhrase& noun = document.chunks[k].noun;
  if (noun.kind != NounKind::kPart || !noun.plural || noun.of || word_form(noun.head) != WordForm::kThing) return false;
  for (std::size_t c = k; c-- > 0;) {
    const Chunk& before = document.chunks[c];
    if (before.kind == ChunkKind::kHave) return c > 0 && document.chunks[c - 1].noun.kind == NounKind::kRoom;
    if (before.kind != ChunkKind::kNoun && before.kind != ChunkKind::kComma && before.kind != ChunkKind::kAnd) return false;
  }
  return false;
}

// "the acoustics matter": what a clause is about.
bool tells_of_it(const Document& document, std::size_t k) {
  const NounPhrase& noun = document.chunks[k].noun;
  if (noun.determiner != Determiner::kDefinite || k + 1 >= document.chunks.size()) return false;
  const ChunkKind before = k == 0 ? ChunkKind::kStop : document.chunks[k - 1].kind, after = document.chunks[k + 1].kind;
  const bool begins =
      before == ChunkKind::kStop || before == ChunkKind::kAnd || before == ChunkKind::kClause || before == ChunkKind::kComma;
  return begins && after != ChunkKind::kHave;
}

// A noun that might be furniture: named or counted, and not only what something is like or is for ("a wardrobe for clothes").
bool is_missed(const Lexicon& lexicon, const Document& document, std::size_t k) {
  const Chunk& chunk = document.chunks[k];
  if (chunk.kind == ChunkKind::kNoun && is_part_of_no_thing(document, k)) return true;
  if (chunk.kind != ChunkKind::kNoun || was_used(document, chunk)) return false;
  const NounPhrase& noun = chunk.noun;
  const bool new_here = noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kAnother || noun.count > 0;
  const bool purpose = k > 0 && document.chunks[k - 1].kind == ChunkKind::kPurpose;
  if (noun.kind == NounKind::kAbstract)  // "for a factory", "a place for my cats" say for whom or what it is
    return !purpose && word_form(noun.head) != WordForm::kPerson &&
           (is_measured(lexicon, document, chunk) || (noun.doubted && (new_here || noun.unplaced || tells_of_it(document, k))));
  if (noun.kind != NounKind::kObject || (purpose && !noun.exact)) return false;
  const bool unknown = !noun.exact && noun.determiner == Determiner::kDefinite;  // "nobody will weigh the labrador"
  const bool named = unknown && std::any_of(document.items.begin(), document.items.end(),
                                            [&](const TextItem& item) { return item.noun.head == noun.head; });
  if (new_here || (unknown && !named)) return true;
  const bool there = noun.entry != nullptr && std::any_of(document.items.begin(), document.items.end(), [&](const TextItem& item) {
                       return item.noun.entry != nullptr && lexicon.catalog().is_a(item.noun.entry->id, noun.entry->id);
                     });
  const bool in_list = k > 0 && document.chunks[k - 1].kind != ChunkKind::kPurpose;
  // "…, timber rack on the left wall": an item of a list, though only of a known kind
  const bool item = k > 0 && document.chunks[k - 1].kind == ChunkKind::kComma && noun.entry != nullptr && !noun.doubted;
  return (noun.exact || item) && in_list && !there && noun.determiner == Determiner::kNone;
}

}  // namespace

void note_left_out(const Lexicon& lexicon, const Document& document, SceneGraph& scene) {
  std::string missed;
  std::size_t first = 0, last = 0;
  for (std::size_t k = 0; k < document.chunks.size(); ++k) {
    if (!is_missed(lexicon, document, k)) continue;
    const Chunk& chunk = document.chunks[k];
    if (missed.empty()) first = document.tokens[chunk.first].begin;
    last = document.tokens[chunk.last - 1].end;
    missed += (missed.empty() ? "\"" : ", \"") + words_between(document, chunk.first, chunk.last) + "\"";
  }
  if (!missed.empty())
    scene.notes.push_back({"left-out", "not placed: " + missed, "prompt:" + std::to_string(first) + "-" + std::to_string(last)});
  if (scene.objects.empty()) scene.notes.push_back({"warning", "nothing is named that stands in the room: it stays empty", "prompt"});
}

}  // namespace layoutbox::offline
