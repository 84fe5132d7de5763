// What becomes of the room itself, its doors and windows.
#include <fmt/format.h>

#include <cmath>

#include "layoutbox/edit/changes.h"
#include "layoutbox/edit/stepper.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

constexpr Mm kLeastSide = 1000, kGreatestSide = 50'000, kLeastHeight = 1500, kGreatestHeight = 20'000;
constexpr Mm kAtWall = 60;

}  // namespace

Opening* EditStepper::opening(const std::string& id) {
  const auto found = std::find_if(scene_.room.openings.begin(), scene_.room.openings.end(), [&](const Opening& o) { return o.id == id; });
  return found == scene_.room.openings.end() ? nullptr : &*found;
}

bool EditStepper::is_of_room(const EditStep& step) {
  return !step.openings.empty() || (!step.targets.empty() && (step.targets[0] == kEditRoom || opening(step.targets[0]) != nullptr));
}

Status EditStepper::apply_to_room(const EditStep& step) {
  const bool whole = !step.targets.empty() && step.targets[0] == kEditRoom;
  switch (step.kind) {
    case EditKind::kAdd:
      for (Opening fresh : step.openings) LAYOUTBOX_CHECK(put(std::move(fresh), *step.opening_place));
      break;
    case EditKind::kRemove:
      for (const std::string& id : step.targets) soften_about_opening(id);
      std::erase_if(scene_.room.openings, [&](const Opening& o) { return has_id(step.targets, o.id); });
      break;
    case EditKind::kMove:
      for (const std::string& id : step.targets) {
        if (const Opening* moved = opening(id)) LAYOUTBOX_CHECK(put(*moved, *step.opening_place));
      }
      break;
    case EditKind::kShift:
      for (const std::string& id : step.targets) LAYOUTBOX_CHECK(shift_opening(id, *step.shift));
      break;
    case EditKind::kSwap: LAYOUTBOX_CHECK(swap_openings(step.targets[0], step.targets[1])); break;
    case EditKind::kResize:
      if (whole) {
        LAYOUTBOX_CHECK(resize_room(step.resize));
      } else {
        for (const std::string& id : step.targets) LAYOUTBOX_CHECK(resize_opening(id, step.resize));
      }
      break;
    default: break;
  }
  const std::vector<Error> faults = check_openings(scene_.room);
  if (!faults.empty()) return fail(ErrorCode::kGeometry, faults[0].message, "text", faults[0].hint);
  guide_.room = scene_.room;
  return {};
}

// The right and the back wall move; what stands at them goes along.
Status EditStepper::resize_room(const EditResize& resize) {
  Room& room = scene_.room;
  Point most{};
  for (const Point& corner : room.polygon) most = {std::max(most.x, corner.x), std::max(most.y, corner.y)};
  const bool swapped = resize.longer_side && most.y > most.x;
  const Mm width = side_after(most.x, resize.sides[swapped ? 1 : 0]), depth = side_after(most.y, resize.sides[swapped ? 0 : 1]);
  const bool all = resize.sides[0].factor != 1 && resize.sides[1].factor != 1;  // a larger room is no higher
  const Mm height = all ? room.height : side_after(room.height, resize.sides[2]);
  for (const auto& [side, least, greatest, word] : {std::tuple{width, kLeastSide, kGreatestSide, "wide"},
                                                    {depth, kLeastSide, kGreatestSide, "deep"},
                                                    {height, kLeastHeight, kGreatestHeight, "high"}}) {
    if (side >= least && side <= greatest) continue;
    return fail(ErrorCode::kGeometry, fmt::format("the room would be {} {}", in_metres(side), word), "text",
                fmt::format("between {} and {} can be", in_metres(least), in_metres(greatest)));
  }
  room.height = height;
  LAYOUTBOX_CHECK(move_far_wall(0, most.x, width - most.x));
  LAYOUTBOX_CHECK(move_far_wall(1, most.y, depth - most.y));
  room.area_m2.reset();
  return {};
}

// Its openings stay where they are, as far as the wall goes.
Status EditStepper::keep_openings(const Wall& wall, Mm by_at_start) {
  for (Opening& opening : scene_.room.openings) {
    if (opening.wall != wall.id || !opening.offset) continue;
    const Mm wanted = *opening.offset + by_at_start;
    const bool fits = wanted >= 0 && wanted + opening.width <= length_of(wall);
    opening.offset = fits ? wanted : free_offset(opening, wall, wanted);
    if (!opening.offset) {
      return fail(ErrorCode::kGeometry,
                  fmt::format("there is no room for {} in {}, which would be {} long", opening.id, wall.id, in_metres(length_of(wall))),
                  "text", "move it first, or say less of it");
    }
  }
  return {};
}

// What stands at that wall goes with it, and so does what stands on that.
void EditStepper::take_along(int axis, Mm far, Mm by) {
  std::set<std::string> along_with;
  const auto i = static_cast<std::size_t>(axis);
  for (const PlacedObject& placed : guide_.objects) {
    const double turn = radians_from_degrees(placed.rotation_deg), across = std::abs(std::sin(turn)), upright = std::abs(std::cos(turn));
    const double half =
        (axis == 0 ? placed.size.width * upright + placed.size.depth * across : placed.size.width * across + placed.size.depth * upright) /
        2;
    if (placed.position[i] + half >= far - kAtWall) along_with.insert(placed.id);
  }
  for (bool found = true; found;) {
    found = false;
    for (const PlacedObject& placed : guide_.objects) {
      if (along_with.contains(placed.supported_by) && along_with.insert(placed.id).second) found = true;
    }
  }
  for (PlacedObject& placed : guide_.objects) {
    if (along_with.contains(placed.id)) placed.position[i] += by;
  }
}

// The wall at the far end of an axis (0: x, 1: y), by so much outwards.
Status EditStepper::move_far_wall(int axis, Mm far, Mm by) {
  if (by == 0) return {};
  Room& room = scene_.room;
  const auto coordinate = [axis](Point& point) -> Mm& { return axis == 0 ? point.x : point.y; };
  for (Point& corner : room.polygon) {
    if (coordinate(corner) == far) {
      coordinate(corner) += by;
    } else if (coordinate(corner) >= far + by) {
      return fail(ErrorCode::kGeometry, "the room's other walls are in the way", "text", "say less of it");
    }
  }
  for (Wall& wall : room.walls) {
    const bool start_moves = coordinate(wall.start) == far, end_moves = coordinate(wall.end) == far;
    if (start_moves) coordinate(wall.start) += by;
    if (end_moves) coordinate(wall.end) += by;
    if (start_moves != end_moves) LAYOUTBOX_CHECK(keep_openings(wall, start_moves ? by : 0));
  }
  take_along(axis, far, by);
  return {};
}

}  // namespace layoutbox
