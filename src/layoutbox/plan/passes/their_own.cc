#include "layoutbox/plan/passes/their_own.h"

#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/passes/for_each.h"

namespace layoutbox::offline {
namespace {

constexpr int kMostOwn = 60;

// What each has for himself: a bed, a desk, a locker, an easel; no table and no shelves.
bool is_for_one(const NounPhrase& noun) {
  if (noun.entry == nullptr || noun.entry->mount != Mount::kFloor || noun.entry->thin) return false;
  return noun.entry->is(Trait::kDesk) || noun.head == "locker" || !(noun.entry->is(Trait::kTable) || noun.entry->is(Trait::kShelving));
}

}  // namespace

void settle_their_own(const Lexicon& lexicon, Document& document) {
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 1; k < chunks.size() && !is_set(document.stop); ++k) {
    NounPhrase& own = chunks[k].noun;
    if (!is_thing(chunks[k]) || own.determiner != Determiner::kPossessive || !own.plural || own.count > 0 || !is_for_one(own)) continue;
    if (document.tokens[own.first].text != "their") continue;
    const bool named = std::any_of(chunks.begin(), chunks.begin() + static_cast<std::ptrdiff_t>(k),
                                   [&](const Chunk& c) { return is_thing(c) && c.noun.head == own.head; });
    if (const int people = named ? 0 : people_before(lexicon, chunks, k); people > 1) own.count = std::min(people, kMostOwn);
  }
}

}  // namespace layoutbox::offline
