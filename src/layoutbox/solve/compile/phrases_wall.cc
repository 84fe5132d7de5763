#include "layoutbox/solve/compile/phrases.h"

#include <cmath>

#include "layoutbox/solve/model/slanted.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kFlush = 3;  // off a slanted wall, that some whole millimetre may be there

}  // namespace

void require_near_wall(Case& c, const PlacementModel& model, ItemId t, const RoomWall& wall, Mm most) {
  c.require(Linear(most) - gap_towards(t, place_of(model, wall), {wall.normal(), wall.inward}));
  c.require(hi(t, wall.along) - Linear(wall.lo)).require(Linear(wall.hi) - lo(t, wall.along));
}

void require_near_slanted_wall(Case& c, const PlacementModel& model, ItemId t, const RoomWall& wall, Mm most) {
  const std::int64_t millimetre = 2 * kHeading;
  const auto length = static_cast<std::int64_t>(std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y));
  const Linear along = along_wall2(model, t, wall);
  c.require(Linear(millimetre * most) - slanted_gap2(model, t, wall), millimetre);
  c.require(along, millimetre).require(Linear(millimetre * length) - along, millimetre);
}

void wish_middle_of_wall(Case& c, const PlacementModel& model, ItemId t, const RoomWall& wall, int weight) {
  if (wall.straight) {
    c.wish(mid2(t, wall.along) - Linear(std::int64_t{wall.lo} + wall.hi), weight, 2);
    return;
  }
  const double length = std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y);
  c.wish(along_wall2(model, t, wall) - Linear(static_cast<std::int64_t>(kHeading * length)), weight, 2 * kHeading);
}

void wish_beside_on_wall(Case& c, const PlacementModel& model, ItemId t, ItemId r, const RoomWall& wall, int weight) {
  if (wall.straight) {
    c.wish(mid2(t, wall.along) - mid2(r, wall.along), weight, 2);
    c.wish(mid2(t, wall.normal()) - mid2(r, wall.normal()), weight / 2, 2);
    return;
  }
  c.wish(along2(model, t, wall.along_heading) - along2(model, r, wall.along_heading), weight, 2 * kHeading);
  c.wish(along2(model, t, wall.normal_heading) - along2(model, r, wall.normal_heading), weight / 2, 2 * kHeading);
}

std::vector<Case> away_from_angled(const PlacementModel& model, ItemId t, const RoomWall& wall, Mm least) {
  std::vector<Case> cases;
  const Place box = place_of(model, wall);  // the least that is surely enough: away from the box around it
  Place around = box;
  const Wall& drawn = model.scene->room.walls[model.walls.id_of(wall).index()];
  around.lo[0] = std::min(drawn.start.x, drawn.end.x), around.hi[0] = std::max(drawn.start.x, drawn.end.x);
  around.lo[1] = std::min(drawn.start.y, drawn.end.y), around.hi[1] = std::max(drawn.start.y, drawn.end.y);
  add_apart(cases, model, t, around, least, Purpose::kPlacing);
  return cases;
}

std::uint64_t states_with_back_to(const Item& item, const RoomWall& wall) { return states_with_side_to(item, wall, Side::kBack); }

std::uint64_t states_where(const Item& r, Side one, Side meant) {
  if (meant != Side::kLong && meant != Side::kShort) return one == meant ? r.all_states : 0;
  std::uint64_t mask = 0;
  for (std::size_t s = 0; s < r.states.size(); ++s) {
    const State& state = r.states[s];
    const Direction d = side_direction(r, one, state.turn);
    const Mm length = state.extent[across(d)], other = state.extent[d.axis];
    if (length == other || (length > other) == (meant == Side::kLong)) mask |= std::uint64_t{1} << s;
  }
  return mask;
}

