#include "layoutbox/solve/search/candidates.h"

#include <map>
#include <tuple>

#include "layoutbox/solve/model/whole_division.h"
#include "layoutbox/solve/objective/cost.h"

namespace layoutbox::placement {
namespace {

constexpr std::array<Mm, 2> kRoomBehind{400, 700};  // off the ends of a region: for a lamp behind a sofa, for somebody to pass

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

CandidateFinder::CandidateFinder(const Model& model, std::vector<char> given_up)
    : model_(model), regions_(model, std::move(given_up)), obstacles_(model, regions_), access_(model) {}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): to be parted
void CandidateFinder::find_soft(const Placements& placements, int item, int state) {
  std::size_t used = 0;
  for (const int c : model_.touching[item]) {
    const Constraint& constraint = model_.constraints[c];
    if (constraint.firmness != Firmness::kSoft) continue;
    for (const Formula& formula : constraint.formulas) {
      const auto known = [&](int other) { return other == item || placements[other].state >= 0; };
      if (formula.cases.empty() || !std::all_of(formula.items.begin(), formula.items.end(), known)) continue;
      if (used == soft_pool_.size()) soft_pool_.emplace_back();
      SoftFormula& soft = soft_pool_[used++];
      soft.weight = constraint.weight, soft.count = 0;
      for (const Case& one : formula.cases) {
        if (soft.count == soft.cases.size()) soft.cases.emplace_back();
        Reduced& reduced = soft.cases[soft.count++];
        reduced.checks.clear();
        reduced.wishes.clear();
        reduced.miss = 0;
        reduced.price = one.price * kPoint;
        for (const StateLiteral& literal : one.states) {
          const int s = literal.item == item ? state : placements[literal.item].state;
          if (!(literal.states >> s & 1)) reduced.miss = kStateMiss;
        }
        for (const Linear& form : one.at_least_zero)
          reduced.checks.push_back(partial_of(model_, placements, regions_.domains(), form, item, state));
        for (const Preference& wish : one.wishes) {
          reduced.wishes.push_back({partial_of(model_, placements, regions_.domains(), wish.form, item, state), wish.weight, wish.scale});
        }
      }
    }
  }
  soft_ = {soft_pool_.data(), used};
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): to be parted
void CandidateFinder::cut(const Placements& placements, int item, int state, const Region& region, CandidateGrid& grid) const {
  const State& own = model_.items[item].states[state];
  const std::size_t most = 36 + model_.items.size() / 3;
  const auto offer = [&](int axis, std::int64_t value) {
    if (value >= region.lo[axis] && value <= region.hi[axis]) grid.values[axis].push_back(static_cast<Mm>(value));
  };
  std::array<std::vector<Mm>, 3> wished;  // always tried, however many others there are
  const auto offer_zero = [&](const Partial& form, bool clamp) {
    const int axis = form.axis();
    if (axis < 0) return;
    const std::int64_t value = floor_div(-form.constant, form.coefficient[axis]);
    if (!clamp) return offer(axis, value);
    wished[axis].push_back(static_cast<Mm>(std::clamp<std::int64_t>(value, region.lo[axis], region.hi[axis])));
  };
  for (int axis = 0; axis < 3; ++axis) {
    grid.values[axis].clear();
    offer(axis, region.lo[axis]);
    offer(axis, region.hi[axis]);
    if (axis == 2) continue;
    offer(axis, region.lo[axis] + (region.hi[axis] - region.lo[axis]) / 2);
    for (const Mm room : kRoomBehind) offer(axis, std::int64_t{region.lo[axis]} + room), offer(axis, std::int64_t{region.hi[axis]} - room);
  }
  for (const Reduced* one : region.cases) {
    for (const Wish& wish : one->wishes) offer_zero(wish.form, true);
  }
  for (const SoftFormula& formula : soft_) {
    for (const Reduced& one : formula.all()) {
      if (one.miss > 0) continue;
      for (const Wish& wish : one.wishes) offer_zero(wish.form, true);
      for (const Partial& form : one.checks) offer_zero(form, false);
    }
  }
  const auto beside = [&](const Box& body, const Box& mine) {
    for (int axis = 0; axis < 2; ++axis) {
      offer(axis, std::int64_t{body.hi[axis]} - mine.lo[axis]);
      offer(axis, std::int64_t{body.lo[axis]} - mine.hi[axis]);
    }
  };
  const Box mine{{0, 0, 0}, own.extent};
  for (const Box& outside : model_.outside) beside(outside, mine);
  for (std::size_t j = 0; j < model_.items.size(); ++j) {
    const int other = static_cast<int>(j);
    if (placements[j].state < 0 || other == item) continue;
    const PairRule rule = model_.pair(item, other);
    if (rule == PairRule::kFree) continue;
    const State& theirs = model_.items[j].states[placements[j].state];
    beside(box_of(model_.items[j], placements[j]), mine);
    for (const Box& clear : theirs.clear) beside(clear.shifted(placements[j].at), mine);
    for (const Box& clear : own.clear) beside(box_of(model_.items[j], placements[j]), clear);
    if (rule != PairRule::kSolids || theirs.solids.size() * own.solids.size() > 24) continue;
    for (const Box& body : theirs.solids) {
      for (const Box& part : own.solids) beside(body.shifted(placements[j].at), part);
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Mm>& values = grid.values[axis];
    const auto in_order = [&] {
      std::sort(values.begin(), values.end());
      values.erase(std::unique(values.begin(), values.end()), values.end());
    };
    in_order();
    if (values.size() > most) {
      std::vector<Mm> fewer;  // evenly over all of them, both ends kept
      for (std::size_t i = 0; i < most; ++i) fewer.push_back(values[i * (values.size() - 1) / (most - 1)]);
      values = std::move(fewer);
    }
    values.insert(values.end(), wished[axis].begin(), wished[axis].end());
    in_order();
  }
}

bool CandidateFinder::collisions(const Placements& placements, int item, const Placement& placement, const std::vector<std::int64_t>& price,
                                 std::vector<int>& hit) const {
  const Item& self = model_.items[item];
  const Box box = box_of(self, placement);
  hit.clear();
  if (!self.is_opening() && !self.fixed) {
    for (const Box& outside : model_.off_limits) {
      if (overlap(outside, box)) return false;
    }
  }
  for (std::size_t j = 0; j < model_.items.size(); ++j) {
    const int other = static_cast<int>(j);
    if (placements[j].state < 0 || other == item || (self.fixed && model_.items[j].fixed)) continue;
    const bool clear_boxes = !regions_.clearance_off(model_.items[j]) && !regions_.clearance_off(self);
    if (!collide(model_, item, placement, other, placements[j], clear_boxes)) continue;
    if (price.empty() || price[j] < 0) return false;
    hit.push_back(other);
  }
  return true;
}

bool CandidateFinder::legal(const Placements& placements, int item, const Placement& placement) const {
  static const std::vector<std::int64_t> kNoPrice;
  std::vector<int> hit;
  return collisions(placements, item, placement, kNoPrice, hit);
}

// What stands at that position of the region at hand; false: the room's edge, or what is not to be pushed.
bool CandidateFinder::pushes(const Vec3& at, const std::vector<std::int64_t>& price, std::vector<int>& hit) const {
  for (const Obstacles::Forbidden& f : obstacles_.all()) {
    if (!obstacles_.holds(f, at)) continue;
    if (f.owner < 0 || price.empty() || price[f.owner] < 0) return false;
    if (hit.empty() || hit.back() != f.owner) hit.push_back(f.owner);
  }
  return true;
}

std::int64_t CandidateFinder::swing_cost(const Placements& placements, int opening, const Placement& placement) {
  probe_ = placements;
  probe_[opening] = placement;
  return access_cost_of(model_, opening, probe_);
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): to be parted
std::vector<Candidate> CandidateFinder::find(const Placements& placements, int item, const CandidateOptions& options, Budget& budget) {
  static const std::vector<std::int64_t> kNoPrice;
  std::vector<Candidate> best;
  const Item& self = model_.items[item];
  regions_.watch(&budget);
  access_.start(placements, item);
  const auto worst = [&] { return options.diverse || best.size() < options.most ? kNoCost : best.back().cost; };
  const auto cheaper = [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; };
  LineCosts lines;
  const auto keep = [&](Candidate candidate) {
    if (candidate.cost >= worst()) return;
    if (options.diverse) {
      if (lines.note(candidate)) best.push_back(std::move(candidate));
      return;
    }
    best.insert(std::upper_bound(best.begin(), best.end(), candidate, cheaper), std::move(candidate));
    if (best.size() > options.most) best.pop_back();
  };
  // Keeps it where it is legal; true: that was enough.
  const auto consider = [&](int state, const Vec3& at, std::int64_t cost) {
    Candidate candidate{{state, at}, cost, {}};
    if (!pushes(at, options.eject_price ? *options.eject_price : kNoPrice, candidate.hit)) return false;
    if (options.first_legal) {
      best = {std::move(candidate)};
      return true;
    }
    for (const int other : candidate.hit) candidate.cost += (*options.eject_price)[other];
    if (options.noise > 0) candidate.cost += options.random->below(options.noise);
    if (candidate.cost >= worst()) return false;
    if (candidate.hit.empty())
      candidate.cost += self.is_opening() ? swing_cost(placements, item, candidate.placement) : access_.cost_at(at);
    budget.count(8);
    keep(std::move(candidate));
    return false;
  };
  // All of the grid; true: that was enough.
  const auto try_grid = [&](int state, std::int64_t size_cost, CandidateGrid& grid) {
    for (std::size_t iz = 0; iz < grid.values[2].size(); ++iz) {
      for (std::size_t iy = 0; iy < grid.values[1].size(); ++iy) {
        budget.count(static_cast<std::int64_t>(grid.values[0].size()));
        if (budget.stopped) return true;
        grid.start_row(iy, iz, size_cost);
        if (grid.row_bound() >= worst()) continue;
        for (std::size_t ix = 0; ix < grid.values[0].size(); ++ix) {
          const std::int64_t cost = grid.cost_in_row(ix, worst());
          if (cost == kNoCost) continue;
          if (consider(state, {grid.values[0][ix], grid.values[1][iy], grid.values[2][iz]}, cost)) return true;
        }
      }
    }
    return false;
  };
  CandidateGrid grid;
  for (std::size_t s = 0; s < self.states.size(); ++s) {
    const int state = static_cast<int>(s);
    if (self.states[s].size_step > options.most_size_step) continue;
    const std::vector<Region>& regions = regions_.find(placements, item, state);
    if (budget.stopped) return best;
    if (regions.empty()) continue;
    find_soft(placements, item, state);
    const std::int64_t size_cost = kPoint * kCostWeights.size_step * self.states[s].size_step;
    for (const Region& region : regions) {
      obstacles_.gather(placements, item, state, region);
      access_.focus(state, region.lo, region.hi);
      cut(placements, item, state, region, grid);
      const std::vector<Point> points = crossings(placements, item, state, region, grid.values, budget);
      grid.tabulate(region, soft_);
      budget.count(50 + static_cast<std::int64_t>(4 * points.size()));
      if (try_grid(state, size_cost, grid)) return best;
      for (const Point& point : points) {
        budget.count(4);
        if (budget.stopped) return best;
        for (const Mm z : grid.values[2]) {
          const Vec3 at{point.x, point.y, z};
          const std::int64_t cost = size_cost + cost_at(region, at);
          if (cost < worst() && holds_at(region, at) && consider(state, at, cost)) return best;
        }
      }
    }
  }
  if (options.diverse) std::stable_sort(best.begin(), best.end(), cheaper);
  if (best.size() > options.most) {  // the cheapest quarter, and of the rest some of every price
    const std::size_t first = options.most / 4, rest = options.most - first, from = best.size() - first;
    for (std::size_t i = 0; i < rest; ++i) best[first + i] = best[first + i * from / rest];
    best.resize(options.most);
  }
  return best;
}

}  // namespace layoutbox::placement
