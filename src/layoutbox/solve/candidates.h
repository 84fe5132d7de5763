// Where one item could go while everything else stays: the regions that the formulas leave, cut at the coordinates that matter (ends
// of the region, what the wishes ask for, beside what already stands), legal ones only, cheapest first.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "layoutbox/solve/region.h"

namespace layoutbox::placement {

// A small generator whose numbers are the same everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15u + 0x1234567) {}
  std::uint64_t next() {
    state_ ^= state_ << 13, state_ ^= state_ >> 7, state_ ^= state_ << 17;
    return state_ * 0x2545F4914F6CDD1Du;
  }
  // 0 … bound − 1. REQUIRES: bound > 0.
  std::int64_t below(std::int64_t bound) { return static_cast<std::int64_t>((next() >> 33) % static_cast<std::uint64_t>(bound)); }

 private:
  std::uint64_t state_;
};

// How much work has been done and may be; a step is the trial of one candidate position.
struct Budget {
  std::int64_t steps = 0;
  std::int64_t limit = 0;
  std::function<bool()> stop;  // asked now and then
  bool stopped = false;

  bool spent() const { return stopped || steps >= limit; }
  void count(std::int64_t more) {
    const std::int64_t before = steps;
    steps += more;
    if ((before >> 12) != (steps >> 12) && stop && stop()) stopped = true;
  }
};

struct Candidate {
  Placement placement;
  std::int64_t cost = 0;  // thousandths of a point, of what touches the item
  std::vector<int> hit;   // with eject_price: the items it collides with
};

struct CandidateOptions {
  std::size_t most = 1;
  bool first_legal = false;                                // the first legal one will do
  bool diverse = false;                                    // the best of every column and row rather than `most` alike
  const std::vector<std::int64_t>* eject_price = nullptr;  // collisions are allowed at these prices by item; less than 0: never
  std::int64_t noise = 0;                                  // up to this much is added to a cost at random
  Random* random = nullptr;                                // REQUIRES: set where noise > 0
  int most_size_step = 0;
};

class CandidateFinder {
 public:
  // `given_up`: by constraint index; those need not hold.
  CandidateFinder(const Model& model, std::vector<char> given_up);
  // By item: not there at all; what speaks of them cannot hold.
  void leave_out(const std::vector<char>& items) { regions_.leave_out(items); }
  ~CandidateFinder();

  // The item itself is taken as not placed.
  std::vector<Candidate> find(const Placements& placements, int item, const CandidateOptions& options, Budget& budget);

  // Collides with nothing placed, and lies in the room.
  bool legal(const Placements& placements, int item, const Placement& placement) const;

  // What it collides with; false: the room's edge or what is not to be ejected.
  bool collisions(const Placements& placements, int item, const Placement& placement, const std::vector<std::int64_t>& price,
                  std::vector<int>& hit) const;

  bool enforced(int constraint) const { return regions_.enforced(constraint); }

 private:
  struct Grid;

  void find_soft(const Placements& placements, int item, int state);
  void cut(const Placements& placements, int item, int state, const Region& region, Grid& grid) const;
  std::vector<Point> crossings(const Placements& placements, int item, int state, const Region& region,
                               const std::array<std::vector<Mm>, 3>& grid, Budget& budget) const;
  std::int64_t cost_at(const Region& region, const Vec3& at) const;
  void tabulate(const Region& region, Grid& grid) const;
  std::int64_t access_cost(int item, const Placement& placement);

  const Model& model_;
  RegionFinder regions_;
  Placements probe_;                                                 // the placements, with the item tried
  std::vector<std::pair<std::int64_t, std::vector<Reduced>>> soft_;  // weight, cases
};

}  // namespace layoutbox::placement
