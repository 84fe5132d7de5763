#include "layoutbox/solve/model/slanted.h"

#include <cmath>

#include "layoutbox/solve/model/items.h"

namespace layoutbox::placement {
namespace {

constexpr double kSameHeading = 1e-4;  // degrees

std::int32_t parts(double value) { return static_cast<std::int32_t>(std::lround(value * kHeading)); }

// The heading of that direction or its opposite.
int heading_towards(std::vector<Heading>& headings, double degrees) {
  double angle = std::fmod(degrees + 720, 180);
  if (180 - angle < kSameHeading) angle = 0;
  for (std::size_t k = 0; k < headings.size(); ++k) {
    if (std::abs(headings[k].angle - angle) < kSameHeading) return static_cast<int>(k);
  }
  headings.push_back({angle, parts(std::cos(radians_from_degrees(angle))), parts(std::sin(radians_from_degrees(angle)))});
  return static_cast<int>(headings.size()) - 1;
}

// How far a rectangle turned by `turn` reaches along a heading.
std::int64_t span_of(double width, double depth, double turn, const Heading& heading) {
  const double off = radians_from_degrees(heading.angle - turn);
  return static_cast<std::int64_t>(std::llround(kHeading * (width * std::abs(std::cos(off)) + depth * std::abs(std::sin(off)))));
}

std::int64_t dot(const Heading& h, std::int64_t x, std::int64_t y) { return h.x * x + h.y * y; }

bool is_convex(std::span<const Point> polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % n], &c = polygon[(i + 2) % n];
    const std::int64_t turn = (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - b.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - b.x);
    if (turn < 0) return false;
  }
  return true;
}

}  // namespace

void add_headings(PlacementModel& model) {
  for (RoomWall& wall : model.walls) {
    if (wall.straight) continue;
    const double inward = wall.angle - 90;  // what has its back there looks into the room
    const double radians = radians_from_degrees(inward);
    wall.normal_heading = heading_towards(model.headings, inward);
    wall.along_heading = heading_towards(model.headings, inward - 90);
    const auto sign = [&](int heading, double x, double y) {
      return model.headings[heading].x * x + model.headings[heading].y * y > 0 ? 1 : -1;
    };
    wall.normal_sign = sign(wall.normal_heading, std::cos(radians), std::sin(radians));
    wall.along_sign = sign(wall.along_heading, double(wall.end.x) - wall.start.x, double(wall.end.y) - wall.start.y);
  }
}

void add_spans(const PlacementModel& model, Item& item) {
  if (model.headings.empty() || item.states.empty()) return;
  item.spans = kFirstConstant + static_cast<int>(item.states[0].constants.size());
  for (State& state : item.states) {
    for (const Heading& heading : model.headings)
      state.constants.push_back(static_cast<Mm>(span_of(state.size.width, state.size.depth, state.angle, heading)));
  }
}

Linear along2(const PlacementModel& model, ItemId item, int heading) {
  const Heading& h = model.headings[heading];
  return h.x * mid2(item, 0) + h.y * mid2(item, 1);
}

Linear span(const PlacementModel& model, ItemId item, int heading) { return constant_of(item, model.items[item].spans + heading); }

Linear slanted_gap2(const PlacementModel& model, ItemId item, const RoomWall& wall) {
  const std::int64_t line = dot(model.headings[wall.normal_heading], wall.start.x, wall.start.y);
  return wall.normal_sign * (along2(model, item, wall.normal_heading) - Linear(2 * line)) - span(model, item, wall.normal_heading);
}

Linear along_wall2(const PlacementModel& model, ItemId item, const RoomWall& wall) {
  const std::int64_t from = dot(model.headings[wall.along_heading], wall.start.x, wall.start.y);
  return wall.along_sign * (along2(model, item, wall.along_heading) - Linear(2 * from));
}

