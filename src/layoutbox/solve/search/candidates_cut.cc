// What is wished for around an item, and the coordinates at which it is tried.
#include <algorithm>
#include <array>
#include <bit>
#include <iterator>

#include "layoutbox/solve/model/whole_division.h"
#include "layoutbox/solve/objective/cost.h"
#include "layoutbox/solve/search/candidates.h"

namespace layoutbox::placement {
namespace {

constexpr std::array<Mm, 2> kRoomBehind{400, 700};  // off the ends of a region: for a lamp behind a sofa, for somebody to pass

}  // namespace

// The coordinates of a grid as they are gathered, axis by axis.
class Coordinates {
 public:
  Coordinates(const Region& region, CandidateGrid& grid) : region_(region), grid_(grid), wished_(grid.wished) {
    for (int axis = 0; axis < 3; ++axis) {
      wished_[axis].clear();
      grid.values[axis].clear();
      offer(axis, region.lo[axis]);
      offer(axis, region.hi[axis]);
      if (axis == 2) continue;
      offer(axis, region.lo[axis] + (region.hi[axis] - region.lo[axis]) / 2);
      for (const Mm room : kRoomBehind)
        offer(axis, std::int64_t{region.lo[axis]} + room), offer(axis, std::int64_t{region.hi[axis]} - room);
    }
  }

  // Where a form of one axis is zero, or as near as the region has it: always tried, however many others there are.
  void offer_wish(const Partial& form) {
    const int axis = form.axis();
    if (axis < 0) return;
    wished_[axis].push_back(static_cast<Mm>(std::clamp<std::int64_t>(zero_of(form, axis), region_.lo[axis], region_.hi[axis])));
  }
  // Where it is zero, within the region.
  void offer_edge(const Partial& form) {
    if (const int axis = form.axis(); axis >= 0) offer(axis, zero_of(form, axis));
  }
  void offer_beside(const GridBox& body, const GridBox& mine) {
    for (int axis = 0; axis < 2; ++axis) {
      offer(axis, std::int64_t{body.hi[axis]} - mine.lo[axis]);
      offer(axis, std::int64_t{body.lo[axis]} - mine.hi[axis]);
    }
  }

  // In order, at most so many a axis besides those wished for.
  void thin_out(std::size_t most) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<Mm>& values = grid_.values[axis];
      put_in_order(axis, values);
      if (values.size() > most) {
        std::vector<Mm> fewer;  // evenly over all of them, both ends kept
        for (std::size_t i = 0; i < most; ++i) fewer.push_back(values[i * (values.size() - 1) / (most - 1)]);
        values = std::move(fewer);
      }
      if (wished_[axis].empty()) continue;
      put_in_order(axis, wished_[axis]);
      std::vector<Mm>& both = grid_.scratch;
      both.clear();
      std::ranges::set_union(values, wished_[axis], std::back_inserter(both));
      values.swap(both);
    }
  }

 private:
  static std::int64_t zero_of(const Partial& form, int axis) { return floor_div(-form.constant, form.coefficient[axis]); }
  // Each once, from the least on. All lie in the region: where that is not large, a bit for each place in it sorts them.
  void put_in_order(int axis, std::vector<Mm>& values) {
    constexpr std::size_t kBits = 64, kMostWords = 256, kFew = 12;
    const Mm from = region_.lo[axis];
    const std::size_t words = static_cast<std::size_t>(region_.hi[axis] - from) / kBits + 1;
    if (values.size() <= kFew || words > kMostWords) {
      std::sort(values.begin(), values.end());
      values.erase(std::unique(values.begin(), values.end()), values.end());
      return;
    }
    std::array<std::uint64_t, kMostWords> there;
    std::fill_n(there.begin(), words, 0);
    for (const Mm value : values) there[static_cast<std::size_t>(value - from) / kBits] |= std::uint64_t{1} << (value - from) % kBits;
    values.clear();
    for (std::size_t word = 0; word < words; ++word) {
      for (std::uint64_t bits = there[word]; bits != 0; bits &= bits - 1)
        values.push_back(from + static_cast<Mm>(word * kBits) + std::countr_zero(bits));
    }
  }
  void offer(int axis, std::int64_t value) {
    if (value >= region_.lo[axis] && value <= region_.hi[axis]) grid_.values[axis].push_back(static_cast<Mm>(value));
  }

  const Region& region_;
  CandidateGrid& grid_;
  std::array<std::vector<Mm>, 3>& wished_;
};

