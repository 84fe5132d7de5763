// Relations between two objects.
#include <array>

#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {

namespace {

// How far apart things look right when nobody said: room for the knees before a seat, nearly touching at the sides.
Mm comfortable_gap(const Item& target, const Item& ref, Side side) {
  if (ref.is_opening()) return 600;
  if (side != Side::kFront) return 50;
  if (target.entry && target.entry->shape.family == "chair") return 100;
  return ref.has_front ? 400 : 100;
}

void beside_each(Compilation& c, Side side) {
  const Mm most = c.length(c.relation.parameters.max, "max", 1500);
  for (const int t : c.targets) {
    for (const int r : c.reference_items()) {
      add_beyond(c.formula(), c.model, t, r, side, most, comfortable_gap(c.item(t), c.item(r), side));
    }
  }
}

// Cases for gap(t, reference) within [least, most].
void add_band(Formula& f, const Compilation& c, int t, const Reference& r, Mm least, Mm most, Mm wished) {
  Formula apart;
  if (r.kind == Reference::Kind::kItem) {
    if (least > 0) {
      add_apart(apart, t, r.index, least);
    } else {
      apart.add();
    }
    for (Case& in : apart.cases) {
      for (int axis = 0; axis < 2; ++axis) in.wish(mid2(t, axis) - mid2(r.index, axis), wished > 500 ? 4 : 15, 2);
      add_within(f, std::move(in), c.model, t, r.index, most);
    }
    return;
  }
  if (r.kind != Reference::Kind::kWall) return;
  const RoomWall& wall = c.model.walls[r.index];
  if (least > 0) {
    add_apart_from_wall(apart, t, wall, least);
  } else {
    apart.add();
  }
  for (Case& in : apart.cases) {
    require_within_wall(in, t, wall, most);
    f.cases.push_back(std::move(in));
  }
}

void band_to_each(Compilation& c, Mm least, Mm most, Mm wished) {
  for (const int t : c.targets) {
    for (const Reference& r : c.references) {
      if (r.kind == Reference::Kind::kRoom) continue;
      add_band(c.formula(), c, t, r, least, most, wished);
    }
  }
}

constexpr std::array kFourSides{Side::kFront, Side::kBack, Side::kLeft, Side::kRight};

// The states of r in which the side is one of those meant: a name, or the longer or shorter ones as it then stands.
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

void along_side(Compilation& c, int t, int r, Side side, Mm most) {
  Formula& f = c.formula();
  for (const Side one : kFourSides) {
    if (const std::uint64_t states = states_where(c.item(r), one, side)) {
      add_at_side(f, c.model, t, r, one, most, comfortable_gap(c.item(t), c.item(r), one), states);
    }
  }
}

// Adds "the turns of t and r differ by one of these".
void add_turned_by(Formula& f, const Model& model, int t, int r, std::initializer_list<int> differences) {
  for_each_turn(model.items[r], [&](int ref_turn, std::uint64_t ref_states) {
    std::uint64_t mask = 0;
    for_each_turn(model.items[t], [&](int turn, std::uint64_t states) {
      for (const int difference : differences) {
        if ((turn - ref_turn - difference) % 360 == 0) mask |= states;
      }
    });
    if (mask) f.add().when(r, ref_states).when(t, mask);
  });
}

void turned_each(Compilation& c, std::initializer_list<int> differences, bool width_along) {
  for (const int t : c.targets) {
    for (const Reference& r : c.references) {
      Formula& f = c.formula();
      if (r.kind == Reference::Kind::kItem) add_turned_by(f, c.model, t, r.index, differences);
      if (r.kind != Reference::Kind::kWall) continue;
      const RoomWall& wall = c.model.walls[r.index];
      f.add().when(t, states_with_width_along(c.item(t), width_along ? wall.along : wall.normal()));
    }
  }
}

}  // namespace

void compile_LeftOf(Compilation& c) { beside_each(c, Side::kLeft); }
void compile_RightOf(Compilation& c) { beside_each(c, Side::kRight); }
void compile_InFrontOf(Compilation& c) { beside_each(c, Side::kFront); }
void compile_Behind(Compilation& c) { beside_each(c, Side::kBack); }

void compile_NextTo(Compilation& c) { band_to_each(c, 0, c.length(c.relation.parameters.max, "max", 500), 100); }

void compile_Near(Compilation& c) {
  const Mm least = c.length(c.relation.parameters.min, "min", 500), most = c.length(c.relation.parameters.max, "max", 1500);
  band_to_each(c, least, most, (least + most) / 2);
}

