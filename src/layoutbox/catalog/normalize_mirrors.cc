// Shelves below mirrors.
#include <algorithm>

#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/trait_table.h"

namespace layoutbox {
namespace {

constexpr Mm kBetweenSeats = 450;  // who sits before mirrors of a row, from seat to seat

bool is_wall_mirror(const NormalizeContext& context, const std::string& id) {
  const SceneObject* object = context.scene.find_object(id);
  const CatalogEntry* kind = object == nullptr ? nullptr : context.catalog.find(object->category);
  return kind != nullptr && kind->is(Trait::kMirror) && object->mount.value_or(kind->mount) == Mount::kWall;
}

// The mirrors that are told to be above it, or that it is told to be below.
std::vector<std::string> mirrors_over(const NormalizeContext& context, const std::string& shelf) {
  std::vector<std::string> mirrors;
  for (const Relation& r : context.scene.relations) {
    const bool above = r.type == RelationType::kAbove && names(r.references, shelf);
    const bool under = r.type == RelationType::kUnder && names(r.targets, shelf);
    if (!above && !under) continue;
    for (const std::string& id : above ? r.targets : r.references) {
      if (is_wall_mirror(context, id) && !names(mirrors, id)) mirrors.push_back(id);
    }
  }
  return mirrors;
}

// From mirror to mirror: what they take, or who sits before them.
Mm pitch_of(const NormalizeContext& context, const std::string& mirror) {
  constexpr Mm kBetweenMirrors = 100;
  Mm pitch = context.catalog.entry_or_nearest(context.scene.find_object(mirror)->category).size.usual.width + kBetweenMirrors;
  for (const Relation& r : context.scene.relations) {
    if ((r.type != RelationType::kFacing && r.type != RelationType::kInFrontOf) || !names(r.references, mirror)) continue;
    const SceneObject* seat = r.targets.empty() ? nullptr : context.scene.find_object(r.targets[0]);
    const CatalogEntry* kind = seat == nullptr ? nullptr : context.catalog.find(seat->category);
    if (kind != nullptr && kind->is(Trait::kSeat)) pitch = std::max(pitch, kind->size.usual.width + kBetweenSeats);
  }
  return pitch;
}

}  // namespace

void hang_shelves_under_mirrors(NormalizeContext& context) {
  constexpr std::string_view kStanding = "shelf";
  const CatalogEntry* hanging = kind_at(context.catalog, kStanding, KinPlace::kOnWall);
  for (std::size_t i = 0; i < context.scene.objects.size() && hanging != nullptr; ++i) {
    SceneObject& shelf = context.scene.objects[i];
    if (shelf.category != kStanding || shelf.size || shelf.mount || shelf.hint.position || !shelf.mesh.empty()) continue;
    const std::vector<std::string> mirrors = mirrors_over(context, shelf.id);
    if (mirrors.empty()) continue;
    shelf.category = hanging->id;
    context.note("guessed", "\"" + shelf.id + "\" is below a mirror: it hangs on the wall",
                 "/furniture/" + std::to_string(i) + "/category");
    if (mirrors.size() < 2) continue;
    SizeRange size = hanging->size;
    const auto n = static_cast<Mm>(mirrors.size());
    const Mm pitch = pitch_of(context, mirrors[0]);
    size.usual.width = n * pitch - kBetweenSeats / 2, size.least.width = size.usual.width * 2 / 3;
    size.greatest.width = n * pitch, size.usual.height = size.least.height;
    shelf.size = size;
    shelf.size_source = SizeSource::kCatalog;
  }
}

}  // namespace layoutbox
