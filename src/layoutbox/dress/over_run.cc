// What hangs over kitchen units: hoods and wall cabinets.
#include <algorithm>
#include <cmath>

#include "layoutbox/catalog/measures.h"
#include "layoutbox/dress/kitchen.h"
#include "layoutbox/dress/places.h"

namespace layoutbox::dressing {
namespace {

constexpr double kNarrowestHung = 400, kHungCabinet = 700;  // widths of cabinets
constexpr double kOverHung = 50;
constexpr double kBehindStove = 150;

// Stretches of low units, side by side.
std::vector<Span> low_runs(const Dresser& dresser, const DressedWall& wall) {
  std::vector<Span> runs;
  for (const KitchenUnit& unit : units_at(dresser, wall)) {
    if (unit.object->size.height > measures().over_worktop) continue;
    if (!runs.empty() && unit.span.low - runs.back().high < kTouching) {
      runs.back().high = unit.span.high;
    } else {
      runs.push_back(unit.span);
    }
  }
  return runs;
}

}  // namespace

void hang_over_stove(Dresser& dresser, const Dressing& row) {
  int left = row.most;
  for (const std::size_t i : dresser.things(row.of)) {
    const PlacedObject stove = dresser.layout().objects[i];
    const DressedWall* wall = left > 0 ? dresser.room().behind(stove, kBehindStove) : nullptr;
    if (wall == nullptr) continue;
    Size size = dresser.size_of(row);
    const RoomBox box = box_round(stove);
    const double low = on_grid(box.z1 + measures().hob_to_hood), middle = wall->along(box).middle();
    const double ceiling = dresser.layout().room.height - kOverHung;
    size.height = static_cast<Mm>(std::min(double(size.height), ceiling - low));
    const Span along{middle - size.width / 2.0, middle + size.width / 2.0};
    const CatalogEntry& entry = dresser.catalog().entry_or_nearest(row.adds);
    if (size.height < entry.size.least.height || along.low < 0 || along.high > wall->length) continue;
    if (!dresser.room().is_free(wall->box(along, {0, double(size.depth)}, {low, low + size.height}))) continue;
    dresser.add_at_wall(row.adds, row.words, size, *wall, along.low, low);
    --left;
  }
}

void hang_over_run(Dresser& dresser, const Dressing& row) {
  const Size size = dresser.size_of(row);
  const double low = dresser.catalog().entry_or_nearest(row.adds).hang_height, top = low + size.height;
  if (top > dresser.layout().room.height - kOverHung) return;
  int left = row.most;
  for (const DressedWall& wall : dresser.room().walls()) {
    const std::vector<Span> free = dresser.room().free_along(wall, {0, double(size.depth)}, {low, top});
    for (const Span& span : shared(low_runs(dresser, wall), free)) {
      const int count = std::min(left, std::max(1, static_cast<int>(std::lround(span.length() / kHungCabinet))));
      const double width = std::floor(span.length() / std::max(count, 1));
      if (count == 0 || width < kNarrowestHung) continue;
      for (int k = 0; k < count; ++k) {
        dresser.add_at_wall(row.adds, row.words, {static_cast<Mm>(width), size.depth, size.height}, wall, span.low + k * width, low);
      }
      left -= count;
    }
  }
}

}  // namespace layoutbox::dressing
