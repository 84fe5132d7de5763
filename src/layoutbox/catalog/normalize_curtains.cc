// Curtains are as wide as their windows: one of them covers a window, several share it.
#include <fmt/format.h>

#include <algorithm>

#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/trait_table.h"

namespace layoutbox {
namespace {

constexpr Mm kBeyondFrame = 150;  // of a window on either side, as curtain makers advise

}  // namespace

void normalize_curtains(NormalizeContext& context) {
  std::vector<Mm> windows;
  for (const Opening& opening : context.scene.room.openings) {
    if (opening.type == OpeningType::kWindow) windows.push_back(opening.width);
  }
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
