// The positions tried in a region, a grid of coordinates, and what each costs: most forms speak of one axis only, so most of the work is
// done once per coordinate.
#pragma once

#include <limits>
#include <span>

#include "layoutbox/solve/search/region.h"

namespace layoutbox::placement {

inline constexpr std::int64_t kNoCost = std::numeric_limits<std::int64_t>::max() / 4;

// Something wished for: its cases where only the item at hand is free, and points per metre missed.
struct SoftFormula {
  std::int64_t weight = 0;
  std::vector<Reduced> cases;
  std::size_t count = 0;  // of them; after them are such as were used before
  std::span<const Reduced> all() const { return {cases.data(), count}; }
};

class CandidateGrid {
 public:
  std::array<std::vector<Mm>, 3> values;

  // REQUIRES: `values` are filled, and stay as they are; the region and the formulas outlive the next calls.
  void tabulate(const Region& region, std::span<const SoftFormula> soft);

  // Of all positions with these y and z, `base` added to each; no cheaper than the bound.
  void start_row(std::size_t y, std::size_t z, std::int64_t base);
  std::int64_t row_bound() const { return row_bound_; }
  // What the x-th of the row costs; kNoCost: at least `limit`, or it is not allowed.
  std::int64_t cost_in_row(std::size_t x, std::int64_t limit) const;

 private:
  // What a case costs along one axis, for each coordinate tried there.
  struct AxisCosts {
    std::vector<std::int64_t> miss, wish;
  };
  struct CaseTable {
    std::int64_t price = 0;
    std::array<AxisCosts, 3> axes;
    std::vector<Partial> crossing;  // forms over several axes
    std::vector<Wish> crossing_wishes;
  };
  // The same in the row at hand.
  struct RowCase {
    std::int64_t miss = 0, cost = 0;
    const std::int64_t *miss_x = nullptr, *wish_x = nullptr;
    const CaseTable* table = nullptr;
  };
  struct RowSoft {
    std::int64_t weight = 0, rest = 0;  // at least so much do the formulas after it cost, wherever in the row
    std::size_t first = 0, end = 0;     // of row_cases_
  };

  void start(CaseTable& table) const;
  void add_wish(CaseTable& table, const Wish& wish) const;
  void add_check(CaseTable& table, const Partial& form) const;

  CaseTable hard_;                 // the wishes of the region's cases
  std::vector<CaseTable> tables_;  // of all soft cases, and after them such as were used before
  std::size_t used_ = 0;
  std::vector<RowSoft> soft_;
  std::vector<std::int64_t> column_bound_;  // by x: at least so much, whatever the row
  std::vector<RowCase> row_cases_;
  std::int64_t row_ = 0, row_bound_ = 0, y_ = 0, z_ = 0;
};

}  // namespace layoutbox::placement
