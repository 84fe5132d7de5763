// Relations of two objects: beside, near, facing, turned like, centred on, tucked under.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "layoutbox/verify/relation_check.h"

namespace layoutbox::checks {
namespace {

constexpr double kTuckedAtLeast = 0.05;  // m

Finding beyond_within_reach(const RelationCase& c, Side side) {
  return each_pair(c, [&](const Body& t, const RelationReference& r) {
    return all_of({gap_within(c, t, r, std::nullopt, max_of(c)), beyond(c, t, r, side)});
  });
}

Finding distances(const RelationCase& c) {
  return each_pair(c, [&](const Body& t, const RelationReference& r) {
    return gap_within(c, t, r, c.metres(&RelationParameters::min), c.metres(&RelationParameters::max));
  });
}

// After how many degrees a body looks the same again: a kind without a front after half a turn, a square one after a quarter.
double period_of(const Body& body) {
  if (body.has_front) return 360;
  return std::abs(body.width - body.depth) < 0.0005 ? 90 : 180;
}

// How far the turn of t against the reference is from one of the turns allowed (multiples of `step` degrees, from `first`).
Finding turned(const RelationCase& c, double first, double step, const std::string& what) {
  return each_pair(c, [&](const Body& t, const RelationReference& r) {
    if (r.is_place()) return condition(false, r.id + " has no direction");
    const Vec2d x = r.body != nullptr ? r.body->own_frame.x : r.shape().frame.x;
    const double turn = std::atan2(cross(x, t.own_frame.x), dot(x, t.own_frame.x)) * (180.0 / kPi);
    const double period = std::min({step, period_of(t), r.body != nullptr ? period_of(*r.body) : 180});
    const double off = std::abs(std::remainder(turn - first, period));
    return degrees_at_most(fmt::format("{} is off {} {} by", t.id(), what, r.id), off, kAngleSlack);
  });
}

Finding centred_along(const RelationCase& c, const Body& t, const RelationReference& r, Vec2d axis) {
  return at_most(fmt::format("centres of {} apart by", name_of_pair(t, r)),
                 std::abs(extent(t.shape, axis).mid() - extent(r.shape(), axis).mid()), 0, c.slack());
}

bool used_all_round(const Body& body) {
  constexpr std::array kAllSides{Side::kFront, Side::kBack, Side::kLeft, Side::kRight};
  const std::vector<Side>& sides = body.entry->used_sides;
  const auto used = [&](Side side) { return std::find(sides.begin(), sides.end(), side) != sides.end(); };
  return !body.has_front || std::all_of(kAllSides.begin(), kAllSides.end(), used);
}

Finding alongside(const RelationCase& c, const Body& t, const RelationReference& r, Side side, double max) {
  if (r.body == nullptr) return condition(false, r.id + " has no long or short side");
  return all_of({gap_within(c, t, r, std::nullopt, max), at_any_side(c, t, r, sides_named(*r.body, side))});
}

// Beside the reference, near its back.
Finding beside_head(const RelationCase& c, const Body& t, const RelationReference& r) {
  const Shape& shape = r.shape();
  const Interval depth = extent(shape, shape.frame.y);
  const Finding beside = any_of({at_least(fmt::format("{} is beyond the left side of {} by", t.id(), r.id),
                                          extent(t.shape, shape.frame.x * -1).lo - extent(shape, shape.frame.x * -1).hi, 0, c.slack()),
                                 at_least(fmt::format("{} is beyond the right side of {} by", t.id(), r.id),
                                          extent(t.shape, shape.frame.x).lo - extent(shape, shape.frame.x).hi, 0, c.slack())},
                                {});
  const double behind_third = dot(t.shape.center, shape.frame.y) - (depth.hi - depth.length() / 3);
  return all_of({beside, at_least(fmt::format("{} is within the rear third of {} by", t.id(), r.id), behind_third, 0, c.slack())});
}

Finding tucked(const RelationCase& c, const Body& t, const RelationReference& r, Side which) {
  const Shape& shape = r.shape();
  const Vec2d out = direction_of(shape.frame, which);
  const Vec2d along = which == Side::kFront || which == Side::kBack ? shape.frame.x : shape.frame.y;
  const Interval across_t = extent(t.shape, along), across_r = extent(shape, along);
  return all_of({at_least(fmt::format("{} reaches under {} by", t.id(), r.id), extent(shape, out).hi - extent(t.shape, out).lo,
                          kTuckedAtLeast, c.slack()),
                 at_side(c, t, r, which),
                 at_most(fmt::format("{} reaches past the side of {} by", t.id(), r.id),
                         std::max(across_r.lo - across_t.lo, across_t.hi - across_r.hi), 0, c.slack())});
}

}  // namespace

Finding check_LeftOf(const RelationCase& c) { return beyond_within_reach(c, Side::kLeft); }
Finding check_RightOf(const RelationCase& c) { return beyond_within_reach(c, Side::kRight); }
Finding check_Behind(const RelationCase& c) { return beyond_within_reach(c, Side::kBack); }
Finding check_AtFootOf(const RelationCase& c) { return beyond_within_reach(c, Side::kFront); }

Finding check_InFrontOf(const RelationCase& c) {
  return each_pair(c, [&](const Body& t, const RelationReference& r) {
    if (r.face == nullptr) return all_of({gap_within(c, t, r, std::nullopt, max_of(c)), beyond(c, t, r, Side::kFront)});
    return all_of({at_most(fmt::format("distance between {} in plan", name_of_pair(t, r)), distance(t.shape.plan, r.shape().plan),
                           max_of(c), c.slack()),
                   beyond(c, t, r, Side::kFront)});
  });
}

Finding check_NextTo(const RelationCase& c) { return distances(c); }
Finding check_Near(const RelationCase& c) { return distances(c); }
Finding check_Far(const RelationCase& c) { return distances(c); }
Finding check_Distance(const RelationCase& c) { return distances(c); }

Finding check_Touching(const RelationCase& c) {
  return each_pair(c, [&](const Body& t, const RelationReference& r) { return gap_within(c, t, r, std::nullopt, 0.0); });
}

Finding check_EdgeAlign(const RelationCase& c) {
  const Edge edge = or_default(c.relation, &RelationParameters::edge);
  return each_pair(c, [&](const Body& t, const RelationReference& r) {
    if (r.is_place()) return condition(false, r.id + " has no edges");
    const Frame& frame = r.shape().frame;
    if (edge == Edge::kCenter) return centred_along(c, t, r, frame.x);
    const std::optional<Side> side = side_from_name(name_of(edge));
    if (!side || *side == Side::kTop || *side == Side::kBottom)
      return condition(false, fmt::format("{} has no {} edge", r.id, name_of(edge)));
    const Vec2d out = direction_of(frame, *side);
    return at_most(fmt::format("the {} edges of {} are apart by", name_of(edge), name_of_pair(t, r)),
                   std::abs(extent(t.shape, out).hi - extent(r.shape(), out).hi), 0, c.slack());
  });
}

Finding check_Facing(const RelationCase& c) {
  return each_pair(c, [&](const Body& t, const RelationReference& r) { return looks_at(t, r, c.view, eyes_of(t, c.view)); });
}

namespace {

// Would t look at r if it stood in the middle of the group?
Finding looks_with_group(const RelationCase& c, const Body& t, const RelationReference& r) {
  if (!t.has_front) return condition(true, t.id() + " has no front");
  Vec2d middle;
  for (const Body* member : c.targets) middle = middle + member->shape.center * (1.0 / static_cast<double>(c.targets.size()));
  const Vec2d front = front_of(t);
  const Interval ahead = extent(r.shape(), front), across = extent(r.shape(), t.own_frame.x);
  const double off = std::abs(across.mid() - dot(middle, t.own_frame.x));
  const std::string what = fmt::format("{} is turned from {}, seen from the middle of its group, by", t.id(), r.id);
  if (ahead.hi < dot(t.shape.center, front) + t.depth / 2 - kTiny) return degrees_at_most(what, 180, kLookAngle);
  const bool ray_meets_it = off <= across.half() + kTiny;
  return degrees_at_most(what, ray_meets_it ? 0.0 : std::atan2(off, std::max(0.0, ahead.lo - dot(middle, front))) * (180.0 / kPi),
                         kLookAngle);
}

constexpr std::size_t kMostAbreast = 3;

// Several things opposite one stand there as a group: its middle is looked at, nobody stands behind another.
Finding opposite_group(const RelationCase& c, const RelationReference& r) {
  std::vector<Finding> findings;
  for (const Body* t : c.targets) {
    findings.push_back(gap_within(c, *t, r, c.metres(&RelationParameters::min), c.metres(&RelationParameters::max)));
    findings.push_back(any_of({looks_at(*t, r, c.view), looks_with_group(c, *t, r)}, {}));
  }
  const Frame& frame = r.body->has_front ? r.shape().frame : c.targets.front()->own_frame;
  if (r.body->has_front) {
    Interval across = extent(c.targets.front()->shape, frame.x);
    for (const Body* t : c.targets) {
      across = hull(across, extent(t->shape, frame.x));
      const Vec2d front = front_of(*r.body);
      findings.push_back(condition(extent(t->shape, front).hi > extent(r.shape(), front).hi - c.slack() - kTiny,
                                   fmt::format("{} is behind the front of {}", t->id(), r.id)));
    }
    const double middle = dot(r.shape().center, frame.x);
    findings.push_back(
        at_least("the middle of " + r.id + " lies within the group by", std::min(middle - across.lo, across.hi - middle), 0, c.slack()));
  }
  for (std::size_t i = 0; c.targets.size() <= kMostAbreast && i < c.targets.size(); ++i) {
    for (std::size_t j = i + 1; j < c.targets.size(); ++j) {
      const double shared = overlap(extent(c.targets[i]->shape, frame.x), extent(c.targets[j]->shape, frame.x));
      findings.push_back(at_most(fmt::format("{} stands behind {} by", c.targets[i]->id(), c.targets[j]->id()), shared, 0, c.slack()));
    }
  }
  return all_of(std::move(findings));
}

}  // namespace

Finding check_Opposite(const RelationCase& c) {
  if (c.targets.size() > 1 &&
      std::any_of(c.references.begin(), c.references.end(), [](const RelationReference& r) { return r.body != nullptr; })) {
    std::vector<Finding> findings;
    for (const RelationReference& r : c.references) {
      if (r.body != nullptr) findings.push_back(opposite_group(c, r));
    }
    return all_of(std::move(findings));
  }
  return each_pair(c, [&](const Body& t, const RelationReference& r) {
    if (r.is_place()) return condition(false, "nothing is opposite " + r.id);
    if (r.face != nullptr) return all_of({looks_at(t, r, c.view), in_line(c, t, r.shape(), r.shape().frame.x)});
    return all_of({gap_within(c, t, r, c.metres(&RelationParameters::min), c.metres(&RelationParameters::max)), looks_at(t, r, c.view),
                   looks_at(*r.body, {t.id(), &t, nullptr}, c.view)});
  });
}

Finding check_Parallel(const RelationCase& c) { return turned(c, 0, 180, "being parallel to"); }
Finding check_Perpendicular(const RelationCase& c) { return turned(c, 90, 180, "being perpendicular to"); }
Finding check_SameOrientation(const RelationCase& c) { return turned(c, 0, 360, "the direction of"); }

Finding check_CenteredOn(const RelationCase& c) {
  return each_pair(c, [&](const Body& t, const RelationReference& r) {
    if (r.is_place()) return condition(false, r.id + " has no middle");
    const Frame& frame = r.shape().frame;
    const Finding x = centred_along(c, t, r, frame.x), y = centred_along(c, t, r, frame.y);
    const bool on_it = r.body != nullptr && t.object->supported_by == r.id;
    if (on_it || t.object->mount == Mount::kCeiling || t.rug || (r.body != nullptr && r.body->rug)) return all_of({x, y});
    if (r.face != nullptr || r.body->object->mount == Mount::kWall || t.object->mount == Mount::kWall) return x;
    return any_of({x, y}, {});
  });
}

Finding check_AtHeadOf(const RelationCase& c) {
  const double max = max_of(c);
  return each_pair(c, [&](const Body& t, const RelationReference& r) {
    if (r.body == nullptr) return condition(false, r.id + " has no head");
    if (used_all_round(*r.body)) return alongside(c, t, r, Side::kShort, max);
    return all_of({gap_within(c, t, r, std::nullopt, max), any_of({beside_head(c, t, r), beyond(c, t, r, Side::kBack)}, {})});
  });
}

Finding check_AlongSide(const RelationCase& c) {
  const Side side = or_default(c.relation, &RelationParameters::side);
  return each_pair(c, [&](const Body& t, const RelationReference& r) { return alongside(c, t, r, side, max_of(c)); });
}

Finding check_TuckedUnder(const RelationCase& c) {
  return each_pair(c, [&](const Body& t, const RelationReference& r) {
    if (r.is_place()) return condition(false, "nothing can be tucked under " + r.id);
    std::vector<Finding> sides;
    for (const Side side : {Side::kFront, Side::kBack, Side::kLeft, Side::kRight}) sides.push_back(tucked(c, t, r, side));
    return all_of({any_of(std::move(sides), {}), looks_at(t, r, c.view)});
  });
}

}  // namespace layoutbox::checks
