// Relations of an object and the free room about it: clearance, reachable, keepClear.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/verify/checks.h"
#include "layoutbox/verify/relation_check.h"
#include "layoutbox/verify/walks.h"

namespace layoutbox::checks {
namespace {

constexpr double kClearDepth = 0.6;    // m, where neither the relation nor the catalogue says it
constexpr double kStandingRoom = 2.0;  // m of height

double depth_wanted(const RelationCase& c, const Body& t, Side side) {
  if (const std::optional<double> given = c.metres(&RelationParameters::depth)) return *given;
  const auto found = t.entry->clearance.find(side);
  return found == t.entry->clearance.end() ? kClearDepth : found->second / 1000.0;
}

bool carried_by(const RoomView& view, const Body& other, const Body& body) {
  const Body* step = &other;
  for (std::size_t i = 0; i < view.bodies.size() && step != nullptr; ++i) {
    if (step->object->supported_by == body.id()) return true;
    step = view.find_body(step->object->supported_by);
  }
  return false;
}

Finding strip_free(const RelationCase& c, const Body& t, Side which) {
  const Vec2d outward = direction_of(t.shape.frame, which), along{-outward.y, outward.x};
  const double depth = depth_wanted(c, t, which);
  const Vec2d centre = t.shape.center + outward * (extent(t.shape, outward).half() + depth / 2);
  const Shape strip = make_box(centre, depth, extent(t.shape, along).length(), {0, kStandingRoom}, {outward, along});
  const double area = signed_area(strip.plan);
  const double off = area > 0 ? 1 - signed_area(clip(c.view.floor, strip.plan)) / area : 0;
  std::vector<Finding> findings{condition(off <= 0.01, fmt::format("{:.0f} % of the {} m at the {} of {} are outside the room", off * 100,
                                                                   figure(depth), name_of(which), t.id()))};
  for (const Body& other : c.view.bodies) {
    if (&other == &t || other.rug || carried_by(c.view, other, t) || c.view.belongs_to(other, t)) continue;
    findings.push_back(at_most(fmt::format("{} stands in the {} m at the {} of {} by", other.id(), figure(depth), name_of(which), t.id()),
                               std::max(0.0, penetration(other.shape, strip)), 0, c.slack()));
  }
  Finding finding = all_of(std::move(findings));
  if (finding.held) finding.message = fmt::format("{} m at the {} of {} are free", figure(depth), name_of(which), t.id());
  return finding;
}

Interval part(Interval whole, int from, int to) { return {whole.lo + whole.length() * from / 3, whole.lo + whole.length() * to / 3}; }

// Thirds of the floor's extent that must stay free.
Finding out_of_region(const RelationCase& c, const Body& t, RoomRegion region) {
  const auto has = [&](Side side) { return lies_at(region, side); };
  Interval x = c.view.floor_x, y = c.view.floor_y;
  if (has(Side::kLeft)) x = part(c.view.floor_x, 0, 1);
  if (has(Side::kRight)) x = part(c.view.floor_x, 2, 3);
  if (has(Side::kFront)) y = part(c.view.floor_y, 0, 1);
  if (has(Side::kBack)) y = part(c.view.floor_y, 2, 3);
  if (region == RoomRegion::kMiddle) x = part(c.view.floor_x, 1, 2), y = part(c.view.floor_y, 1, 2);
  const Shape place = make_box({x.mid(), y.mid()}, x.length(), y.length(), t.shape.heights, {});
  return at_most(fmt::format("{} reaches into the {} of the room by", t.id(), name_of(region)), std::max(0.0, penetration(t.shape, place)),
                 0, c.slack());
}

}  // namespace

Finding check_Clearance(const RelationCase& c) {
  const Side side = or_default(c.relation, &RelationParameters::side);
  return each_target(c, [&](const Body& t) {
    std::vector<Finding> findings;
    for (const Side one : sides_named(t, side)) findings.push_back(strip_free(c, t, one));
    return all_of(std::move(findings));
  });
}

Finding check_Reachable(const RelationCase& c) {
  const double width = c.metres(&RelationParameters::width).value_or(0);
  return each_target(c, [&](const Body& t) {
    const bool way = reachable(c.view, t, width);
    return condition(way, fmt::format("there is {} way {} m wide from the door to {}", way ? "a" : "no", figure(width), t.id()));
  });
}

Finding check_KeepClear(const RelationCase& c) {
  const RelationParameters& given = c.relation.parameters;
  const std::optional<double> depth = c.metres(&RelationParameters::depth);
  if (c.references.empty()) {
    if (!given.region) return condition(false, "keepClear names neither a thing nor a region to keep clear of");
    return each_target(c, [&](const Body& t) { return out_of_region(c, t, *given.region); });
  }
  return each_pair(c, [&](const Body& t, const RelationReference& r) {
    if (r.face != nullptr && r.face->opening != nullptr) return keeps_out_of_opening(c, t, *r.face, depth);
    return gap_within(c, t, r, depth.value_or(kClearDepth), std::nullopt);
  });
}

}  // namespace layoutbox::checks
