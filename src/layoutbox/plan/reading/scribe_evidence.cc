// Whether a noun of no known kind is a thing of the room: where the text places, counts or lists it, or says that it is there.
// "Nobody will weigh the labrador" does nothing of that.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/reading/scribe.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {

// The sentence says more than what is there and where: it has a verb of its own.
bool Scribe::tells_more() const {
  const std::size_t first = sentence_->front().chunk, last = sentence_->back().chunk;
  for (std::size_t c = first; c-- > 0 && document_.chunks[c].kind != ChunkKind::kStop;) {
    if (document_.chunks[c].kind == ChunkKind::kUnknown || document_.chunks[c].kind == ChunkKind::kPurpose) return true;
  }
  for (std::size_t c = first; c < document_.chunks.size() && (c <= last || document_.chunks[c].kind != ChunkKind::kStop); ++c) {
    const ChunkKind kind = document_.chunks[c].kind;
    if (kind == ChunkKind::kUnknown || kind == ChunkKind::kPurpose || kind == ChunkKind::kVerb) return true;
  }
  return false;
}

// Nothing but a break, an opening or what places things stands before it.
bool Scribe::is_named_anew(int u) const {
  const NounPhrase& noun = chunk(u).noun;
  if (noun.count == 0 && noun.determiner != Determiner::kIndefinite && noun.determiner != Determiner::kAnother) return false;
  std::size_t before = unit(u).chunk;
  while (before > 0 && (document_.chunks[before - 1].kind == ChunkKind::kIgnored || document_.chunks[before - 1].kind == ChunkKind::kSoft))
    --before;
  if (before == 0) return true;
  const Chunk& last = document_.chunks[before - 1];
  return last.kind != ChunkKind::kUnknown && last.kind != ChunkKind::kPurpose && !(last.kind == ChunkKind::kVerb && last.passive);
}

bool Scribe::is_listed(int u) const {
  if (reading(u).former >= 0) return true;
  for (int other = u + 1; other < static_cast<int>(sentence_->size()); ++other) {
    if (is(other, UnitKind::kNoun) && reading(other).former == u) return true;
  }
  return false;
}

// An animal, which may be spoken of without being part of the room; a toy or a statue of one is a thing.
bool Scribe::is_living(const NounPhrase& noun) const {
  if (noun.entry != nullptr && noun.entry->is(Trait::kPet)) return true;
  const bool farm = noun.entry != nullptr && noun.entry->is(Trait::kAnimal);
  if (farm && noun.name == noun.head && noun_form(noun.head) == WordForm::kBody) return true;
  return !noun.exact && noun_form(noun.head) == WordForm::kBody && noun.attributes.empty() && noun.name == noun.head;
}

bool Scribe::is_evident(int u) const {
  const NounPhrase& noun = chunk(u).noun;
  const bool living = is_living(noun);
  const UnitReading& own = reading(u);
  // "my parrot lives in the cage", "the dog sleeps under it": whose animal it is comes and goes. "The dog by the stove" lies there.
  const bool owned = noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kPossessive;
  if (living && owned && noun.kind == NounKind::kObject && own.role == NounRole::kRoot && tells_more()) return false;
  // "the belly of a whale": what a part is of, where nothing is placed by it.
  if (noun.kind != NounKind::kObject) return own.role != NounRole::kRoot || own.placed || noun.kind == NounKind::kMember;
  if ((noun.exact && !living) || own.role != NounRole::kRoot || own.placed || own.predicate >= 0) return true;
  if (is(u - 1, UnitKind::kOpen) && unit(u - 1).chunk + 1 == unit(u).chunk && (!living || chunk(u - 1).kind == ChunkKind::kThere))
    return true;
  if (is_named_anew(u) || is_listed(u)) return true;
  for (int v = 0; v < static_cast<int>(sentence_->size()); ++v) {
    const bool verb = is(v, UnitKind::kVerb) || is(v, UnitKind::kParticiple) || is(v, UnitKind::kPlace);
    if (verb && reading(v).subject == u && !(is(v, UnitKind::kVerb) && chunk(v).passive)) return true;
  }
  return !tells_more();
}

// What the noun at u brought in goes again; `items`: how many there were before.
void Scribe::forget(int u, int mention, std::size_t items) {
  document_.items.resize(items);
  Mention& made = mention_at(mention);
  made.items.clear();
  made.introduces = false;
  NounPhrase& noun = document_.chunks[unit(u).chunk].noun;
  noun.kind = made.noun.kind = NounKind::kAbstract;
  noun.doubted = noun.unplaced = true;
}

}  // namespace layoutbox::offline
