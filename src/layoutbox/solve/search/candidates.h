// Where one item could go while everything else stays: the regions that the formulas leave, cut at the coordinates that matter (ends
// of the region, what the wishes ask for, beside what already stands), legal ones only, cheapest first.
#pragma once

#include <cstdint>
#include <vector>

#include "layoutbox/base/random.h"
#include "layoutbox/solve/objective/access.h"
#include "layoutbox/solve/search/budget.h"
#include "layoutbox/solve/search/candidate_grid.h"
#include "layoutbox/solve/search/obstacles.h"
#include "layoutbox/solve/search/region.h"
#include "layoutbox/solve/search/taken_cells.h"

namespace layoutbox::placement {

struct Candidate {
  Placement placement;
  std::int64_t cost = 0;    // thousandths of a point, of what touches the item
  std::vector<ItemId> hit;  // with eject_price: the items it collides with
};

struct CandidateOptions {
  std::size_t most = 1;
  bool first_legal = false;                                 // the first legal one will do
  bool diverse = false;                                     // the best of every column and row rather than `most` alike
  const ById<ItemId, std::int64_t>* eject_price = nullptr;  // collisions are allowed at these prices; less than 0: never
  std::int64_t noise = 0;                                   // up to this much is added to a cost at random
  Random* random = nullptr;                                 // REQUIRES: set where noise > 0
  int most_size_step = 0;
};

class Coordinates;

class CandidateFinder {
 public:
  CandidateFinder(const PlacementModel& model, Scope scope);

  // From now on regions are passed over where no position can be cheaper than the best so far. It finds the same in fewer steps, so that a
  // search with a budget goes farther; the first search, which decides what is given up, goes without.
  void skip_dear_regions() { skips_dear_ = true; }

  // The item itself is taken as not placed.
  std::vector<Candidate> find(const Placements& placements, ItemId item, const CandidateOptions& options, Budget& budget);

  // Collides with nothing placed, and lies in the room.
  bool legal(const Placements& placements, ItemId item, const Placement& placement) const;

  // What it collides with; false: the room's edge or what is not to be ejected.
  bool collisions(const Placements& placements, ItemId item, const Placement& placement, const ById<ItemId, std::int64_t>& price,
                  std::vector<ItemId>& hit) const;

  const Scope& scope() const { return regions_.scope(); }
  bool enforced(ConstraintId constraint) const { return regions_.enforced(constraint); }

 private:
  struct Hunt;
  bool consider(Hunt& hunt, int state, const Vec3& at, std::int64_t cost);
  bool try_grid(Hunt& hunt, int state, std::int64_t base, CandidateGrid& grid);
  bool try_points(Hunt& hunt, int state, std::int64_t base, const Region& region, const std::vector<Point>& points,
                  const std::vector<Mm>& heights);
  void reduce_soft(const Placements& placements, const Case& one, ItemId item, int state, Reduced& reduced) const;
  void find_soft(const Placements& placements, ItemId item, int state);
  void offer_neighbours(const Placements& placements, ItemId item, int state, Coordinates& to) const;
  void cut(const Placements& placements, ItemId item, int state, const Region& region, CandidateGrid& grid) const;
  void heed(const CandidateGrid& grid, Budget& budget) const;
  std::vector<Point> crossings(const Placements& placements, ItemId item, int state, const Region& region,
                               const std::array<std::vector<Mm>, 3>& grid, Budget& budget) const;
  std::int64_t cost_at(const Region& region, const Vec3& at) const;
  // May it be pushed aside?
  static bool gives_way(const Obstacles::Forbidden& f, const CandidateOptions& options);
  bool pushes(const Vec3& at, const CandidateOptions& options, std::vector<ItemId>& hit);
  std::int64_t swing_cost(const Placements& placements, ItemId opening, const Placement& placement);

  const PlacementModel& model_;
  RegionFinder regions_;
  Obstacles obstacles_;
  AccessProbe access_;
  Placements probe_;  // the placements, with the item tried
  std::vector<SoftFormula> soft_pool_;
  std::span<const SoftFormula> soft_;  // those of the item at hand
  CandidateGrid grid_;                 // kept for its room
  TakenCells taken_;                   // of the layer of the grid at hand
  bool skips_dear_ = false;
};

}  // namespace layoutbox::placement
