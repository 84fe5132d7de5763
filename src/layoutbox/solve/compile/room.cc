// Relations between an object and the room: walls, corners, middle, parts.
#include <cmath>

#include "layoutbox/solve/compile/phrases.h"
#include "layoutbox/solve/model/slanted.h"

namespace layoutbox::placement {
namespace {

// Twice the middle of the floor's extent.
std::int64_t twice_middle(const PlacementModel& model, int axis) { return std::int64_t{model.room.lo[axis]} + model.room.hi[axis]; }

// Both at once.
Case both(Case a, const Case& b) {
  a.states.insert(a.states.end(), b.states.begin(), b.states.end());
  a.at_least_zero.insert(a.at_least_zero.end(), b.at_least_zero.begin(), b.at_least_zero.end());
  a.wishes.insert(a.wishes.end(), b.wishes.begin(), b.wishes.end());
  a.price += b.price;
  return a;
}

// The inner angle between two walls that follow one another is under 180°, by more than a hair.
bool turns_left(const RoomWall& a, const RoomWall& b) {
  const double turn = std::remainder(b.angle - a.angle, 360);
  return turn > 1;
}

// One thing, its back to the wall and its middle before the wall's.
void centre_on_slanted(Formula& f, const Compilation& c, const RoomWall& wall, Mm gap) {
  f.exact = false;
  if (c.targets.size() != 1) return;
  const ItemId t = c.targets[0];
  const std::size_t known = f.cases.size();
  add_against(f, c.model, t, states_with_back_to(c.item(t), wall), wall, gap);
  const std::int64_t millimetre = 2 * kHeading;
  const double length = std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y);
  const Linear off = along_wall2(c.model, t, wall) - Linear(static_cast<std::int64_t>(kHeading * length));
  for (std::size_t i = known; i < f.cases.size(); ++i) {
    const Linear most(2 * millimetre);
    f.cases[i].require(most - off, millimetre).require(most + off, millimetre).wish(off, 10, millimetre);
  }
}

// In a corner of which a wall is slanted: near where they meet.
void stand_in_slanted_corner(Formula& f, const Compilation& c, ItemId t, const RoomWall& first, Mm most) {
  f.exact = false;
  Place corner;
  const Point& at = first.end;
  corner.lo[0] = corner.hi[0] = at.x, corner.lo[1] = corner.hi[1] = at.y;
  corner.lo[2] = c.model.room.lo[2], corner.hi[2] = c.model.room.hi[2];
  Case base;
  for (int axis = 0; axis < 2; ++axis) base.wish(mid2(t, axis) - Linear(2 * (axis == 0 ? at.x : at.y)), 200, 2);
  add_within(f.cases, base, c.model, t, corner, most, Purpose::kPlacing);
}

}  // namespace

void compile_AgainstWall(Compilation& c) {
  const Mm gap = c.length(&RelationParameters::gap);
  for (const ItemId t : c.targets) {
    Formula& f = c.formula();
    for (const WallId w : c.walls()) {
      const RoomWall& wall = c.model.walls[w];
      add_against(f, c.model, t, states_with_back_to(c.item(t), wall), wall, gap);
    }
  }
}

void compile_SideAgainstWall(Compilation& c) {
  const Mm gap = c.length(&RelationParameters::gap);
  const std::vector<Side> sides =
      c.relation.parameters.side ? std::vector{*c.relation.parameters.side} : std::vector{Side::kLeft, Side::kRight};
  for (const ItemId t : c.targets) {
    Formula& f = c.formula();
    for (const WallId w : c.walls()) {
      const RoomWall& wall = c.model.walls[w];
      std::uint64_t states = 0;
      for (const Side side : sides) states |= states_with_side_to(c.item(t), wall, side);
      add_against(f, c.model, t, states, wall, gap);
    }
  }
}

