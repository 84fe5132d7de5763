// The paper's four relations.
#include <cmath>
#include <optional>

#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {
namespace {

enum class Which { kLow, kMiddle, kHigh };

Edge edge_meant(const Compilation& c) { return or_default(c.relation, &RelationParameters::edge); }

Which which_edge(Edge edge) {
  if (edge == Edge::kMin || edge == Edge::kLeft || edge == Edge::kFront || edge == Edge::kBottom) return Which::kLow;
  return edge == Edge::kCenter ? Which::kMiddle : Which::kHigh;
}

std::vector<int> axes_meant(const Compilation& c) {
  const Edge edge = edge_meant(c);
  if (edge == Edge::kLeft || edge == Edge::kRight) return {0};
  if (edge == Edge::kFront || edge == Edge::kBack) return {1};
  if (edge == Edge::kBottom || edge == Edge::kTop) return {2};
  if (!c.relation.parameters.axis) return {0, 1};
  return {static_cast<int>(*c.relation.parameters.axis)};
}

constexpr std::int32_t kOtherSide = 3000;  // points for the side where the scene's own positions do not have it

// On which side of r the scene's own positions have t, along the relation's axis or else the one along which they are farther apart.
std::optional<Direction> hinted_side(const Compilation& c, ItemId t, ItemId r) {
  const Item &target = c.item(t), &ref = c.item(r);
  if (target.is_opening() || ref.is_opening() || !target.object->hint.position || !ref.object->hint.position) return std::nullopt;
  const auto off = [&](int axis) { return (*target.object->hint.position)[axis] - (*ref.object->hint.position)[axis]; };
  const int axis = c.relation.parameters.axis             ? static_cast<int>(*c.relation.parameters.axis)
                   : std::abs(off(0)) >= std::abs(off(1)) ? 0
                                                          : 1;
  if (std::abs(off(axis)) < 1) return std::nullopt;
  return Direction{axis, off(axis) > 0 ? 1 : -1};
}

// Twice the coordinate that is to be equal.
Linear edge2(const Linear& low, const Linear& high, Which which) {
  if (which == Which::kLow) return 2 * low;
  if (which == Which::kHigh) return 2 * high;
  return low + high;
}

void align_all(Compilation& c) {
  const Which which = which_edge(edge_meant(c));
  Formula& f = c.formula();
  for (const int axis : axes_meant(c)) {
    std::vector<Linear> edges;
    for (const ItemId t : c.targets) edges.push_back(edge2(lo(t, axis), hi(t, axis), which));
    for (const Reference& r : c.references) {
      const Place place = c.place(r);
      edges.push_back(edge2(place.lo[axis], place.hi[axis], which));
    }
    Case& in = f.add();
    for (std::size_t i = 1; i < edges.size(); ++i) in.require_small(edges[i] - edges[0], 1);
  }
}

void offset_from_wall(Formula& f, const Compilation& c, ItemId t, const RoomWall& wall, Mm distance) {
  const int axis = c.relation.parameters.axis ? static_cast<int>(*c.relation.parameters.axis) : wall.normal();
  if (!wall.straight) f.exact = false;
  if (c.relation.parameters.edge == Edge::kCenter && axis == wall.normal()) {
    constexpr Mm kOfSlack = 10;  // twice half a step of the grid, which may lie between
    f.add().require_small(mid2(t, axis) - Linear(2 * (wall.at + wall.inward * distance)), kOfSlack);
  } else if (axis == wall.normal()) {
    for (const int sign : {wall.inward, -wall.inward}) {  // past a corner of the room there may be room behind a wall's line
      Case& in = f.add().require_small(gap_towards(t, place_of(c.model, wall), {axis, sign}) - Linear(distance), 0);
      if (sign != wall.inward) in.price = 100;
    }
  } else if (axis == wall.along) {  // from either end of the wall
    f.add().require_small(lo(t, axis) - Linear(wall.lo + distance), 0);
    f.add().require_small(Linear(wall.hi - distance) - hi(t, axis), 0);
  }
}

void offset_from_item(Formula& f, const Compilation& c, ItemId t, ItemId r, Mm distance) {
  const std::optional<Axis>& asked = c.relation.parameters.axis;
  const std::vector<int> axes = asked ? std::vector{static_cast<int>(*asked)} : std::vector{0, 1};
  for (const int axis : axes) {
    for (const int sign : {1, -1}) {
      Case& in = f.add();
      if (const auto side = hinted_side(c, t, r); side && !(*side == Direction{axis, sign})) in.price = kOtherSide;
      in.require_small(gap_towards(t, r, {axis, sign}) - Linear(distance), 0);
      if (asked) continue;
      for (const int way : {1, -1}) in.require(Linear(distance) - gap_towards(t, r, {1 - axis, way}));  // the axis with the larger gap
    }
  }
}

}  // namespace

void compile_Offset(Compilation& c) {
  const Mm distance = c.relation.parameters.distance.value_or(0);
  for (const ItemId t : c.targets) {
    for (const Reference& r : c.references) {
      Formula& f = c.formula();
      if (r.kind == Reference::Kind::kWall) offset_from_wall(f, c, t, c.model.walls[r.wall], distance);
      if (r.kind == Reference::Kind::kItem) offset_from_item(f, c, t, r.item, distance);
    }
  }
}

void compile_Align(Compilation& c) { align_all(c); }
void compile_GroupAlign(Compilation& c) { align_all(c); }

void compile_Inside(Compilation& c) {
  const std::vector<Reference> room{{Reference::Kind::kRoom, {}, {}}};
  for (const ItemId t : c.targets) {
    for (const Reference& r : c.references.empty() ? room : c.references) {
      const Place place = c.place(r);
      Case& in = c.formula().add();
      for (int axis = 0; axis < 2; ++axis) in.require(lo(t, axis) - place.lo[axis]).require(place.hi[axis] - hi(t, axis));
      if (r.kind == Reference::Kind::kRoom) in.require(place.hi[2] - hi(t, 2));
    }
  }
}

}  // namespace layoutbox::placement
