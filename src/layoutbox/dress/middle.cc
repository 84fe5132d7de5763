// What fills an empty middle of the floor, and what is below what hangs.
#include <algorithm>
#include <cmath>

#include "layoutbox/dress/places.h"

namespace layoutbox::dressing {

namespace {

RoomBox round_room(const Layout& layout) {
  RoomBox all{1e9, 1e9, 0, -1e9, -1e9, 0};
  for (const Point& p : layout.room.polygon) {
    all.x0 = std::min(all.x0, double(p.x)), all.x1 = std::max(all.x1, double(p.x));
    all.y0 = std::min(all.y0, double(p.y)), all.y1 = std::max(all.y1, double(p.y));
  }
  return all;
}

}  // namespace

// Where so much floor is free round it, as near to the middle of the room as can be; along the longer side of the room.
void lie_in_middle(Dresser& dresser, const Dressing& row) {
  constexpr double kStep = 100, kTall = 1000, kOffMiddle = 0.16;
  if (dresser.layout().room.floor_material.find("carpet") != std::string::npos) return;
  const CatalogEntry& entry = dresser.catalog().entry_or_nearest(row.adds);
  const RoomBox room = round_room(dresser.layout());
  const double width = room.x1 - room.x0, depth = room.y1 - room.y0;
  const bool turned = depth > width;
  for (const double scale : {1.0, 0.85, 0.7}) {
    Size size = dresser.size_of(row);
    size.width = static_cast<Mm>(on_grid(std::max(size.width * scale, double(entry.size.least.width))));
    size.depth = static_cast<Mm>(on_grid(std::max(size.depth * scale, double(entry.size.least.depth))));
    const double half_x = (turned ? size.depth : size.width) / 2.0 + row.before,
                 half_y = (turned ? size.width : size.depth) / 2.0 + row.before;
    const double farthest = kOffMiddle * std::hypot(width, depth);
    double nearest = farthest, x = 0, y = 0;
    for (double at_x = room.x0 + half_x; at_x <= room.x1 - half_x; at_x += kStep) {
      for (double at_y = room.y0 + half_y; at_y <= room.y1 - half_y; at_y += kStep) {
        const double off = std::hypot(at_x - (room.x0 + room.x1) / 2, at_y - (room.y0 + room.y1) / 2);
        if (off >= nearest || !dresser.room().is_free({at_x - half_x, at_y - half_y, 0, at_x + half_x, at_y + half_y, kTall})) continue;
        nearest = off, x = on_grid(at_x), y = on_grid(at_y);
      }
    }
    if (nearest >= farthest) continue;
    dresser.add(row.adds, row.words, size, {{x, y, 0}, turned ? 90.0 : 0.0});
    return;
  }
}

// On the wall below the middle of what hangs there, somewhat wider than that: a ledge under a mirror.
void hang_below(Dresser& dresser, const Dressing& row) {
  constexpr double kUnder = 40, kWider = 160;
  int left = row.most;
  for (const std::size_t i : dresser.things(row.of)) {
    const PlacedObject above = dresser.layout().objects[i];
    const DressedWall* wall = above.mount == Mount::kWall ? dresser.room().behind(above, kUnder) : nullptr;
    if (wall == nullptr || left == 0) continue;
    Size size = dresser.size_of(row);
    size.width = static_cast<Mm>(on_grid(above.size.width + kWider));
    const RoomBox box = box_round(above);
    const double height = on_grid(box.z0 - kUnder - size.height), from = on_grid(wall->along(box).middle() - size.width / 2.0);
    const Span along{from, from + size.width}, up{height, height + size.height};
    if (height < row.before || !dresser.room().is_free(wall->box(along, {0, double(size.depth)}, up))) continue;
    dresser.add_at_wall(row.adds, row.words, size, *wall, from, height);
    --left;
  }
}

}  // namespace layoutbox::dressing
