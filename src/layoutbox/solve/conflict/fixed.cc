#include "layoutbox/solve/conflict/fixed.h"

#include <fmt/format.h>

namespace layoutbox::placement {
namespace {

constexpr Mm kAllowed = 5;  // rooms that somebody measured are no more exact than that

Clash clash_of(std::vector<ItemId> items, std::string sentence) {
  Clash clash;
  for (const ItemId item : items) clash.demands.push_back(Demand::of_item(item));
  clash.sentence = std::move(sentence);
  return clash;
}

// How far a box reaches out of another.
Mm reach_out(const GridBox& box, const GridBox& whole) {
  Mm most = 0;
  for (int k = 0; k < 3; ++k) most = std::max({most, whole.lo[k] - box.lo[k], box.hi[k] - whole.hi[k]});
  return most;
}

// The least move that parts them.
Mm depth_of(const GridBox& shared) { return std::min({shared.extent(0), shared.extent(1), shared.extent(2)}); }

// Nothing but what is fixed itself takes part: else it may be held by something that is still to be placed.
bool is_settled(const PlacementModel& model, const Case& one) {
  const auto fixed = [&](ItemId item) { return model.items[item].fixed; };
  return std::all_of(one.states.begin(), one.states.end(), [&](const StateLiteral& l) { return fixed(l.item); }) &&
         std::all_of(one.at_least_zero.begin(), one.at_least_zero.end(), [&](const Linear& form) {
           return std::all_of(form.terms.begin(), form.terms.end(), [&](const Term& t) { return fixed(t.item); });
         });
}

bool hangs_in_the_air(const PlacementModel& model, ItemId item, const Placements& placements) {
  for (const Formula& formula : model.constraints[model.items[item].support_constraint].formulas) {
    const std::vector<Case>& cases = formula.outer.empty() ? formula.cases : formula.outer;
    if (!std::all_of(cases.begin(), cases.end(), [&](const Case& one) { return is_settled(model, one); })) continue;
    Formula needed;
    needed.cases = cases;
    if (miss_of(model, needed, placements) > 0) return true;
  }
  return false;
}

}  // namespace

std::vector<Clash> clashes_of_fixed(const PlacementModel& model, const Scope& scope) {
  std::vector<Clash> out;
  std::vector<ItemId> fixed;
  Placements placements(model.items.size());
  for (const ItemId i : model.items.ids()) {
    const Item& item = model.items[i];
    if (!item.fixed || item.is_opening() || scope.leaves_out(i)) continue;
    placements[i] = {0, item.fixed_at};
    fixed.push_back(i);
  }
  for (const ItemId i : fixed) {
    const GridBox box = box_of(model.items[i], placements[i]);
    const std::string who = object_in_words(model, i);
    const auto in_wall = [&](const GridBox& outside) { return overlap(outside, box) && depth_of(intersection(outside, box)) > kAllowed; };
    const bool angled = std::any_of(model.walls.begin(), model.walls.end(), [](const RoomWall& wall) { return !wall.straight; });
    if (const Mm by = reach_out(box, model.room); by > kAllowed) {
      out.push_back(clash_of({i}, fmt::format("{} is fixed where it reaches {} out of the room", who, metres(by))));
    } else if (!angled && std::any_of(model.outside.begin(), model.outside.end(), in_wall)) {
      out.push_back(clash_of({i}, fmt::format("{} is fixed where it reaches out of the room", who)));
    } else if (hangs_in_the_air(model, i, placements)) {
      out.push_back(clash_of({i}, fmt::format("nothing holds {} up where it is fixed", who)));
    }
    for (const ItemId j : fixed) {
      const auto askew = [&](ItemId k) { return model.items[k].states[0].turn % 90 != 0; };
      if (j <= i || askew(i) || askew(j) || !collide(model, i, placements[i], j, placements[j], false)) continue;
      const GridBox shared = intersection(box, box_of(model.items[j], placements[j]));
      if (depth_of(shared) <= kAllowed) continue;
      out.push_back(clash_of({i, j}, fmt::format("{} and {} are both fixed where they overlap, by {:.2f} × {:.2f} m", who,
                                                 object_in_words(model, j), shared.extent(0) / 1000.0, shared.extent(1) / 1000.0)));
    }
  }
  return out;
}

}  // namespace layoutbox::placement
