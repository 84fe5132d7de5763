// Relations over one another: on, under, above, in, stacked.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/verify/checks.h"
#include "layoutbox/verify/relation_check.h"

namespace layoutbox::checks {
namespace {

constexpr double kUnderRise = 0.05;  // m: what lies under a thing may begin that much higher than it (a box under a bed on low feet)
constexpr double kWellWithin = 0.6;  // of the shorter of a thing and the window that it is under
constexpr double kAboveReach = 0.1;  // m: a picture over a sofa that stands a little off the wall is above it

// The space that a body stands in, or null.
const Hollow* hollow_under(const RelationCase& c, const Body& t, const Body& host) {
  for (const Hollow& hollow : host.hollows) {
    const bool level = std::abs(t.underside() - hollow.heights.lo) <= c.view.options.support_tolerance_m + kTiny;
    if (level && contains(hollow.plan, t.shape.center)) return &hollow;
  }
  return nullptr;
}

Finding named_space(const RelationCase& c, const Body& t, const Body& host, const std::string& name) {
  const Hollow* hollow = hollow_under(c, t, host);
  return condition(hollow != nullptr && hollow->name == name,
                   fmt::format("{} stands {} {} of {}", t.id(), hollow && hollow->name == name ? "in" : "not in", name, host.id()));
}

// One word of `part`: a half or a third of the host, or its top.
Finding in_part(const RelationCase& c, const Body& t, const Body& host, PartWord word) {
  const Frame& frame = host.shape.frame;
  const Interval x = extent(host.shape, frame.x), y = extent(host.shape, frame.y);
  const double off_x = dot(t.shape.center, frame.x) - x.mid(), off_y = dot(t.shape.center, frame.y) - y.mid();
  const auto half = [&](double value) {
    return at_least(fmt::format("{} is in the {} half of {} by", t.id(), name_of(word), host.id()), value, 0, c.slack());
  };
  const auto outer = [&](double off, const Interval& side) {
    return at_least(fmt::format("{} is off the middle of {} by", t.id(), host.id()), std::abs(off), side.length() / 6, c.slack());
  };
  const auto inner = [&](double off, const Interval& side) {
    return at_most(fmt::format("{} is off the middle of {} by", t.id(), host.id()), std::abs(off), side.length() / 6, c.slack());
  };
  switch (word) {
    case PartWord::kLeft: return half(-off_x);
    case PartWord::kRight: return half(off_x);
    case PartWord::kFront: return half(-off_y);
    case PartWord::kBack: return half(off_y);
    case PartWord::kCenter: return all_of({inner(off_x, x), inner(off_y, y)});
    case PartWord::kCorner: return all_of({outer(off_x, x), outer(off_y, y)});
    case PartWord::kEdge: return any_of({outer(off_x, x), outer(off_y, y)}, {});
    case PartWord::kEnd: return outer(off_x, x);
    case PartWord::kTop: break;
  }
  return at_least(fmt::format("the underside of {} is at", t.id()), t.underside(), host.top(), c.slack());
}

Finding in_parts(const RelationCase& c, const Body& t, const Body& host) {
  const ThingPart& part = c.relation.parameters.part;
  const auto is_meant = [&](const Hollow& hollow) { return hollow.name == part.text(); };
  const bool is_space = std::any_of(host.hollows.begin(), host.hollows.end(), is_meant);
  if (is_space || (!part.empty() && !part.is_words())) return named_space(c, t, host, part.text());
  std::vector<Finding> findings;
  for (const PartWord word : part.words()) findings.push_back(in_part(c, t, host, word));
  return all_of(std::move(findings));
}

// Itself, or by way of what it stands on: a cup on a coaster on the table.
bool is_held_by(const RelationCase& c, const Body& t, const std::string& holder) {
  const Body* body = &t;
  for (std::size_t storeys = 0; body != nullptr && storeys <= c.view.bodies.size(); ++storeys) {
    if (body->object->supported_by == holder) return true;
    body = c.view.find_body(body->object->supported_by);
  }
  return false;
}

Finding held_by(const RelationCase& c, const Body& t, const std::string& holder) {
  if (holder == "floor" ? t.object->supported_by != holder : !is_held_by(c, t, holder))
    return condition(false, fmt::format("{} is held by {}, not by {}", t.id(), t.object->supported_by, holder));
  const SupportFault fault = support_fault(c.view, t);
  return condition(fault.message.empty(), fault.message.empty() ? fmt::format("{} stands on {}", t.id(), holder) : fault.message);
}

Finding stands_on(const RelationCase& c, const Body& t, const RelationReference& r) {
  if (r.body == nullptr) return held_by(c, t, r.is_place() && r.id == "room" ? "floor" : r.id);
  if (r.body->rug) return all_of({held_by(c, t, "floor"), covers(c, t, r.shape(), 0, r.id), in_parts(c, t, *r.body)});
  return all_of({held_by(c, t, r.id), in_parts(c, t, *r.body)});
}

Finding within_plan(const RelationCase& c, const Body& t, const Body& host) {
  std::vector<Finding> findings;
  for (const Vec2d axis : {host.shape.frame.x, host.shape.frame.y}) {
    const Interval a = extent(t.shape, axis), b = extent(host.shape, axis);
    findings.push_back(
        at_most(fmt::format("{} reaches out of {} by", t.id(), host.id()), std::max(b.lo - a.lo, a.hi - b.hi), 0, c.slack()));
  }
  return all_of(std::move(findings));
}

Finding above_opening(const RelationCase& c, const Body& t, const Face& opening) {
  return all_of({at_least(fmt::format("the underside of {} is at", t.id()), t.underside(), opening.shape.heights.hi, c.slack()),
                 at_most(fmt::format("distance between {} and {} in plan", t.id(), opening.id), distance(t.shape.plan, opening.shape.plan),
                         kAboveReach, c.slack()),
                 shares_along(c, t, opening, kWellWithin)});
}

}  // namespace

Finding below_window(const RelationCase& c, const Body& t, const Face& window, double max) {
  return all_of({at_most(fmt::format("distance between {} and {} in plan", t.id(), window.id), distance(t.shape.plan, window.shape.plan),
                         max, c.slack()),
                 shares_along(c, t, window, kWellWithin),
                 at_most(fmt::format("the middle of {} is at height", t.id()), t.shape.heights.mid(), window.shape.heights.lo, c.slack())});
}

Finding check_On(const RelationCase& c) {
  return each_pair(c, [&](const Body& t, const RelationReference& r) { return stands_on(c, t, r); });
}

Finding check_Under(const RelationCase& c) {
  return each_pair(c, [&](const Body& t, const RelationReference& r) {
    if (r.is_place()) return condition(false, "nothing is under " + r.id);
    if (r.face != nullptr) return below_window(c, t, *r.face, 0.5);
    return all_of({at_most(fmt::format("the underside of {} is above that of {} by", t.id(), r.id), t.underside() - r.body->underside(),
                           kUnderRise, c.slack()),
                   at_most(fmt::format("the middle of {} is at height", t.id()), t.shape.heights.mid(), r.shape().heights.mid(), c.slack()),
                   covers(c, t, r.shape(), 0, r.id)});
  });
}

Finding check_Above(const RelationCase& c) {
  const std::optional<double> wanted = c.metres(&RelationParameters::gap);
  return each_pair(c, [&](const Body& t, const RelationReference& r) {
    if (r.is_place()) return condition(false, "nothing in the room is above " + r.id);
    if (r.face != nullptr) return above_opening(c, t, *r.face);
    const double free = t.underside() - r.body->top();
    std::vector<Finding> findings{at_least(fmt::format("free height between {}", name_of_pair(t, r)), free, 0, c.slack()),
                                  covers(c, t, r.shape(), kAboveReach, r.id)};
    if (wanted) findings.push_back(equal_to(fmt::format("free height between {}", name_of_pair(t, r)), free, *wanted, c.slack()));
    return all_of(std::move(findings));
  });
}

Finding check_In(const RelationCase& c) {
  const ThingPart& part = c.relation.parameters.part;
  return each_pair(c, [&](const Body& t, const RelationReference& r) {
    if (r.body == nullptr) return check_Inside(c);
    const double below_top = r.body->top() - t.underside();
    std::vector<Finding> findings{
        held_by(c, t, r.id), condition(hollow_under(c, t, *r.body) != nullptr, fmt::format("{} is not in a space of {}", t.id(), r.id)),
        within_plan(c, t, *r.body),
        at_least(fmt::format("{} is below the top of {} over", t.id(), r.id), below_top, t.shape.heights.length() / 2, c.slack())};
    if (!part.empty()) findings.push_back(in_parts(c, t, *r.body));
    return all_of(std::move(findings));
  });
}

Finding check_Stacked(const RelationCase& c) {
  std::vector<Finding> findings;
  for (const RelationReference& r : c.references) findings.push_back(stands_on(c, *c.targets.front(), r));
  for (std::size_t i = 1; i < c.targets.size(); ++i) {
    const Body &above = *c.targets[i], &below = *c.targets[i - 1];
    findings.push_back(held_by(c, above, below.id()));
    findings.push_back(equal_to(fmt::format("the underside of {} is at", above.id()), above.underside(), below.top(), c.slack()));
  }
  return all_of(std::move(findings));
}

}  // namespace layoutbox::checks
