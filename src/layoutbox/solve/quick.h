// The quick search for a first legal layout: costs are not looked at. Each item goes to the first free position of a sweep; one that has
// none pushes out what has failed least often so far, and that looks for a new place (an ejection search).
#pragma once

#include <cstdint>
#include <vector>

#include "layoutbox/solve/candidates.h"
#include "layoutbox/solve/order.h"

namespace layoutbox::placement {

class QuickSearch {
 public:
  // `given_up`: by constraint index. `most_size_step`: how far from the usual size items may be.
  QuickSearch(const Model& model, const Dependencies& dependencies, std::vector<char> given_up, std::uint64_t seed, int most_size_step);

  // Places everything that has no place yet in `placements` but what is `left_out`; what is there may be moved, what stays() apart.
  // False: not within the budget; `placements` is then as good as it got.
  bool complete(Placements& placements, const std::vector<char>& left_out, Budget& budget);

  // Those without a place in the best try.
  const std::vector<int>& failed() const { return failed_; }

 private:
  // |2 · (x, y) · position + constant| < half.
  struct Stripe {
    std::int64_t x = 0, y = 0, constant = 0, half = 0;
  };
  // Positions of the item's low corner, all inside of the box, at which it would collide with the owner (−1: the room).
  struct Forbidden {
    Vec3 lo{}, hi{};
    int owner = -1;
    std::vector<Stripe> stripes = {};  // and within all of these
    bool holds(const Vec3& at) const {
      const auto within = [&](const Stripe& s) { return std::abs(2 * (s.x * at[0] + s.y * at[1]) + s.constant) < s.half; };
      return lo[0] < at[0] && at[0] < hi[0] && lo[1] < at[1] && at[1] < hi[1] && lo[2] < at[2] && at[2] < hi[2] &&
             std::all_of(stripes.begin(), stripes.end(), within);
    }
    // What of the line along axis `b` lies in it, open at both ends; false: nothing.
    bool along(int b, Mm line, Mm& from, Mm& to) const;
  };
  struct Sweep {
    int outer = 0;
    bool down[2] = {false, false};
  };

  bool attempt(const std::vector<char>& left_out, std::vector<int> pending, Budget& budget);
  int next_of(std::vector<int>& pending) const;
  bool settle(int item, Budget& budget);
  bool settle_once(int item, Budget& budget);
  bool push_out(int item, std::vector<int>& pending, Budget& budget);
  std::vector<int> all_hosts(int item) const;
  bool take_hosts(int item, std::vector<int>& pending);
  void take_out(int item, std::vector<int>& pending);
  void forbid(int item, int state);
  void forbid_pair(int item, int state, int other);
  bool somewhere(const Region& region, Vec3& at);
  bool sweep(const Region& region, const Sweep& how, Vec3& at, Budget& budget);
  bool sweep_line(const Region& region, const Sweep& how, Vec3& at) const;
  bool narrow(const Region& region, int b, const Vec3& at, Mm& from, Mm& to) const;
  std::vector<int> states_in_turn(int item);

  const Model& model_;
  const Dependencies& dependencies_;
  RegionFinder regions_;
  Random random_;
  int most_size_step_;
  Placements placements_;
  std::vector<int> weight_;  // how often an item found no place
  int attempts_ = 0;
  std::vector<int> failed_;
  std::vector<Forbidden> forbidden_;
  std::vector<const Forbidden*> near_;  // those at the height that is swept
  std::vector<Mm> lines_;
};

}  // namespace layoutbox::placement
