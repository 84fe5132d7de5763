// The four relations of the paper: offset, align, inside, groupAlign.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/verify/checks.h"
#include "layoutbox/verify/relation_check.h"

namespace layoutbox::checks {
namespace {

double edge_gap(Interval a, Interval b) { return -overlap(a, b); }

Axis offset_axis(const RelationCase& c, const Body& t, const RelationReference& r) {
  if (c.relation.parameters.axis) return *c.relation.parameters.axis;
  if (r.is_wall()) return std::abs(r.face->inward.x) > std::abs(r.face->inward.y) ? Axis::kX : Axis::kY;
  const double x = edge_gap(room_extent(t, Axis::kX), room_extent(c, r, Axis::kX));
  const double y = edge_gap(room_extent(t, Axis::kY), room_extent(c, r, Axis::kY));
  return x >= y ? Axis::kX : Axis::kY;
}

// True when the axis runs along a wall: distances are then from its ends.
bool along_wall(const RelationReference& r, Axis axis) {
  if (!r.is_wall() || axis == Axis::kZ) return false;
  const double along = axis == Axis::kX ? r.face->along.x : r.face->along.y;
  return std::abs(along) > 0.999;
}

double coordinate(Interval extent, Edge edge) {
  switch (edge) {
    case Edge::kMin:
    case Edge::kLeft:
    case Edge::kFront:
    case Edge::kBottom: return extent.lo;
    case Edge::kMax:
    case Edge::kRight:
    case Edge::kBack:
    case Edge::kTop: return extent.hi;
    case Edge::kCenter: break;
  }
  return extent.mid();
}

Finding aligned_along(const RelationCase& c, Axis axis, Edge edge) {
  std::vector<double> places;
  for (const Body* target : c.targets) places.push_back(coordinate(room_extent(*target, axis), edge));
  for (const RelationReference& reference : c.references) places.push_back(coordinate(room_extent(c, reference, axis), edge));
  if (places.empty()) return {};
  const auto [least, greatest] = std::minmax_element(places.begin(), places.end());
  return at_most(fmt::format("out of line along {} by", name_of(axis)), *greatest - *least, 0, c.slack());
}

Finding aligned(const RelationCase& c) {
  const Edge edge = or_default(c.relation, &RelationParameters::edge);
  if (edge == Edge::kLeft || edge == Edge::kRight) return aligned_along(c, Axis::kX, edge);
  if (edge == Edge::kFront || edge == Edge::kBack) return aligned_along(c, Axis::kY, edge);
  if (edge == Edge::kBottom || edge == Edge::kTop) return aligned_along(c, Axis::kZ, edge);
  if (c.relation.parameters.axis) return aligned_along(c, *c.relation.parameters.axis, edge);
  return any_of({aligned_along(c, Axis::kX, edge), aligned_along(c, Axis::kY, edge)}, {});
}

}  // namespace

Finding check_Offset(const RelationCase& c) {
  const double wanted = c.metres(&RelationParameters::distance).value_or(0);
  return each_pair(c, [&](const Body& t, const RelationReference& r) {
    const Axis axis = offset_axis(c, t, r);
    if (along_wall(r, axis)) {
      const Interval own = room_extent(t, axis), wall = room_extent(c, r, axis);
      const std::string what = fmt::format("{} from the end of {} along {}", t.id(), r.id, name_of(axis));
      return any_of({equal_to(what, own.lo - wall.lo, wanted, c.slack()), equal_to(what, wall.hi - own.hi, wanted, c.slack())}, {});
    }
    if (r.is_wall() && c.relation.parameters.edge == Edge::kCenter) {
      const Interval own = room_extent(t, axis), other = room_extent(c, r, axis);
      return equal_to(fmt::format("from the middle of {} to {} along {}", t.id(), r.id, name_of(axis)),
                      std::max({other.lo - own.mid(), own.mid() - other.hi, 0.0}), wanted, c.slack());
    }
    return equal_to(fmt::format("gap between {} along {}", name_of_pair(t, r), name_of(axis)),
                    edge_gap(room_extent(t, axis), room_extent(c, r, axis)), wanted, c.slack());
  });
}

Finding check_Align(const RelationCase& c) { return aligned(c); }

Finding check_GroupAlign(const RelationCase& c) { return aligned(c); }

Finding check_Inside(const RelationCase& c) {
  const auto in_room = [&](const Body& t) {
    const double area = signed_area(t.shape.plan);
    const double off = area > 0 ? std::max(0.0, 1 - signed_area(clip(c.view.floor, t.shape.plan)) / area) : 0.0;
    return all_of({condition(off <= 0.01, fmt::format("{:.1f} % of the footprint of {} is off the floor, at most 1 %", off * 100, t.id())),
                   at_most(fmt::format("the top of {} is at", t.id()), t.top(), c.view.height, c.slack())});
  };
  if (c.references.empty()) return each_target(c, in_room);
  return each_pair(c, [&](const Body& t, const RelationReference& r) {
    if (r.is_place()) return in_room(t);
    std::vector<Finding> findings;
    for (const Vec2d axis : {r.shape().frame.x, r.shape().frame.y}) {
      const Interval a = extent(t.shape, axis), b = extent(r.shape(), axis);
      findings.push_back(at_most(fmt::format("{} reaches out of {} by", t.id(), r.id), std::max(b.lo - a.lo, a.hi - b.hi), 0, c.slack()));
    }
    return all_of(std::move(findings));
  });
}

}  // namespace layoutbox::checks
