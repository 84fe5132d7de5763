// The quick search for a first legal layout: costs are not looked at. Each item goes to the first free position of a sweep; one that has
// none pushes out what has failed least often so far, and that looks for a new place (an ejection search).
#pragma once

#include <cstdint>
#include <vector>

#include "layoutbox/solve/search/candidates.h"
#include "layoutbox/solve/search/obstacles.h"
#include "layoutbox/solve/search/order.h"

namespace layoutbox::placement {

class QuickSearch {
 public:
  // `most_size_step`: how far from the usual size items may be.
  QuickSearch(const PlacementModel& model, const Dependencies& dependencies, Scope scope, std::uint64_t seed, int most_size_step);

  // Places everything in its scope that has no place yet in `placements`; what is there may be moved, what stays() apart.
  // False: not within the budget; `placements` is then as good as it got.
  bool complete(Placements& placements, Budget& budget);

  // Those without a place in the best try.
  const std::vector<ItemId>& failed() const { return failed_; }

 private:
  void note_failed(const Placements& placements);
  bool attempt(std::vector<ItemId> pending, Budget& budget);
  ItemId next_of(std::vector<ItemId>& pending) const;
  bool settle(ItemId item, Budget& budget);
  bool settle_once(ItemId item, Budget& budget);
  bool push_out(ItemId item, std::vector<ItemId>& pending, Budget& budget);
  class Prices;
  struct Push;
  void coordinates_of(const Region& region, int axis, std::vector<Mm>& tried);
  void try_to_push(const Region& region, int state, const Vec3& at, Prices& prices, Push& push);
  std::vector<ItemId> all_hosts(ItemId item) const;
  bool take_hosts(ItemId item, std::vector<ItemId>& pending);
  void take_out(ItemId item, std::vector<ItemId>& pending);
  bool somewhere(const Region& region, Vec3& at);
  const std::vector<int>& states_in_turn(ItemId item);

  const PlacementModel& model_;
  const Dependencies& dependencies_;
  RegionFinder regions_;
  Random random_;
  int most_size_step_;
  Placements placements_;
  ById<ItemId, int> weight_;  // how often an item found no place
  int attempts_ = 0;
  std::vector<ItemId> failed_;
  Obstacles obstacles_;
  ById<ItemId, std::vector<std::uint64_t>> alike_;  // by state: the states that make no difference
  std::vector<int> turns_;
};

}  // namespace layoutbox::placement
