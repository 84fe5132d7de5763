// Curtains are as wide as their windows: one of them covers a window, several share it. One by a bed is as long as that.
#include <fmt/format.h>

#include <algorithm>

#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/trait_table.h"

namespace layoutbox {
namespace {

constexpr Mm kBeyondFrame = 150;  // of a window on either side, as curtain makers advise
constexpr Mm kBeyondBed = 100;    // of a bed at either end

// The length of what a curtain from the ceiling hangs beside; 0: nothing.
Mm length_beside(const NormalizeContext& context, const SceneObject& curtain) {
  for (const Relation& r : context.scene.relations) {
    if (r.type != RelationType::kNextTo || !names(r.targets, curtain.id) || r.references.size() != 1) continue;
    const SceneObject* host = context.scene.find_object(r.references[0]);
    if (host != nullptr && host->size) return std::max(host->size->usual.width, host->size->usual.depth);
  }
  return 0;
}

// A mirror that several are to look into is as wide as they sit.
void widen_mirrors(NormalizeContext& context) {
  constexpr Mm kPlace = 1050;
  for (SceneObject& mirror : context.scene.objects) {
    if (!context.catalog.entry_or_nearest(mirror.category).is(Trait::kMirror) || mirror.mount != Mount::kWall || !mirror.size ||
        mirror.size_source != SizeSource::kCatalog)
      continue;
    Mm seats = 0;
    for (const Relation& r : context.scene.relations) {
      if (r.type == RelationType::kFacing && names(r.references, mirror.id)) seats += static_cast<Mm>(r.targets.size());
    }
    if (seats < 2) continue;
    SizeRange& size = *mirror.size;
    size.usual.width = std::max(size.usual.width, seats * kPlace);
    size.greatest.width = std::max(size.greatest.width, size.usual.width);
    context.note("filled", fmt::format("\"{}\" is {} wide, for those who look into it", mirror.id, metres_text(size.usual.width)));
  }
}

}  // namespace

void normalize_curtains(NormalizeContext& context) {
  std::vector<Mm> windows;
  for (const Opening& opening : context.scene.room.openings) {
    if (opening.type == OpeningType::kWindow) windows.push_back(opening.width);
  }
  for (SceneObject& object : context.scene.objects) {
    const CatalogEntry& entry = context.catalog.entry_or_nearest(object.category);
    if (!entry.is(Trait::kCurtain) || entry.mount != Mount::kCeiling || !object.size || object.size_source != SizeSource::kCatalog)
      continue;
    const Mm length = length_beside(context, object);
    SizeRange& size = *object.size;
    if (length > 0) size.usual.width = std::clamp(length + 2 * kBeyondBed, size.least.width, size.greatest.width);
  }
  widen_mirrors(context);
  std::vector<SceneObject*> curtains;
  for (SceneObject& object : context.scene.objects) {
    const CatalogEntry& entry = context.catalog.entry_or_nearest(object.category);
    if (entry.is(Trait::kCurtain) && entry.mount == Mount::kWall && object.size) curtains.push_back(&object);
  }
  for (std::size_t i = 0; i < curtains.size() && !windows.empty(); ++i) {
    SceneObject& curtain = *curtains[i];
    if (curtain.size_source != SizeSource::kCatalog || !curtain.catalog_id.empty()) continue;
    const std::size_t window = i % windows.size();
    const auto sharing = static_cast<Mm>((curtains.size() - window + windows.size() - 1) / windows.size());
    const Mm width = (windows[window] + 2 * kBeyondFrame) / sharing;
    SizeRange& size = *curtain.size;
    size.usual.width = std::min(width, size.greatest.width);
    size.least.width = std::min(size.least.width, size.usual.width);
    context.note("filled", fmt::format("\"{}\" is {} wide, for its window", curtain.id, metres_text(size.usual.width)));
  }
}

}  // namespace layoutbox
