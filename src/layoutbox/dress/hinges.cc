#include "layoutbox/dress/hinges.h"

#include <algorithm>
#include <cmath>

#include "layoutbox/dress/free_room.h"

namespace layoutbox {
namespace {

using dressing::DressedWall;
using dressing::FreeRoom;
using dressing::Span;

constexpr double kBehindLeaf = 700;  // mm from the hinge: what stands there one reaches round the leaf for
constexpr double kNearCorner = 600;  // from the hinge to the wall that the leaf opens against
constexpr double kLeaf = 50;         // its thickness, and the play of what stands flush with the frame

// What an open leaf hides at one end of its door.
struct BehindLeaf {
  double hidden = 0;  // of the wall there, from the first thing on
  double corner = 0;  // how far the wall goes on
};

BehindLeaf behind_leaf(const FreeRoom& room, const DressedWall& wall, const Opening& door, bool at_end) {
  const double hinge = double(*door.offset) + (at_end ? door.width : 0);
  BehindLeaf behind{kBehindLeaf, at_end ? wall.length - hinge : hinge};
  const double look = std::min(kLeaf, behind.corner / 2);
  const double just_beside = at_end ? hinge + look : hinge - look;
  for (const Span& free : room.free_along(wall, {kLeaf, double(door.width)}, {0, double(door.height)}, FreeRoom::Count::kThings)) {
    if (just_beside < free.low || just_beside > free.high) continue;
    const bool to_corner = at_end ? free.high >= wall.length - 1 : free.low <= 1;
    behind.hidden = to_corner ? 0 : std::max(0.0, kBehindLeaf - (at_end ? free.high - hinge : hinge - free.low));
  }
  return behind;
}

bool is_better(const BehindLeaf& one, const BehindLeaf& other) {
  constexpr double kAlike = 100;
  if (std::abs(one.hidden - other.hidden) > kAlike) return one.hidden < other.hidden;
  return one.corner < kNearCorner && one.corner < other.corner;
}

}  // namespace

std::size_t hang_doors_clear(SceneGraph& scene, Layout& layout, const Catalog& catalog) {
  std::size_t turned = 0;
  const FreeRoom room(layout, catalog);
  for (Opening& door : layout.room.openings) {
    const bool in = door.swing == Swing::kInLeft || door.swing == Swing::kInRight;
    if (door.type != OpeningType::kDoor || !in || !door.offset || layout.lists_as_given_up("door swing of " + door.id)) continue;
    const auto wall = std::ranges::find_if(room.walls(), [&](const DressedWall& frame) { return frame.wall->id == door.wall; });
    if (wall == room.walls().end()) continue;
    // Seen from within, the wall's end is at the left.
    const bool at_end = door.swing == Swing::kInLeft;
    if (!is_better(behind_leaf(room, *wall, door, !at_end), behind_leaf(room, *wall, door, at_end))) continue;
    door.swing = at_end ? Swing::kInRight : Swing::kInLeft;
    for (Opening& asked : scene.room.openings) {
      if (asked.id == door.id) asked.swing = door.swing;
    }
    ++turned;
  }
  return turned;
}

}  // namespace layoutbox
