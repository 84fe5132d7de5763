// Collisions, bounds and support: what makes a layout a possible room at all.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "layoutbox/verify/checks.h"

namespace layoutbox::checks {
namespace {

constexpr double kHungAbove = 0.05;  // m: what hangs does not stand on the floor

// True when all that two boxes share is free in one of them, height by height.
bool in_hollows(const Body& a, const Body& b, double tolerance) {
  if (a.hollows.empty() && b.hollows.empty()) return false;
  const Polygon shared = clip(a.shape.plan, b.shape.plan);
  const Interval heights{std::max(a.underside(), b.underside()), std::min(a.top(), b.top())};
  std::vector<Hollow> free;
  std::set<double> cuts{heights.lo, heights.hi};
  for (const Body* host : {&a, &b}) {
    for (const Hollow& hollow : host->hollows) {
      const Vec2d w = hollow.plan[1] - hollow.plan[0], d = hollow.plan[3] - hollow.plan[0];
      const double grow = 2 * (tolerance + kTiny);
      const Shape grown =
          make_box((hollow.plan[0] + hollow.plan[2]) * 0.5, length(w) + grow, length(d) + grow, hollow.heights, host->own_frame);
      free.push_back({hollow.name, grown.plan, hollow.heights, hollow.carries});
      for (const double z : {hollow.heights.lo, hollow.heights.hi}) {
        if (z > heights.lo && z < heights.hi) cuts.insert(z);
      }
    }
  }
  for (auto cut = cuts.begin(); std::next(cut) != cuts.end(); ++cut) {
    const double low = *cut, high = *std::next(cut);
    if (high - low <= tolerance + kTiny) continue;
    std::vector<Polygon> covers;
    for (const Hollow& hollow : free) {
      if (hollow.heights.lo <= low + kTiny && hollow.heights.hi >= high - kTiny) covers.push_back(hollow.plan);
    }
    if (uncovered_area(shared, covers) > 1e-9) return false;
  }
  return true;
}

double distance_to_wall(const Body& body, const Face& wall) { return gap(body.shape, wall.shape); }

SupportFault held_by_wall(const RoomView& view, const Body& body, const std::string& name) {
  double least = std::numeric_limits<double>::infinity();
  const Face* named = view.find_wall(name);
  for (const Face& wall : view.walls) {
    if (named == nullptr || named == &wall) least = std::min(least, distance_to_wall(body, wall));
  }
  if (least <= view.options.mount_tolerance_m + kTiny) return {};
  return {fmt::format("{} is {} m from {}, on which it hangs", body.id(), figure_beside(least, 0), named ? named->id : "every wall"),
          least};
}

SupportFault held_by_sill(const RoomView& view, const Body& body, const Face& window) {
  const double depth = window.opening->sill_depth / 1000.0;
  const double above = body.underside() - window.shape.heights.lo;
  const double off = distance(window.shape.plan, body.shape.center);
  if (std::abs(above) > view.options.support_tolerance_m + kTiny) {
    return {fmt::format("the underside of {} is {} m from the sill of {}", body.id(), figure_beside(above, 0), window.id), std::abs(above)};
  }
  if (off <= depth + kTiny) return {};
  return {fmt::format("the centre of {} is {} m from {}, whose sill is {} m deep", body.id(), figure_beside(off, depth), window.id,
                      figure(depth)),
          off};
}

SupportFault held_by_body(const RoomView& view, const Body& body, const Body& below) {
  const VerifyOptions& options = view.options;
  if (body.object->mount == Mount::kHung) {
    const double off = gap(body.shape, below.shape);
    if (off <= options.mount_tolerance_m + kTiny && body.underside() > kHungAbove) return {};
    return {fmt::format("{} is {} m from {}, on which it hangs", body.id(), figure_beside(off, 0), below.id()), off};
  }
  for (const Hollow& hollow : below.hollows) {
    const bool stands = hollow.carries && std::abs(body.underside() - hollow.heights.lo) <= options.support_tolerance_m + kTiny;
    if (stands && contains(hollow.plan, body.shape.center)) return {};
  }
  if (!contains(below.shape.plan, body.shape.center)) {
    return {fmt::format("the centre of {} is not over {}, on which it stands", body.id(), below.id()),
            distance(below.shape.plan, body.shape.center)};
  }
  const double above = body.underside() - below.top();
  if (std::abs(above) <= options.support_tolerance_m + kTiny) return {};
  return {fmt::format("the underside of {} is {} m {} the top of {}, on which it stands", body.id(), figure_beside(std::abs(above), 0),
                      above > 0 ? "above" : "below", below.id()),
          std::abs(above)};
}

// What holds an object; where the layout does not say, its mount does.
std::string holder_of(const Body& body) {
  if (!body.object->supported_by.empty()) return body.object->supported_by;
  if (body.object->mount == Mount::kWall) return "wall";
  return std::string(name_of(body.object->mount));
}

SupportFault direct_fault(const RoomView& view, const Body& body) {
  const std::string holder = holder_of(body);
  if (holder == "floor") {
    const double above = std::abs(body.underside());
    if (above <= view.options.support_tolerance_m + kTiny) return {};
    return {fmt::format("the underside of {} is {} m {} the floor", body.id(), figure_beside(above, 0),
                        body.underside() > 0 ? "above" : "below"),
            above};
  }
  if (holder == "ceiling") {
    const double below = std::abs(view.height - body.top());
    if (below <= view.options.mount_tolerance_m + kTiny) return {};
    return {fmt::format("the top of {} is {} m from the ceiling", body.id(), figure_beside(below, 0)), below};
  }
  if (const Body* below = view.find_body(holder); below != nullptr && below != &body) return held_by_body(view, body, *below);
  if (const Face* opening = view.find_opening(holder)) return held_by_sill(view, body, *opening);
  if (holder == "wall" || view.find_wall(holder) != nullptr) return held_by_wall(view, body, holder);
  return {fmt::format("{} is supported by \"{}\", which is not there", body.id(), holder), 0};
}

}  // namespace

std::string object_pointer(const Body& body) { return fmt::format("/objects/{}", body.index); }

std::string figure(double value) { return fmt::format("{:.2f}", value == 0 ? 0.0 : value); }

std::string figure_beside(double value, double limit) {
  return std::abs(value - limit) < 0.01 ? fmt::format("{:.3f}", std::abs(value) < 0.0005 ? 0.0 : value) : figure(value);
}

bool collide(const Body& a, const Body& b, double tolerance) {
  if (penetration(a.shape, b.shape) <= tolerance + kTiny || a.rug || b.rug) return false;
  return !in_hollows(a, b, tolerance);
}

void check_collisions(const RoomView& view, Report& report) {
  std::set<std::size_t> hit;
  for (std::size_t i = 0; i < view.bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < view.bodies.size(); ++j) {
      const Body &a = view.bodies[i], &b = view.bodies[j];
      if (!collide(a, b, view.options.collision_tolerance_m)) continue;
      hit.insert(i), hit.insert(j);
      const double depth = penetration(a.shape, b.shape);
      report.checks.push_back({"collision", a.id() + " / " + b.id(), false, true, depth, "m",
                               fmt::format("{} and {} overlap by {} m, at most {:.3f} m", a.id(), b.id(),
                                           figure_beside(depth, view.options.collision_tolerance_m), view.options.collision_tolerance_m),
                               object_pointer(b)});
    }
  }
  if (hit.empty()) {
    report.checks.push_back({"collision", "all objects", true, true, 0, "m", "no two objects overlap", "/objects"});
  }
  report.metrics["collisions"] = static_cast<double>(hit.size());
}

