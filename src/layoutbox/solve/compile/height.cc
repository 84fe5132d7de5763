// Relations of height: on, under, above, in, stacked.
#include "layoutbox/solve/compile/phrases.h"
#include "layoutbox/solve/compile/support.h"

namespace layoutbox::placement {
namespace {

bool says(const std::string& part, std::string_view word) { return part.find(word) != std::string::npos; }

// Where on the reference: halves, the middle, corners; in its own frame.
void require_part(Formula& f, const Model& model, int t, int r, const std::string& part) {
  const Item& ref = model.items[r];
  for_each_turn(ref, [&](int turn, std::uint64_t states) {
    const auto half = [&](Case& c, Side side) {
      const Direction d = side_direction(ref, side, turn);
      const Linear beyond2 = d.sign * mid2(t, d.axis) - d.sign * mid2(r, d.axis);
      c.require(beyond2 - Linear(20)).wish(2 * beyond2 - extent(r, d.axis), 40, 4);
    };
    const auto outer_third = [&](Case& c, Side side) {
      const Direction d = side_direction(ref, side, turn);
      const Linear beyond2 = d.sign * mid2(t, d.axis) - d.sign * mid2(r, d.axis);  // ≥ extent/3: the outer third
      c.require(3 * beyond2 - extent(r, d.axis) - Linear(15)).wish(reach(t, d) - reach(r, d) + Linear(60), 60);
    };
    Case base;
    base.when(r, states);
    if (says(part, "center") || says(part, "middle") || says(part, "centre")) {
      for (int axis = 0; axis < 2; ++axis) {
        const Linear off = mid2(t, axis) - mid2(r, axis);
        base.require(extent(r, axis) - 3 * off).require(extent(r, axis) + 3 * off).wish(off, 100, 2);
      }
      f.cases.push_back(base);
      return;
    }
    std::vector<Side> named;
    for (const auto& [word, side] :
         {std::pair{"left", Side::kLeft}, {"right", Side::kRight}, {"front", Side::kFront}, {"back", Side::kBack}}) {
      if (says(part, word)) named.push_back(side);
    }
    const bool corner = says(part, "corner"), edge = says(part, "edge");
    if (!corner && !edge) {
      for (const Side side : named) half(base, side);
      f.cases.push_back(base);
      return;
    }
    // Every choice of one side along the width and one along the depth that the named sides allow.
    for (const Side across_side : {Side::kLeft, Side::kRight}) {
      for (const Side deep_side : {Side::kBack, Side::kFront}) {
        const Side other_across = across_side == Side::kLeft ? Side::kRight : Side::kLeft;
        const Side other_deep = deep_side == Side::kBack ? Side::kFront : Side::kBack;
        const auto is_named = [&](Side s) { return std::find(named.begin(), named.end(), s) != named.end(); };
        if (is_named(other_across) && !is_named(across_side)) continue;
        if (is_named(other_deep) && !is_named(deep_side)) continue;
        Case c = base;
        if (corner) {
          outer_third(c, across_side);
          outer_third(c, deep_side);
        } else {
          const bool deep = is_named(Side::kFront) || is_named(Side::kBack);
          outer_third(c, deep ? deep_side : across_side);
        }
        if (deep_side == Side::kFront) c.price = 20;
        f.cases.push_back(std::move(c));
      }
    }
  });
}

bool is_place_word(const std::string& part) {
  for (const char* word : {"left", "right", "front", "back", "center", "centre", "middle", "corner", "edge"}) {
    if (says(part, word)) return true;
  }
  return false;
}

bool names_space(const Item& item, const std::string& part) {
  return std::any_of(item.spaces.begin(), item.spaces.end(), [&](const ItemSpace& s) { return s.name == part; });
}

}  // namespace

void compile_On(Compilation& c) {
  const std::string& part = c.relation.parameters.part;
  for (const int t : c.targets) {
    for (const Reference& r : c.references) {
      if (r.kind == Reference::Kind::kRoom) {  // the floor
        c.formula().add().require_small(lo(t, 2) - Linear(c.model.room.lo[2]), 0);
        continue;
      }
      if (r.kind != Reference::Kind::kItem) continue;
      const Item& ref = c.item(r.index);
      Formula& f = c.formula();
      if (ref.thin) {
        Case& in = f.add().require_small(lo(t, 2) - Linear(c.model.room.lo[2]), 0);
        require_cover(in, c.model, t, r.index, 0);
      } else if (ref.is_opening()) {
        add_on_sill(f, c.model, t, r.index);
      } else {
        add_resting(f, c.model, t, r.index, names_space(ref, part) ? part : "", Resting::kOn);
      }
      if (is_place_word(part) && !names_space(ref, part)) require_part(c.formula(), c.model, t, r.index, part);
    }
  }
}

void compile_In(Compilation& c) {
  const std::string& part = c.relation.parameters.part;
  for (const int t : c.targets) {
    for (const int r : c.reference_items()) {
      add_resting(c.formula(), c.model, t, r, names_space(c.item(r), part) ? part : "", Resting::kIn);
    }
  }
}

void compile_Stacked(Compilation& c) {
  std::vector<int> pile = c.reference_items();
  pile.insert(pile.end(), c.targets.begin(), c.targets.end());
  for (std::size_t i = 1; i < pile.size(); ++i) add_resting(c.formula(), c.model, pile[i], pile[i - 1], "", Resting::kTop);
}

void compile_Under(Compilation& c) {
  for (const int t : c.targets) {
    for (const int r : c.reference_items()) {
      Formula& f = c.formula();
      if (c.item(r).is_opening()) {
        add_under_window(f, c.model, t, r, 500);
        continue;
      }
      Case& in = f.add();
      require_cover(in, c.model, t, r, 0);
      in.require(mid2(r, 2) - mid2(t, 2) - Linear(1)).require(lo(r, 2) + Linear(50) - lo(t, 2));
      for (int axis = 0; axis < 2; ++axis) in.wish(mid2(t, axis) - mid2(r, axis), 60, 2);
    }
  }
}

void compile_Above(Compilation& c) {
  for (const int t : c.targets) {
    for (const int r : c.reference_items()) {
      Formula& f = c.formula();
      if (c.item(r).is_opening()) {
        for_each_turn(c.item(r), [&](int turn, std::uint64_t states) {
          const Direction in_dir = side_direction(c.item(r), Side::kFront, turn);
          Case& in = f.add().when(r, states);
          in.require(lo(t, 2) - hi(r, 2)).require(gap_towards(t, r, in_dir)).require(Linear(90) - gap_towards(t, r, in_dir));
          require_in_line(in, t, r, across(in_dir));
          in.wish(mid2(t, across(in_dir)) - mid2(r, across(in_dir)), 100, 2).wish(lo(t, 2) - hi(r, 2) - Linear(50), 50);
        });
        continue;
      }
      Case& in = f.add();
      require_cover(in, c.model, t, r, 100);
      const Linear gap = lo(t, 2) - hi(r, 2);
      in.require(gap);
      if (c.relation.parameters.gap) in.require_small(gap - Linear(*c.relation.parameters.gap), 0);
      for (int axis = 0; axis < 2; ++axis) in.wish(mid2(t, axis) - mid2(r, axis), 150, 2);
      if (c.item(t).mount == Mount::kWall) in.wish(gap - Linear(250), 30);
    }
  }
}

}  // namespace layoutbox::placement
