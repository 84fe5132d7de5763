// Where one item cannot stand because of what stands there already, and the first free position of a sweep past all that.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "layoutbox/solve/search/budget.h"
#include "layoutbox/solve/search/region.h"

namespace layoutbox::placement {

class Obstacles {
 public:
  // |2 · (x, y) · position + constant| < half.
  struct Stripe {
    std::int64_t x = 0, y = 0, constant = 0, half = 0;
  };
  // Positions of the item's low corner, all inside of the box and within the stripes, at which it would collide with the owner (none: the
  // room).
  struct Forbidden {
    Vec3 lo{}, hi{};
    ItemId owner = {};
    int first_stripe = 0, stripes = 0;
  };
  struct Sweep {
    int outer = 0;
    bool down[2] = {false, false};
  };

  // REQUIRES: both outlive it.
  Obstacles(const PlacementModel& model, const RegionFinder& regions);

  // Finds what is in the way of the item anywhere in the region. The item itself is taken as not placed.
  void gather(const Placements& placements, ItemId item, int state, const Region& region);

  const std::vector<Forbidden>& all() const { return forbidden_; }
  bool holds(const Forbidden& f, const Vec3& at) const {
    return f.lo[0] < at[0] && at[0] < f.hi[0] && f.lo[1] < at[1] && at[1] < f.hi[1] && f.lo[2] < at[2] && at[2] < f.hi[2] &&
           (f.stripes == 0 || within_stripes(f, at));
  }
  bool is_free(const Vec3& at) const;
  // What may hold a position with that y and z. Asked for row by row, most often of the one before.
  std::span<const Forbidden* const> across(const Vec3& at);

  // The first free position of the region gathered for, line by line from one of its corners; false: there is none.
  bool sweep(const Region& region, const Sweep& how, Vec3& at, Budget& budget);

 private:
  std::span<const Stripe> stripes_of(const Forbidden& f) const {
    return {stripes_.data() + f.first_stripe, static_cast<std::size_t>(f.stripes)};
  }
  bool within_stripes(const Forbidden& f, const Vec3& at) const;
  bool along(const Forbidden& f, int b, Mm line, Mm& from, Mm& to) const;
  void add_pair(const Placements& placements, ItemId item, int state, ItemId other, const Region& region);
  // A part of a body: the whole (−1) or one of its solids; of an opening a box that is to be free.
  struct Piece {
    GridBox box;
    int solid = -1;
  };
  void add_stripes(Forbidden& f, const Placements& placements, ItemId item, int state, const Piece& mine, const Piece& theirs);
  void line_up(const Region& region, const Sweep& how, Mm z);
  bool sweep_line(const Region& region, const Sweep& how, Vec3& at) const;
  const GridBox& reach(ItemId item, int state) const { return reach_[first_state_[item] + static_cast<std::size_t>(state)]; }

  const PlacementModel& model_;
  const RegionFinder& regions_;
  ById<ItemId, std::size_t> first_state_;  // into reach_
  std::vector<GridBox> reach_;             // a state's box and its clear boxes, from the low corner
  std::vector<Forbidden> forbidden_;
  std::vector<Stripe> stripes_;
  std::vector<const Forbidden*> near_;  // those at the height that is swept
  std::vector<const Forbidden*> across_;
  Mm across_y_ = 0, across_z_ = 0;
  bool across_known_ = false;
  std::vector<Mm> lines_;
};

}  // namespace layoutbox::placement