void compile_Far(Compilation& c) {
  const Mm least = c.length(c.relation.parameters.min, "min", 4000);
  for (const int t : c.targets) {
    for (const Reference& r : c.references) {
      if (r.kind == Reference::Kind::kItem) add_apart(c.formula(), t, r.index, least);
      if (r.kind == Reference::Kind::kWall) add_apart_from_wall(c.formula(), t, c.model.walls[r.index], least);
    }
  }
}

void compile_Distance(Compilation& c) {
  const Mm least = c.relation.parameters.min.value_or(0), most = c.relation.parameters.max.value_or(100000);
  band_to_each(c, least, most, (least + std::min(most, 4000)) / 2);
}

void compile_Touching(Compilation& c) {
  // A shared piece of face: no gap along one axis, overlapping extents along the others.
  for (const int t : c.targets) {
    for (const int r : c.reference_items()) {
      Formula& f = c.formula();
      for (int axis = 0; axis < 3; ++axis) {
        for (const int sign : {1, -1}) {
          Case& in = f.add();
          in.require_small(gap_towards(t, r, {axis, sign}), 0);
          for (int other = 0; other < 3; ++other) {
            if (other == axis) continue;
            in.require(hi(t, other) - lo(r, other)).require(hi(r, other) - lo(t, other));
            if (other < 2) in.wish(mid2(t, other) - mid2(r, other), 30, 2);
          }
          if (axis == 2) in.price = 50;
        }
      }
    }
  }
}

void compile_EdgeAlign(Compilation& c) {
  const std::string& edge = c.relation.parameters.edge;
  for (const int t : c.targets) {
    for (const int r : c.reference_items()) {
      Formula& f = c.formula();
      for_each_turn(c.item(r), [&](int turn, std::uint64_t states) {
        Case& in = f.add().when(r, states);
        if (edge == "center" || edge == "middle") {
          const int axis = side_direction(c.item(r), Side::kRight, turn).axis;
          in.require_small(mid2(t, axis) - mid2(r, axis), 1);
          return;
        }
        const Side side = edge == "back" ? Side::kBack : edge == "left" ? Side::kLeft : edge == "right" ? Side::kRight : Side::kFront;
        const Direction d = side_direction(c.item(r), side, turn);
        in.require_small(reach(t, d) - reach(r, d), 0);
      });
    }
  }
}

void compile_Facing(Compilation& c) {
  for (const int t : c.targets) {
    for (const Reference& r : c.references) {
      Formula& f = c.formula();
      if (r.kind == Reference::Kind::kItem) add_looks_at(f, c.model, t, r.index);
      if (r.kind == Reference::Kind::kWall) add_looks_at_wall(f, c.model, t, c.model.walls[r.index]);
      const Box& room = c.model.room;
      if (r.kind == Reference::Kind::kRoom) {
        add_looks_at_point(f, c.model, t, {(room.lo[0] + room.hi[0]) / 2, (room.lo[1] + room.hi[1]) / 2});
      }
    }
  }
}

void compile_Opposite(Compilation& c) {
  const Mm least = c.length(c.relation.parameters.min, "min", 1500), most = c.length(c.relation.parameters.max, "max", 4000);
  for (const int t : c.targets) {
    for (const int r : c.reference_items()) {
      add_looks_at(c.formula(), c.model, t, r);
      if (c.item(r).is_opening()) {
        Formula& f = c.formula();
        for (int axis = 0; axis < 2; ++axis) {
          std::uint64_t states = states_with_width_along(c.item(r), axis);
          if (!states) continue;
          Case& in = f.add().when(r, states);
          require_in_line(in, t, r, axis);
          in.wish(mid2(t, axis) - mid2(r, axis), 50, 2);
        }
        continue;
      }
      add_looks_at(c.formula(), c.model, r, t);
      add_band(c.formula(), c, t, {Reference::Kind::kItem, r}, least, most, (least + most) / 2);
    }
  }
}

void compile_Parallel(Compilation& c) { turned_each(c, {0, 180}, true); }
void compile_Perpendicular(Compilation& c) { turned_each(c, {90, 270}, false); }
void compile_SameOrientation(Compilation& c) { turned_each(c, {0}, true); }