// A case of something wished for, with the item at hand in that state and everything else where it is.
void CandidateFinder::reduce_soft(const Placements& placements, const Case& one, ItemId item, int state, Reduced& reduced) const {
  reduced.checks.clear();
  reduced.wishes.clear();
  reduced.miss = 0;
  reduced.price = one.price * kPoint;
  for (const StateLiteral& literal : one.states) {
    const int s = literal.item == item ? state : placements[literal.item].state;
    if (!(literal.states >> s & 1)) reduced.miss = kStateMiss;
  }
  for (const Linear& form : one.at_least_zero)
    reduced.checks.push_back(partial_of(model_, placements, regions_.domains(), form, item, state));
  for (const Preference& wish : one.wishes) {
    reduced.wishes.push_back({partial_of(model_, placements, regions_.domains(), wish.form, item, state), wish.weight, wish.scale});
  }
}

void CandidateFinder::find_soft(const Placements& placements, ItemId item, int state) {
  std::size_t used = 0;
  const auto known = [&](ItemId other) { return other == item || placements[other].state >= 0; };
  for (const ConstraintId c : model_.touching[item]) {
    const Constraint& constraint = model_.constraints[c];
    if (constraint.firmness != Firmness::kSoft) continue;
    for (const Formula& formula : constraint.formulas) {
      if (formula.cases.empty() || !std::all_of(formula.items.begin(), formula.items.end(), known)) continue;
      if (used == soft_pool_.size()) soft_pool_.emplace_back();
      SoftFormula& soft = soft_pool_[used++];
      soft.weight = constraint.weight, soft.count = 0;
      for (const Case& one : formula.cases) {
        if (soft.count == soft.cases.size()) soft.cases.emplace_back();
        reduce_soft(placements, one, item, state, soft.cases[soft.count++]);
      }
    }
  }
  soft_ = {soft_pool_.data(), used};
}

// Beside what stands there, and beside what it must leave free.
void CandidateFinder::offer_neighbours(const Placements& placements, ItemId item, int state, Coordinates& to) const {
  const State& own = model_.items[item].states[state];
  const GridBox mine{{0, 0, 0}, own.extent};
  for (const GridBox& outside : model_.outside) to.offer_beside(outside, mine);
  for (const ItemId other : model_.items.ids()) {
    if (placements[other].state < 0 || other == item) continue;
    const PairRule rule = model_.pair(item, other);
    if (rule == PairRule::kFree) continue;
    const State& theirs = model_.items[other].states[placements[other].state];
    to.offer_beside(box_of(model_.items[other], placements[other]), mine);
    for (const GridBox& clear : theirs.clear) to.offer_beside(clear.shifted(placements[other].at), mine);
    for (const GridBox& clear : own.clear) to.offer_beside(box_of(model_.items[other], placements[other]), clear);
    if (rule != PairRule::kSolids || theirs.solids.size() * own.solids.size() > 24) continue;
    for (const GridBox& body : theirs.solids) {
      for (const GridBox& part : own.solids) to.offer_beside(body.shifted(placements[other].at), part);
    }
  }
}

void CandidateFinder::cut(const Placements& placements, ItemId item, int state, const Region& region, CandidateGrid& grid) const {
  Coordinates all(region, grid);
  for (const Reduced* one : region.cases) {
    for (const Wish& wish : one->wishes) all.offer_wish(wish.form);
  }
  for (const SoftFormula& formula : soft_) {
    for (const Reduced& one : formula.all()) {
      if (one.miss > 0) continue;
      for (const Wish& wish : one.wishes) all.offer_wish(wish.form);
      for (const Partial& form : one.checks) all.offer_edge(form);
    }
  }
  offer_neighbours(placements, item, state, all);
  all.thin_out(36 + model_.items.size() / 3);
}

}  // namespace layoutbox::placement
