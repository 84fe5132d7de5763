#include "layoutbox/export/plan_room.h"

#include <algorithm>
#include <cmath>

#include "layoutbox/base/units.h"
#include "layoutbox/catalog/opening_look.h"

namespace layoutbox {
namespace {

PlanVector vector_of(const Point& p) { return {double(p.x), double(p.y)}; }

PlanWall plan_wall(const Wall& wall) {
  const PlanVector a = vector_of(wall.start), b = vector_of(wall.end);
  const double length = std::max(1.0, std::hypot(b.x - a.x, b.y - a.y));
  const PlanVector along{(b.x - a.x) / length, (b.y - a.y) / length};
  return {a, along, {along.y, -along.x}, length, double(wall.thickness)};
}

std::vector<PlanVector> sweep(const PlanWall& wall, double hinge, double side, double leaf, bool in) {
  const double depth = in ? 0 : wall.thickness, way = in ? -1 : 1;
  std::vector<PlanVector> points{wall.at(hinge, depth)};
  for (int i = 0; i <= 18; ++i) {
    const double angle = i * kPi / 36;
    points.push_back(wall.at(hinge + side * leaf * std::cos(angle), depth + way * leaf * std::sin(angle)));
  }
  return points;
}

}  // namespace

PlanRoom::PlanRoom(const Layout& layout) {
  for (const Wall& wall : layout.room.walls) walls.push_back(plan_wall(wall));
  bool first = true;
  const auto reach = [&](PlanVector p) {
    if (first) x0 = x1 = p.x, y0 = y1 = p.y;
    first = false;
    x0 = std::min(x0, p.x), x1 = std::max(x1, p.x), y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
  };
  for (const Point& p : layout.room.polygon) reach(vector_of(p));
  for (const PlanWall& wall : walls) {
    for (const double s : {0.0, wall.length}) reach(wall.at(s, wall.thickness));
  }
  for (const Opening& opening : layout.room.openings) {
    const int wall = wall_of(opening, layout);
    if (wall < 0) continue;
    for (const auto& leaf : door_sweeps(walls[static_cast<std::size_t>(wall)], opening)) std::for_each(leaf.begin(), leaf.end(), reach);
  }
}

int wall_of(const Opening& opening, const Layout& layout) {
  const auto& walls = layout.room.walls;
  const auto found = std::find_if(walls.begin(), walls.end(), [&](const Wall& w) { return w.id == opening.wall; });
  return found == walls.end() ? -1 : static_cast<int>(found - walls.begin());
}

std::vector<std::vector<PlanVector>> door_sweeps(const PlanWall& wall, const Opening& door) {
  if (door.type != OpeningType::kDoor || door.swing == Swing::kSliding || door.swing == Swing::kNone) return {};
  const double s = door.offset.value_or(0), e = s + door.width;
  const bool in = door.swing == Swing::kInLeft || door.swing == Swing::kInRight;
  if (has_two_leaves(door)) {
    return {sweep(wall, s, 1, door.width / 2.0, in), sweep(wall, e, -1, door.width / 2.0, in)};
  }
  // Seen from within looking at the wall, the wall's end is at the left.
  const bool left = door.swing == Swing::kInLeft || door.swing == Swing::kOutLeft;
  return {sweep(wall, left ? e : s, left ? -1 : 1, door.width, in)};
}

}  // namespace layoutbox
