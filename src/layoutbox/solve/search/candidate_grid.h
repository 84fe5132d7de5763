// The positions tried in a region, a grid of coordinates, and what each costs: most forms speak of one axis only, so most of the work is
// done once per coordinate.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "layoutbox/solve/model/reduced.h"
#include "layoutbox/solve/objective/cost.h"

namespace layoutbox::placement {

class CandidateGrid {
 public:
  std::array<std::vector<Mm>, 3> values;
  // For whoever fills them: kept for their room.
  std::array<std::vector<Mm>, 3> wished;
  std::vector<Mm> scratch;

  // REQUIRES: `values` are filled, and stay as they are; the region and the formulas outlive the next calls.
  void tabulate(const Region& region, std::span<const SoftFormula> soft);

  // Of all positions with these y and z, `base` added to each; none is cheaper than the bound.
  void start_row(std::size_t y, std::size_t z, std::int64_t base);
  std::int64_t row_bound() const { return row_bound_ + least_column_; }
  // What the x-th of the row costs; kNoCost: at least `limit`, or it is not allowed.
  std::int64_t cost_in_row(std::size_t x, std::int64_t limit) const;

 private:
  static constexpr std::size_t kHard = 0;  // the number of the region's own cases, all together; after it those of the soft formulas

  // By how much a case is missed, and what its wishes cost.
  struct Cost {
    std::int64_t miss = 0, wish = 0;
  };
  // Its forms over several axes, which no table holds, and along which axes it has others.
  struct Slanted {
    std::vector<Partial> checks;
    std::vector<Wish> wishes;
    bool any() const { return !checks.empty() || !wishes.empty(); }
  };
  struct Along {
    bool checks_x = false, checks_row = false, wishes_x = false, wishes_row = false;  // row: along y or z
  };
  // A case in the row at hand.
  struct RowCase {
    std::int64_t least = 0;  // wherever in the row, without what it costs along x
    std::int64_t miss = 0, cost = 0;
    const Slanted* slanted = nullptr;  // where it has any
  };
  // What is wished for, by how its cost depends on the place: most of it is a sum of a part by x and a part by row, or of one of both
  // only, and is never looked at cell by cell.
  struct Formula {
    enum class Kind { kSum, kSumMissedAlongX, kByRow, kByX, kBoth } kind = Kind::kBoth;
    std::int64_t weight = 0;
    std::int64_t least = 0;          // kBoth: at least so much does it cost, wherever in the row, without the wishes along x
    std::size_t first = 0, end = 0;  // of its cases
  };

  void pick_cases(const Region& region, std::span<const SoftFormula> soft);
  void start(std::size_t cases);
  void add_wish(std::size_t number, const Wish& wish);
  void add_check(std::size_t number, const Partial& form);
  Formula::Kind kind_of(std::size_t first, std::size_t end) const;
  void tabulate_columns();
  std::int64_t part_by_x(const Formula& formula, const Cost* here) const;

  std::size_t cases_ = 0;
  std::array<std::vector<Cost>, 3> costs_;  // along each axis: of all cases at the first coordinate, at the second…
  std::vector<Cost> whole_;                 // of each case, whatever the position
  std::vector<Slanted> slanted_;            // of each case, and after them such as were used before
  std::vector<Along> along_;                // of each case
  std::vector<Formula> formulas_;
  std::vector<const Reduced*> picked_;      // the cases, from the first after the region's own on
  std::vector<CostRange> ranges_;           // of the cases of one formula
  std::vector<std::size_t> both_;           // numbers of those that depend on both
  std::vector<std::int64_t> column_bound_;  // by x: at least so much, whatever the row
  std::vector<std::int64_t> column_least_;  // the share of each of `both_` in that, by x
  std::int64_t least_column_ = 0;           // of the bounds by x
  std::vector<RowCase> row_cases_;
  std::int64_t row_bound_ = 0, y_ = 0, z_ = 0;
};

}  // namespace layoutbox::placement
