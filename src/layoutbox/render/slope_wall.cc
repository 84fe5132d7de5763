#include "layoutbox/render/slope_wall.h"

#include <cmath>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/catalog/trait_table.h"

namespace layoutbox {

const Wall* wall_of_slope(const Layout& layout, const PlacedObject& object, const Catalog& catalog) {
  if (!catalog.entry_or_nearest(object.category).is(Trait::kRoofSlope)) return nullptr;
  constexpr double kAt = 30;  // mm
  const double turn = radians_from_degrees(object.rotation_deg), half = object.size.depth / 2.0;
  const double x = object.position[0] - half * std::sin(turn), y = object.position[1] + half * std::cos(turn);
  for (const Wall& wall : layout.room.walls) {
    const double along_x = wall.end.x - wall.start.x, along_y = wall.end.y - wall.start.y, length = std::hypot(along_x, along_y);
    if (length < 1) continue;
    const double off = ((x - wall.start.x) * along_y - (y - wall.start.y) * along_x) / length;
    const double along = ((x - wall.start.x) * along_x + (y - wall.start.y) * along_y) / length;
    if (std::abs(off) <= kAt && along >= 0 && along <= length) return &wall;
  }
  return nullptr;
}

}  // namespace layoutbox