Constraint within_walls(const PlacementModel& model, ItemId item) {
  Constraint out;
  out.name = "within the walls: " + model.items[item].id;
  out.firmness = Firmness::kAlways;
  const bool convex = is_convex(model.scene->room.polygon);
  for (const RoomWall& wall : model.walls) {
    if (wall.straight) continue;
    Formula& f = out.formulas.emplace_back();
    f.add().require(slanted_gap2(model, item, wall), 2 * kHeading);
    if (convex) continue;
    // Past the ends of the wall there may be room behind its line.
    for (int axis = 0; axis < 2; ++axis) {
      const Mm a = axis == 0 ? wall.start.x : wall.start.y, b = axis == 0 ? wall.end.x : wall.end.y;
      f.add().require(lo(item, axis) - Linear(std::max(a, b)));
      f.add().require(Linear(std::min(a, b)) - hi(item, axis));
    }
    f.exact = false;  // a body that passes the wall's end needs none of these; of such rooms nothing is proven
  }
  return out;
}

std::vector<GridBox> off_limits_of(const PlacementModel& model) {
  const std::vector<Point>& polygon = model.scene->room.polygon;
  if (model.headings.empty()) return model.outside;
  if (is_convex(polygon)) return {};
  return wholly_outside_of(polygon, model.room.lo[2], model.room.hi[2]);
}

Reach reach_of(const PlacementModel& model, const Item& item, int s, int solid, int heading) {
  const State& state = item.states[s];
  const Heading& h = model.headings[heading];
  if (solid < 0) return {dot(h, state.extent[0], state.extent[1]), state.constants[item.spans - kFirstConstant + heading]};
  if (is_quarter(state)) return reach_of(state.solids[solid], h);
  // The part in the object's own frame, turned about the middle of the footprint.
  const GridBox& own = state.own_solids[solid];
  const double c = std::cos(radians_from_degrees(state.angle)), sn = std::sin(radians_from_degrees(state.angle));
  const GridBox whole = own_box(state.size);
  const double x = double(own.lo[0]) + own.hi[0] - whole.lo[0] - whole.hi[0], y = double(own.lo[1]) + own.hi[1] - whole.lo[1] - whole.hi[1];
  return {dot(h, state.extent[0] + std::lround(c * x - sn * y), state.extent[1] + std::lround(sn * x + c * y)),
          span_of(own.extent(0), own.extent(1), state.angle, h)};
}

Reach reach_of(const GridBox& box, const Heading& h) {
  return {dot(h, std::int64_t{box.lo[0]} + box.hi[0], std::int64_t{box.lo[1]} + box.hi[1]),
          std::abs(std::int64_t{h.x} * box.extent(0)) + std::abs(std::int64_t{h.y} * box.extent(1))};
}

namespace {

// Where it stands.
Reach placed_reach(const PlacementModel& model, const BodyPart& part, int heading) {
  Reach reach = reach_of(model, *part.item, part.placement->state, part.solid, heading);
  reach.middle2 += 2 * dot(model.headings[heading], part.placement->at[0], part.placement->at[1]);
  return reach;
}

template <typename ReachAlong>
bool apart_along_any(const PlacementModel& model, const BodyPart& a, const ReachAlong& b_along) {
  for (std::size_t k = 0; k < model.headings.size(); ++k) {
    const Reach ra = placed_reach(model, a, static_cast<int>(k)), rb = b_along(static_cast<int>(k));
    if (std::abs(ra.middle2 - rb.middle2) >= ra.span + rb.span) return true;
  }
  return false;
}

}  // namespace

bool apart_along_headings(const PlacementModel& model, const BodyPart& a, const BodyPart& b) {
  return apart_along_any(model, a, [&](int heading) { return placed_reach(model, b, heading); });
}

bool apart_along_headings(const PlacementModel& model, const BodyPart& a, const GridBox& box) {
  return apart_along_any(model, a, [&](int heading) { return reach_of(box, model.headings[heading]); });
}

}  // namespace layoutbox::placement
