// Relations about free floor. What is linear is posted; what is not (a way to walk) is checked on each layout (walk.h).
#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {

void compile_Clearance(Compilation& c) {
  const Side named = c.relation.parameters.side.value_or(Side::kFront);
  for (const int t : c.targets) {
    const Item& item = c.item(t);
    Mm depth = 600;
    if (item.entry) {
      const auto usual = item.entry->clearance.find(named);
      if (usual != item.entry->clearance.end()) depth = usual->second;
    }
    depth = c.relation.parameters.depth.value_or(depth);
    // Inside the room…
    Formula& room = c.formula();
    for_each_turn(item, [&](int turn, std::uint64_t states) {
      const Direction d = side_direction(item, named, turn);
      const Mm edge = d.sign > 0 ? c.model.room.hi[d.axis] : -c.model.room.lo[d.axis];
      room.add().when(t, states).require(Linear(edge - depth) - reach(t, d));
    });
    // …and free of everything that could stand there.
    for (std::size_t o = 0; o < c.model.items.size(); ++o) {
      const int other = static_cast<int>(o);
      const Item& body = c.item(other);
      if (other == t || body.is_opening() || body.thin || body.mount == Mount::kCeiling) continue;
      const auto on_t = [&](const SupportOption& s) { return s.kind == SupportOption::Kind::kItem && s.index == t; };
      if (std::any_of(body.supports.begin(), body.supports.end(), on_t)) continue;
      if (c.model.pair(t, other) == PairRule::kFree) continue;
      Formula& f = c.formula();
      for_each_turn(item, [&](int turn, std::uint64_t states) {
        const Direction d = side_direction(item, named, turn), side{across(d), 1};
        f.add().when(t, states).require(gap_towards(other, t, d) - Linear(depth));
        f.add().when(t, states).require(gap_towards(other, t, opposite(d)) + extent(t, d.axis));
        f.add().when(t, states).require(gap_towards(other, t, side));
        f.add().when(t, states).require(gap_towards(other, t, opposite(side)));
        f.add().when(t, states).require(lo(other, 2) - Linear(2000));
      });
    }
  }
}

// Not linear: looked at on each layout (cost.h).
void compile_Reachable(Compilation& c) {
  for (const int t : c.targets) c.out.reach.emplace_back(t, c.length(c.relation.parameters.width, "width", 600));
}

void compile_KeepClear(Compilation& c) {
  const std::string& region = c.relation.parameters.region;
  const std::vector<int> refs = c.reference_items();
  bool openings = false;
  for (const int t : c.targets) {
    for (const int r : refs) {
      if (c.item(r).is_opening()) {
        openings = true;
      } else {
        add_apart(c.formula(), t, r, c.relation.parameters.depth.value_or(600));
      }
    }
    if (region.empty()) continue;
    Formula& f = c.formula();
    const bool middle = region == "middle" || region == "center" || region == "centre";
    for (int axis = 0; axis < 2; ++axis) {
      const Mm from = c.model.room.lo[axis], third = c.model.room.extent(axis) / 3;
      const bool lower = region == (axis == 0 ? "left" : "front"), upper = region == (axis == 0 ? "right" : "back");
      if (middle || lower) f.add().require(lo(t, axis) - Linear(from + (middle ? 2 * third : third) + 2));
      if (middle || upper) f.add().require(Linear(from + (middle ? third : 2 * third)) - hi(t, axis));
    }
  }
  if (openings) compile_NotBlocking(c);
}

}  // namespace layoutbox::placement
