// What makes one legal layout better than another, in thousandths of a point: how its terms are measured. The list of them is in terms.h.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "layoutbox/solve/model/model.h"
#include "layoutbox/solve/model/reduced.h"

namespace layoutbox::placement {

// Points; what for is said in terms.cc.
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

// What is wished of one item in one state costs at least so much, wherever it stands in the region; from `enough` on perhaps more.
// `soft`: what is wished apart from what the region's cases ask for.
std::int64_t least_wish_cost(const Region& region, std::span<const SoftFormula> soft, std::int64_t enough);

// What a case of something wished for costs at least and at most, wherever in the region.
struct CostRange {
  std::int64_t least = 0, most = 0;
};
CostRange cost_range(const Reduced& one, std::int64_t weight, const Region& region);

// Cost of a size below the usual one.
inline std::int64_t size_cost(const State& state) { return kPoint * kCostWeights.size_step * state.size_step; }

// Thousandths of the free floor that hang together for a person 0.2 m wide (largest part of all).
int walk_permille(const PlacementModel& model, const Placements& placements);
// Can somebody `width` wide walk from a door to a place beside the item?
bool reachable(const PlacementModel& model, ItemId item, Mm width, const Placements& placements);

// Cost of cut off floor, and of `reachable` relations that do not hold; where it comes to `enough`, perhaps less than all of it, but so
// much.
std::int64_t ways_cost(const PlacementModel& model, const Placements& placements,
                       std::int64_t enough = std::numeric_limits<std::int64_t>::max());

}  // namespace layoutbox::placement
