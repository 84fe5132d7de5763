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

std::int64_t most_cost(const Wish& wish, const Region& region) {
  const auto [least, most] = range_of(wish.form, region);
  return std::max(-least, most) * wish.weight / wish.scale;
}

bool in_its_states(const Case& one, const Placements& placements) {
  return std::all_of(one.states.begin(), one.states.end(),
                     [&](const StateLiteral& literal) { return literal.states >> placements[literal.item].state & 1; });
}

// What a case costs that is missed by `miss` at least; from `enough` on perhaps less than all of it, but so much.
std::int64_t case_cost(const PlacementModel& model, const Constraint& constraint, const Case& one, std::int64_t miss, std::int64_t enough,
                       const Placements& placements) {
  const bool soft = constraint.firmness == Firmness::kSoft;
  const auto so_far = [&] { return one.price * kPoint + miss * constraint.weight; };
  for (const Linear& form : one.at_least_zero) {
    if ((!soft && miss > 0) || so_far() >= enough) break;
    miss = std::max(miss, missing(value_of(model, form, placements), form.scale));
  }
  if (!soft && miss > 0) return kNoCost;
  std::int64_t cost = so_far();
  for (const Preference& wish : one.wishes) {
    if (cost >= enough) break;
    cost += std::abs(value_of(model, wish.form, placements)) * wish.weight / wish.scale;
  }
  return cost;
}

}  // namespace

std::int64_t constraint_cost(const PlacementModel& model, const Constraint& constraint, const Placements& placements) {
  if (!all_placed(constraint, placements)) return 0;
  std::int64_t sum = 0;
  for (const Formula& formula : constraint.formulas) {
    std::int64_t best = kNoCost;
    // Most cases have a wrong state, and cost more than the best of the others, whatever their forms.
    for (const Case& one : formula.cases) {
      if (in_its_states(one, placements)) best = std::min(best, case_cost(model, constraint, one, 0, best, placements));
    }
    for (const Case& one : formula.cases) {
      if (!in_its_states(one, placements)) best = std::min(best, case_cost(model, constraint, one, kStateMiss, best, placements));
    }
    if (best < kNoCost) sum += best;
  }
  return sum;
}

CostRange cost_range(const Reduced& one, std::int64_t weight, const Region& region) {
  std::int64_t least_miss = one.miss, most_miss = one.miss;
  for (const Partial& check : one.checks) {
    const auto [least, most] = range_of(check, region);
    least_miss = std::max(least_miss, missing(most, check.scale)), most_miss = std::max(most_miss, missing(least, check.scale));
  }
  CostRange range{one.price + least_miss * weight, one.price + most_miss * weight};
  for (const Wish& wish : one.wishes) range.least += least_cost(wish, region), range.most += most_cost(wish, region);
  return range;
}

std::int64_t least_wish_cost(const Region& region, std::span<const SoftFormula> soft, std::int64_t enough) {
  std::int64_t cost = region.price;
  for (const Reduced* one : region.cases) {
    for (const Wish& wish : one->wishes) cost += least_cost(wish, region);
  }
  for (std::size_t i = 0; i < soft.size() && cost < enough; ++i) {
    std::int64_t least = kNoCost;
    for (const Reduced& one : soft[i].all()) least = std::min(least, cost_range(one, soft[i].weight, region).least);
    cost += least;
  }
  return cost;
}

}  // namespace layoutbox::placement
