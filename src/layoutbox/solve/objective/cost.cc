#include "layoutbox/solve/objective/cost.h"

#include "layoutbox/solve/objective/access.h"

namespace layoutbox::placement {
namespace {}  // namespace

std::int64_t constraint_cost(const PlacementModel& model, const Constraint& constraint, const Placements& placements) {
  if (!all_placed(constraint, placements)) return 0;
  const bool soft = constraint.firmness == Firmness::kSoft;
  std::int64_t sum = 0;
  for (const Formula& formula : constraint.formulas) {
    std::int64_t best = std::numeric_limits<std::int64_t>::max() / 4;
    for (const Case& one : formula.cases) {
      std::int64_t miss = 0;
      for (const StateLiteral& literal : one.states) {
        if (!(literal.states >> placements[literal.item].state & 1)) miss = kStateMiss;
      }
      for (const Linear& form : one.at_least_zero) miss = std::max(miss, missing(value_of(model, form, placements), form.scale));
      if (!soft && miss > 0) continue;
      std::int64_t cost = one.price * kPoint + miss * constraint.weight;
      for (const Preference& wish : one.wishes) {
        if (cost >= best) break;
        cost += std::abs(value_of(model, wish.form, placements)) * wish.weight / wish.scale;
      }
      best = std::min(best, cost);
    }
    if (best < std::numeric_limits<std::int64_t>::max() / 4) sum += best;
  }
  return sum;
}

std::map<std::string, std::int64_t> cost_terms(const PlacementModel& model, const Placements& placements) {
  std::map<std::string, std::int64_t> terms{{"habits", 0}, {"relations", 0}, {"access", 0}, {"ways", 0}, {"sizes", 0}};
  for (const Constraint& constraint : model.constraints) {
    if (!all_placed(constraint, placements)) continue;
    const bool stay = constraint.stay || !constraint.words.empty();
    terms[stay ? "stay" : constraint.relation < 0 ? "habits" : "relations"] += constraint_cost(model, constraint, placements);
  }
  for (std::size_t i = 0; i < model.items.size(); ++i) {
    if (placements[i].state < 0) continue;
    terms["access"] += access_cost_of(model, static_cast<int>(i), placements);
    terms["sizes"] += std::int64_t{kPoint} * kCostWeights.size_step * model.items[i].states[placements[i].state].size_step;
  }
  terms["ways"] = ways_cost(model, placements);
  return terms;
}

}  // namespace layoutbox::placement
