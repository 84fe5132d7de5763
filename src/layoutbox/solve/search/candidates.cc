#include "layoutbox/solve/search/candidates.h"

#include <map>
#include <tuple>

#include "layoutbox/solve/objective/cost.h"
#include "layoutbox/solve/objective/terms.h"

namespace layoutbox::placement {
namespace {

constexpr std::int64_t kStepsOfBound = 16;  // of a region that is passed over

// What the best of every column and row costs, in each state.
class LineCosts {
 public:
  // True: it is the best of its column or its row so far.
  bool note(const Candidate& candidate) {
    bool any = false;
    for (const int axis : {0, 1}) {
      const auto [known, fresh] = least_.try_emplace({axis, candidate.placement.state, candidate.placement.at[axis]}, candidate.cost);
      if (!fresh && known->second <= candidate.cost) continue;
      known->second = candidate.cost;
      any = true;
    }
    return any;
  }

 private:
  std::map<std::tuple<int, int, Mm>, std::int64_t> least_;
};

}  // namespace

// The best candidates so far, and what is looked for.
struct CandidateFinder::Hunt {
  const Placements& placements;
  ItemId item;
  const CandidateOptions& options;
  Budget& budget;
  std::vector<Candidate> best;
  LineCosts lines;

  static bool cheaper(const Candidate& a, const Candidate& b) { return a.cost < b.cost; }

  std::int64_t worst() const { return options.diverse || best.size() < options.most ? kNoCost : best.back().cost; }

  void keep(Candidate candidate) {
    if (candidate.cost >= worst()) return;
    if (options.diverse) {
      if (lines.note(candidate)) best.push_back(std::move(candidate));
      return;
    }
    best.insert(std::upper_bound(best.begin(), best.end(), candidate, cheaper), std::move(candidate));
    if (best.size() > options.most) best.pop_back();
  }