void check_bounds(const RoomView& view, Report& report) {
  int bad = 0;
  for (const Body& body : view.bodies) {
    const double area = std::abs(signed_area(body.shape.plan));
    double off = view.floor.empty() ? 1.0 : 0.0;
    if (!view.floor.empty() && area > 0) off = std::clamp(1 - signed_area(clip(view.floor, body.shape.plan)) / area, 0.0, 1.0);
    if (!view.floor.empty() && area <= 0) off = contains(view.floor, body.shape.center) ? 0.0 : 1.0;
    const double through = body.top() - view.height;
    const bool outside = off > kOutsideShare + 1e-9, too_high = through > kCeilingReach + kTiny;
    bad += outside || too_high;
    Check check{"outOfBounds", body.id(), !outside && !too_high, true, off, "share", {}, object_pointer(body)};
    if (outside) {
      check.message = fmt::format("{:.1f} % of the footprint of {} is off the floor, at most 1 %", off * 100, body.id());
    } else if (too_high) {
      check.value = through, check.unit = "m";
      check.message = fmt::format("the top of {} is {} m above the ceiling", body.id(), figure_beside(through, 0));
    } else {
      check.message = fmt::format("{} is within the room", body.id());
    }
    report.checks.push_back(std::move(check));
  }
  report.metrics["outOfBounds"] = bad;
}

SupportFault support_fault(const RoomView& view, const Body& body) {
  SupportFault fault = direct_fault(view, body);
  std::set<const Body*> seen{&body};
  const Body* step = &body;
  while (fault.message.empty()) {
    step = view.find_body(step->object->supported_by);
    if (step == nullptr) break;
    if (!seen.insert(step).second) fault.message = fmt::format("what holds {} runs in a circle at {}", body.id(), step->id());
  }
  return fault;
}

void check_support(const RoomView& view, Report& report) {
  int good = 0;
  for (const Body& body : view.bodies) {
    const SupportFault fault = support_fault(view, body);
    const bool held = fault.message.empty();
    good += held;
    report.checks.push_back({"support", body.id(), held, true, fault.gap, "m",
                             held ? fmt::format("{} is held by {}", body.id(), holder_of(body)) : fault.message, object_pointer(body)});
  }
  report.metrics["support"] = view.bodies.empty() ? 1.0 : good / static_cast<double>(view.bodies.size());
}

}  // namespace layoutbox::checks
