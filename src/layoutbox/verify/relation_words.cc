// The words that docs/relations.md defines before its tables: beyond, at side, in line, covers, looks at.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/verify/checks.h"
#include "layoutbox/verify/relation_check.h"

namespace layoutbox::checks {

std::string name_of_pair(const Body& body, const RelationReference& reference) { return body.id() + " and " + reference.id; }

Vec2d direction_of(const Frame& frame, Side side) {
  switch (side) {
    case Side::kBack: return frame.y;
    case Side::kLeft: return frame.x * -1;
    case Side::kRight: return frame.x;
    default: return frame.y * -1;
  }
}

Vec2d front_of(const Body& body) { return body.own_frame.y * -1; }

std::vector<Side> sides_named(const Body& body, Side side) {
  const std::vector<Side> at_ends{Side::kLeft, Side::kRight}, along{Side::kFront, Side::kBack};
  if (side != Side::kLong && side != Side::kShort) return {side};
  const double width = extent(body.shape, body.shape.frame.x).length(), depth = extent(body.shape, body.shape.frame.y).length();
  if (std::abs(width - depth) < 0.0005) return {Side::kFront, Side::kBack, Side::kLeft, Side::kRight};
  return (width > depth) == (side == Side::kLong) ? along : at_ends;
}

Interval room_extent(const Body& body, Axis axis) {
  if (axis == Axis::kZ) return body.shape.heights;
  return extent(body.shape, axis == Axis::kX ? Vec2d{1, 0} : Vec2d{0, 1});
}

Interval room_extent(const RelationCase& c, const RelationReference& reference, Axis axis) {
  if (reference.body != nullptr) return room_extent(*reference.body, axis);
  if (reference.is_place()) return axis == Axis::kX ? c.view.floor_x : axis == Axis::kY ? c.view.floor_y : Interval{0, c.view.height};
  return axis == Axis::kZ ? reference.face->shape.heights : extent(reference.face->shape, axis == Axis::kX ? Vec2d{1, 0} : Vec2d{0, 1});
}

double turn_between(double a_deg, double b_deg) {
  const double turn = std::fabs(std::remainder(a_deg - b_deg, 360.0));
  return std::isfinite(turn) ? turn : 180.0;
}

Finding gap_within(const RelationCase& c, const Body& t, const RelationReference& r, std::optional<double> min, std::optional<double> max) {
  if (r.is_place()) return condition(false, r.id + " is neither an object nor a wall, door or window");
  return in_band("distance between " + name_of_pair(t, r), gap(t.shape, r.shape()), min, max, c.slack());
}

Finding in_line(const RelationCase& c, const Body& t, const Shape& r, Vec2d along) {
  const Interval a = extent(t.shape, along), b = extent(r, along);
  return at_most(t.id() + " is out of line by", std::abs(a.mid() - b.mid()),
                 std::max(a.half(), b.half()) - std::min(a.half(), b.half()) / 5, c.slack());
}

// Left, right, before and behind what has no front are meant in the frame of the one thing that it is said to stand on; not of where it
// came to stand unasked.
Frame frame_of(const RelationCase& c, const RelationReference& r) {
  const bool by_side = traits_of(c.relation.type).placing == Placing::kSide;
  if (!by_side || r.body == nullptr || r.body->has_front) return r.shape().frame;
  const Body* host = nullptr;
  for (const PlacedRelation& placed : c.view.layout.relations) {
    const Relation& relation = placed.relation;
    const bool stands = traits_of(relation.type).rests;
    if (!stands || relation.targets != std::vector<std::string>{r.id} || relation.references.size() != 1) continue;
    const Body* named = c.view.find_body(relation.references.front());
    if (named == nullptr && c.view.find_opening(relation.references.front()) == nullptr) continue;
    if (named == nullptr || named->rug || (host != nullptr && host != named)) return r.shape().frame;
    host = named;
  }
  return host != nullptr && host->has_front ? host->own_frame : r.shape().frame;
}

Finding beyond(const RelationCase& c, const Body& t, const RelationReference& r, Side side) {
  if (r.is_place()) return condition(false, r.id + " has no sides");
  const Shape& shape = r.shape();
  const Frame frame = frame_of(c, r);
  const Vec2d out = direction_of(frame, side);
  const double past = extent(t.shape, out).lo - extent(shape, out).hi;
  const Vec2d along = side == Side::kFront || side == Side::kBack ? frame.x : frame.y;
  return all_of({at_least(fmt::format("{} is beyond the {} side of {} by", t.id(), name_of(side), r.id), past, 0, c.slack()),
                 in_line(c, t, shape, along)});
}

Finding at_side(const RelationCase& c, const Body& t, const RelationReference& r, Side side) {
  if (r.is_place()) return condition(false, r.id + " has no sides");
  const Shape& shape = r.shape();
  const Vec2d out = direction_of(shape.frame, side);
  const Interval a = extent(t.shape, out), b = extent(shape, out);
  const Vec2d along = side == Side::kFront || side == Side::kBack ? shape.frame.x : shape.frame.y;
  return all_of({at_least(fmt::format("{} stands out at the {} side of {} by", t.id(), name_of(side), r.id), a.hi - b.hi, 0, c.slack()),
                 at_least(fmt::format("{} is past the middle of {} by", t.id(), r.id), a.lo - b.mid(), 0, c.slack()),
                 in_line(c, t, shape, along)});
}

Finding at_any_side(const RelationCase& c, const Body& t, const RelationReference& r, const std::vector<Side>& sides) {
  std::vector<Finding> findings;
  for (const Side side : sides) findings.push_back(at_side(c, t, r, side));
  return any_of(std::move(findings), "there is no such side");
}

Finding covers(const RelationCase& c, const Body& t, const Shape& r, double grow, const std::string& reference) {
  std::vector<Finding> findings;
  for (const Vec2d axis : {r.frame.x, r.frame.y}) {
    const Interval a = extent(t.shape, axis), b = extent(r, axis);
    const double half_r = b.half() + grow;
    findings.push_back(at_most(fmt::format("middles of {} and {} apart by", t.id(), reference), std::abs(a.mid() - b.mid()),
                               std::max(a.half(), half_r) - std::min(a.half(), half_r) / 2, c.slack()));
  }
  return all_of(std::move(findings));
}

Side eyes_of(const Body& t, const RoomView& view) {
  const std::vector<Side>& used = t.object->used_sides;
  if (!t.entry->is(Trait::kDeskLike) || (!used.empty() && used.front() != Side::kFront)) return Side::kFront;
  for (const PlacedRelation& placed : view.layout.relations) {
    const Relation& relation = placed.relation;
    if (relation.type != RelationType::kBehind || std::ranges::find(relation.references, t.id()) == relation.references.end()) continue;
    for (const std::string& id : relation.targets) {
      const Body* seat = view.find_body(id);
      if (seat != nullptr && seat->entry->is(Trait::kTableSeat)) return Side::kFront;
    }
  }
  return Side::kBack;
}

Finding looks_at(const Body& t, const RelationReference& r, const RoomView& view, Side eyes) {
  if (!t.has_front) return condition(true, t.id() + " has no front");
  const Shape middle{{{view.floor_x.mid(), view.floor_y.mid()}}, {}, {}, {}};
  const Shape& shape = r.is_place() ? middle : r.shape();
  const Vec2d front = direction_of(t.own_frame, eyes);
  const Interval ahead = extent(shape, front), across = extent(shape, t.own_frame.x);
  const double from = dot(t.shape.center, front), off = std::abs(across.mid() - dot(t.shape.center, t.own_frame.x));
  const std::string what = fmt::format("{} is turned from {} by", t.id(), r.id);
  if (ahead.hi < from + t.depth / 2 - kTiny) return degrees_at_most(what, 180, kLookAngle);
  const bool ray_meets_it = off <= across.half() + kTiny;
  return degrees_at_most(what, ray_meets_it ? 0.0 : std::atan2(off, std::max(0.0, ahead.lo - from)) * (180.0 / kPi), kLookAngle);
}

Finding shares_along(const RelationCase& c, const Body& t, const Face& face, double share) {
  const Interval a = extent(t.shape, face.along), b = extent(face.shape, face.along);
  const double shorter = std::min(a.length(), b.length());
  return at_least(fmt::format("{} is in front of {} over", t.id(), face.id), overlap(a, b), shorter * share, c.slack());
}

namespace {

// What stands at a wall and is turned by a degree has a corner in it, metres.
constexpr double kTurnedCorner = 0.01;

// How far a body is on the other side of a wall's inner face.
double reach_through(const Body& t, const Face& wall) {
  return std::max(0.0, dot(wall.start, wall.inward) - extent(t.shape, wall.inward).lo);
}

}  // namespace

Finding side_along_wall(const RelationCase& c, const Body& t, const Face& wall, const std::vector<Side>& sides, double max_gap) {
  std::vector<Finding> findings;
  for (const Side which : sides) {
    // The direction of a side as the body stands, where it has no front that of the room's side it is nearest to.
    const Vec2d outward = t.has_front ? side_of(t, which).outward : direction_of(t.shape.frame, which);
    const double turn = std::acos(std::clamp(dot(outward, wall.inward * -1), -1.0, 1.0)) * (180.0 / kPi);
    findings.push_back(
        degrees_at_most(fmt::format("the {} of {} is turned from {} by", name_of(which), t.id(), wall.id), turn, kAngleSlack));
  }
  return all_of({any_of(std::move(findings), "there is no such side"),
                 at_most(fmt::format("gap between {} and {}", t.id(), wall.id), gap(t.shape, wall.shape), max_gap, c.slack()),
                 at_most(fmt::format("{} reaches through {} by", t.id(), wall.id), reach_through(t, wall), kTurnedCorner, c.slack()),
                 shares_along(c, t, wall, 0.5)});
}

Finding keeps_out_of_opening(const RelationCase& c, const Body& t, const Face& opening, std::optional<double> depth) {
  if (t.rug || (opening.is_window() && t.curtain)) return condition(true, t.id() + " is in nobody's way");
  const double before = penetration(t.shape, depth ? space_before(opening, *depth) : space_before(opening));
  return all_of(
      {at_most(fmt::format("{} reaches into the space before {} by", t.id(), opening.id), std::max(0.0, before), 0, c.slack()),
       at_most(fmt::format("{} reaches into the swing of {} by", t.id(), opening.id), swing_intrusion(opening, t), 0, c.slack())});
}

}  // namespace layoutbox::checks
