// Relations of several objects in lines: rows, columns, grids, even spaces.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "layoutbox/verify/relation_check.h"

namespace layoutbox::checks {
namespace {

// Neighbours sorted along an axis.
std::vector<Interval> sorted_extents(const RelationCase& c, Axis axis) {
  std::vector<Interval> extents;
  for (const Body* target : c.targets) extents.push_back(room_extent(*target, axis));
  std::sort(extents.begin(), extents.end(), [](Interval a, Interval b) { return a.mid() < b.mid(); });
  return extents;
}

Finding equal_coordinates(const RelationCase& c, Axis axis) {
  std::array<Interval, 3> spread;  // of lo, mid and hi
  for (std::size_t i = 0; i < c.targets.size(); ++i) {
    const Interval e = room_extent(*c.targets[i], axis);
    const std::array<double, 3> at{e.lo, e.mid(), e.hi};
    for (std::size_t k = 0; k < 3; ++k) spread[k] = i == 0 ? Interval{at[k], at[k]} : hull(spread[k], {at[k], at[k]});
  }
  const double least = std::min({spread[0].length(), spread[1].length(), spread[2].length()});
  return at_most(fmt::format("out of line along {} by", name_of(axis)), least, 0, c.slack());
}

Finding in_row(const RelationCase& c, Axis along) {
  const std::optional<double> wanted = c.metres(&RelationParameters::gap);
  std::vector<Finding> findings{equal_coordinates(c, along == Axis::kX ? Axis::kY : Axis::kX)};
  const std::vector<Interval> row = sorted_extents(c, along);
  for (std::size_t i = 1; i < row.size(); ++i) {
    const double free = row[i].lo - row[i - 1].hi;
    findings.push_back(at_least(fmt::format("gap between neighbours along {}", name_of(along)), free, 0, c.slack()));
    if (wanted) findings.push_back(equal_to(fmt::format("gap between neighbours along {}", name_of(along)), free, *wanted, c.slack()));
  }
  return all_of(std::move(findings));
}

// Different coordinates of the centres along an axis, those within `kSpacing` taken as one.
std::vector<double> lines_along(const RelationCase& c, Axis axis) {
  std::vector<double> places;
  for (const Body* target : c.targets) places.push_back(room_extent(*target, axis).mid());
  std::sort(places.begin(), places.end());
  std::vector<double> lines;
  for (const double place : places) {
    if (lines.empty() || place > lines.back() + kSpacing) lines.push_back(place);
  }
  return lines;
}

Finding equally_spaced(const std::vector<double>& places, const std::string& what) {
  if (places.size() < 3) return {};
  Interval step{places[1] - places[0], places[1] - places[0]};
  for (std::size_t i = 2; i < places.size(); ++i) step = hull(step, {places[i] - places[i - 1], places[i] - places[i - 1]});
  return at_most(what, step.length(), kSpacing, 0);
}

Finding even_gaps(const RelationCase& c, Axis axis) {
  const std::vector<Interval> row = sorted_extents(c, axis);
  std::vector<double> gaps;
  for (std::size_t i = 1; i < row.size(); ++i) gaps.push_back(row[i].lo - row[i - 1].hi);
  if (gaps.empty()) return {};
  const auto [least, greatest] = std::minmax_element(gaps.begin(), gaps.end());
  return at_most(fmt::format("gaps along {} differ by", name_of(axis)), *greatest - *least, kSpacing, 0);
}

// The axis along which the targets are spread farther; both where neither is by a millimetre, the step of all places.
std::vector<Axis> wider_spread(const RelationCase& c) {
  const std::vector<Interval> x = sorted_extents(c, Axis::kX), y = sorted_extents(c, Axis::kY);
  const double more = (x.back().mid() - x.front().mid()) - (y.back().mid() - y.front().mid());
  if (std::abs(more) < 0.001) return {Axis::kX, Axis::kY};
  return {more > 0 ? Axis::kX : Axis::kY};
}

}  // namespace

Finding check_Row(const RelationCase& c) {
  if (c.relation.parameters.axis) return in_row(c, *c.relation.parameters.axis);
  return any_of({in_row(c, Axis::kX), in_row(c, Axis::kY)}, {});
}

Finding check_Column(const RelationCase& c) { return in_row(c, Axis::kY); }

Finding check_Grid(const RelationCase& c) {
  const std::size_t count = c.targets.size();
  const int given = c.relation.parameters.columns.value_or(0);
  const std::size_t columns =
      given > 0 ? static_cast<std::size_t>(given) : static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const std::size_t rows = (count + columns - 1) / columns;
  const std::vector<double> x = lines_along(c, Axis::kX), y = lines_along(c, Axis::kY);
  const std::size_t wanted_x = std::min(columns, count);
  std::vector<Finding> findings{condition(x.size() == wanted_x && y.size() == rows,
                                          fmt::format("{} columns and {} rows, to be {} and {}", x.size(), y.size(), wanted_x, rows)),
                                equally_spaced(x, "distances of the columns differ by"),
                                equally_spaced(y, "distances of the rows differ by")};
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const Vec2d apart = c.targets[i]->shape.center - c.targets[j]->shape.center;
      findings.push_back(condition(std::abs(apart.x) > kSpacing || std::abs(apart.y) > kSpacing,
                                   fmt::format("{} and {} have one place", c.targets[i]->id(), c.targets[j]->id())));
    }
  }
  const std::optional<double> gap = c.metres(&RelationParameters::gap);
  for (const auto& [axis, lines] : {std::pair{Axis::kX, x}, std::pair{Axis::kY, y}}) {
    if (!gap || lines.size() < 2) continue;
    double length = 0;
    for (const Body* target : c.targets) length = std::max(length, room_extent(*target, axis).length());
    findings.push_back(
        equal_to(fmt::format("gap between neighbours along {}", name_of(axis)), lines[1] - lines[0] - length, *gap, kSpacing));
  }
  return all_of(std::move(findings));
}

Finding check_EvenlySpaced(const RelationCase& c) {
  if (c.relation.parameters.axis) return even_gaps(c, *c.relation.parameters.axis);
  std::vector<Finding> along;
  for (const Axis axis : wider_spread(c)) along.push_back(even_gaps(c, axis));
  return any_of(std::move(along), {});
}

}  // namespace layoutbox::checks
