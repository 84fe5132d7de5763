// The constructive search: places one item after another, the most constrained first, each at the best of its candidates; starts anew
// with the priority of what failed raised; then improves by taking groups of items out and placing them again.
// Deterministic: integer costs, a seeded generator of its own, effort counted in steps.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "layoutbox/solve/objective/known_costs.h"
#include "layoutbox/solve/search/candidates.h"
#include "layoutbox/solve/search/order.h"

namespace layoutbox::placement {

inline constexpr std::int64_t kLeastGain =
    -400'000;                                  // thousandths of a point: what a move must gain without the ways for these to be measured
inline constexpr std::int64_t kPatience = 12;  // moves in vain a thing, after which an improvement ends

class Search {
 public:
  // `most_size_step`: how far below the usual size items may be.
  Search(const PlacementModel& model, Scope scope, std::uint64_t seed, int most_size_step);

  void skip_dear_regions() { finder_.skip_dear_regions(); }

  // Places everything in its scope, or as much as it can. True when all are placed.
  bool construct(int restarts, Budget& budget);
  // A start in which formations of so many members at least stand in their places from the first: crowds that are in one another's way
  // where they come one by one. False also where there is none.
  bool construct_formed(std::size_t fewest, Budget& budget);
  // A start unlike that: a few things first that have no right to be, and places that are as good within a noise. What finds no place
  // pushes others out.
  bool construct_unlike(Budget& budget);

  // Local moves from a complete layout; never makes it worse. Ends after so many moves a thing in vain. `sweeps`: each thing once first.
  void improve(Budget& budget, std::int64_t patience, bool sweeps = true);
  // Things in formation go to their places all at once, each with what hangs on it; what stood there looks for a new place.
  void form_up(Budget& budget);
  // Takes a few things with all that hangs on them out of a complete layout, and puts them where they are well off within a noise.
  // False: they found no place; nothing is changed then.
  bool shake(Budget& budget);

  const Placements& placements() const { return placements_; }
  void adopt(const Placements& placements) { placements_ = placements; }
  // Items that could not be placed in the best try.
  const std::vector<ItemId>& failed() const { return failed_; }

 private:
  bool is_out(ItemId item) const { return finder_.scope().leaves_out(item); }
  std::vector<ItemId> order(const ById<ItemId, int>& bonus) const { return placing_order(model_, dependencies_, finder_.scope(), bonus); }
  bool try_order(const std::vector<ItemId>& order, std::int64_t noise, Budget& budget);
  std::vector<ItemId> movable() const;
  std::vector<std::vector<ItemId>> formations() const;
  bool form_from_nothing(const std::vector<ConstraintId>& places, std::size_t way);
  bool form_all(std::size_t fewest, std::size_t way);
  bool try_start(const std::vector<ItemId>& order, Budget& budget);
  // Which case of its places a formation takes, and how far off them all of it stands.
  struct Way {
    std::size_t looking = 0;
    std::array<Mm, 2> off{};
  };
  bool form_up(const std::vector<ConstraintId>& places, const Way& way, Budget& budget);
  bool step_into_place(ConstraintId constraint, const Way& way, const std::vector<ItemId>& members, std::vector<ItemId>& moved,
                       std::vector<ItemId>& loose);
  std::vector<ItemId> followers_of(ItemId item, const std::vector<ItemId>& members) const;
  bool slide(ItemId item, Budget& budget);
  bool push_away(std::vector<ItemId>& moved, std::vector<ItemId> in_way, const ById<ItemId, std::int64_t>& price);
  bool may_stay(ItemId item, const Placement& placement) const;
  bool may_stay(const std::vector<ItemId>& group, Budget& budget) const;
  bool is_free(ItemId item, const Placement& placement) const;
  bool place(ItemId item, std::int64_t noise, Budget& budget);
  bool watched_fit(ItemId item, Budget& budget);
  bool repair(Budget& budget);
  void take_out(ItemId item, std::vector<ItemId>& queue);
  bool move(const std::vector<ItemId>& group, std::int64_t noise, Budget& budget);
  std::vector<ItemId> load_of(ItemId item) const;
  void gather_group(ItemId item, const std::vector<ItemId>& movable, std::vector<ItemId>& group);
  bool sweep_step(ItemId item, Budget& budget);
  std::optional<bool> chance_step(ItemId item, const std::vector<ItemId>& movable, const std::vector<std::vector<ItemId>>& together,
                                  Budget& budget);
  bool push(ItemId item, Budget& budget);
  std::vector<ItemId> cluster_of(ItemId item);
  std::vector<ItemId> company_of(ItemId item) const;
  bool shift(const std::vector<ItemId>& cluster, int axis, Mm by, std::int64_t least_gain, Budget& budget);
  bool nudge(ItemId item, Budget& budget);
  bool nudge_all(const std::vector<ItemId>& cluster, std::int64_t least_gain, Budget& budget);
  void settle(Budget& budget);
  bool are_tied(const std::vector<ItemId>& a, const std::vector<ItemId>& b) const;
  bool is_better(const Placements& before, const std::vector<ItemId>& moved, Budget& budget, std::int64_t least_gain = kLeastGain);

  const PlacementModel& model_;
  CandidateFinder finder_;
  Random random_;
  int most_size_step_;
  Placements placements_;
  std::vector<ItemId> failed_;
  std::int64_t late_ = 0;    // what is measured last costs so much as things stand, while improving
  KnownCosts known_;         // of what many moves start from
  ById<ItemId, int> bonus_;  // how often an item failed
  Dependencies dependencies_;
};

}  // namespace layoutbox::placement
