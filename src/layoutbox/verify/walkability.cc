#include "layoutbox/verify/walkability.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "layoutbox/verify/checks.h"

namespace layoutbox::checks {
namespace {

constexpr int kResolution = 256;                       // pixels, as in quality.md
constexpr double kPerson = 0.2;                        // m, width of who walks in `navigability`
constexpr double kStripDepth = 0.2, kStripGap = 0.05;  // m, the strip of `accessibility`
constexpr int kMostSamples = 4096;                     // along a side: enough for any room, and bounded for absurd sizes
constexpr double kStandsBelow = 0.05;                  // m: what begins higher is not used from the floor

bool in_the_way(const Body& body) { return !body.rug && body.shape.heights.mid() <= kBodyReach; }

std::vector<const Body*> all_in_the_way(const RoomView& view) {
  std::vector<const Body*> bodies;
  for (const Body& body : view.bodies) {
    if (in_the_way(body)) bodies.push_back(&body);
  }
  return bodies;
}

int samples(double length, double step) {
  const double wanted = std::nearbyint(length / step);
  return std::isfinite(wanted) ? static_cast<int>(std::clamp(wanted, 8.0, double{kMostSamples})) : kMostSamples;
}

double side_access(const Body& body, Side which, const FloorPixels& plan) {
  const BodySide side = side_of(body, which);
  const int along = samples(2 * side.half_width, plan.step()), deep = samples(kStripDepth, plan.step());
  int free = 0;
  for (int i = 0; i < along; ++i) {
    const Vec2d foot = body.shape.center + side.along * ((i + 0.5) / along * 2 * side.half_width - side.half_width);
    for (int j = 0; j < deep; ++j) free += plan.free_at(foot + side.outward * (side.reach + kStripGap + (j + 0.5) / deep * kStripDepth));
  }
  return free / (static_cast<double>(along) * deep);
}

}  // namespace

std::vector<Side> sides_to_reach(const Body& body) {
  std::vector<Side> sides;
  if (body.rug || body.underside() > kStandsBelow) return sides;
  for (const Side side : body.object->used_sides) {
    if (side == Side::kFront || side == Side::kBack || side == Side::kLeft || side == Side::kRight) sides.push_back(side);
  }
  return sides;
}

double navigability(const RoomView& view) {
  FloorPixels plan(view, 0.2, kResolution);
  plan.erode(kPerson);
  plan.block(all_in_the_way(view), kPerson / 2);
  const std::int64_t all = plan.free_pixels();
  return all == 0 ? 0.0 : static_cast<double>(plan.largest_free_part()) / static_cast<double>(all);
}

FloorPixels plan_for_access(const RoomView& view) {
  FloorPixels plan(view, 0, kResolution);
  plan.block(all_in_the_way(view), 0);
  return plan;
}

std::optional<double> accessibility(const Body& body, const FloorPixels& plan) {
  std::optional<double> best;
  for (const Side side : sides_to_reach(body)) best = std::max(best.value_or(0), side_access(body, side, plan));
  return best;
}

}  // namespace layoutbox::checks
