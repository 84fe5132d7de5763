// The verifier's own geometry: doubles, metres and radians, convex shapes in the plan with an interval of heights.
// It shares nothing with the solver's integer arithmetic, so that a mistake in one is seen by the other.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace layoutbox::checks {

inline constexpr double kTiny = 1e-6;  // m: numerical noise that is not a finding

struct Vec2d {
  double x = 0, y = 0;
};
inline Vec2d operator+(Vec2d a, Vec2d b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2d operator-(Vec2d a, Vec2d b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2d operator*(Vec2d a, double s) { return {a.x * s, a.y * s}; }
inline double dot(Vec2d a, Vec2d b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vec2d a, Vec2d b) { return a.x * b.y - a.y * b.x; }
double length(Vec2d a);

// A closed interval along some axis.
struct Interval {
  double lo = 0, hi = 0;
  double mid() const { return lo + (hi - lo) / 2; }
  double half() const { return (hi - lo) / 2; }
  double length() const { return hi - lo; }
};
// How much two intervals share; negative: how far they are apart.
double overlap(Interval a, Interval b);
// The smallest interval around both.
Interval hull(Interval a, Interval b);

// Directions in the plan, square to each other; x × y points up.
struct Frame {
  Vec2d x{1, 0}, y{0, 1};
};
// Turned counter-clockwise; quarter turns are exact.
Frame frame_at(double rotation_deg);

using Polygon = std::vector<Vec2d>;  // counter-clockwise

double signed_area(const Polygon& polygon);
// The part of `subject` (any simple polygon) within a convex polygon; for a subject with notches, its area is exact.
Polygon clip(const Polygon& subject, const Polygon& convex);
// The part on the side of the line through `point` to which `inward` points.
Polygon clip_half_plane(const Polygon& subject, Vec2d point, Vec2d inward);
// The area of a convex polygon that none of the convex `covers` covers.
double uncovered_area(const Polygon& convex, std::span<const Polygon> covers);
// Inside or on the edge.
bool contains(const Polygon& polygon, Vec2d point);
double distance_to_segment(Vec2d point, Vec2d a, Vec2d b);
// Distance between two convex shapes, of which each may be a segment; 0 when they meet.
double distance(const Polygon& a, const Polygon& b);
double distance(const Polygon& a, Vec2d point);

// An upright prism over a convex plan: a body, a wall's inner face, an opening.
struct Shape {
  Polygon plan;  // four corners, or the two ends of a face
  Vec2d center;
  Interval heights;
  Frame frame;  // the frame in which left, right, front (−y) and back of it are meant
};

// Extent of a shape along a direction of unit length.
Interval extent(const Shape& shape, Vec2d direction);
// Shortest distance in three dimensions; 0 when they meet.
double gap(const Shape& a, const Shape& b);
// An upright box of that size, centred there.
Shape make_box(Vec2d center, double width, double depth, Interval heights, const Frame& frame);
// Depth in metres by which two boxes overlap along each of their edges and in height; zero or less when they do not.
double penetration(const Shape& a, const Shape& b);

}  // namespace layoutbox::checks
