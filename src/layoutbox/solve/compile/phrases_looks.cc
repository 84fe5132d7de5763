#include "layoutbox/solve/compile/phrases.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace layoutbox::placement {
namespace {

constexpr int kNormalise = 1000;  // directions at odd angles are whole numbers in thousandths
// tan 15° as a fraction; within what the verifier calls 15°.
constexpr std::int32_t kLookAcross = 100000, kLookAhead = 26794;

}  // namespace

Side looking_side(const PlacementModel& model, ItemId item) {
  const Item& self = model.items[item];
  if (!self.is(Trait::kDeskLike) || used_side(self) != Side::kFront) return Side::kFront;
  const auto has = [](const std::vector<std::string>& ids, const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  const bool used_from_behind = std::any_of(model.scene->relations.begin(), model.scene->relations.end(), [&](const Relation& r) {
    const auto sits = [&](const std::string& id) {
      const ItemId seat = model.find_item(id);
      return seat.exists() && model.items[seat].is(Trait::kTableSeat);
    };
    return r.type == RelationType::kBehind && has(r.references, self.id) && std::any_of(r.targets.begin(), r.targets.end(), sits);
  });
  return used_from_behind ? Side::kFront : Side::kBack;
}

void add_looks_at(Formula& f, const PlacementModel& model, ItemId t, ItemId r, Side eyes) {
  const Item& item = model.items[t];
  if (!item.has_front) {
    f.add().wish(Linear(0), 1);
    return;
  }
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    if (!quarter(turn)) {
      const double angle = radians_from_degrees(item.states[static_cast<std::size_t>(std::countr_zero(states))].angle);
      const int length = eyes == Side::kBack ? -kNormalise : kNormalise;
      const auto nx = static_cast<std::int32_t>(std::lround(std::sin(angle) * length));
      const auto ny = static_cast<std::int32_t>(std::lround(-std::cos(angle) * length));
      const Linear dx = mid2(r, 0) - mid2(t, 0), dy = mid2(r, 1) - mid2(t, 1);
      const Linear ahead = nx * dx + ny * dy, aside = nx * dy - ny * dx;
      Case& c = f.add().when(t, states);  // within 7.6°: tan = 2/15, and before its front: not what stands on it
      c.require(ahead - Linear(std::int64_t{kNormalise} * item.states[static_cast<std::size_t>(std::countr_zero(states))].size.depth));
      c.require(2 * ahead - 15 * aside).require(2 * ahead + 15 * aside);
      c.wish(aside, 100, 2 * kNormalise);
      return;
    }
    const Direction d = side_direction(item, eyes, turn);
    const int a = across(d);
    const Linear off = mid2(t, a) - mid2(r, a);
    const Linear ahead = reach(r, d) - reach(t, d);
    // Its whole front looks at r, or r's near edge is within 15°, or the ray from its middle meets r.
    Case& whole = f.add().when(t, states).require(ahead);
    whole.require(lo(t, a) - lo(r, a)).require(hi(r, a) - hi(t, a)).wish(off, 100, 2);
    Case& cone = f.add().when(t, states).require(ahead);
    const Linear distance2 = Linear(0) - 2 * reach(r, opposite(d)) - d.sign * mid2(t, d.axis);
    cone.require(kLookAhead * distance2 - kLookAcross * off).require(kLookAhead * distance2 + kLookAcross * off).wish(off, 100, 2);
    Case& middle = f.add().when(t, states).require(ahead);
    middle.require(extent(r, a) - off).require(extent(r, a) + off).wish(off, 100, 2);
    middle.price = 80;
  });
  const bool odd = std::any_of(item.states.begin(), item.states.end(), [](const State& s) { return !quarter(s.turn); });
  if (!odd) return;
  f.outer = f.cases;
  f.exact = false;
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    if (!quarter(turn)) f.outer.emplace_back().when(t, states);
  });
}

void add_looks_with_group(Formula& f, const PlacementModel& model, ItemId t, const std::vector<ItemId>& group, ItemId r) {
  const Item& item = model.items[t];
  add_looks_at(f, model, t, r);
  if (!item.has_front) return;
  const bool known = f.exact || !f.outer.empty();
  const auto n = static_cast<std::int32_t>(group.size());
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    if (!quarter(turn)) return;
    const Direction d = side_direction(item, Side::kFront, turn);
    const int a = across(d);
    Linear off = Linear(0) - n * mid2(r, a), back = Linear(0);
    for (const ItemId member : group) off = off + mid2(member, a), back = back + mid2(member, d.axis);
    const Linear ahead = reach(r, d) - reach(t, d);
    const Linear distance2 = Linear(0) - 2 * n * reach(r, opposite(d)) - d.sign * back;
    Case middle, cone;
    middle.when(t, states).require(ahead).require(n * extent(r, a) - off).require(n * extent(r, a) + off).wish(off, 100, 2 * n);
    cone.when(t, states).require(ahead);
    cone.require(kLookAhead * distance2 - kLookAcross * off).require(kLookAhead * distance2 + kLookAcross * off).wish(off, 100, 2 * n);
    for (Case* one : {&middle, &cone}) {
      f.cases.push_back(*one);
      if (!f.exact && known) f.outer.push_back(*one);
    }
  });
}

void add_looks_at_wall(Formula& f, const PlacementModel& model, ItemId t, const RoomWall& wall, Side eyes) {
  const Item& item = model.items[t];
  if (!item.has_front) {
    f.add();
    return;
  }
  if (!model.outside.empty()) f.exact = false;  // past the end of a wall there may be more room, from where it can be seen
  const Direction towards{wall.normal(), -wall.inward};
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    if (!wall.straight || !quarter(turn) || !(side_direction(item, eyes, turn) == towards)) return;
    f.add()
        .when(t, states)
        .require(mid2(t, wall.along) - Linear(2 * wall.lo))
        .require(Linear(2 * wall.hi) - mid2(t, wall.along))
        .require(Linear(std::int64_t{towards.sign} * wall.at) - reach(t, towards));
  });
}

void add_looks_at_point(Formula& f, const PlacementModel& model, ItemId t, Point point, Side eyes) {
  const Item& item = model.items[t];
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    if (!item.has_front || !quarter(turn)) return;
    const Direction d = side_direction(item, eyes, turn);
    const std::int64_t at = std::int64_t{d.sign} * (d.axis == 0 ? point.x : point.y);
    const Linear ahead2 = Linear(2 * at) - d.sign * mid2(t, d.axis);
    const Linear off2 = mid2(t, across(d)) - Linear(2 * (across(d) == 0 ? point.x : point.y));
    Case& c = f.add().when(t, states).require(Linear(at) - reach(t, d));
    c.require(kLookAhead * ahead2 - kLookAcross * off2).require(kLookAhead * ahead2 + kLookAcross * off2).wish(off2, 50, 2);
  });
  if (!item.has_front) f.add();
}

}  // namespace layoutbox::placement
