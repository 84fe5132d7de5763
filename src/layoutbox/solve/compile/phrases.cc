#include "layoutbox/solve/compile/phrases.h"

#include <cmath>

namespace layoutbox::placement {
namespace {

constexpr Mm kKnees = 300;           // how high what is free below must be for legs
constexpr double kSameAngle = 0.01;  // degrees

Mm greatest_extent(const Item& item, int axis) {
  Mm greatest = 0;
  for (const State& state : item.states) greatest = std::max(greatest, state.extent[axis]);
  return greatest;
}

}  // namespace

Place place_of(ItemId item) {
  Place place;
  place.item = item;
  for (int axis = 0; axis < 3; ++axis) place.lo[axis] = lo(item, axis), place.hi[axis] = hi(item, axis);
  return place;
}

Place place_of(const PlacementModel& model, const RoomWall& wall) {
  Place place;
  place.lo[wall.along] = wall.lo, place.hi[wall.along] = wall.hi;
  place.lo[wall.normal()] = place.hi[wall.normal()] = wall.at;
  place.lo[2] = model.room.lo[2], place.hi[2] = model.room.hi[2];
  return place;
}

bool has_knee_room(const Item& item) {
  return std::any_of(item.spaces.begin(), item.spaces.end(), [&](const ItemSpace& s) {
    return !s.carries && item.states[0].constants[static_cast<std::size_t>(s.quantity - kFirstConstant) + 5] >= kKnees;
  });
}

Side used_side(const Item& item) {
  const std::vector<Side> used = item.object->used_sides.value_or(item.entry->used_sides);
  return used.empty() ? Side::kFront : used[0];
}

void for_each_turn(const Item& item, const std::function<void(int, std::uint64_t)>& visit) {
  std::vector<int> seen;
  for (const State& state : item.states) {
    if (std::find(seen.begin(), seen.end(), state.turn) != seen.end()) continue;
    seen.push_back(state.turn);
    visit(state.turn, item.states_at(state.turn));
  }
}

Linear gap_towards(const Place& t, const Place& r, Direction d) {
  return d.sign > 0 ? t.lo[d.axis] - r.hi[d.axis] : r.lo[d.axis] - t.hi[d.axis];
}

Linear gap_towards(ItemId t, const Place& r, Direction d) { return gap_towards(place_of(t), r, d); }

bool floor_only(const Item& item) {
  return !item.is_opening() && item.supports.size() == 1 && item.supports[0].kind == SupportOption::Kind::kFloor;
}

std::uint64_t states_at_angle(const Item& item, double angle, double period) {
  std::uint64_t mask = 0;
  for (std::size_t s = 0; s < item.states.size(); ++s) {
    if (std::abs(std::remainder(item.states[s].angle - angle, period)) < kSameAngle) mask |= std::uint64_t{1} << s;
  }
  return mask;
}

std::optional<SignedHeading> signed_heading(const PlacementModel& model, double degrees) {
  for (std::size_t k = 0; k < model.headings.size(); ++k) {
    const double off = std::remainder(degrees - model.headings[k].angle, 360);
    if (std::abs(off) < kSameAngle) return SignedHeading{static_cast<int>(k), 1};
    if (std::abs(std::abs(off) - 180) < kSameAngle) return SignedHeading{static_cast<int>(k), -1};
  }
  return std::nullopt;
}

std::vector<PartPlace> parts_of(const PlacementModel& model, ItemId index) {
  const Item& item = model.items[index];
  std::vector<PartPlace> parts;
  if (quarter_states(item)) parts.push_back({place_of(index), quarter_states(item)});
  if (item.odd_states == 0) return parts;
  const auto constant = [&](int k) { return constant_of(index, item.footprint + k); };
  PartPlace within{place_of(index), item.odd_states};
  for (int axis = 0; axis < 2; ++axis) {
    within.place.lo[axis] = lo(index, axis) + constant(axis);
    within.place.hi[axis] = lo(index, axis) + constant(2 + axis);
  }
  parts.push_back(within);
  for (int corner = 0; corner < 4; ++corner) {
    PartPlace point = within;
    point.corner = true;
    for (int axis = 0; axis < 2; ++axis) point.place.lo[axis] = point.place.hi[axis] = lo(index, axis) + constant(4 + 2 * corner + axis);
    parts.push_back(point);
  }
  return parts;
}

std::vector<Case> in_line(const Case& base, const PlacementModel& model, ItemId t, const Place& r, int axis, Facing facing) {
  // |mid(t) − mid(r)| ≤ max(half) − min(half)/5, or ≤ max(half).
  constexpr int kFifths = 5;
  const Linear off = mid2(t, axis) - r.lo[axis] - r.hi[axis];
  const auto within = [&](const Linear& longer, const Linear& shorter) {
    Case c = base;
    if (facing == Facing::kHalf)
      c.require(longer - off).require(longer + off);
    else
      c.require(kFifths * longer - shorter - kFifths * off).require(kFifths * longer - shorter + kFifths * off);
    return c;
  };
  const Linear length = r.hi[axis] - r.lo[axis];
  const Item& item = model.items[t];
  const Mm shortest = r.item.exists() ? model.items[r.item].least_extent(axis) : static_cast<Mm>(length.constant);
  const Mm longest = r.item.exists() ? greatest_extent(model.items[r.item], axis) : static_cast<Mm>(length.constant);
  std::vector<Case> cases;
  if (item.least_extent(axis) < longest) cases.push_back(within(length, extent(t, axis)));
  if (greatest_extent(item, axis) >= shortest || cases.empty()) cases.push_back(within(extent(t, axis), length));
  return cases;
}

std::vector<Case> cover(const Case& base, const PlacementModel& model, ItemId t, ItemId r, Mm grow) {
  // |mid(t) − mid(r)| ≤ max(half) − min(half)/2 along both axes: one case for each that may be the greater.
  const Item &a = model.items[t], &b = model.items[r];
  std::vector<Case> cases{base};
  for (int axis = 0; axis < 2; ++axis) {
    const Linear off = mid2(t, axis) - mid2(r, axis);
    std::vector<Case> next;
    for (const Case& c : cases) {
      if (b.least_extent(axis) + 2 * grow < greatest_extent(a, axis)) {  // t may be the greater
        const Linear bound2 = 2 * extent(t, axis) - extent(r, axis) - Linear(2 * grow);
        next.push_back(c);
        next.back().require(bound2 - 2 * off).require(bound2 + 2 * off);
      }
      if (greatest_extent(b, axis) + 2 * grow >= a.least_extent(axis)) {
        const Linear bound2 = 2 * extent(r, axis) + Linear(4 * grow) - extent(t, axis);
        next.push_back(c);
        next.back().require(bound2 - 2 * off).require(bound2 + 2 * off);
      }
    }
    cases = std::move(next);
  }
  return cases;
}

std::uint64_t states_with_width_along(const Item& item, int axis) {
  std::uint64_t mask = 0;
  for (std::size_t s = 0; s < item.states.size(); ++s) {
    const int turn = item.states[s].turn;
    if (quarter(turn) && (turn % 180 == 0) == (axis == 0)) mask |= std::uint64_t{1} << s;
  }
  return mask;
}

std::vector<std::vector<ItemId>> orders_of(const PlacementModel& model, const Relation& relation, std::vector<ItemId> things) {
  if (things.size() < 2) return {things};
  // Alike: one kind, one size, nothing said of one that is not said of the others in this very relation.
  const auto is_alone = [&](ItemId t) {
    const std::string& id = model.items[t].id;
    const auto speaks = [&](const Relation& r) {
      const auto has = [&](const std::vector<std::string>& ids) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
      return &r != &relation && (has(r.targets) || has(r.references));
    };
    return !model.items[t].fixed && std::none_of(model.scene->relations.begin(), model.scene->relations.end(), speaks);
  };
  const Item& first = model.items[things[0]];
  const bool alike = std::all_of(things.begin(), things.end(), [&](ItemId t) {
    const Item& item = model.items[t];
    return item.entry == first.entry && item.mount == first.mount && item.states.size() == first.states.size() &&
           item.states[0].size == first.states[0].size && is_alone(t);
  });
  if (alike) return {things};
  if (things.size() > 4) return {};
  std::vector<std::vector<ItemId>> orders;
  std::sort(things.begin(), things.end());
  do {
    orders.push_back(things);
  } while (std::next_permutation(things.begin(), things.end()));
  return orders;
}

}  // namespace layoutbox::placement
