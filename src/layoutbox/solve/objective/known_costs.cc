#include "layoutbox/solve/objective/known_costs.h"

namespace layoutbox::placement {

void KnownCosts::forget(const PlacementModel& model) {
  const auto terms = cost_terms();
  known_.resize(terms.size());
  touched_.resize(terms.size());
  for (std::size_t t = 0; t < terms.size(); ++t) known_[t].assign(terms[t].shares(model), std::nullopt);
}

// What the difference does not touch stays known.
void KnownCosts::are_of(const PlacementModel& model, const Placements& placements) {
  if (of_ == placements && !known_.empty()) return;
  std::vector<ItemId> moved;
  bool fresh = known_.empty();
  for (const ItemId i : placements.ids()) {
    if (fresh) break;
    if (of_[i] == placements[i]) continue;
    moved.push_back(i);
    fresh = of_[i].state < 0 || placements[i].state < 0;
  }
  if (fresh) forget(model);
  const auto terms = cost_terms();
  for (std::size_t t = 0; t < terms.size() && !fresh; ++t) {
    if (terms[t].late) continue;
    terms[t].touched(model, {of_, placements, moved}, touched_[t]);
    for (const std::size_t share : touched_[t]) known_[t][share].reset();
  }
  of_ = placements;
}

std::int64_t KnownCosts::gain(const PlacementModel& model, const Change& change, std::int64_t least_gain) {
  are_of(model, change.before);
  const auto terms = cost_terms();
  std::int64_t gain = 0;
  // All that it cost before, known for the most part, then what it costs now, as long as that may be worth it.
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (terms[t].late) continue;
    terms[t].touched(model, change, touched_[t]);
    for (const std::size_t share : touched_[t]) {
      std::optional<std::int64_t>& cost = known_[t][share];
      if (!cost) cost = terms[t].evaluate(model, share, change.before, kAllOfIt);
      gain += *cost;
    }
  }
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (terms[t].late) continue;
    for (std::size_t k = 0; k < touched_[t].size() && gain > least_gain; ++k)
      gain -= terms[t].evaluate(model, touched_[t][k], change.after, kAllOfIt);
  }
  return gain;
}

}  // namespace layoutbox::placement
