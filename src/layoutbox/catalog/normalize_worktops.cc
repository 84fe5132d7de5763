// A workbench "along the back wall" is about as long as that wall lets it be; a shelf there is a long one.
#include <algorithm>

#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

constexpr Mm kForDoor = 1500;    // of a wall is left to a door and to what else stands there
constexpr Mm kLongShelf = 2400;  // several bays of one kind

bool says_along(const Relation& r) { return r.why.starts_with("along") || r.why.starts_with("down the") || r.why.starts_with("running"); }

// How much of the wall what else is told to be at it takes.
Mm taken_by_others(const SceneGraph& scene, const std::string& wall, const std::string& bench) {
  Mm taken = 0;
  for (const SceneObject& other : scene.objects) {
    const bool there = other.id != bench && other.size && std::ranges::any_of(scene.relations, [&](const Relation& r) {
                         return r.type == RelationType::kAgainstWall && names(r.targets, other.id) && names(r.references, wall);
                       });
    if (there) taken += other.size->usual.width;
  }
  return taken;
}

// How long such a thing may be where it is told to be along a wall; 0: as it is.
Mm longest_along(const NormalizeContext& context, const SceneObject& object) {
  const CatalogEntry& entry = context.catalog.entry_or_nearest(object.category);
  if (entry.is(Trait::kLongAtWall)) return object.size->greatest.width;
  const auto alike = std::ranges::count(context.scene.objects, object.category, &SceneObject::category);
  const bool shelf = entry.is(Trait::kShelving) && entry.mount == Mount::kFloor && entry.back_to_wall;
  return shelf && alike == 1 ? std::max(kLongShelf, object.size->greatest.width) : 0;
}

}  // namespace

void normalize_worktops(NormalizeContext& context) {
  for (const Relation& r : context.scene.relations) {
    if (r.type != RelationType::kAgainstWall || r.targets.size() != 1 || r.references.size() != 1 || !says_along(r)) continue;
    const auto bench = std::ranges::find(context.scene.objects, r.targets[0], &SceneObject::id);
    const Wall* wall = context.scene.find_wall(r.references[0]);
    if (bench == context.scene.objects.end() || wall == nullptr || !bench->size || bench->size_source != SizeSource::kCatalog) continue;
    const Mm longest = longest_along(context, *bench);
    if (longest == 0) continue;
    const Mm free = length_of(*wall) - kForDoor - taken_by_others(context.scene, wall->id, bench->id);
    Mm& usual = bench->size->usual.width;
    usual = std::max(usual, std::min(free, longest));
    bench->size->greatest.width = std::max(usual, bench->size->greatest.width);
  }
}

}  // namespace layoutbox
