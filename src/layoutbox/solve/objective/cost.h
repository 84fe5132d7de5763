// What makes one legal layout better than another, in thousandths of a point; the terms and their weights are described in docs/solve.md.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>

#include "layoutbox/solve/model/model.h"

namespace layoutbox::placement {

// Points: for a used side that cannot be reached at all, for wanted floor that is blocked, per thousandth of free floor that is cut off,
// for a greater thing to whose used sides no way 0.6 m wide leads from a door,
// per step below the usual size, per metre that something reaches into a door's swing that had to be given up, per relation `reachable`
// that does not hold.
struct CostWeights {
  int access = 700;
  int wanted = 350;
  int walk = 6;
  int narrow = 120;
  int size_step = 150;
  int swing = 1500;
  int unreached = 800;
};
inline constexpr CostWeights kCostWeights{};

// Costs are counted in thousandths of a point.
inline constexpr std::int64_t kPoint = 1000;

// Cost of one constraint: the best case's wishes and price; soft ones also what they miss. Nothing where something it speaks of is not
// placed.
std::int64_t constraint_cost(const PlacementModel& model, const Constraint& constraint, const Placements& placements);

// Thousandths of the free floor that hang together for a person 0.2 m wide (largest part of all).
int walk_permille(const PlacementModel& model, const Placements& placements);
// Can somebody `width` wide walk from a door to a place beside the item?
bool reachable(const PlacementModel& model, int item, Mm width, const Placements& placements);

// Cost of cut off floor, and of `reachable` relations that do not hold; where it comes to `enough`, perhaps less than all of it, but so
// much.
std::int64_t ways_cost(const PlacementModel& model, const Placements& placements,
                       std::int64_t enough = std::numeric_limits<std::int64_t>::max());

// All terms by name, for the layout's score; "stay", the way from an earlier layout, is not part of it.
std::map<std::string, std::int64_t> cost_terms(const PlacementModel& model, const Placements& placements);

}  // namespace layoutbox::placement
