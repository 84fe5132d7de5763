#include "layoutbox/verify/geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace layoutbox::checks {
namespace {

Vec2d to_line_crossing(Vec2d a, Vec2d b, double side_a, double side_b) { return a + (b - a) * (side_a / (side_a - side_b)); }

bool segments_cross(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  const double abc = cross(b - a, c - a), abd = cross(b - a, d - a);
  const double cda = cross(d - c, a - c), cdb = cross(d - c, b - c);
  return ((abc > 0) != (abd > 0)) && ((cda > 0) != (cdb > 0)) && abc != abd && cda != cdb;
}

// A shape of two points has one edge, not two.
std::size_t edge_count(const Polygon& polygon) { return polygon.size() > 2 ? polygon.size() : polygon.size() - 1; }

}  // namespace

double length(Vec2d a) { return std::hypot(a.x, a.y); }

double overlap(Interval a, Interval b) { return std::min(a.hi, b.hi) - std::max(a.lo, b.lo); }

Interval hull(Interval a, Interval b) { return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)}; }

Frame frame_at(double rotation_deg) {
  const double turn = std::fmod(rotation_deg, 360.0);
  const double quarters = turn / 90.0;
  Vec2d x;
  if (quarters == std::round(quarters)) {
    constexpr std::array<Vec2d, 4> kQuarter{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    x = kQuarter[static_cast<std::size_t>((static_cast<int>(quarters) + 4) % 4)];
  } else {
    const double angle = turn * (std::numbers::pi / 180.0);
    x = {std::cos(angle), std::sin(angle)};
  }
  return {x, {-x.y, x.x}};
}

double signed_area(const Polygon& polygon) {
  if (polygon.size() < 3) return 0;
  double twice = 0;  // about the first corner: places far from the origin lose nothing
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return twice / 2;
}

Polygon clip_half_plane(const Polygon& subject, Vec2d point, Vec2d inward) {
  Polygon result;
  for (std::size_t i = 0; i < subject.size(); ++i) {
    const Vec2d a = subject[i], b = subject[(i + 1) % subject.size()];
    const double side_a = dot(a - point, inward), side_b = dot(b - point, inward);
    if (side_a >= 0) result.push_back(a);
    if ((side_a > 0 && side_b < 0) || (side_a < 0 && side_b > 0)) result.push_back(to_line_crossing(a, b, side_a, side_b));
  }
  return result;
}

Polygon clip(const Polygon& subject, const Polygon& convex) {
  Polygon result = subject;
  for (std::size_t i = 0; i < convex.size() && !result.empty(); ++i) {
    const Vec2d a = convex[i], edge = convex[(i + 1) % convex.size()] - a;
    result = clip_half_plane(result, a, {-edge.y, edge.x});
  }
  return result;
}

double uncovered_area(const Polygon& convex, std::span<const Polygon> covers) {
  std::vector<Polygon> left{convex};
  for (const Polygon& cover : covers) {
    std::vector<Polygon> next;
    for (Polygon piece : left) {
      // What lies outside each edge in turn is left over; what is inside all of them is covered.
      for (std::size_t i = 0; i < cover.size() && !piece.empty(); ++i) {
        const Vec2d a = cover[i], edge = cover[(i + 1) % cover.size()] - a, inward{-edge.y, edge.x};
        Polygon outside = clip_half_plane(piece, a, inward * -1);
        if (signed_area(outside) > 0) next.push_back(std::move(outside));
        piece = clip_half_plane(piece, a, inward);
      }
    }
    left = std::move(next);
  }
  double area = 0;
  for (const Polygon& piece : left) area += signed_area(piece);
  return area;
}

bool contains(const Polygon& polygon, Vec2d point) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2d a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if (distance_to_segment(point, a, b) < 1e-9) return true;
    if ((a.y > point.y) != (b.y > point.y) && point.x < a.x + (b.x - a.x) * ((point.y - a.y) / (b.y - a.y))) inside = !inside;
  }
  return inside;
}

double distance_to_segment(Vec2d point, Vec2d a, Vec2d b) {
  const Vec2d way = b - a;
  const double squared = dot(way, way);
  const double t = squared > 0 ? std::clamp(dot(point - a, way) / squared, 0.0, 1.0) : 0.0;
  return length(point - (a + way * t));
}

double distance(const Polygon& a, Vec2d point) {
  if (a.size() > 2 && contains(a, point)) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < edge_count(a); ++i) least = std::min(least, distance_to_segment(point, a[i], a[(i + 1) % a.size()]));
  return least;
}

double distance(const Polygon& a, const Polygon& b) {
  if ((a.size() > 2 && contains(a, b[0])) || (b.size() > 2 && contains(b, a[0]))) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < edge_count(a); ++i) {
    const Vec2d a0 = a[i], a1 = a[(i + 1) % a.size()];
    for (std::size_t j = 0; j < edge_count(b); ++j) {
      const Vec2d b0 = b[j], b1 = b[(j + 1) % b.size()];
      if (segments_cross(a0, a1, b0, b1)) return 0;
      least = std::min({least, distance_to_segment(a0, b0, b1), distance_to_segment(a1, b0, b1), distance_to_segment(b0, a0, a1),
                        distance_to_segment(b1, a0, a1)});
    }
  }
  return least;
}

Interval extent(const Shape& shape, Vec2d direction) {
  Interval result{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Vec2d corner : shape.plan) {
    const double at = dot(corner, direction);
    result = {std::min(result.lo, at), std::max(result.hi, at)};
  }
  return result;
}

double gap(const Shape& a, const Shape& b) { return std::hypot(distance(a.plan, b.plan), std::max(0.0, -overlap(a.heights, b.heights))); }

Shape make_box(Vec2d center, double width, double depth, Interval heights, const Frame& frame) {
  const Vec2d w = frame.x * (width / 2), d = frame.y * (depth / 2);
  return {{center - w - d, center + w - d, center + w + d, center - w + d}, center, heights, frame};
}

double penetration(const Shape& a, const Shape& b) {
  // As far as one must be moved along an axis to be free: for a thing within another that is more than what they share.
  const auto depth_along = [](Interval p, Interval q) { return std::min(p.hi - q.lo, q.hi - p.lo); };
  double depth = depth_along(a.heights, b.heights);
  for (const Shape* shape : {&a, &b}) {
    for (std::size_t i = 0; i < 2 && shape->plan.size() == 4; ++i) {
      const Vec2d edge = shape->plan[i + 1] - shape->plan[i];
      if (length(edge) == 0) continue;
      const Vec2d axis = edge * (1 / length(edge));
      depth = std::min(depth, depth_along(extent(a, axis), extent(b, axis)));
    }
  }
  return depth;
}

}  // namespace layoutbox::checks
