// Relations between an object and the room: walls, corners, middle, parts.
#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {
namespace {

Side back_of(const Item&) { return Side::kBack; }

// Twice the middle of the floor's extent.
std::int64_t room_mid2(const Model& model, int axis) { return std::int64_t{model.room.lo[axis]} + model.room.hi[axis]; }

std::vector<Side> sides_meant(const Compilation& c, const Item& item) {
  const Side side = c.relation.parameters.side.value_or(Side::kLeft);
  if (!c.relation.parameters.side) return {Side::kLeft, Side::kRight};
  if (side == Side::kLong || side == Side::kShort) {
    const Size& size = item.states[0].size;
    const bool wide = size.width >= size.depth;
    if ((side == Side::kLong) == wide) return {Side::kBack, Side::kFront};
    return {Side::kLeft, Side::kRight};
  }
  return {side};
}

}  // namespace

void compile_AgainstWall(Compilation& c) {
  const Mm gap = c.length(c.relation.parameters.gap, "gap", 20);
  for (const int t : c.targets) {
    Formula& f = c.formula();
    for (const int w : c.walls()) add_against(f, c.model, t, c.model.walls[w], back_of(c.item(t)), gap);
  }
}

void compile_SideAgainstWall(Compilation& c) {
  const Mm gap = c.length(c.relation.parameters.gap, "gap", 20);
  for (const int t : c.targets) {
    Formula& f = c.formula();
    for (const int w : c.walls()) {
      for (const Side side : sides_meant(c, c.item(t))) add_against(f, c.model, t, c.model.walls[w], side, gap);
    }
  }
}

void compile_Corner(Compilation& c) {
  const Mm most = c.length(c.relation.parameters.max, "max", 500);
  const std::size_t n = c.model.walls.size();
  std::vector<int> named;
  for (const Reference& r : c.references) {
    if (r.kind == Reference::Kind::kWall) named.push_back(r.index);
  }
  for (const int t : c.targets) {
    Formula& f = c.formula();
    for (std::size_t i = 0; i < n; ++i) {
      const int first = static_cast<int>(i), second = static_cast<int>((i + 1) % n);
      const RoomWall &a = c.model.walls[first], &b = c.model.walls[second];
      if (!a.straight || !b.straight || a.along == b.along) continue;
      // Inner angle under 180°: the second wall runs the way the first one looks.
      if ((b.runs_up ? 1 : -1) != a.inward) continue;
      const auto is_named = [&](int w) { return w == first || w == second; };
      if (!std::all_of(named.begin(), named.end(), is_named)) continue;
      Case& inside = f.add();
      for (const RoomWall* wall : {&a, &b}) {
        require_within_wall(inside, t, *wall, most);
        const Direction out{wall->normal(), wall->inward};
        const Linear off = Linear(0) - reach(t, opposite(out)) - Linear(std::int64_t{wall->inward} * wall->at);
        inside.require(off).wish(off, 200);
      }
    }
  }
}

void compile_CenterOfRoom(Compilation& c) {
  const Mm most = c.length(c.relation.parameters.max, "max", 50);
  if (c.targets.size() == 1) {
    Case& in = c.formula().add();
    for (int axis = 0; axis < 2; ++axis) {
      const Linear off = mid2(c.targets[0], axis) - Linear(room_mid2(c.model, axis));
      in.require_small(off, 2 * most).wish(off, 300, 2);
    }
    return;
  }
  // The middle of the group's extent: some target is the lowest and some the highest along each axis.
  for (int axis = 0; axis < 2; ++axis) {
    Formula& f = c.formula();
    for (const int low : c.targets) {
      for (const int high : c.targets) {
        Case& in = f.add();
        for (const int t : c.targets) {
          if (t != low) in.require(lo(t, axis) - lo(low, axis));
          if (t != high) in.require(hi(high, axis) - hi(t, axis));
        }
        const Linear off = lo(low, axis) + hi(high, axis) - Linear(room_mid2(c.model, axis));
        in.require_small(off, 2 * most).wish(off, 300, 2);
      }
    }
  }
}

void compile_CenteredOnWall(Compilation& c) {
  const Mm gap = c.length(c.relation.parameters.gap, "gap", 20);
  Formula& f = c.formula();
  for (const int w : c.walls()) {
    const RoomWall& wall = c.model.walls[w];
    if (!wall.straight) continue;
    // One target per case; several targets share the middle by their extent, posted as a chain in the order given.
    Formula each;
    add_against(each, c.model, c.targets[0], wall, Side::kBack, gap);
    for (Case& first : each.cases) {
      const int last = c.targets.back();
      const Linear off = lo(c.targets[0], wall.along) + hi(last, wall.along) - Linear(std::int64_t{wall.lo} + wall.hi);
      first.require_small(off, 1).wish(off, 1, 2);
      for (std::size_t i = 0; i + 1 < c.targets.size(); ++i) {
        first.require(lo(c.targets[i + 1], wall.along) - hi(c.targets[i], wall.along));
      }
      f.cases.push_back(std::move(first));
    }
  }
  for (std::size_t i = 1; i < c.targets.size(); ++i) {
    Formula& more = c.formula();
    for (const int w : c.walls()) add_against(more, c.model, c.targets[i], c.model.walls[w], Side::kBack, gap);
  }
}

void compile_InRegion(Compilation& c) {
  const std::string& region = c.relation.parameters.region;
  const auto says = [&](std::string_view word) { return region.find(word) != std::string::npos; };
  for (const int t : c.targets) {
    Case& in = c.formula().add();
    for (int axis = 0; axis < 2; ++axis) {
      const std::int64_t low = c.model.room.lo[axis], high = c.model.room.hi[axis], span = high - low;
      const bool lower = axis == 0 ? says("left") : says("front"), upper = axis == 0 ? says("right") : says("back");
      if (lower) in.require(Linear(low + high - span / 20) - mid2(t, axis)).wish(mid2(t, axis) - Linear(2 * low + span / 2), 20, 2);
      if (upper) in.require(mid2(t, axis) - Linear(low + high + span / 20)).wish(mid2(t, axis) - Linear(2 * high - span / 2), 20, 2);
    }
    if (says("middle") || says("cent")) {
      for (int axis = 0; axis < 2; ++axis) {
        const std::int64_t span = c.model.room.extent(axis);
        const Linear off = mid2(t, axis) - Linear(room_mid2(c.model, axis));
        in.require_small(off, static_cast<Mm>(span / 3 - 10)).wish(off, 60, 2);
      }
    }
  }
}

void compile_OnWall(Compilation& c) {
  for (const int t : c.targets) {
    Formula& f = c.formula();
    for (const int w : c.walls()) add_against(f, c.model, t, c.model.walls[w], Side::kBack, 0);
    if (c.relation.parameters.height) {
      Case& at = c.formula().add();
      at.require_small(lo(t, 2) - Linear(*c.relation.parameters.height), 0);
    }
  }
}

void compile_OnCeiling(Compilation& c) {
  for (const int t : c.targets) c.formula().add().require_small(hi(t, 2) - Linear(c.model.room.hi[2]), 0);
}

void compile_AwayFromWall(Compilation& c) {
  const Mm least = c.length(c.relation.parameters.min, "min", 500);
  for (const int t : c.targets) {
    for (const int w : c.walls()) add_apart_from_wall(c.formula(), t, c.model.walls[w], least);
  }
}

}  // namespace layoutbox::placement