namespace {

constexpr int kIntoCorner = 700;  // points a metre: what is in a corner stands close to both walls

// A wall and the next meet in an inner corner.
bool is_inner_corner(const RoomWall& a, const RoomWall& b) {
  if (!a.straight || !b.straight) return turns_left(a, b);
  // Inner angle under 180°: the second wall runs the way the first one looks.
  return a.along != b.along && (b.runs_up ? 1 : -1) == a.inward;
}

// Of one wall that is named either end is meant, of several where two of them meet.
bool is_meant(const std::vector<WallId>& named, WallId first, WallId second) {
  const auto is_named = [&](WallId w) { return std::find(named.begin(), named.end(), w) != named.end(); };
  if (named.empty()) return true;
  return named.size() == 1 ? is_named(first) || is_named(second) : is_named(first) && is_named(second);
}

void stand_in_corner(Formula& f, const Compilation& c, ItemId t, const RoomWall& a, const RoomWall& b, Mm most) {
  if (!a.straight || !b.straight) return stand_in_slanted_corner(f, c, t, a, most);
  Case& inside = f.add();
  for (const RoomWall* wall : {&a, &b}) {
    require_near_wall(inside, c.model, t, *wall, most);
    const Linear off = gap_towards(t, place_of(c.model, *wall), {wall->normal(), wall->inward});
    inside.require(off).wish(off, kIntoCorner);
  }
}

}  // namespace

void compile_Corner(Compilation& c) {
  const Mm most = c.length(&RelationParameters::max);
  std::vector<WallId> named;
  for (const Reference& r : c.references) {
    if (r.kind == Reference::Kind::kWall) named.push_back(r.wall);
  }
  const auto is_named_at_all = [](const Reference& r) { return r.kind != Reference::Kind::kRoom; };
  if (named.empty() && std::any_of(c.references.begin(), c.references.end(), is_named_at_all)) {
    c.never();  // a corner of no wall
    return;
  }
  for (const ItemId t : c.targets) {
    Formula& f = c.formula();
    // Near the end of a wall that goes on past another the distance runs round a corner.
    if (!c.model.outside.empty()) f.exact = false;
    for (const WallId first : c.model.walls.ids()) {
      const WallId second = c.model.walls.next(first);
      const RoomWall &a = c.model.walls[first], &b = c.model.walls[second];
      if (is_inner_corner(a, b) && is_meant(named, first, second)) stand_in_corner(f, c, t, a, b, most);
    }
  }
}

void compile_CenterOfRoom(Compilation& c) {
  const Mm most = c.length(&RelationParameters::max);
  if (c.targets.size() == 1) {
    Case& in = c.formula().add();
    for (int axis = 0; axis < 2; ++axis) {
      const Linear off = mid2(c.targets[0], axis) - Linear(twice_middle(c.model, axis));
      in.require_small(off, 2 * most).wish(off, 300, 2);
    }
    return;
  }
  // The middle of the group's extent: some target is the lowest and some the highest along each axis.
  for (int axis = 0; axis < 2; ++axis) {
    Formula& f = c.formula();
    for (const ItemId low : c.targets) {
      for (const ItemId high : c.targets) {
        Case& in = f.add();
        for (const ItemId t : c.targets) {
          if (t != low) in.require(lo(t, axis) - lo(low, axis));
          if (t != high) in.require(hi(high, axis) - hi(t, axis));
        }
        const Linear off = lo(low, axis) + hi(high, axis) - Linear(twice_middle(c.model, axis));
        in.require_small(off, 2 * most).wish(off, 300, 2);
      }
    }
  }
}

