// Relations of several objects: around, each side, between, symmetry, circles, pairs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "layoutbox/verify/relation_check.h"

namespace layoutbox::checks {
namespace {

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
