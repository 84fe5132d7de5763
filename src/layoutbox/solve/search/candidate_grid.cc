#include "layoutbox/solve/search/candidate_grid.h"

#include <algorithm>

namespace layoutbox::placement {

void CandidateGrid::start(std::size_t cases) {
  cases_ = cases;
  for (int axis = 0; axis < 3; ++axis) costs_[axis].assign(values[axis].size() * cases, {});
  whole_.assign(cases, {});
  along_.assign(cases, {});
  if (slanted_.size() < cases) slanted_.resize(cases);
  for (std::size_t k = 0; k < cases; ++k) slanted_[k].checks.clear(), slanted_[k].wishes.clear();
}

void CandidateGrid::add_wish(std::size_t number, const Wish& wish) {
  const int axis = wish.form.axis();
  if (axis == -2) {
    slanted_[number].wishes.push_back(wish);
    return;
  }
  if (axis == -1) {
    whole_[number].wish += wish.cost_of(wish.form.constant);
    return;
  }
  (axis == 0 ? along_[number].wishes_x : along_[number].wishes_row) = true;
  Cost* cost = &costs_[axis][number];
  for (const Mm value : values[axis]) {
    cost->wish += wish.cost_of(wish.form.constant + std::int64_t{wish.form.coefficient[axis]} * value);
    cost += cases_;
  }
}

void CandidateGrid::add_check(std::size_t number, const Partial& form) {
  const int axis = form.axis();
  if (axis == -2) {
    slanted_[number].checks.push_back(form);
    return;
  }
  if (axis == -1) {
    whole_[number].miss = std::max(whole_[number].miss, missing(form.constant, form.scale));
    return;
  }
  (axis == 0 ? along_[number].checks_x : along_[number].checks_row) = true;
  Cost* cost = &costs_[axis][number];
  for (const Mm value : values[axis]) {
    cost->miss = std::max(cost->miss, missing(form.constant + std::int64_t{form.coefficient[axis]} * value, form.scale));
    cost += cases_;
  }
}

CandidateGrid::Formula::Kind CandidateGrid::kind_of(std::size_t first, std::size_t end) const {
  using Kind = Formula::Kind;
  Along all;
  for (std::size_t k = first; k < end; ++k) {
    if (slanted_[k].any()) return Kind::kBoth;
    const Along& one = along_[k];
    all.checks_x |= one.checks_x, all.checks_row |= one.checks_row, all.wishes_x |= one.wishes_x, all.wishes_row |= one.wishes_row;
  }
  if (!all.checks_x && !all.wishes_x) return Kind::kByRow;
  if (!all.checks_row && !all.wishes_row) return Kind::kByX;
  if (end - first > 1 || (all.checks_x && all.checks_row)) return Kind::kBoth;
  return all.checks_x ? Kind::kSumMissedAlongX : Kind::kSum;
}

// Of what a formula costs at one x: all of it, the part that does not depend on the row, or a bound.
std::int64_t CandidateGrid::part_by_x(const Formula& formula, const Cost* here) const {
  using Kind = Formula::Kind;
  if (formula.kind == Kind::kByRow) return 0;
  std::int64_t least = kNoCost;
  for (std::size_t k = formula.first; k < formula.end; ++k) {
    std::int64_t cost = here[k].wish;
    if (formula.kind == Kind::kByX || formula.kind == Kind::kSumMissedAlongX)
      cost += std::max(whole_[k].miss, here[k].miss) * formula.weight;
    if (formula.kind == Kind::kByX) cost += whole_[k].wish;
    least = std::min(least, cost);
  }
  return least;
}

// The cases that may be the cheapest of their formula somewhere in the region. Most have a wrong state and are not.
void CandidateGrid::pick_cases(const Region& region, std::span<const SoftFormula> soft) {
  formulas_.clear();
  picked_.clear();
  for (const SoftFormula& formula : soft) {
    ranges_.clear();
    std::int64_t enough = kNoCost;  // one of them costs that at most, wherever
    for (const Reduced& one : formula.all()) {
      ranges_.push_back(cost_range(one, formula.weight, region));
      enough = std::min(enough, ranges_.back().most);
    }
    const std::size_t first = picked_.size();
    for (std::size_t k = 0; k < formula.count; ++k) {
      if (ranges_[k].least <= enough) picked_.push_back(&formula.cases[k]);
    }
    formulas_.push_back({Formula::Kind::kBoth, formula.weight, 0, kHard + 1 + first, kHard + 1 + picked_.size()});
  }
}

void CandidateGrid::tabulate(const Region& region, std::span<const SoftFormula> soft) {
  pick_cases(region, soft);
  start(kHard + 1 + picked_.size());
  whole_[kHard].wish = region.price;
  for (const Reduced* one : region.cases) {
    slanted_[kHard].checks.insert(slanted_[kHard].checks.end(), one->checks.begin(), one->checks.end());
    for (const Wish& wish : one->wishes) add_wish(kHard, wish);
  }
  for (std::size_t k = 0; k < picked_.size(); ++k) {
    const std::size_t number = kHard + 1 + k;
    whole_[number] = {picked_[k]->miss, picked_[k]->price};
    for (const Partial& form : picked_[k]->checks) add_check(number, form);
    for (const Wish& wish : picked_[k]->wishes) add_wish(number, wish);
  }
  both_.clear();
  for (std::size_t f = 0; f < formulas_.size(); ++f) {
    formulas_[f].kind = kind_of(formulas_[f].first, formulas_[f].end);
    if (formulas_[f].kind == Formula::Kind::kBoth) both_.push_back(f);
  }
  tabulate_columns();
}

void CandidateGrid::tabulate_columns() {
  column_bound_.clear();
  column_least_.clear();
  least_column_ = kNoCost;
  for (std::size_t x = 0; x < values[0].size(); ++x) {
    const Cost* const here = &costs_[0][x * cases_];
    std::int64_t bound = here[kHard].wish;
    for (const Formula& formula : formulas_) {
      const std::int64_t part = part_by_x(formula, here);
      if (formula.kind == Formula::Kind::kBoth) column_least_.push_back(part);
      bound += part;
    }
    column_bound_.push_back(bound);
    least_column_ = std::min(least_column_, bound);
  }
}

void CandidateGrid::start_row(std::size_t y, std::size_t z, std::int64_t base) {
  using Kind = Formula::Kind;
  y_ = values[1][y], z_ = values[2][z];
  const Cost *const along_y = &costs_[1][y * cases_], *const along_z = &costs_[2][z * cases_];
  row_cases_.resize(cases_);
  row_bound_ = base + whole_[kHard].wish + along_y[kHard].wish + along_z[kHard].wish;
  for (Formula& formula : formulas_) {
    if (formula.kind == Kind::kByX) continue;
    formula.least = kNoCost;
    for (std::size_t k = formula.first; k < formula.end; ++k) {
      const std::int64_t miss = std::max({whole_[k].miss, along_y[k].miss, along_z[k].miss}),
                         cost = whole_[k].wish + along_y[k].wish + along_z[k].wish;
      const std::int64_t least = formula.kind == Kind::kSumMissedAlongX ? cost : cost + miss * formula.weight;
      formula.least = std::min(formula.least, least);
      if (formula.kind == Kind::kBoth) row_cases_[k] = {least, miss, cost, slanted_[k].any() ? &slanted_[k] : nullptr};
    }
    row_bound_ += formula.least;
  }
}

std::int64_t CandidateGrid::cost_in_row(std::size_t x, std::int64_t limit) const {
  std::int64_t cost = row_bound_ + column_bound_[x];  // at least; formula by formula its bounds give way to what it costs
  if (cost >= limit) return kNoCost;
  const Cost* const here = &costs_[0][x * cases_];
  const Vec3 at{values[0][x], static_cast<Mm>(y_), static_cast<Mm>(z_)};
  for (const Partial& check : slanted_[kHard].checks) {
    if (check.at(at) < 0) return kNoCost;
  }
  for (const Wish& wish : slanted_[kHard].wishes) cost += wish.cost(at);
  const std::int64_t* column_least = column_least_.data() + x * both_.size();
  for (const std::size_t number : both_) {
    const Formula& formula = formulas_[number];
    std::int64_t least = kNoCost;
    for (std::size_t k = formula.first; k < formula.end; ++k) {
      const RowCase& one = row_cases_[k];
      if (one.least >= least) continue;
      std::int64_t miss = std::max(one.miss, here[k].miss), sum = one.cost + here[k].wish;
      if (one.slanted != nullptr) {
        for (const Partial& form : one.slanted->checks) miss = std::max(miss, missing(form.at(at), form.scale));
        for (const Wish& wish : one.slanted->wishes) sum += wish.cost(at);
      }
      least = std::min(least, sum + miss * formula.weight);
    }
    cost += least - formula.least - *column_least++;
    if (cost >= limit) return kNoCost;
  }
  return cost;
}

}  // namespace layoutbox::placement
