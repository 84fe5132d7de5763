#include "layoutbox/solve/candidates.h"

#include "layoutbox/solve/cost.h"

namespace layoutbox::placement {
namespace {

constexpr std::int64_t kNoCost = std::numeric_limits<std::int64_t>::max() / 4;
constexpr std::int64_t kPoint = 1000;
constexpr std::array<Mm, 2> kRoomBehind{400, 700};  // off the ends of a region: for a lamp behind a sofa, for somebody to pass

std::int64_t floor_div(std::int64_t a, std::int64_t b) { return a / b - ((a % b != 0) && ((a < 0) != (b < 0))); }

// What a case costs along one axis, for each coordinate tried there.
struct AxisCosts {
  std::vector<std::int64_t> miss, wish;
};

// One case over the whole grid: most forms speak of one axis only, so most of the work is done once per coordinate.
struct CaseTable {
  std::int64_t price = 0;
  std::array<AxisCosts, 3> axes;
  std::vector<Partial> crossing;  // forms over several axes
  std::vector<Wish> crossing_wishes;
};

struct SoftTable {
  std::int64_t weight = 0;
  std::vector<CaseTable> cases;
};

}  // namespace

struct CandidateFinder::Grid {
  std::array<std::vector<Mm>, 3> values;
  CaseTable hard;  // the wishes of the region's cases
  std::vector<SoftTable> soft;
};

CandidateFinder::CandidateFinder(const Model& model, std::vector<char> given_up) : model_(model), regions_(model, std::move(given_up)) {}

CandidateFinder::~CandidateFinder() = default;

void CandidateFinder::find_soft(const Placements& placements, int item, int state) {
  soft_.clear();
  for (const int c : model_.touching[item]) {
    const Constraint& constraint = model_.constraints[c];
    if (constraint.firmness != Firmness::kSoft) continue;
    for (const Formula& formula : constraint.formulas) {
      const auto known = [&](int other) { return other == item || placements[other].state >= 0; };
      if (formula.cases.empty() || !std::all_of(formula.items.begin(), formula.items.end(), known)) continue;
      std::vector<Reduced> cases;
      for (const Case& one : formula.cases) {
        Reduced& reduced = cases.emplace_back();
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
      soft_.emplace_back(constraint.weight, std::move(cases));
    }
  }
}

void CandidateFinder::cut(const Placements& placements, int item, int state, const Region& region, Grid& grid) const {
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
  for (const auto& [weight, cases] : soft_) {
    for (const Reduced& one : cases) {
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

void CandidateFinder::tabulate(const Region& region, Grid& grid) const {
  const auto start = [&](CaseTable& table) {
    for (int axis = 0; axis < 3; ++axis) {
      table.axes[axis].miss.assign(grid.values[axis].size(), 0);
      table.axes[axis].wish.assign(grid.values[axis].size(), 0);
    }
  };
  const auto add_wish = [&](CaseTable& table, const Wish& wish) {
    const int axis = wish.form.axis();
    if (axis == -2) {
      table.crossing_wishes.push_back(wish);
      return;
    }
    if (axis == -1) {
      table.price += std::abs(wish.form.constant) * wish.weight / wish.scale;
      return;
    }
    const std::vector<Mm>& values = grid.values[axis];
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::int64_t off = wish.form.constant + std::int64_t{wish.form.coefficient[axis]} * values[i];
      table.axes[axis].wish[i] += std::abs(off) * wish.weight / wish.scale;
    }
  };
  grid.hard = {};
  grid.hard.price = region.price;
  start(grid.hard);
  for (const Reduced* one : region.cases) {
    grid.hard.crossing.insert(grid.hard.crossing.end(), one->checks.begin(), one->checks.end());
    for (const Wish& wish : one->wishes) add_wish(grid.hard, wish);
  }
  grid.soft.clear();
  for (const auto& [weight, cases] : soft_) {
    SoftTable& soft = grid.soft.emplace_back();
    soft.weight = weight;
    for (const Reduced& one : cases) {
      CaseTable& table = soft.cases.emplace_back();
      table.price = one.price;
      start(table);
      for (std::int64_t& miss : table.axes[2].miss) miss = one.miss;
      for (const Partial& form : one.checks) {
        const int axis = form.axis();
        if (axis == -2) {
          table.crossing.push_back(form);
        } else if (axis == -1) {
          for (std::int64_t& miss : table.axes[2].miss) miss = std::max(miss, missing(form.constant, form.scale));
        } else {
          const std::vector<Mm>& values = grid.values[axis];
          for (std::size_t i = 0; i < values.size(); ++i) {
            std::int64_t& miss = table.axes[axis].miss[i];
            miss = std::max(miss, missing(form.constant + std::int64_t{form.coefficient[axis]} * values[i], form.scale));
          }
        }
      }
      for (const Wish& wish : one.wishes) add_wish(table, wish);
    }
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

std::int64_t CandidateFinder::access_cost(int item, const Placement& placement) {
  const Item& self = model_.items[item];
  probe_[item] = placement;
  std::int64_t cost = access_cost_of(model_, item, probe_);
  const Box body = box_of(self, placement);
  if (!blocks_floor(self, body)) return cost;
  for (std::size_t j = 0; j < model_.items.size(); ++j) {
    const int other = static_cast<int>(j);
    if (other == item || probe_[j].state < 0) continue;
    const State& state = model_.items[j].states[probe_[j].state];
    const auto touched = [&](const Box& strip) { return overlap_in_plan(strip.shifted(probe_[j].at), body); };
    const bool any =
        std::any_of(state.strips.begin(), state.strips.end(), touched) || std::any_of(state.wanted.begin(), state.wanted.end(), touched);
    if (any) cost += access_cost_of(model_, other, probe_) - access_cost_of(model_, other, probe_, item);
  }
  return cost;
}

std::vector<Candidate> CandidateFinder::find(const Placements& placements, int item, const CandidateOptions& options, Budget& budget) {
  static const std::vector<std::int64_t> kNoPrice;
  std::vector<Candidate> best;
  const Item& self = model_.items[item];
  probe_ = placements;
  const auto worst = [&] { return options.diverse || best.size() < options.most ? kNoCost : best.back().cost; };
  const auto keep = [&](Candidate candidate) {
    if (candidate.cost >= worst()) return;
    if (options.diverse) {  // only where it is the best of its column or its row
      bool column = true, row = true;
      for (const Candidate& other : best) {
        if (other.placement.state != candidate.placement.state || other.cost > candidate.cost) continue;
        column = column && other.placement.at[0] != candidate.placement.at[0];
        row = row && other.placement.at[1] != candidate.placement.at[1];
      }
      if (!column && !row) return;
    }
    const auto place =
        std::upper_bound(best.begin(), best.end(), candidate.cost, [](std::int64_t c, const Candidate& k) { return c < k.cost; });
    best.insert(place, std::move(candidate));
    if (!options.diverse && best.size() > options.most) best.pop_back();
  };
  // Keeps it where it is legal; true: that was enough.
  const auto consider = [&](int state, const Vec3& at, std::int64_t cost) {
    Candidate candidate{{state, at}, cost, {}};
    if (!collisions(placements, item, candidate.placement, options.eject_price ? *options.eject_price : kNoPrice, candidate.hit))
      return false;
    if (options.first_legal) {
      best = {std::move(candidate)};
      return true;
    }
    for (const int other : candidate.hit) candidate.cost += (*options.eject_price)[other];
    if (options.noise > 0) candidate.cost += options.random->below(options.noise);
    if (candidate.cost >= worst()) return false;
    if (candidate.hit.empty()) candidate.cost += access_cost(item, candidate.placement);
    budget.count(8);
    keep(std::move(candidate));
    return false;
  };
  // All of the grid; true: that was enough.
  const auto try_grid = [&](int state, std::int64_t size_cost, const Grid& grid) {
    for (std::size_t iz = 0; iz < grid.values[2].size(); ++iz) {
      for (std::size_t iy = 0; iy < grid.values[1].size(); ++iy) {
        budget.count(static_cast<std::int64_t>(grid.values[0].size()));
        if (budget.stopped) return true;
        const std::int64_t row = size_cost + grid.hard.price + grid.hard.axes[2].wish[iz] + grid.hard.axes[1].wish[iy];
        if (row >= worst()) continue;
        for (std::size_t ix = 0; ix < grid.values[0].size(); ++ix) {
          const Vec3 at{grid.values[0][ix], grid.values[1][iy], grid.values[2][iz]};
          std::int64_t cost = row + grid.hard.axes[0].wish[ix];
          if (cost >= worst()) continue;
          bool holds = true;
          for (const Partial& check : grid.hard.crossing) holds = holds && check.at(at) >= 0;
          if (!holds) continue;
          for (const Wish& wish : grid.hard.crossing_wishes) cost += wish.cost(at);
          for (const SoftTable& soft : grid.soft) {
            std::int64_t least = kNoCost;
            for (const CaseTable& one : soft.cases) {
              std::int64_t miss = std::max({one.axes[0].miss[ix], one.axes[1].miss[iy], one.axes[2].miss[iz]});
              for (const Partial& form : one.crossing) miss = std::max(miss, missing(form.at(at), form.scale));
              std::int64_t c = one.price + miss * soft.weight + one.axes[0].wish[ix] + one.axes[1].wish[iy] + one.axes[2].wish[iz];
              for (const Wish& wish : one.crossing_wishes) c += wish.cost(at);
              least = std::min(least, c);
            }
            cost += least;
            if (cost >= worst()) break;
          }
          if (cost < worst() && consider(state, at, cost)) return true;
        }
      }
    }
    return false;
  };
  Grid grid;
  for (std::size_t s = 0; s < self.states.size(); ++s) {
    const int state = static_cast<int>(s);
    if (self.states[s].size_step > options.most_size_step) continue;
    const std::vector<Region>& regions = regions_.find(placements, item, state);
    if (regions.empty()) continue;
    find_soft(placements, item, state);
    const std::int64_t size_cost = kPoint * kCostWeights.size_step * self.states[s].size_step;
    for (const Region& region : regions) {
      cut(placements, item, state, region, grid);
      const std::vector<Point> points = crossings(placements, item, state, region, grid.values, budget);
      tabulate(region, grid);
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
  if (best.size() > options.most) {  // the cheapest quarter, and of the rest some of every price
    const std::size_t first = options.most / 4, rest = options.most - first, from = best.size() - first;
    for (std::size_t i = 0; i < rest; ++i) best[first + i] = best[first + i * from / rest];
    best.resize(options.most);
  }
  return best;
}

}  // namespace layoutbox::placement
