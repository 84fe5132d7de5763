// Relations between two objects: where one is seen from the other.
#include <array>

#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {

namespace {

// How far apart things look right when nobody said: room for the knees before a seat, nearly touching at the sides.
Mm comfortable_gap(const Item& target, const Item& ref, Side side) {
  if (ref.is_opening()) return 600;
  if (side != Side::kFront) return 50;
  if (target.is(Trait::kTableSeat)) return 100;
  return ref.has_front ? 400 : 100;
}

void beside_each(Compilation& c, Side side) {
  const Mm most = c.length(&RelationParameters::max);
  for (const ItemId t : c.targets) {
    for (const ItemId r : c.reference_items()) {
      const Mm wished = comfortable_gap(c.item(t), c.item(r), side);
      const bool in_plan = c.item(r).is_opening() && c.relation.type == RelationType::kInFrontOf;
      add_beside(c.formula(), c.model, t, r, side,
                 {.most = most, .wished_gap = wished, .in_plan_only = in_plan, .frame = frame_host(c.model, r)});
    }
  }
}

void band_to_each(Compilation& c, Mm least, std::optional<Mm> most, Mm wished) {
  for (const ItemId t : c.targets) {
    for (const Reference& r : c.references) {
      Formula& f = c.formula();
      if (r.kind == Reference::Kind::kRoom) continue;  // no distance from it
      if (r.kind == Reference::Kind::kWall && !c.model.walls[r.wall].straight) {
        f.exact = false;
        continue;
      }
      add_band(f, c.model, t, c.place(r), least, most, wished);
    }
  }
}

constexpr std::array kFourSides{Side::kFront, Side::kBack, Side::kLeft, Side::kRight};

void along_side(Compilation& c, ItemId t, ItemId r, Side side, Mm most) {
  Formula& f = c.formula();
  for (const Side one : kFourSides) {
    if (const std::uint64_t states = states_where(c.item(r), one, side)) {
      const Mm wished = comfortable_gap(c.item(t), c.item(r), one);
      add_beside(f, c.model, t, r, one, {.most = most, .wished_gap = wished, .may_reach_under = true, .ref_states = states});
    }
  }
}

}  // namespace

void compile_LeftOf(Compilation& c) { beside_each(c, Side::kLeft); }
void compile_RightOf(Compilation& c) { beside_each(c, Side::kRight); }
void compile_InFrontOf(Compilation& c) { beside_each(c, Side::kFront); }
void compile_Behind(Compilation& c) { beside_each(c, Side::kBack); }

void compile_NextTo(Compilation& c) { band_to_each(c, 0, c.length(&RelationParameters::max), 100); }

void compile_Near(Compilation& c) {
  const Mm least = c.length(&RelationParameters::min), most = c.length(&RelationParameters::max);
  band_to_each(c, least, most, (least + most) / 2);
}

void compile_Far(Compilation& c) {
  const Mm least = c.length(&RelationParameters::min);
  band_to_each(c, least, std::nullopt, least);
}

void compile_Distance(Compilation& c) {
  const Mm least = c.relation.parameters.min.value_or(0);
  band_to_each(c, least, c.relation.parameters.max, (least + std::min(c.relation.parameters.max.value_or(4000), 4000)) / 2);
}

void compile_Touching(Compilation& c) {
  // A shared piece of face: no gap along one axis, overlapping extents along the others.
  for (const ItemId t : c.targets) {
    for (const ItemId r : c.reference_items()) {
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
      Case& within = f.add();  // one in a free space of the other, or on a rug
      for (int axis = 0; axis < 3; ++axis) within.require(hi(t, axis) - lo(r, axis)).require(hi(r, axis) - lo(t, axis));
      within.price = 60;
    }
  }
}

void compile_Opposite(Compilation& c) {
  const Mm least = c.length(&RelationParameters::min), most = c.length(&RelationParameters::max);
  if (c.targets.size() > 1) {
    for (const Reference& r : c.references) {
      if (r.kind == Reference::Kind::kItem && !c.item(r.item).is_opening()) add_opposite_group(c, r.item, least, most);
    }
  }
  for (const ItemId t : c.targets) {
    for (const ItemId r : c.reference_items()) {
      if (c.targets.size() < 2 || c.item(r).is_opening()) add_looks_at(c.formula(), c.model, t, r);
      if (c.item(r).is_opening()) {
        Formula& f = c.formula();
        for_each_turn(c.item(r), [&](int turn, std::uint64_t states) {
          Case in;
          const int axis = across(side_direction(c.item(r), Side::kFront, turn));
          in.when(r, states).wish(mid2(t, axis) - mid2(r, axis), 50, 2);
          for (Case& one : in_line(in, c.model, t, place_of(r), axis)) f.cases.push_back(std::move(one));
        });
        continue;
      }
      if (c.targets.size() > 1) continue;
      add_looks_at(c.formula(), c.model, r, t);
      add_band(c.formula(), c.model, t, place_of(r), least, most, (least + most) / 2);
    }
  }
}