void compile_CenteredOnWall(Compilation& c) {
  const Mm gap = c.length(&RelationParameters::gap);
  Formula& f = c.formula();
  for (const WallId w : c.walls()) {
    const RoomWall& wall = c.model.walls[w];
    if (!wall.straight) {
      centre_on_slanted(f, c, wall, gap);
      continue;
    }
    // All of them at the wall…
    std::vector<Case> ways{Case{}};
    for (const ItemId t : c.targets) {
      Formula one;
      add_against(one, c.model, t, states_with_back_to(c.item(t), wall), wall, gap);
      std::vector<Case> more;
      for (const Case& way : ways) {
        for (const Case& at : one.cases) more.push_back(both(way, at));
      }
      ways = std::move(more);
    }
    // …and the middle of their common extent the wall's: one of them is the lowest and one the highest.
    for (const Case& way : ways) {
      for (const ItemId low : c.targets) {
        for (const ItemId high : c.targets) {
          Case in = way;
          for (const ItemId t : c.targets) {
            if (t != low) in.require(lo(t, wall.along) - lo(low, wall.along));
            if (t != high) in.require(hi(high, wall.along) - hi(t, wall.along));
          }
          const Linear off = lo(low, wall.along) + hi(high, wall.along) - Linear(std::int64_t{wall.lo} + wall.hi);
          in.require_small(off, 1).wish(off, 1, 2);
          f.cases.push_back(std::move(in));
        }
      }
    }
  }
}

void compile_InRegion(Compilation& c) {
  if (!c.relation.parameters.region) {
    c.never();
    return;
  }
  const RoomRegion region = *c.relation.parameters.region;
  const bool middle = region == RoomRegion::kMiddle;
  for (const ItemId t : c.targets) {
    Case& in = c.formula().add();
    for (int axis = 0; axis < 2; ++axis) {
      const std::int64_t low = c.model.room.lo[axis], high = c.model.room.hi[axis], span = high - low;
      const bool lower = lies_at(region, axis == 0 ? Side::kLeft : Side::kFront);
      const bool upper = lies_at(region, axis == 0 ? Side::kRight : Side::kBack);
      if (lower) in.require(Linear(low + high) - mid2(t, axis)).wish(mid2(t, axis) - Linear(2 * low + span / 2), 20, 2);
      if (upper) in.require(mid2(t, axis) - Linear(low + high)).wish(mid2(t, axis) - Linear(2 * high - span / 2), 20, 2);
    }
    if (middle) {
      for (int axis = 0; axis < 2; ++axis) {
        const std::int64_t span = c.model.room.extent(axis);
        const Linear off = mid2(t, axis) - Linear(twice_middle(c.model, axis));
        in.require_small(off, static_cast<Mm>(span / 3)).wish(off, 60, 2);
      }
    }
  }
}

void compile_OnWall(Compilation& c) {
  for (const ItemId t : c.targets) {
    const Item& item = c.item(t);
    const auto hangs = [](const SupportOption& s) { return s.kind == SupportOption::Kind::kWall; };
    Formula& f = c.formula();
    if (std::none_of(item.supports.begin(), item.supports.end(), hangs)) continue;  // a wish that a floor lamp hang
    for (const WallId w : c.walls()) {
      const RoomWall& wall = c.model.walls[w];
      add_against(f, c.model, t, states_with_back_to(item, wall), wall, 0, true);
    }
    if (!c.relation.parameters.height) continue;
    c.formula().add().require_small(lo(t, 2) - Linear(*c.relation.parameters.height), 0);
  }
}

void compile_OnCeiling(Compilation& c) {
  for (const ItemId t : c.targets) c.formula().add().require_small(hi(t, 2) - Linear(c.model.room.hi[2]), 0);
}

void compile_AwayFromWall(Compilation& c) {
  const Mm least = c.length(&RelationParameters::min);
  for (const ItemId t : c.targets) {
    for (const WallId w : c.walls()) {
      const RoomWall& wall = c.model.walls[w];
      if (!wall.straight) {
        c.formula().exact = false;
        c.out.formulas.back().cases = away_from_angled(c.model, t, wall, least);
        continue;
      }
      add_band(c.formula(), c.model, t, place_of(c.model, wall), least, std::nullopt, 0);
    }
  }
}

}  // namespace layoutbox::placement
