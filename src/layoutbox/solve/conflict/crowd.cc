// Too many things for the floor: the fewest of them that are too many.
#include "layoutbox/solve/search/quick.h"
#include "layoutbox/solve/solving.h"

namespace layoutbox::placement {
namespace {

constexpr std::size_t kMostInCrowd = 12;
constexpr std::int64_t kStepsForRest = 20'000;
constexpr double kProofOfCrowd = 0.3;  // CP-SAT's deterministic time

// The demands of a clash are all there is.
Scope alone(const PlacementModel& model, const Clash& clash) {
  Scope only{ById<ConstraintId, char>(model.constraints.size()), ById<ItemId, char>(model.items.size(), 1)};
  for (const ConstraintId c : only.given_up.ids()) {
    const Firmness firmness = model.constraints[c].firmness;
    only.given_up[c] = static_cast<char>(firmness == Firmness::kHard || firmness == Firmness::kImplied);
  }
  for (const Demand& demand : clash.demands) {
    if (demand.is_item()) {
      only.left_out[demand.item] = 0;
    } else {
      only.given_up[demand.constraint] = 0;
    }
  }
  return only;
}

}  // namespace

// Is there a place for all but any one of them?
bool Solver::each_is_needed(const Clash& clash) {
  const Dependencies dependencies(model_);
  const Scope all = alone(model_, clash);
  return std::all_of(clash.demands.begin(), clash.demands.end(), [&](const Demand& demand) {
    Scope rest = all;
    if (demand.is_item()) {
      rest.left_out[demand.item] = 1;
      // Without the door there is no floor to be free before it.
      const Item& item = model_.items[demand.item];
      if (item.is_opening()) rest.given_up[item.clearance_constraint] = 1;
    } else {
      rest.given_up[demand.constraint] = 1;
    }
    Placements placements(model_.items.size());
    Budget budget = part(kStepsForRest);
    return QuickSearch(model_, dependencies, rest, options_.seed, kAllSizes).complete(placements, budget);
  });
}

// A smallest clash among those of a sum of areas, which knows nothing of how the rest would fit; the same where none is found in a moment.
Result<Clash> Solver::smallest_crowd(Clash clash) {
  if (clash.minimal || !clash.proven || clash.demands.size() > kMostInCrowd || enough()) return clash;
  if (each_is_needed(clash)) {
    clash.minimal = true;
    return clash;
  }
  const Scope only = alone(model_, clash);
  LAYOUTBOX_ASSIGN(const Proof proof, ask(only, Placements(model_.items.size()), kProofOfCrowd));
  const bool smaller = proof.outcome == Proof::Outcome::kClash && proof.clash.proven && proof.clash.minimal;
  return smaller ? proof.clash : clash;
}

}  // namespace layoutbox::placement
