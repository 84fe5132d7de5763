// Doors and windows that are put into a wall, moved along it, swapped and resized.
#include <fmt/format.h>

#include <cmath>

#include "layoutbox/edit/changes.h"
#include "layoutbox/edit/stepper.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

constexpr Mm kLeastOpening = 200, kFromCorner = 100, kBetween = 100, kLittleShift = 300, kBeforeWindow = 300, kFlat = 30;

struct WallDirection {
  double dx = 1, dy = 0, length = 1;
};
WallDirection along(const Wall& wall) {
  const double dx = wall.end.x - wall.start.x, dy = wall.end.y - wall.start.y, length = std::max(std::hypot(dx, dy), 1.0);
  return {dx / length, dy / length, length};
}

// The offset at which the opening's centre is nearest to a point.
Mm offset_near(const Wall& wall, const Opening& opening, const std::array<double, 2>& point) {
  const WallDirection way = along(wall);
  const double at = (point[0] - wall.start.x) * way.dx + (point[1] - wall.start.y) * way.dy;
  return static_cast<Mm>(std::lround((at - opening.width / 2.0) / kGridMm) * kGridMm);
}

}  // namespace

// How the opening lies in the wall: nearest to where it is wanted, beside the others. Empty: there is no room for it.
std::optional<Mm> EditStepper::free_offset(const Opening& opening, const Wall& wall, Mm wanted) const {
  const Mm length = length_of(wall);
  if (opening.width > length) return std::nullopt;
  const Mm margin = std::min(kFromCorner, (length - opening.width) / 2);
  const auto is_free = [&](Mm offset) {
    return std::none_of(scene_.room.openings.begin(), scene_.room.openings.end(), [&](const Opening& other) {
      return other.id != opening.id && other.wall == wall.id && other.offset && offset < *other.offset + other.width + kBetween &&
             *other.offset < offset + opening.width + kBetween;
    });
  };
  std::optional<Mm> best;
  for (Mm offset = margin; offset <= length - opening.width - margin; offset += kGridMm) {
    if ((!best || std::abs(offset - wanted) < std::abs(*best - wanted)) && is_free(offset)) best = offset;
  }
  return best;
}

// Where the opening is least in the way of what stands there, as near to the wall's middle as can be. Empty where something would have to
// make room for a door: the solver chooses.
std::optional<Mm> EditStepper::offset_least_in_the_way(const Opening& opening, const Wall& wall) const {
  const WallDirection way = along(wall);
  const bool window = opening.type == OpeningType::kWindow;
  const double deep = window ? kBeforeWindow : opening.width;
  const auto covered = [&](const PlacedObject& placed, Mm offset) {  // how much of the opening stands behind the thing
    if (window ? placed.position[2] + placed.size.height <= opening.sill : placed.size.height <= kFlat) return 0.0;
    const double turn = radians_from_degrees(placed.rotation_deg), c = std::abs(std::cos(turn)), s = std::abs(std::sin(turn));
    const double half_x = (placed.size.width * c + placed.size.depth * s) / 2, half_y = (placed.size.width * s + placed.size.depth * c) / 2;
    const double dx = placed.position[0] - wall.start.x, dy = placed.position[1] - wall.start.y;
    const double at = dx * way.dx + dy * way.dy, off = dy * way.dx - dx * way.dy;  // along the wall, and inwards from it
    const double half_along = std::abs(way.dx) * half_x + std::abs(way.dy) * half_y;
    const double half_off = std::abs(way.dy) * half_x + std::abs(way.dx) * half_y;
    if (off - half_off >= deep) return 0.0;
    return std::max(0.0, std::min<double>(at + half_along, offset + opening.width) - std::max<double>(at - half_along, offset));
  };
  const Mm middle = (length_of(wall) - opening.width) / 2 / kGridMm * kGridMm;
  std::optional<Mm> best;
  double least = 0;
  for (Mm away = 0; away <= middle; away += kGridMm) {
    for (const Mm offset : {middle - away, middle + away}) {
      if (free_offset(opening, wall, offset) != offset) continue;
      double all = 0;
      for (const PlacedObject& placed : guide_.objects) all += covered(placed, offset);
      if (!best || all < least) best = offset, least = all;
    }
  }
  return window || least == 0 ? best : std::nullopt;
}

