#include "layoutbox/solve/search/candidate_grid.h"

#include <algorithm>

namespace layoutbox::placement {

void CandidateGrid::start(std::size_t cases) {
  cases_ = cases;
  for (int axis = 0; axis < 3; ++axis) {
    CostsAlong& along = costs_[axis];
    along.count = values[axis].size();
    along.misses.assign(along.count * cases, 0);
    along.wishes.assign(along.count * cases, 0);
  }
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
  std::int64_t* cost = costs_[axis].wishes_of(number);
  const std::int64_t constant = wish.form.constant, coefficient = wish.form.coefficient[axis];
  for (const Mm value : values[axis]) *cost++ += wish.cost_of(constant + coefficient * value);
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
  std::int64_t* miss = costs_[axis].misses_of(number);
  const std::int64_t constant = form.constant, coefficient = form.coefficient[axis];
  for (const Mm value : values[axis]) {
    *miss = std::max(*miss, missing(constant + coefficient * value, form.scale));
    ++miss;
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

// Of what a formula costs at each x: all of it, the part that does not depend on the row, or a bound.
void CandidateGrid::tabulate_parts(const Formula& formula) {
  using Kind = Formula::Kind;
  const std::size_t count = costs_[0].count;
  const bool missed = formula.kind == Kind::kByX || formula.kind == Kind::kSumMissedAlongX;
  parts_.assign(count, kNoCost);
  for (std::size_t k = formula.first; k < formula.end; ++k) {
    const std::int64_t *const misses = costs_[0].misses_of(k), *const wishes = costs_[0].wishes_of(k);
    const std::int64_t whole = formula.kind == Kind::kByX ? whole_[k].wish : 0, least = whole_[k].miss;
    for (std::size_t x = 0; x < count; ++x)
      parts_[x] = std::min(parts_[x], whole + wishes[x] + (missed ? std::max(least, misses[x]) * formula.weight : 0));
  }
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
  const std::size_t count = costs_[0].count;
  column_bound_.assign(costs_[0].wishes_of(kHard), costs_[0].wishes_of(kHard) + count);
  column_least_.clear();
  for (const Formula& formula : formulas_) {
    if (formula.kind == Formula::Kind::kByRow) continue;
    tabulate_parts(formula);
    for (std::size_t x = 0; x < count; ++x) column_bound_[x] += parts_[x];
    if (formula.kind == Formula::Kind::kBoth) column_least_.insert(column_least_.end(), parts_.begin(), parts_.end());
  }
  least_column_ = column_bound_.empty() ? kNoCost : *std::ranges::min_element(column_bound_);
}

void CandidateGrid::bound_rows(std::size_t z, std::int64_t base) {
  using Kind = Formula::Kind;
  const std::size_t count = costs_[1].count;
  z_ = values[2][z], layer_ = z;
  row_bounds_.assign(count, base + whole_[kHard].wish + costs_[2].at(kHard, z).wish);
  const std::int64_t* const hard = costs_[1].wishes_of(kHard);
  for (std::size_t y = 0; y < count; ++y) row_bounds_[y] += hard[y];
  for (const Formula& formula : formulas_) {
    if (formula.kind == Kind::kByX) continue;
    parts_.assign(count, kNoCost);
    const std::int64_t weight = formula.kind == Kind::kSumMissedAlongX ? 0 : formula.weight;
    for (std::size_t k = formula.first; k < formula.end; ++k) {
      const std::int64_t *const misses = costs_[1].misses_of(k), *const wishes = costs_[1].wishes_of(k);
      const Cost of_layer = costs_[2].at(k, z);
      const std::int64_t miss = std::max(whole_[k].miss, of_layer.miss), cost = whole_[k].wish + of_layer.wish;
      for (std::size_t y = 0; y < count; ++y) parts_[y] = std::min(parts_[y], cost + wishes[y] + std::max(miss, misses[y]) * weight);
    }
    for (std::size_t y = 0; y < count; ++y) row_bounds_[y] += parts_[y];
  }
  rows_.resize(count);
  for (std::size_t y = 0; y < count; ++y) rows_[y] = y;
  std::ranges::stable_sort(rows_, {}, [&](std::size_t y) { return row_bounds_[y]; });
}

void CandidateGrid::start_row(std::size_t y) {
  y_ = values[1][y];
  row_bound_ = row_bounds_[y];
  row_cases_.resize(cases_);
  for (const std::size_t number : both_) {
    Formula& formula = formulas_[number];
    formula.least = kNoCost;
    for (std::size_t k = formula.first; k < formula.end; ++k) {
      const Cost along_y = costs_[1].at(k, y), along_z = costs_[2].at(k, layer_);
      const std::int64_t miss = std::max({whole_[k].miss, along_y.miss, along_z.miss}), cost = whole_[k].wish + along_y.wish + along_z.wish;
      const std::int64_t least = cost + miss * formula.weight;
      formula.least = std::min(formula.least, least);
      row_cases_[k] = {least, miss, cost, slanted_[k].any() ? &slanted_[k] : nullptr};
    }
  }
}

std::int64_t CandidateGrid::cost_in_row(std::size_t x, std::int64_t limit) const {
  std::int64_t cost = row_bound_ + column_bound_[x];  // at least; formula by formula its bounds give way to what it costs
  if (cost >= limit) return kNoCost;
  const Vec3 at{values[0][x], static_cast<Mm>(y_), static_cast<Mm>(z_)};
  for (const Partial& check : slanted_[kHard].checks) {
    if (check.at(at) < 0) return kNoCost;
  }
  for (const Wish& wish : slanted_[kHard].wishes) cost += wish.cost(at);
  const std::int64_t* column_least = column_least_.data() + x;
  for (const std::size_t number : both_) {
    const Formula& formula = formulas_[number];
    std::int64_t least = kNoCost;
    for (std::size_t k = formula.first; k < formula.end; ++k) {
      const RowCase& one = row_cases_[k];
      if (one.least >= least) continue;
      const Cost here = costs_[0].at(k, x);
      std::int64_t miss = std::max(one.miss, here.miss), sum = one.cost + here.wish;
      if (one.slanted != nullptr) {
        for (const Partial& form : one.slanted->checks) miss = std::max(miss, missing(form.at(at), form.scale));
        for (const Wish& wish : one.slanted->wishes) sum += wish.cost(at);
      }
      least = std::min(least, sum + miss * formula.weight);
    }
    cost += least - formula.least - *column_least;
    column_least += costs_[0].count;
    if (cost >= limit) return kNoCost;
  }
  return cost;
}

}  // namespace layoutbox::placement
