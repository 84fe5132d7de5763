// The constructive search: places one item after another, the most constrained first, at candidate positions that follow from the
// formulas and from what already stands; starts anew with the priority of what failed raised; then improves by local moves.
// Deterministic: integer costs, a seeded generator of its own, effort counted in steps.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "layoutbox/solve/model.h"

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
};

struct Candidate {
  Placement placement;
  std::int64_t cost = 0;
};

class Search {
 public:
  // `given_up`: constraints that need not hold. All by constraint index.
  Search(const Model& model, std::vector<char> given_up, std::uint64_t seed, int most_size_step);

  // Places everything, or as much as it can: `left_out` are items that must not be placed at all. True when all the rest are placed.
  bool construct(const std::vector<char>& left_out, int restarts, Budget& budget);

  // Local moves from a complete layout.
  void improve(Budget& budget);

  const Placements& placements() const { return placements_; }
  void adopt(const Placements& placements) { placements_ = placements; }
  // Items that could not be placed in the best try.
  const std::vector<int>& failed() const { return failed_; }

  std::int64_t total_cost();

 private:
  struct Reduced;  // a case in which only the item at hand is free
  struct Domain;
  struct Sketch;   // all that is the same for every candidate of one state

  std::vector<int> order() const;
  std::vector<int> depends_on(int item) const;
  bool try_order(const std::vector<int>& order, Budget& budget, int& failed);
  bool place(int item, Budget& budget);
  bool watched_fit(int item, Budget& budget);
  // The best candidates, cheapest first, at most `most`; `any`: stop at the first legal one.
  std::vector<Candidate> candidates(int item, std::size_t most, bool any, Budget& budget);
  bool reduce(const Case& one, int item, int state, Reduced& out) const;
  void domains(int item, int state, std::vector<Domain>& out) const;
  void collect_soft(int item, int state, Sketch& sketch) const;
  void coordinates(int item, int state, const Domain& domain, const Sketch& sketch, std::array<std::vector<Mm>, 3>& out) const;
  bool legal(int item, const Placement& placement) const;
  std::int64_t soft_cost(const Sketch& sketch, const Vec3& at) const;
  std::int64_t access_cost(int item, const Placement& placement) const;
  bool move_group(int item, Budget& budget);
  bool enforced(int constraint) const;

  const Model& model_;
  std::vector<char> given_up_;
  Random random_;
  int most_size_step_;
  Placements placements_;
  std::vector<int> failed_;
  std::vector<char> left_out_;
  std::vector<int> bonus_;
  std::vector<std::vector<int>> depends_;     // item → items it refers to
  std::vector<std::vector<int>> dependents_;
  std::int64_t noise_ = 0;
};

}  // namespace layoutbox::placement
