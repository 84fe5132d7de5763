#include "layoutbox/solve/search/candidate_grid.h"

namespace layoutbox::placement {

void CandidateGrid::start(CaseTable& table) const {
  table.crossing.clear();
  table.crossing_wishes.clear();
  for (int axis = 0; axis < 3; ++axis) {
    table.axes[axis].miss.assign(values[axis].size(), 0);
    table.axes[axis].wish.assign(values[axis].size(), 0);
  }
}

void CandidateGrid::add_wish(CaseTable& table, const Wish& wish) const {
  const int axis = wish.form.axis();
  if (axis == -2) {
    table.crossing_wishes.push_back(wish);
    return;
  }
  if (axis == -1) {
    table.price += std::abs(wish.form.constant) * wish.weight / wish.scale;
    return;
  }
  for (std::size_t i = 0; i < values[axis].size(); ++i) {
    const std::int64_t off = wish.form.constant + std::int64_t{wish.form.coefficient[axis]} * values[axis][i];
    table.axes[axis].wish[i] += std::abs(off) * wish.weight / wish.scale;
  }
}

void CandidateGrid::add_check(CaseTable& table, const Partial& form) const {
  const int axis = form.axis();
  if (axis == -2) {
    table.crossing.push_back(form);
  } else if (axis == -1) {
    for (std::int64_t& miss : table.axes[2].miss) miss = std::max(miss, missing(form.constant, form.scale));
  } else {
    for (std::size_t i = 0; i < values[axis].size(); ++i) {
      std::int64_t& miss = table.axes[axis].miss[i];
      miss = std::max(miss, missing(form.constant + std::int64_t{form.coefficient[axis]} * values[axis][i], form.scale));
    }
  }
}

void CandidateGrid::tabulate(const Region& region, std::span<const SoftFormula> soft) {
  hard_.price = region.price;
  start(hard_);
  for (const Reduced* one : region.cases) {
    hard_.crossing.insert(hard_.crossing.end(), one->checks.begin(), one->checks.end());
    for (const Wish& wish : one->wishes) add_wish(hard_, wish);
  }
  used_ = 0;
  soft_.clear();
  column_bound_ = hard_.axes[0].wish;
  for (const SoftFormula& formula : soft) {
    const std::size_t first = used_;
    for (const Reduced& one : formula.all()) {
      if (used_ == tables_.size()) tables_.emplace_back();
      CaseTable& table = tables_[used_++];
      table.price = one.price;
      start(table);
      for (std::int64_t& miss : table.axes[2].miss) miss = one.miss;
      for (const Partial& form : one.checks) add_check(table, form);
      for (const Wish& wish : one.wishes) add_wish(table, wish);
    }
    soft_.push_back({formula.weight, 0, first, used_});
    for (std::size_t x = 0; x < column_bound_.size(); ++x) {
      std::int64_t least = kNoCost;
      for (std::size_t k = first; k < used_; ++k) least = std::min(least, tables_[k].axes[0].wish[x]);
      column_bound_[x] += least;
    }
  }
}

void CandidateGrid::start_row(std::size_t y, std::size_t z, std::int64_t base) {
  y_ = values[1][y], z_ = values[2][z];
  row_ = base + hard_.price + hard_.axes[2].wish[z] + hard_.axes[1].wish[y];
  row_cases_.clear();
  for (std::size_t k = 0; k < used_; ++k) {
    const CaseTable& table = tables_[k];
    const auto& [x_costs, y_costs, z_costs] = table.axes;
    row_cases_.push_back({std::max(y_costs.miss[y], z_costs.miss[z]), table.price + y_costs.wish[y] + z_costs.wish[z], x_costs.miss.data(),
                          x_costs.wish.data(), &table});
  }
  std::int64_t rest = 0;
  for (std::size_t i = soft_.size(); i-- > 0;) {
    RowSoft& formula = soft_[i];
    formula.rest = rest;
    std::int64_t least = kNoCost;
    for (std::size_t k = formula.first; k < formula.end; ++k)
      least = std::min(least, row_cases_[k].cost + row_cases_[k].miss * formula.weight);
    rest += least;
  }
  row_bound_ = row_ + rest;
}

std::int64_t CandidateGrid::cost_in_row(std::size_t x, std::int64_t limit) const {
  if (row_bound_ + column_bound_[x] >= limit) return kNoCost;
  const Vec3 at{values[0][x], static_cast<Mm>(y_), static_cast<Mm>(z_)};
  for (const Partial& check : hard_.crossing) {
    if (check.at(at) < 0) return kNoCost;
  }
  std::int64_t cost = row_ + hard_.axes[0].wish[x];
  for (const Wish& wish : hard_.crossing_wishes) cost += wish.cost(at);
  for (const RowSoft& formula : soft_) {
    std::int64_t least = kNoCost;
    for (std::size_t k = formula.first; k < formula.end; ++k) {
      const RowCase& one = row_cases_[k];
      std::int64_t miss = std::max(one.miss, one.miss_x[x]);
      for (const Partial& form : one.table->crossing) miss = std::max(miss, missing(form.at(at), form.scale));
      std::int64_t sum = one.cost + miss * formula.weight + one.wish_x[x];
      for (const Wish& wish : one.table->crossing_wishes) sum += wish.cost(at);
      least = std::min(least, sum);
    }
    cost += least;
    if (cost + formula.rest >= limit) return kNoCost;
  }
  return cost < limit ? cost : kNoCost;
}

}  // namespace layoutbox::placement