void compile_CenteredOn(Compilation& c) {
  for (const int t : c.targets) {
    for (const int r : c.reference_items()) {
      const Item &target = c.item(t), &ref = c.item(r);
      const bool along_only = ref.is_opening() || target.mount == Mount::kWall || ref.mount == Mount::kWall;
      const bool over = c.model.pair(t, r) == PairRule::kFree || target.mount == Mount::kCeiling || ref.mount == Mount::kCeiling;
      const auto rests_on = [&](const SupportOption& s) { return s.kind == SupportOption::Kind::kItem && s.index == r; };
      const bool both = over || std::any_of(target.supports.begin(), target.supports.end(), rests_on);
      Formula& f = c.formula();
      for_each_turn(ref, [&](int turn, std::uint64_t states) {
        const int x = side_direction(ref, Side::kRight, turn).axis;
        if (!along_only && both) {
          Case& in = f.add().when(r, states);
          for (int axis = 0; axis < 2; ++axis) in.require_small(mid2(t, axis) - mid2(r, axis), 1);
          return;
        }
        f.add().when(r, states).require_small(mid2(t, x) - mid2(r, x), 1);
        if (!along_only) f.add().when(r, states).require_small(mid2(t, 1 - x) - mid2(r, 1 - x), 1).price = 30;
      });
    }
  }
}

void compile_AtFootOf(Compilation& c) {
  const Mm most = c.length(c.relation.parameters.max, "max", 500);
  for (const int t : c.targets) {
    for (const int r : c.reference_items()) add_beyond(c.formula(), c.model, t, r, Side::kFront, most, 50);
  }
}

void compile_AtHeadOf(Compilation& c) {
  const Mm most = c.length(c.relation.parameters.max, "max", 500);
  for (const int r : c.reference_items()) {
    const Item& ref = c.item(r);
    const bool table = !ref.has_front || (ref.object && ref.object->used_sides && ref.object->used_sides->size() == 4);
    if (table) {
      for (const int t : c.targets) {
        along_side(c, t, r, Side::kShort, most);
      }
      continue;
    }
    for (const int t : c.targets) {
      Formula& f = c.formula();
      add_beyond(f, c.model, t, r, Side::kBack, most, 50);
      for (const Side side : {Side::kLeft, Side::kRight}) {
        for_each_turn(ref, [&](int turn, std::uint64_t states) {
          const Direction d = side_direction(ref, side, turn), back = side_direction(ref, Side::kBack, turn);
          Case& in = f.add().when(r, states);
          in.require(gap_towards(t, r, d)).require(Linear(most) - gap_towards(t, r, d)).wish(gap_towards(t, r, d) - Linear(50), 100);
          // The centre of t in the rear third: 3·(2·back edge − mid2) ≤ 2·extent; and not behind it by more than half of t.
          const Linear from_back = 2 * reach(r, back) - back.sign * mid2(t, back.axis);
          in.require(2 * extent(r, back.axis) - 3 * from_back).require(from_back);
          in.wish(reach(t, back) - reach(r, back), 60);
        });
      }
    }
  }
}

void compile_AlongSide(Compilation& c) {
  for (const int t : c.targets) {
    for (const int r : c.reference_items()) {
      along_side(c, t, r, c.relation.parameters.side.value_or(Side::kLong), c.length(c.relation.parameters.max, "max", 500));
    }
  }
}

// A seat at one side of a table: looks at it, within the side's length, pushed under by at least `under`.
void add_tucked(Formula& f, const Model& model, int t, int r, Side side, Mm under, Mm wished_under) {
  const Item &seat = model.items[t], &table = model.items[r];
  for_each_turn(table, [&](int turn, std::uint64_t states) {
    const Direction d = side_direction(table, side, turn);
    std::uint64_t facing = 0;
    for_each_turn(seat, [&](int seat_turn, std::uint64_t seat_states) {
      if (seat_turn % 90 != 0) return;
      if (!seat.has_front || side_direction(seat, Side::kFront, seat_turn) == opposite(d)) facing |= seat_states;
    });
    if (!facing) return;
    Case& in = f.add().when(r, states).when(t, facing);
    const Linear gap = gap_towards(t, r, d);
    in.require(Linear(-under) - gap).require(reach(t, d) - reach(r, d));
    in.require(-2 * reach(t, opposite(d)) - d.sign * mid2(r, d.axis));  // not past the middle of the table
    in.require(lo(t, across(d)) - lo(r, across(d))).require(hi(r, across(d)) - hi(t, across(d)));
    in.wish(gap + Linear(wished_under), 60).wish(mid2(t, across(d)) - mid2(r, across(d)), 60, 2);
  });
}

void compile_TuckedUnder(Compilation& c) {
  for (const int t : c.targets) {
    for (const int r : c.reference_items()) {
      Formula& f = c.formula();
      for (const Side side : {Side::kFront, Side::kBack, Side::kLeft, Side::kRight}) {
        add_tucked(f, c.model, t, r, side, 50, 300);
      }
    }
  }
}

}  // namespace layoutbox::placement
