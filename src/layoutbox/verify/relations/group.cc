// Relations of several objects: around, each side, between, rows and grids, symmetry, circles, pairs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "layoutbox/verify/relation_check.h"

namespace layoutbox::checks {
namespace {

constexpr double kSpacing = 0.01;  // m: two places on the 1 cm grid may differ by one step
constexpr std::array kFourSides{Side::kFront, Side::kBack, Side::kLeft, Side::kRight};

double far_out(const Body& t, const Shape& r, Side side) {
  const Vec2d out = direction_of(r.frame, side);
  return extent(t.shape, out).hi - extent(r, out).hi;
}

Side side_taken(const Body& t, const Shape& r) {
  return *std::max_element(kFourSides.begin(), kFourSides.end(), [&](Side a, Side b) { return far_out(t, r, a) < far_out(t, r, b); });
}

Finding spread_over_sides(const RelationCase& c, const RelationReference& r) {
  if (c.targets.size() < 2) return {};
  std::map<Side, std::size_t> taken;
  for (const Body* target : c.targets) ++taken[side_taken(*target, r.shape())];
  const std::size_t allowed = (c.targets.size() + 1) / 2;
  const auto fullest = std::max_element(taken.begin(), taken.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return condition(fullest->second <= allowed, fmt::format("{} of {} stand at the {} side of {}, at most {}", fullest->second,
                                                           c.targets.size(), name_of(fullest->first), r.id, allowed));
}

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

Finding between_two(const RelationCase& c, const Body& t, const RelationReference& first, const RelationReference& second) {
  std::vector<Finding> axes;
  for (const Axis axis : {Axis::kX, Axis::kY}) {
    const Axis other = axis == Axis::kX ? Axis::kY : Axis::kX;
    Interval a = room_extent(c, first, axis), b = room_extent(c, second, axis);
    if (b.mid() < a.mid()) std::swap(a, b);
    const Interval own = room_extent(t, axis), across = hull(room_extent(c, first, other), room_extent(c, second, other));
    const double middle = room_extent(t, other).mid();
    const std::string what = fmt::format("{} is between {} and {} along {} by", t.id(), first.id, second.id, name_of(axis));
    axes.push_back(all_of({at_least(what, std::min(own.lo - a.hi, b.lo - own.hi), 0, c.slack()),
                           at_most(fmt::format("{} is off the way between them by", t.id()),
                                   std::max(across.lo - middle, middle - across.hi), 0, c.slack())}));
  }
  return any_of(std::move(axes), {});
}

// Largest set of pairs (target, reference), each used once, among those allowed; augmenting paths.
class Matching {
 public:
  explicit Matching(std::vector<std::vector<bool>> allowed) : allowed_(std::move(allowed)) {}

  std::size_t size() {
    if (allowed_.empty()) return 0;
    target_of_.assign(allowed_.front().size(), kFree);
    std::size_t pairs = 0;
    for (std::size_t t = 0; t < allowed_.size(); ++t) {
      std::vector<bool> tried(target_of_.size(), false);
      pairs += place(t, tried);
    }
    return pairs;
  }

 private:
  static constexpr std::size_t kFree = static_cast<std::size_t>(-1);

  bool place(std::size_t target, std::vector<bool>& tried) {
    for (std::size_t r = 0; r < target_of_.size(); ++r) {
      if (!allowed_[target][r] || tried[r]) continue;
      tried[r] = true;
      if (target_of_[r] != kFree && !place(target_of_[r], tried)) continue;
      target_of_[r] = target;
      return true;
    }
    return false;
  }

  std::vector<std::vector<bool>> allowed_;
  std::vector<std::size_t> target_of_;
};

Finding spread_in_circle(const RelationCase& c, const RelationReference& r) {
  std::vector<double> angles;
  for (const Body* target : c.targets) {
    const Vec2d way = target->shape.center - r.shape().center;
    angles.push_back(std::atan2(way.y, way.x) * (180.0 / kPi));
  }
  if (angles.size() < 2) return {};
  std::sort(angles.begin(), angles.end());
  double widest = angles.front() + 360 - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) widest = std::max(widest, angles[i] - angles[i - 1]);
  const double limit = 1.5 * 360 / static_cast<double>(angles.size());
  return degrees_at_most(fmt::format("neighbours around {} are apart by", r.id), widest, limit + kAngleSlack);
}

}  // namespace

Finding check_Around(const RelationCase& c) {
  std::vector<Finding> findings{each_pair(c, [&](const Body& t, const RelationReference& r) {
    const std::vector<Side> sides(kFourSides.begin(), kFourSides.end());
    return all_of({gap_within(c, t, r, std::nullopt, max_of(c)), at_any_side(c, t, r, sides), looks_at(t, r, c.view)});
  })};
  for (const RelationReference& r : c.references) {
    if (!r.is_place()) findings.push_back(spread_over_sides(c, r));
  }
  return all_of(std::move(findings));
}

namespace {

Finding at_either_side(const RelationCase& c, Axis axis) {
  const Side low = axis == Axis::kY ? Side::kFront : Side::kLeft, high = axis == Axis::kY ? Side::kBack : Side::kRight;
  int balance = 0;
  Finding sides = each_pair(c, [&](const Body& t, const RelationReference& r) {
    const Finding at_low = beyond(c, t, r, low), at_high = beyond(c, t, r, high);
    balance += at_low.held ? -1 : at_high.held ? 1 : 0;
    return all_of({gap_within(c, t, r, std::nullopt, max_of(c)), any_of({at_low, at_high}, {})});
  });
  const int odd = static_cast<int>(c.targets.size() % 2);
  if (!sides.held) return sides;
  return all_of(
      {sides, condition(std::abs(balance) <= odd, fmt::format("one side has {} more than the other, at most {}", std::abs(balance), odd))});
}

// It has no front by which left and right would be known, or is sat at from all sides.
bool has_any_sides(const RelationReference& r) {
  if (r.body == nullptr) return false;
  const auto is_knee_room = [](const Hollow& hollow) { return !hollow.carries; };
  return !r.body->has_front || (!r.body->entry->back_to_wall && std::any_of(r.body->hollows.begin(), r.body->hollows.end(), is_knee_room));
}

}  // namespace

Finding check_EachSideOf(const RelationCase& c) {
  const std::optional<Axis>& axis = c.relation.parameters.axis;
  const bool either = !axis && std::all_of(c.references.begin(), c.references.end(), has_any_sides);
  if (either) return any_of({at_either_side(c, Axis::kX), at_either_side(c, Axis::kY)}, {});
  return at_either_side(c, axis.value_or(Axis::kX));
}

Finding check_Between(const RelationCase& c) {
  return each_target(c, [&](const Body& t) {
    std::vector<Finding> pairs;
    for (std::size_t i = 0; i < c.references.size(); ++i) {
      for (std::size_t j = i + 1; j < c.references.size(); ++j) pairs.push_back(between_two(c, t, c.references[i], c.references[j]));
    }
    return any_of(std::move(pairs), "between needs two references");
  });
}

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

Finding check_SymmetricAbout(const RelationCase& c) {
  const bool mirror_y = or_default(c.relation, &RelationParameters::axis) == Axis::kY;
  std::vector<Finding> findings;
  for (const RelationReference& r : c.references) {
    if (r.is_place()) return condition(false, r.id + " has no middle");
    const Shape& shape = r.shape();
    const Vec2d axis = mirror_y ? shape.frame.y : shape.frame.x;
    for (const Body* target : c.targets) {
      const Vec2d way = target->shape.center - shape.center;
      const Vec2d mirrored = shape.center + way - axis * (2 * dot(way, axis));
      double nearest = std::numeric_limits<double>::infinity();
      for (const Body* other : c.targets) nearest = std::min(nearest, length(other->shape.center - mirrored));
      findings.push_back(
          at_most(fmt::format("{} has its mirror image in {} missed by", target->id(), r.id), nearest, 0, kSpacing + c.slack()));
    }
  }
  return all_of(std::move(findings));
}

Finding check_Surround(const RelationCase& c) {
  std::vector<Finding> findings{each_pair(c, [&](const Body& t, const RelationReference& r) {
    return all_of({gap_within(c, t, r, std::nullopt, max_of(c)), looks_at(t, r, c.view)});
  })};
  for (const RelationReference& r : c.references) {
    if (!r.is_place()) findings.push_back(spread_in_circle(c, r));
  }
  return all_of(std::move(findings));
}

Finding check_PairedWith(const RelationCase& c) {
  std::vector<std::vector<bool>> allowed;
  std::vector<Finding> findings;
  for (const Body* target : c.targets) {
    std::vector<Finding> to_each;
    allowed.emplace_back();
    for (const RelationReference& r : c.references) {
      to_each.push_back(gap_within(c, *target, r, std::nullopt, max_of(c)));
      allowed.back().push_back(to_each.back().held);
    }
    findings.push_back(any_of(std::move(to_each), "there is nothing to be paired with"));
  }
  const std::size_t pairs = Matching(std::move(allowed)).size();
  findings.push_back(condition(pairs == c.references.size(), fmt::format("{} of {} have one of their own", pairs, c.references.size())));
  return all_of(std::move(findings));
}

}  // namespace layoutbox::checks