// Into a wall, at a place or wherever the solver finds it best.
Status EditStepper::put(Opening fresh, const EditOpeningPlace& place) {
  const auto fits = [&](const Wall& wall) { return free_offset(fresh, wall, 0).has_value(); };
  const Wall* wall = place.wall.empty() ? nullptr : scene_.find_wall(place.wall);
  if (wall != nullptr && !fits(*wall)) {
    return fail(ErrorCode::kGeometry,
                fmt::format("there is no room for {}, which is {} wide, in {}, which is {} long", fresh.id, in_metres(fresh.width),
                            wall->id, in_metres(length_of(*wall))),
                "text", "name another wall, or make it narrower");
  }
  if (wall == nullptr && std::none_of(scene_.room.walls.begin(), scene_.room.walls.end(), fits)) {
    return fail(ErrorCode::kGeometry, fmt::format("no wall has room for {}, which is {} wide", fresh.id, in_metres(fresh.width)), "text");
  }
  fresh.wall = wall != nullptr ? wall->id : std::string();
  fresh.offset.reset();
  if (wall != nullptr && place.near) {
    fresh.offset = free_offset(fresh, *wall, offset_near(*wall, fresh, *place.near));
  } else if (wall != nullptr) {
    fresh.offset = offset_least_in_the_way(fresh, *wall);
  }
  settle_opening(std::move(fresh));
  return {};
}

// What was placed by it stays where it is, rather than going after it. "Under a window" may mean this one.
void EditStepper::soften_about_opening(const std::string& id) {
  for (Relation& relation : scene_.relations) {
    const bool any_opening = relation.references.empty() && (relation_row(relation.type).reference_kinds & kOpening) != 0;
    if (any_opening || has_id(relation.references, id)) soften(relation);
  }
}

void EditStepper::settle_opening(Opening changed) {
  changed.origin = Origin::kAsked;
  if (!changed.offset) freed_.push_back(changed.id);
  soften_about_opening(changed.id);
  if (Opening* there = opening(changed.id)) {
    *there = std::move(changed);
  } else {
    scene_.room.openings.push_back(std::move(changed));
  }
}

// How far it goes along its wall, from the wall's start to its end.
Result<double> EditStepper::way_along(const Opening& opening, const Wall& wall, const EditShift& shift) const {
  using Way = EditShift::Way;
  const double distance = shift.distance ? *shift.distance : kLittleShift;
  // Left and right are those of somebody who looks at the wall from within, to whom it runs from right to left; save that on the front
  // wall they are the room's own.
  const WallDirection way = along(wall);
  const bool upright = std::abs(way.dy) > std::abs(way.dx);
  double step = 0;  // along the wall, from its start to its end
  if (shift.way == Way::kTowards || shift.way == Way::kAway) {
    PlacedObject here;
    here.id = opening.id;
    const double middle = *opening.offset + opening.width / 2.0;
    here.position = {wall.start.x + way.dx * middle, wall.start.y + way.dy * middle, 0};
    LAYOUTBOX_ASSIGN(const auto whole, way_of(here, shift, guide_, true));
    step = whole[0] * way.dx + whole[1] * way.dy;
    if (shift.distance && step != 0) step = step < 0 ? -distance : distance;
  } else {
    const bool back_and_forth = shift.way == Way::kFront || shift.way == Way::kBack;
    if (back_and_forth != upright && back_and_forth) {
      return fail(ErrorCode::kGeometry, fmt::format("{} can only go along {}", opening.id, wall.id), "text",
                  "say left or right, or name another wall");
    }
    if (back_and_forth) {
      step = ((shift.way == Way::kBack) == (way.dy > 0)) ? distance : -distance;
    } else if (upright) {
      step = shift.way == Way::kLeft ? distance : -distance;
    } else {
      step = ((shift.way == Way::kRight) == (way.dx > 0)) ? distance : -distance;
    }
  }
  return step;
}

