// Seats that are as high as what one sits at asks.
#include <algorithm>
#include <cstdlib>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

// "an island with three stools", "a kids table with four chairs": those that one sits on there. A chair of the usual height stays one.
void RelationBuilder::settle_seat_heights() {
  constexpr Mm kAlike = 150;  // of two backs
  constexpr Mm kHigh = 900;   // one stands or perches at what is so high
  const auto seats_there = [](R type) {
    return traits_of(type).around || type == R::kAlongSide || type == R::kInFrontOf || type == R::kNextTo || type == R::kNear ||
           type == R::kFacing;
  };
  for (const Relation& at : scene_.relations) {
    if (at.references.size() != 1 || !seats_there(at.type)) continue;
    const SceneObject* host = object_of(at.references[0]);
    const auto& seatings = Groups::builtin().seatings;
    const auto row =
        std::ranges::find_if(seatings, [&](const Seating& s) { return host != nullptr && catalog_.is_a(host->category, s.at); });
    const CatalogEntry* right = row == seatings.end() ? nullptr : catalog_.find(row->seat);
    if (right == nullptr) continue;
    for (const std::string& seat : at.targets) {
      const auto object = std::ranges::find(scene_.objects, seat, &SceneObject::id);
      if (object == scene_.objects.end()) continue;
      const CatalogEntry& named = catalog_.entry_or_nearest(object->category);
      // "a tavern: a long table with three stools along each side": no stools of a bar
      const NounPhrase& noun = noun_of_object(*object);
      const CatalogEntry* plain =
          one_of(noun.head, WordSet::kStools) && singular_of(noun.name) == noun.head ? catalog_.find_by_words(noun.head) : nullptr;
      const bool low = catalog_.entry_or_nearest(host->category).size.usual.height < kHigh;
      if (plain != nullptr && low && plain->size.usual.height < named.size.usual.height) object->category = plain->id;
      const bool alike = std::abs(named.size.usual.height - right->size.usual.height) <= kAlike;
      if (catalog_.is_a(right->id, named.id) && !(named.is(Trait::kChair) && alike)) object->category = right->id;
    }
  }
}

}  // namespace layoutbox::offline
