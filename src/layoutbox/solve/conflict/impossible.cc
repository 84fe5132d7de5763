// Relations that cannot hold whatever else is asked for: looked for one by one, with nothing there but what they speak of. They are given
// up before anything else is, so that the many that can hold are not blamed for them.
#include "layoutbox/solve/search/quick.h"
#include "layoutbox/solve/solving.h"

namespace layoutbox::placement {
namespace {

constexpr std::int64_t kStepsAlone = 20'000;
constexpr double kProofAlone = 0.01;  // CP-SAT's deterministic time

// Everything but what the constraint speaks of and what could hold that up.
ById<ItemId, char> all_beside(const PlacementModel& model, const Constraint& constraint) {
  ById<ItemId, char> out(model.items.size(), 1);
  std::vector<ItemId> kept;
  const auto keep = [&](ItemId item) {
    if (out[item]) out[item] = 0, kept.push_back(item);
  };
  for (const Formula& formula : constraint.formulas) {
    for (const ItemId item : formula.items) keep(item);
  }
  for (std::size_t k = 0; k < kept.size(); ++k) {
    for (const SupportOption& support : model.items[kept[k]].supports) {
      if (support.kind == SupportOption::Kind::kItem || support.kind == SupportOption::Kind::kSill) keep(support.item);
    }
  }
  return out;
}

}  // namespace

// True: it was given up.
Result<bool> Solver::give_up_impossible(ConstraintId constraint, const Dependencies& dependencies) {
  Scope alone{scope_.given_up, all_beside(model_, model_.constraints[constraint])};
  for (const ConstraintId c : alone.given_up.ids()) {
    const Firmness firmness = model_.constraints[c].firmness;
    const bool other = c != constraint && (firmness == Firmness::kHard || firmness == Firmness::kImplied);
    alone.given_up[c] = static_cast<char>(alone.given_up[c] || other);
  }
  Placements placements(model_.items.size());
  Budget budget = part(kStepsAlone);
  if (QuickSearch(model_, dependencies, alone, options_.seed, kAllSizes).complete(placements, budget)) return false;
  LAYOUTBOX_ASSIGN(const Proof proof, ask(alone, placements, kProofAlone));
  if (proof.outcome != Proof::Outcome::kClash || !proof.clash.proven) return false;
  LAYOUTBOX_CHECK(give_up(proof.clash));
  return true;
}

// True: something was given up.
Result<bool> Solver::give_up_impossible() {
  const Dependencies dependencies(model_);
  for (const ConstraintId c : model_.constraints.ids()) {
    if (enough()) break;
    const Constraint& constraint = model_.constraints[c];
    if (constraint.firmness != Firmness::kHard || !constraint.relation.exists() || scope_.given_up[c]) continue;
    if (!looked_at_alone_.insert(constraint.name).second) continue;
    LAYOUTBOX_ASSIGN(const bool given_up, give_up_impossible(c, dependencies));
    if (given_up) return true;
  }
  return false;
}

}  // namespace layoutbox::placement
