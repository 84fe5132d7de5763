#include "layoutbox/solve/conflict/locks.h"

#include <fmt/format.h>

#include <algorithm>

namespace layoutbox::placement {
namespace {

ConstraintId lock_of(const PlacementModel& model, ItemId item) {
  for (const ConstraintId c : model.touching[item]) {
    if (model.constraints[c].words.empty() || model.constraints[c].firmness != Firmness::kHard) continue;
    if (model.constraints[c].name == "lock of " + model.items[item].id) return c;
  }
  return {};
}

}  // namespace

std::vector<Clash> clashes_of_locks(const PlacementModel& model, const Scope& scope) {
  std::vector<Clash> out;
  if (model.start.empty()) return out;
  const auto at_of = [&](ItemId i) {
    const Item& item = model.items[i];
    return item.fixed ? Placement{0, item.fixed_at} : model.start[i];
  };
  const auto stays = [&](ItemId i) {
    const Item& item = model.items[i];
    const ConstraintId lock = item.locked ? lock_of(model, i) : ConstraintId();
    return !item.is_opening() && !scope.leaves_out(i) && (item.fixed || (lock.exists() && !scope.gives_up(lock)));
  };
  const auto beyond_walls = [&](ItemId i) {
    Placements alone(model.items.size());
    alone[i] = at_of(i);
    return miss_of(model, model.constraints[model.items[i].within_constraint], alone) > 0;
  };
  for (const ItemId i : model.items.ids()) {
    if (!stays(i) || model.items[i].fixed) continue;
    const Demand lock = Demand::of(lock_of(model, i));
    const std::string who = object_in_words(model, i);
    const GridBox box = box_of(model.items[i], at_of(i));
    const GridBox inside = intersection(box, model.room);
    const bool in_obstacle =
        std::any_of(model.off_limits.begin(), model.off_limits.end(), [&](const GridBox& o) { return overlap(o, box); });
    const bool behind_wall = model.items[i].within_constraint.exists() && beyond_walls(i);
    if (!(inside == box) || in_obstacle || behind_wall) {
      Clash clash;
      clash.demands = {lock};
      clash.sentence = fmt::format("{} sticks out of the room where it is to stay", who);
      out.push_back(std::move(clash));
      continue;
    }
    for (const ItemId j : model.items.ids()) {
      if (j == i || !stays(j) || (!model.items[j].fixed && j < i)) continue;
      if (!collide(model, i, at_of(i), j, at_of(j), true)) continue;
      Clash clash;
      clash.demands = {lock};
      if (!model.items[j].fixed) clash.demands.push_back(Demand::of(lock_of(model, j)));
      const GridBox shared = intersection(box, box_of(model.items[j], at_of(j)));
      clash.sentence = fmt::format("{} and {} are both to stay where they are, and overlap there by {:.2f} × {:.2f} m", who,
                                   object_in_words(model, j), shared.extent(0) / 1000.0, shared.extent(1) / 1000.0);
      out.push_back(std::move(clash));
    }
  }
  return out;
}

}  // namespace layoutbox::placement