  std::vector<Candidate> take() {
    if (options.diverse) std::stable_sort(best.begin(), best.end(), cheaper);
    if (best.size() > options.most) {  // the cheapest quarter, and of the rest some of every price
      const std::size_t first = options.most / 4, rest = options.most - first, from = best.size() - first;
      for (std::size_t i = 0; i < rest; ++i) best[first + i] = best[first + i * from / rest];
      best.resize(options.most);
    }
    return std::move(best);
  }
};

CandidateFinder::CandidateFinder(const PlacementModel& model, Scope scope)
    : model_(model), regions_(model, std::move(scope)), obstacles_(model, regions_), access_(model) {}

bool CandidateFinder::collisions(const Placements& placements, ItemId item, const Placement& placement,
                                 const ById<ItemId, std::int64_t>& price, std::vector<ItemId>& hit) const {
  const Item& self = model_.items[item];
  const GridBox box = box_of(self, placement);
  hit.clear();
  if (!self.is_opening() && !self.fixed) {
    for (const GridBox& outside : model_.off_limits) {
      if (overlap(outside, box)) return false;
    }
  }
  for (const ItemId other : model_.items.ids()) {
    if (placements[other].state < 0 || other == item || (self.fixed && model_.items[other].fixed)) continue;
    const bool clear_boxes = !regions_.clearance_off(model_.items[other]) && !regions_.clearance_off(self);
    if (!collide(model_, item, placement, other, placements[other], clear_boxes)) continue;
    if (price.empty() || price[other] < 0) return false;
    hit.push_back(other);
  }
  return true;
}

bool CandidateFinder::legal(const Placements& placements, ItemId item, const Placement& placement) const {
  static const ById<ItemId, std::int64_t> kNoPrice;
  std::vector<ItemId> hit;
  return collisions(placements, item, placement, kNoPrice, hit);
}

bool CandidateFinder::gives_way(const Obstacles::Forbidden& f, const CandidateOptions& options) {
  return f.owner.exists() && options.eject_price != nullptr && !options.eject_price->empty() && (*options.eject_price)[f.owner] >= 0;
}

// What stands at that position of the region at hand; false: the room's edge, or what is not to be pushed.
bool CandidateFinder::pushes(const Vec3& at, const CandidateOptions& options, std::vector<ItemId>& hit) {
  for (const Obstacles::Forbidden* const near : obstacles_.across(at)) {
    const Obstacles::Forbidden& f = *near;
    if (!obstacles_.holds(f, at)) continue;
    if (!gives_way(f, options)) return false;
    if (hit.empty() || hit.back() != f.owner) hit.push_back(f.owner);
  }
  return true;
}

std::int64_t CandidateFinder::swing_cost(const Placements& placements, ItemId opening, const Placement& placement) {
  probe_ = placements;
  probe_[opening] = placement;
  return access_cost_of(model_, opening, probe_);
}

// Keeps it where it is legal; true: that was enough.
bool CandidateFinder::consider(Hunt& hunt, int state, const Vec3& at, std::int64_t cost) {
  const CandidateOptions& options = hunt.options;
  Candidate candidate{{state, at}, cost, {}};
  if (!pushes(at, options, candidate.hit)) return false;
  if (options.first_legal) {
    hunt.best = {std::move(candidate)};
    return true;
  }
  for (const ItemId other : candidate.hit) candidate.cost += (*options.eject_price)[other];
  if (options.noise > 0) candidate.cost += options.random->below(options.noise);
  if (candidate.cost >= hunt.worst()) return false;
  if (candidate.hit.empty())
    candidate.cost += model_.items[hunt.item].is_opening() ? swing_cost(hunt.placements, hunt.item, candidate.placement)
                                                           : access_.cost_at(at, hunt.worst() - candidate.cost);
  hunt.budget.count(8);
  hunt.keep(std::move(candidate));
  return false;
}

// All of the grid; true: that was enough.
bool CandidateFinder::try_grid(Hunt& hunt, int state, std::int64_t base, CandidateGrid& grid) {
  for (std::size_t iz = 0; iz < grid.values[2].size(); ++iz) {
    taken_.start(grid.values[0], grid.values[1]);
    for (const Obstacles::Forbidden& f : obstacles_.all()) {  // what stands slantwise is left to `pushes`
      const bool here = f.lo[2] < grid.values[2][iz] && grid.values[2][iz] < f.hi[2];
      if (here && f.stripes == 0 && !gives_way(f, hunt.options)) taken_.add(f.lo, f.hi);
    }
    for (std::size_t iy = 0; iy < grid.values[1].size(); ++iy) {
      hunt.budget.count(static_cast<std::int64_t>(grid.values[0].size()));
      if (hunt.budget.stopped) return true;
      std::size_t ix = taken_.next_free(iy, 0);
      if (ix == grid.values[0].size()) continue;
      grid.start_row(iy, iz, base);
      if (grid.row_bound() >= hunt.worst()) continue;
      for (; ix < grid.values[0].size(); ix = taken_.next_free(iy, ix + 1)) {
        const std::int64_t cost = grid.cost_in_row(ix, hunt.worst());
        if (cost == kNoCost) continue;
        if (consider(hunt, state, {grid.values[0][ix], grid.values[1][iy], grid.values[2][iz]}, cost)) return true;
      }
    }
  }
  return false;
}

// Single points, at each height of the grid; true: that was enough.
bool CandidateFinder::try_points(Hunt& hunt, int state, std::int64_t base, const Region& region, const std::vector<Point>& points,
                                 const std::vector<Mm>& heights) {
  for (const Point& point : points) {
    hunt.budget.count(4);
    if (hunt.budget.stopped) return true;
    for (const Mm z : heights) {
      const Vec3 at{point.x, point.y, z};
      const std::int64_t cost = base + cost_at(region, at);
      if (cost < hunt.worst() && holds_at(region, at) && consider(hunt, state, at, cost)) return true;
    }
  }
  return false;
}

// What is wished for is looked at along each axis.
void CandidateFinder::heed(const CandidateGrid& grid, Budget& budget) const {
  std::size_t cases = 0, values = 0;
  for (const SoftFormula& formula : soft_) cases += formula.count;
  for (const std::vector<Mm>& along : grid.values) values += along.size();
  budget.heed(static_cast<std::int64_t>(cases * values));
}

std::vector<Candidate> CandidateFinder::find(const Placements& placements, ItemId item, const CandidateOptions& options, Budget& budget) {
  Hunt hunt{placements, item, options, budget, {}, {}};
  const Item& self = model_.items[item];
  regions_.watch(&budget);
  access_.start(placements, item);
  CandidateGrid& grid = grid_;
  for (std::size_t s = 0; s < self.states.size(); ++s) {
    const int state = static_cast<int>(s);
    if (self.states[s].size_step > options.most_size_step) continue;
    const std::vector<Region>& regions = regions_.find(placements, item, state);
    if (budget.stopped) return std::move(hunt.best);
    if (regions.empty()) continue;
    find_soft(placements, item, state);
    const std::int64_t by_size = size_cost(self.states[s]);
    for (const Region& region : regions) {
      if (skips_dear_ && hunt.worst() < kNoCost && least_cost({self.states[s], region, soft_}, hunt.worst()) >= hunt.worst()) {
        budget.count(kStepsOfBound);
        continue;
      }
      obstacles_.gather(placements, item, state, region);
      access_.focus(state, region.lo, region.hi);
      cut(placements, item, state, region, grid);
      heed(grid, budget);
      if (budget.stopped) return std::move(hunt.best);
      const std::vector<Point> points = crossings(placements, item, state, region, grid.values, budget);
      grid.tabulate(region, soft_);
      budget.count(50 + static_cast<std::int64_t>(4 * points.size()));
      if (try_grid(hunt, state, by_size, grid) || try_points(hunt, state, by_size, region, points, grid.values[2]))
        return std::move(hunt.best);
    }
  }
  return hunt.take();
}

}  // namespace layoutbox::placement
