// Before slanted walls the coordinates that matter come in pairs: single points, where lines cross.
#include <cmath>
#include <optional>

#include "layoutbox/solve/model/slanted.h"
#include "layoutbox/solve/search/candidates.h"

namespace layoutbox::placement {
namespace {

// a · x + b · y + c = 0.
struct Line {
  std::int64_t a = 0, b = 0, c = 0;
};

// Where two lines cross, in the region and where all its checks hold; the nearest whole millimetre that does.
std::optional<Point> crossing_of(const Line& p, const Line& q, const Region& region, Mm z) {
  const auto wide = [](std::int64_t v) { return static_cast<double>(v); };
  const double by = wide(p.a) * wide(q.b) - wide(q.a) * wide(p.b);
  if (std::abs(by) < 1e-6 * std::hypot(wide(p.a), wide(p.b)) * std::hypot(wide(q.a), wide(q.b))) return std::nullopt;
  const double x = (wide(p.b) * wide(q.c) - wide(q.b) * wide(p.c)) / by, y = (wide(q.a) * wide(p.c) - wide(p.a) * wide(q.c)) / by;
  if (!(x > region.lo[0] - 1.0 && x < region.hi[0] + 1.0 && y > region.lo[1] - 1.0 && y < region.hi[1] + 1.0)) return std::nullopt;
  for (const double dx : {0.5, -0.5, 1.5}) {
    for (const double dy : {0.5, -0.5, 1.5}) {
      const Vec3 at{static_cast<Mm>(std::floor(x + dx)), static_cast<Mm>(std::floor(y + dy)), z};
      if (at[0] < region.lo[0] || at[0] > region.hi[0] || at[1] < region.lo[1] || at[1] > region.hi[1]) continue;
      if (holds_at(region, at)) return Point{at[0], at[1]};
    }
  }
  return std::nullopt;
}

constexpr std::size_t kMostCrossings = 60, kAcross = 8;

// The lines of a region before slanted walls: the edges of what is allowed, and what may cross them.
struct RegionLines {
  Mm z = 0;
  std::vector<Line> edges, others;

  Line line_of(const Partial& form) const {
    return {form.coefficient[0], form.coefficient[1], form.constant + std::int64_t{form.coefficient[2]} * z};
  }
  void add_edges(const Region& region) {
    const auto slants = [](const Partial& form) { return form.scale != 1 && form.coefficient[0] != 0 && form.coefficient[1] != 0; };
    for (const Reduced* one : region.cases) {
      for (const Partial& check : one->checks) {
        if (slants(check)) edges.push_back(line_of(check));
      }
    }
  }
  void add_wishes(const std::vector<Wish>& wishes) {
    for (const Wish& wish : wishes) {
      if (wish.form.axis() == -2) others.push_back(line_of(wish.form));
    }
  }
  // Some of the coordinates, from end to end.
  void add_across(int axis, const std::vector<Mm>& values) {
    for (std::size_t i = 0; i < kAcross && !values.empty(); ++i) {
      const std::int64_t value = values[i * (values.size() - 1) / (kAcross - 1)];
      others.push_back(axis == 0 ? Line{1, 0, -value} : Line{0, 1, -value});
    }
  }
  // Beside what stands there, turned or not.
  void add_beside(const PlacementModel& model, ItemId item, int state, ItemId other, const Placement& placement) {
    for (std::size_t k = 0; k < model.headings.size(); ++k) {
      const Heading& h = model.headings[k];
      const Reach mine = reach_of(model, model.items[item], state, -1, static_cast<int>(k));
      const Reach theirs = reach_of(model, model.items[other], placement.state, -1, static_cast<int>(k));
      const Vec3& at = placement.at;
      const std::int64_t off = mine.middle2 - theirs.middle2 - 2 * (std::int64_t{h.x} * at[0] + std::int64_t{h.y} * at[1]);
      for (const int sign : {1, -1}) others.push_back({2 * h.x, 2 * h.y, off + sign * (mine.span + theirs.span)});
    }
  }
  // Where an edge meets another, then where one meets the others.
  std::vector<Point> crossings(const Region& region) const {
    std::vector<Point> points;
    const auto offer = [&](const Line& p, const Line& q) {
      if (points.size() >= kMostCrossings) return;
      const auto point = crossing_of(p, q, region, z);
      if (point && std::find(points.begin(), points.end(), *point) == points.end()) points.push_back(*point);
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
      for (std::size_t j = i + 1; j < edges.size(); ++j) offer(edges[i], edges[j]);
    }
    for (const Line& other : others) {
      for (const Line& edge : edges) offer(edge, other);
    }
    return points;
  }
};

}  // namespace

// Before a slanted wall: where the edge of what is allowed meets what is wished, what stands there, and some lines across.
std::vector<Point> CandidateFinder::crossings(const Placements& placements, ItemId item, int state, const Region& region,
                                              const std::array<std::vector<Mm>, 3>& grid, Budget& budget) const {
  RegionLines lines{region.lo[2], {}, {}};
  lines.add_edges(region);
  if (lines.edges.empty()) return {};
  for (const Reduced* one : region.cases) lines.add_wishes(one->wishes);
  for (const SoftFormula& formula : soft_) {
    for (const Reduced& one : formula.all()) {
      if (one.miss == 0) lines.add_wishes(one.wishes);
    }
  }
  for (const ItemId other : placements.ids()) {
    if (placements[other].state < 0 || other == item || model_.items[other].is_opening() || model_.pair(item, other) == PairRule::kFree)
      continue;
    lines.add_beside(model_, item, state, other, placements[other]);
  }
  for (const int axis : {0, 1}) lines.add_across(axis, grid[axis]);
  budget.count(static_cast<std::int64_t>(lines.edges.size() * (lines.edges.size() + lines.others.size())));
  return lines.crossings(region);
}

// What a single position costs, as the tables of a grid have it.
std::int64_t CandidateFinder::cost_at(const Region& region, const Vec3& at) const {
  std::int64_t sum = region.price;
  for (const Reduced* one : region.cases) {
    for (const Wish& wish : one->wishes) sum += wish.cost(at);
  }
  for (const SoftFormula& formula : soft_) {
    std::int64_t least = std::numeric_limits<std::int64_t>::max() / 4;
    for (const Reduced& one : formula.all()) {
      std::int64_t miss = one.miss;
      for (const Partial& form : one.checks) miss = std::max(miss, missing(form.at(at), form.scale));
      std::int64_t cost = one.price + miss * formula.weight;
      for (const Wish& wish : one.wishes) cost += wish.cost(at);
      least = std::min(least, cost);
    }
    sum += least;
  }
  return sum;
}

}  // namespace layoutbox::placement
