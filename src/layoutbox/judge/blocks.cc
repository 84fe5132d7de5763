#include "layoutbox/judge/blocks.h"

#include <algorithm>
#include <cmath>

namespace layoutbox::scoring {
namespace {

constexpr int kAcross = 20, kUp = 10;  // points a side

std::size_t axis_of(Way way) { return static_cast<std::size_t>(way) / 2; }
double sign_of(Way way) { return way == Way::kRight || way == Way::kBack || way == Way::kTop ? 1 : -1; }
// The front is −y: the order of Way is left, right, front, back.
double coordinate(const Point3& point, std::size_t axis) { return axis == 0 ? point.x : axis == 1 ? point.y : point.z; }

double cell(int i, int count) { return (i + 0.5) / count * 2 - 1; }

template <class Held>
double share_of(const Block& target, const Block& reference, const Held& held) {
  std::size_t count = 0;
  for (const Point3& point : target.points) count += held(reference.local(point));
  return target.points.empty() ? 0 : static_cast<double>(count) / static_cast<double>(target.points.size());
}

bool within(const Block& reference, const Point3& point, std::size_t dimensions) {
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    if (std::abs(coordinate(point, axis)) > reference.half[axis] + kTiny) return false;
  }
  return true;
}

}  // namespace

Point3 Block::local(const Point3& point) const {
  const Vec2d off = Vec2d{point.x, point.y} - center();
  return {dot(off, frame.x), dot(off, frame.y), point.z - middle()};
}

Block block_of(const checks::Shape& shape) {
  Block block;
  block.shape = shape;
  block.frame = shape.frame;
  block.half = {checks::extent(shape, shape.frame.x).half(), checks::extent(shape, shape.frame.y).half(), shape.heights.half()};
  block.points.reserve(kAcross * kAcross * kUp);
  for (int i = 0; i < kAcross; ++i) {
    for (int j = 0; j < kAcross; ++j) {
      const Vec2d at =
          shape.center + block.frame.x * (cell(i, kAcross) * block.half[0]) + block.frame.y * (cell(j, kAcross) * block.half[1]);
      for (int k = 0; k < kUp; ++k) block.points.push_back({at.x, at.y, block.middle() + cell(k, kUp) * block.half[2]});
    }
  }
  return block;
}

Block block_of(const checks::Body& body) {
  checks::Shape shape = body.shape;
  shape.frame = body.own_frame;
  Block block = block_of(shape);
  block.body = &body;
  return block;
}

double side_share(const Block& target, const Block& reference, Way way, bool outside, double margin, bool heights) {
  const std::size_t axis = axis_of(way);
  return share_of(target, reference, [&](const Point3& point) {
    if (sign_of(way) * coordinate(point, axis) < (outside ? reference.half[axis] : 0) - kTiny) return false;
    for (std::size_t other = 0; other < 3; ++other) {
      if (other == axis || (other == 2 && !heights)) continue;
      if (std::abs(coordinate(point, other)) > reference.half[other] * (1 + margin) + kTiny) return false;
    }
    return true;
  });
}

double inside_share(const Block& target, const Block& reference) {
  return share_of(target, reference, [&](const Point3& point) { return within(reference, point, 3); });
}

double half_share(const Block& target, const Block& reference, Way way, bool flat) {
  const std::size_t axis = axis_of(way);
  return share_of(target, reference, [&](const Point3& point) {
    return within(reference, point, flat ? 2 : 3) && sign_of(way) * coordinate(point, axis) >= -kTiny;
  });
}

double cover(const Block& target, const Block& reference, double grow) {
  const checks::Shape grown = checks::make_box(reference.center(), 2 * (reference.half[0] + grow), 2 * (reference.half[1] + grow),
                                               reference.shape.heights, reference.frame);
  const double shared = std::abs(checks::signed_area(checks::clip(target.shape.plan, grown.plan)));
  return shared / (4 * std::min(target.half[0] * target.half[1], reference.half[0] * reference.half[1]));
}

double beside_share(const Block& target, const Block& reference, Way way, const Frame& frame) {
  const bool sideways = axis_of(way) == 0;
  const Vec2d along = sideways ? frame.x : frame.y, square = sideways ? frame.y : frame.x;
  const checks::Interval own = checks::extent(target.shape, along), its = checks::extent(reference.shape, along);
  const double beyond = sign_of(way) > 0 ? own.hi - std::max(own.lo, its.hi) : std::min(own.hi, its.lo) - own.lo;
  const checks::Interval own_line = checks::extent(target.shape, square), its_line = checks::extent(reference.shape, square);
  const double in_line = checks::overlap(own_line, its_line) / std::min(own_line.length(), its_line.length());
  return std::max(0.0, beyond / own.length()) * std::clamp(in_line, 0.0, 1.0);
}

double gap_between(const Block& a, const Block& b) { return checks::gap(a.shape, b.shape); }

double band(double value, double low, double high, double spread) {
  const double miss = std::max({low - value, value - high, 0.0});
  return std::exp(-miss * miss / (2 * spread * spread));
}

}  // namespace layoutbox::scoring
