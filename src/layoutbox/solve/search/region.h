// Where one item may stand while others stay: the boxes of positions that the formulas leave it, in one state.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "layoutbox/solve/model/model.h"
#include "layoutbox/solve/model/reduced.h"
#include "layoutbox/solve/model/scope.h"
#include "layoutbox/solve/search/budget.h"

namespace layoutbox::placement {

// Between which bounds the low corner and the extents of an item lie, whatever its place and state.
struct Domain {
  Vec3 lo{}, hi{};           // of the low corner
  Vec3 least{}, greatest{};  // extents
  bool empty() const { return lo[0] > hi[0] || lo[1] > hi[1] || lo[2] > hi[2]; }
};

// REQUIRES: state is one of the item's. What is not placed counts as much as its domain allows.
Partial partial_of(const PlacementModel& model, const Placements& placements, const ById<ItemId, Domain>& domains, const Linear& form,
                   ItemId item, int state);

class RegionFinder {
 public:
  // `most_size_step`: how far from the usual size items may be.
  RegionFinder(const PlacementModel& model, Scope scope, int most_size_step = std::numeric_limits<int>::max());

  // Once its stop has come nothing is found any more. Null: there is none. Kept by the caller. With the first the domains are narrowed.
  void watch(Budget* budget);

  const Scope& scope() const { return scope_; }
  bool enforced(ConstraintId constraint) const;
  // Is the constraint before the doors and windows given up for this opening?
  bool clearance_off(const Item& item) const { return scope_.gives_up(item.clearance_constraint); }

  const ById<ItemId, Domain>& domains() const { return domains_; }

  // Good until the next call. The item itself is taken as not placed; what is not placed yet binds as far as its domain does.
  const std::vector<Region>& find(const Placements& placements, ItemId item, int state, bool with_wishes = true);

 private:
  // What of a case speaks of an item: numbers of its forms and wishes.
  struct Shares {
    ById<ItemId, std::vector<std::size_t>> forms, wishes;
  };
  bool reduce(const Placements& placements, const Case& one, ItemId item, int state, bool with_wishes, const Shares* shares,
              Reduced& out) const;
  void share_out();
  bool toil(std::size_t more);
  bool is_linked(ItemId item) const;
  Domain widest_domain(const Item& item) const;
  Domain narrower_domain(ItemId item, const Placements& nowhere);
  void narrow_domains();
  void descend(std::size_t depth, const Region& region, int& nodes);
  std::vector<Reduced>& next_pool();

  const PlacementModel& model_;
  Scope scope_;
  int most_size_step_;
  ById<ItemId, Domain> domains_;
  std::map<std::pair<ConstraintId, int>, Shares> shares_;  // of formulas with one long case, by constraint and formula
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
