#include "layoutbox/serve/snapping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace layoutbox::serve {
namespace {

constexpr double kReach = 150;  // mm
constexpr double kBeyond = 1500;

struct FloorVector {
  double x = 0, y = 0;
};

// A wall with its direction and the direction into the room (its left: walls run counter-clockwise).
struct WallLine {
  FloorVector start, along, inward;
  double length = 0;
};

WallLine line_of(const Wall& wall) {
  const double dx = wall.end.x - wall.start.x, dy = wall.end.y - wall.start.y, length = std::max(1.0, std::hypot(dx, dy));
  return {{double(wall.start.x), double(wall.start.y)}, {dx / length, dy / length}, {-dy / length, dx / length}, length};
}

double across(const WallLine& line, double x, double y) { return (x - line.start.x) * line.inward.x + (y - line.start.y) * line.inward.y; }
double along(const WallLine& line, double x, double y) { return (x - line.start.x) * line.along.x + (y - line.start.y) * line.along.y; }

// From the object's centre to its farthest point against the direction into the room.
double half_extent(const PlacedObject& object, const WallLine& line) {
  const double angle = radians_from_degrees(object.rotation_deg), c = std::cos(angle), s = std::sin(angle);
  return std::abs(c * line.inward.x + s * line.inward.y) * object.size.width / 2 +
         std::abs(-s * line.inward.x + c * line.inward.y) * object.size.depth / 2;
}

// How far its near side is from the wall's inner face; nothing where the wall does not run beside it.
double gap_to(const PlacedObject& object, const WallLine& line) {
  const double at = along(line, object.position[0], object.position[1]);
  if (at < 0 || at > line.length) return std::numeric_limits<double>::infinity();
  return across(line, object.position[0], object.position[1]) - half_extent(object, line);
}

void put_at(PlacedObject& object, const WallLine& line) {
  const double gap = gap_to(object, line);
  object.position[0] -= gap * line.inward.x;
  object.position[1] -= gap * line.inward.y;
}

// The front, which is −y at rotation 0, looks into the room.
double back_to(const WallLine& line) { return normalized_degrees(std::round(std::atan2(line.inward.y, line.inward.x) * 180 / kPi + 90)); }

bool pulls(double gap) { return gap <= kReach && gap >= -kBeyond; }

}  // namespace

void snap_to_walls(PlacedObject& object, const Room& room, const CatalogEntry& entry) {
  std::vector<WallLine> near;
  for (const Wall& wall : room.walls) {
    if (const WallLine line = line_of(wall); pulls(gap_to(object, line))) near.push_back(line);
  }
  if (near.empty()) return;
  std::sort(near.begin(), near.end(), [&](const WallLine& a, const WallLine& b) { return gap_to(object, a) < gap_to(object, b); });
  if (entry.back_to_wall) object.rotation_deg = back_to(near.front());
  for (const WallLine& line : near) {
    if (pulls(gap_to(object, line))) put_at(object, line);
  }
}

void snap_opening(Opening& opening, const Room& room, double x, double y) {
  double best = std::numeric_limits<double>::infinity();
  for (const Wall& wall : room.walls) {
    const WallLine line = line_of(wall);
    if (line.length < opening.width) continue;
    const double at = std::clamp(along(line, x, y) - opening.width / 2.0, 0.0, line.length - opening.width);
    const double nearest = at + opening.width / 2.0;
    const double distance = std::hypot(line.start.x + line.along.x * nearest - x, line.start.y + line.along.y * nearest - y);
    if (distance >= best) continue;
    best = distance;
    opening.wall = wall.id;
    opening.offset = static_cast<Mm>(std::lround(at / kGridMm) * kGridMm);
  }
}

}  // namespace layoutbox::serve
