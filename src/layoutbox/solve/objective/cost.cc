#include "layoutbox/solve/objective/cost.h"

namespace layoutbox::placement {
namespace {

// The least and the greatest value of a form over a region.
std::pair<std::int64_t, std::int64_t> range_of(const Partial& form, const Region& region) {
  std::int64_t least = form.constant, most = form.constant;
  for (int k = 0; k < 3; ++k) {
    const std::int64_t c = form.coefficient[k];
    least += c * (c > 0 ? region.lo[k] : region.hi[k]);
    most += c * (c > 0 ? region.hi[k] : region.lo[k]);
  }
  return {least, most};
}

std::int64_t least_cost(const Wish& wish, const Region& region) {
  const auto [least, most] = range_of(wish.form, region);
  return std::max<std::int64_t>({0, least, -most}) * wish.weight / wish.scale;
}

// What a case of something wished for costs at least, wherever in the region.
std::int64_t least_cost(const Reduced& one, std::int64_t weight, const Region& region) {
  std::int64_t miss = one.miss;
  for (const Partial& check : one.checks) miss = std::max(miss, missing(range_of(check, region).second, check.scale));
  std::int64_t cost = one.price + miss * weight;
  for (const Wish& wish : one.wishes) cost += least_cost(wish, region);
  return cost;
}

}  // namespace

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

std::int64_t least_wish_cost(const Region& region, std::span<const SoftFormula> soft, std::int64_t enough) {
  std::int64_t cost = region.price;
  for (const Reduced* one : region.cases) {
    for (const Wish& wish : one->wishes) cost += least_cost(wish, region);
  }
  for (std::size_t i = 0; i < soft.size() && cost < enough; ++i) {
    std::int64_t least = kNoCost;
    for (const Reduced& one : soft[i].all()) least = std::min(least, least_cost(one, soft[i].weight, region));
    cost += least;
  }
  return cost;
}

}  // namespace layoutbox::placement
