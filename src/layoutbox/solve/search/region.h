// Where one item may stand while others stay: the boxes of positions that the formulas leave it, in one state.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "layoutbox/solve/model/model.h"
#include "layoutbox/solve/model/scope.h"
#include "layoutbox/solve/search/budget.h"

namespace layoutbox::placement {

// A linear form in which only the position of one item is free.
struct Partial {
  std::int64_t constant = 0;
  std::array<std::int32_t, 3> coefficient{};
  std::int32_t scale = 1;  // as of the form
  bool unknown = false;    // speaks of something else that is not placed; `constant` then has the most that can add

  std::int64_t at(const Vec3& p) const {
    return constant + std::int64_t{coefficient[0]} * p[0] + std::int64_t{coefficient[1]} * p[1] + std::int64_t{coefficient[2]} * p[2];
  }
  // The only axis with a coefficient; −1: none, −2: several.
  int axis() const {
    int found = -1;
    for (int k = 0; k < 3; ++k) {
      if (coefficient[k] == 0) continue;
      if (found >= 0) return -2;
      found = k;
    }
    return found;
  }
};

struct Wish {
  Partial form;
  std::int32_t weight = 1, scale = 1;
  std::int64_t cost(const Vec3& at) const { return cost_of(form.at(at)); }
  // Of the form's value. Nearly all scales are 1, and a division takes as long as all the rest.
  std::int64_t cost_of(std::int64_t value) const {
    const std::int64_t whole = std::abs(value) * weight;
    return scale == 1 ? whole : whole / scale;
  }
};

// Between which bounds the low corner and the extents of an item lie, whatever its place and state.
struct Domain {
  Vec3 lo{}, hi{};           // of the low corner
  Vec3 least{}, greatest{};  // extents
  bool empty() const { return lo[0] > hi[0] || lo[1] > hi[1] || lo[2] > hi[2]; }
};

// REQUIRES: state is one of the item's. What is not placed counts as much as its domain allows.
Partial partial_of(const PlacementModel& model, const Placements& placements, const std::vector<Domain>& domains, const Linear& form,
                   int item, int state);

// A case in which only the item at hand is free.
struct Reduced {
  Vec3 lo{-(1 << 29), -(1 << 29), -(1 << 29)}, hi{1 << 29, 1 << 29, 1 << 29};
  std::vector<Partial> checks;  // over several axes; for soft cases all forms
  std::vector<Wish> wishes;
  std::int64_t price = 0;
  std::int64_t miss = 0;  // soft cases: whatever the position
};

struct Region {
  Vec3 lo{}, hi{};
  std::vector<const Reduced*> cases;  // those that check or wish anything
  std::int64_t price = 0;
  bool empty() const { return lo[0] > hi[0] || lo[1] > hi[1] || lo[2] > hi[2]; }
};

inline bool holds_at(const Region& region, const Vec3& at) {
  return std::all_of(region.cases.begin(), region.cases.end(), [&](const Reduced* one) {
    return std::all_of(one->checks.begin(), one->checks.end(), [&](const Partial& check) { return check.at(at) >= 0; });
  });
}

class RegionFinder {
 public:
  // `most_size_step`: how far from the usual size items may be.
  RegionFinder(const PlacementModel& model, Scope scope, int most_size_step = std::numeric_limits<int>::max());

  // Once its stop has come nothing is found any more. Null: there is none. Kept by the caller. With the first the domains are narrowed.
  void watch(Budget* budget);

  const Scope& scope() const { return scope_; }
  bool enforced(int constraint) const;
  // Is the constraint before the doors and windows given up for this opening?
  bool clearance_off(const Item& item) const { return scope_.gives_up(item.clearance_constraint); }

  const std::vector<Domain>& domains() const { return domains_; }

  // Good until the next call. The item itself is taken as not placed; what is not placed yet binds as far as its domain does.
  const std::vector<Region>& find(const Placements& placements, int item, int state, bool with_wishes = true);

 private:
  // What of a case speaks of an item: numbers of its forms and wishes.
  struct Shares {
    std::vector<std::vector<int>> forms, wishes;  // by item
  };
  bool reduce(const Placements& placements, const Case& one, int item, int state, bool with_wishes, const Shares* shares,
              Reduced& out) const;
  void share_out();
  bool toil(std::size_t more);
  bool is_linked(int item) const;
  Domain widest_domain(const Item& item) const;
  Domain narrower_domain(int item, const Placements& nowhere);
  void narrow_domains();
  void descend(std::size_t depth, const Region& region, int& nodes);
  std::vector<Reduced>& next_pool();

  const PlacementModel& model_;
  Scope scope_;
  int most_size_step_;
  std::vector<Domain> domains_;
  std::map<std::pair<int, int>, Shares> shares_;  // of formulas with one long case, by constraint and formula
  Budget* budget_ = nullptr;
  bool narrowed_ = false;  // the domains, which takes time: not before there is a budget
  std::vector<std::vector<Reduced>>
      pool_;  // per enforced formula, its cases that are possible; kept for their room, the first `pools_` count
  std::size_t pools_ = 0;
  std::vector<const std::vector<Reduced>*> by_size_;  // of those, what leaves least choice first
  std::vector<const Reduced*> chosen_;                // on the way down
  std::vector<Region> regions_;
};

}  // namespace layoutbox::placement