void compile_CenteredOn(Compilation& c) {
  for (const ItemId t : c.targets) {
    for (const ItemId r : c.reference_items()) {
      const Item &target = c.item(t), &ref = c.item(r);
      const auto rests_on = [&](const SupportOption& s) { return s.kind == SupportOption::Kind::kItem && s.item == r; };
      const bool may_rest = std::any_of(target.supports.begin(), target.supports.end(), rests_on);
      const bool over = target.mount == Mount::kCeiling || target.thin || ref.thin;
      const bool along_only = !over && (ref.is_opening() || target.mount == Mount::kWall || ref.mount == Mount::kWall);
      Formula& f = c.formula();
      if (may_rest && !over) f.exact = false;  // it may also stand elsewhere: then one axis is enough
      for_each_turn(ref, [&](int turn, std::uint64_t states) {
        const int x = side_direction(ref, Side::kRight, turn).axis;
        const auto centre = [&](Case& in, int axis) { in.when(r, states).require_small(mid2(t, axis) - mid2(r, axis), 1); };
        if (over || may_rest) {
          Case& in = f.add();
          centre(in, 0);
          in.require_small(mid2(t, 1) - mid2(r, 1), 1);
        } else {
          centre(f.add(), x);
          if (along_only) return;
          centre(f.add(), 1 - x);
          f.cases.back().price = 30;
        }
        if (f.exact) return;
        centre(f.outer.emplace_back(), x);
        centre(f.outer.emplace_back(), 1 - x);
      });
    }
  }
}

void compile_AtFootOf(Compilation& c) {
  const Mm most = c.length(&RelationParameters::max);
  for (const ItemId t : c.targets) {
    for (const ItemId r : c.reference_items()) add_beside(c.formula(), c.model, t, r, Side::kFront, {.most = most, .wished_gap = 50});
  }
}

void compile_AtHeadOf(Compilation& c) {
  const Mm most = c.length(&RelationParameters::max);
  for (const ItemId r : c.reference_items()) {
    const Item& ref = c.item(r);
    const std::vector<Side> used = ref.object ? ref.object->used_sides.value_or(ref.entry->used_sides) : std::vector<Side>{};
    const auto is_used = [&](Side side) { return std::find(used.begin(), used.end(), side) != used.end(); };
    const bool table = !ref.has_front || std::all_of(kFourSides.begin(), kFourSides.end(), is_used);
    for (const ItemId t : c.targets) {
      if (ref.is_opening()) {
        c.never();
        continue;
      }
      if (table) {
        along_side(c, t, r, Side::kShort, most);
        continue;
      }
      Formula& f = c.formula();
      add_beside(f, c.model, t, r, Side::kBack, {.most = most, .wished_gap = 50});
      std::vector<Case> outer = f.exact ? f.cases : f.outer;
      for (const Side side : {Side::kLeft, Side::kRight}) {
        for_each_turn(ref, [&](int turn, std::uint64_t states) {
          const Direction d = side_direction(ref, side, turn), back = side_direction(ref, Side::kBack, turn);
          Case in;
          in.when(r, states).require(gap_towards(t, r, d));
          // The centre of t in the rear third: 3·(2·back edge − mid2) ≤ 2·extent.
          const Linear from_back = 2 * reach(r, back) - back.sign * mid2(t, back.axis);
          in.require(2 * extent(r, back.axis) - 3 * from_back);
          add_within(outer, in, c.model, t, place_of(r), most, Purpose::kProving);
          in.require(from_back).wish(gap_towards(t, r, d) - Linear(50), 100).wish(reach(t, back) - reach(r, back), 60);
          add_within(f.cases, in, c.model, t, place_of(r), most, Purpose::kPlacing);
        });
      }
      f.exact = false;
      f.outer = std::move(outer);
    }
  }
}

void compile_AlongSide(Compilation& c) {
  for (const ItemId t : c.targets) {
    for (const ItemId r : c.reference_items()) {
      along_side(c, t, r, or_default(c.relation, &RelationParameters::side), c.length(&RelationParameters::max));
    }
  }
}

// A seat at one side of a table: looks at it, within the side's length, pushed under by at least `under`.
void add_tucked(Formula& f, const PlacementModel& model, ItemId t, ItemId r, Side side, Mm under, Mm wished_under) {
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
    in.require(-2 * reach(t, opposite(d)) - d.sign * mid2(r, d.axis));  // its near edge not past the middle of r
    in.require(lo(t, across(d)) - lo(r, across(d))).require(hi(r, across(d)) - hi(t, across(d)));
    in.wish(gap + Linear(wished_under), 60).wish(mid2(t, across(d)) - mid2(r, across(d)), 60, 2);
  });
}

void compile_TuckedUnder(Compilation& c) {
  for (const ItemId t : c.targets) {
    for (const ItemId r : c.reference_items()) {
      Formula& f = c.formula();
      for (const Side side : {Side::kFront, Side::kBack, Side::kLeft, Side::kRight}) {
        add_tucked(f, c.model, t, r, side, 50, 300);
      }
      f.exact = false;  // far under, it may look at r along the side as well
      for (const Case& one : f.cases) {
        Case& outer = f.outer.emplace_back(one);
        std::erase_if(outer.states, [&](const StateLiteral& l) { return l.item == t; });
      }
    }
  }
}

}  // namespace layoutbox::placement