namespace {

// Whatever hangs on a wall is flat on it, its back to that: an axe as well, which has no front where it lies.
bool is_turned_to_walls(const Item& item) { return item.has_front || item.mount == Mount::kWall; }

// With that side to a slanted wall. No front: any side, or that which is the longer or shorter.
std::uint64_t states_with_side_to_slanted(const Item& item, const RoomWall& wall, Side side) {
  if (is_turned_to_walls(item)) {
    switch (side) {
      case Side::kBack: return states_at_angle(item, wall.angle, 360);
      case Side::kRight: return states_at_angle(item, wall.angle + 90, 360);
      case Side::kFront: return states_at_angle(item, wall.angle + 180, 360);
      case Side::kLeft: return states_at_angle(item, wall.angle + 270, 360);
      default: return 0;
    }
  }
  std::uint64_t mask = 0;
  const std::uint64_t all_along = states_at_angle(item, wall.angle, 180), all_across = states_at_angle(item, wall.angle + 90, 180);
  for (std::size_t s = 0; s < item.states.size(); ++s) {
    const bool along = (all_along >> s & 1) != 0, across = (all_across >> s & 1) != 0;
    const Size& size = item.states[s].size;
    const Mm beside = along ? size.width : size.depth, off = along ? size.depth : size.width;
    const bool meant = side == Side::kLong ? beside >= off : side != Side::kShort || beside <= off;
    if ((along || across) && meant) mask |= std::uint64_t{1} << s;
  }
  return mask;
}

}  // namespace

std::uint64_t states_with_side_to(const Item& item, const RoomWall& wall, Side side) {
  if (!wall.straight) return states_with_side_to_slanted(item, wall, side);
  const Direction towards{wall.normal(), -wall.inward};
  if (!item.has_front && is_turned_to_walls(item) && side == Side::kBack) {
    std::uint64_t flat = 0;
    for_each_turn(item, [&](int turn, std::uint64_t states) {
      if (quarter(turn) && turned({1, 1}, turn) == towards) flat |= states;
    });
    return flat;
  }
  const bool by_length = side == Side::kLong || side == Side::kShort;
  std::uint64_t mask = 0;
  for (const Side one : {Side::kFront, Side::kBack, Side::kLeft, Side::kRight}) {
    if (item.has_front && !by_length && one != side) continue;
    const std::uint64_t meant = by_length ? states_where(item, one, side) : item.all_states;
    for_each_turn(item, [&](int turn, std::uint64_t states) {
      if (quarter(turn) && side_direction(item, one, turn) == towards) mask |= states & meant;
    });
  }
  return mask;
}

void add_against_slanted(Formula& f, const PlacementModel& model, ItemId t, std::uint64_t states, const RoomWall& wall, Mm gap) {
  f.exact = false;
  if (!states || model.items[t].spans < 0) return;
  const Linear off = slanted_gap2(model, t, wall), along = along_wall2(model, t, wall), half = span(model, t, wall.along_heading);
  const std::int64_t millimetre = 2 * kHeading;
  Case& c = f.add().when(t, states);
  // Its place is in whole millimetres: nothing is nearer than one of them allows.
  c.require(off, millimetre).require(Linear(millimetre * std::max(gap, kFlush)) - off, millimetre).wish(off, 400, millimetre);
  const double length = std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y);
  c.require(along - half, millimetre);
  c.require(Linear(static_cast<std::int64_t>(millimetre * length)) - along - half, millimetre);
}

void add_against(Formula& f, const PlacementModel& model, ItemId t, std::uint64_t states, const RoomWall& wall, Mm gap, bool whole) {
  if (!wall.straight) {
    add_against_slanted(f, model, t, states, wall, gap);
    return;
  }
  if (!states) return;
  const Item& item = model.items[t];
  const Direction out{wall.normal(), wall.inward};
  Case c;
  if (states != item.all_states) c.when(t, states);
  const Linear off = Linear(0) - reach(t, opposite(out)) - Linear(std::int64_t{wall.inward} * wall.at);
  c.require(off).require(Linear(gap) - off).wish(off, 400);
  const bool open_ends = wall.lo > model.room.lo[wall.along] || wall.hi < model.room.hi[wall.along];
  if (!whole && open_ends) {  // half of it before the wall will do
    for (Case& loose : in_line(c, model, t, place_of(model, wall), wall.along, Facing::kHalf)) {
      loose.price += 200;
      f.cases.push_back(std::move(loose));
    }
  }
  c.require(lo(t, wall.along) - Linear(wall.lo)).require(Linear(wall.hi) - hi(t, wall.along));
  f.cases.push_back(std::move(c));
}

}  // namespace layoutbox::placement