Status EditStepper::shift_opening(const std::string& id, const EditShift& shift) {
  using Way = EditShift::Way;
  const Opening* found = opening(id);
  const Wall* wall = found == nullptr ? nullptr : scene_.find_wall(found->wall);
  if (wall == nullptr || !found->offset) return {};
  Opening moved = *found;
  const double distance = shift.distance ? *shift.distance : kLittleShift;
  if (shift.way == Way::kUp || shift.way == Way::kDown) {
    if (moved.type != OpeningType::kWindow) return fail(ErrorCode::kGeometry, fmt::format("{} stands on the floor", id), "text");
    moved.sill += static_cast<Mm>(shift.way == Way::kUp ? distance : -distance);
    if (moved.sill < 0) return fail(ErrorCode::kGeometry, fmt::format("{} would reach below the floor", id), "text", "say less of it");
    settle_opening(std::move(moved));
    return {};
  }
  LAYOUTBOX_ASSIGN(const double step, way_along(moved, *wall, shift));
  const Mm wanted = *moved.offset + static_cast<Mm>(std::lround(step / kGridMm)) * kGridMm;
  const auto there = free_offset(moved, *wall, wanted);
  if (!there || *there == *moved.offset || (shift.distance && std::abs(*there - wanted) > kFromCorner)) {
    return fail(ErrorCode::kGeometry, fmt::format("{} cannot go so far along {}", id, wall->id), "text",
                "say less of it, or name another wall");
  }
  const bool within = wanted >= 0 && wanted + moved.width <= length_of(*wall);
  moved.offset = shift.distance && within ? wanted : *there;
  settle_opening(std::move(moved));
  return {};
}

Status EditStepper::swap_openings(const std::string& a, const std::string& b) {
  const Opening *first = opening(a), *second = opening(b);
  if (first == nullptr || second == nullptr) return {};
  const auto place_of = [&](const Opening& o) {
    const Wall* wall = scene_.find_wall(o.wall);
    EditOpeningPlace place{o.wall, std::nullopt};
    if (wall == nullptr || !o.offset) return place;
    const WallDirection way = along(*wall);
    const double middle = *o.offset + o.width / 2.0;
    place.near = {wall->start.x + way.dx * middle, wall->start.y + way.dy * middle};
    return place;
  };
  const Opening one = *first, other = *second;
  const EditOpeningPlace place_of_one = place_of(one), place_of_other = place_of(other);
  std::erase_if(scene_.room.openings, [&](const Opening& o) { return o.id == a || o.id == b; });
  LAYOUTBOX_CHECK(put(one, place_of_other));
  return put(other, place_of_one);
}

// Its middle stays where it is, as far as the wall and its neighbours let it.
Status EditStepper::resize_opening(const std::string& id, const EditResize& resize) {
  const Opening* found = opening(id);
  if (found == nullptr) return {};
  Opening made = *found;
  made.width = side_after(made.width, resize.sides[0]);
  made.height = side_after(made.height, resize.sides[2]);
  const bool loosely = resize.sides[0].factor != 1 && resize.sides[2].factor != 1;
  const Mm head_room = scene_.room.height - made.sill - 50;
  if (loosely) made.height = std::min(made.height, std::max(head_room, found->height));
  const Wall* wall = scene_.find_wall(made.wall);
  if (made.width < kLeastOpening || made.height < kLeastOpening) {
    return fail(ErrorCode::kGeometry, fmt::format("{} would be {} wide and {} high", id, in_metres(made.width), in_metres(made.height)),
                "text");
  }
  if (wall != nullptr && made.offset) {
    const Mm wanted = *made.offset - (made.width - found->width) / 2 / kGridMm * kGridMm;
    made.offset = free_offset(made, *wall, wanted);
    if (!made.offset) {
      return fail(ErrorCode::kGeometry,
                  fmt::format("there is no room for {} in {} when it is {} wide", id, wall->id, in_metres(made.width)), "text",
                  "say less of it");
    }
  }
  settle_opening(std::move(made));
  return {};
}

}  // namespace layoutbox
