// Bodies of a room as the judge measures them: in three dimensions, by points spread evenly over them.
#pragma once

#include <array>
#include <vector>

#include "layoutbox/verify/drawn.h"
#include "layoutbox/verify/room_view.h"

namespace layoutbox::scoring {

using checks::Frame;
using checks::Vec2d;

inline constexpr double kTiny = 1e-6;  // m

// An upright box. Left is −x and front −y of its own frame.
struct Block {
  const checks::Body* body = nullptr;  // null: the space before an opening
  checks::Shape shape;
  Frame frame;
  std::array<double, 3> half{};
  std::vector<Point3> points;  // spread evenly over it
  Vec2d center() const { return shape.center; }
  double middle() const { return shape.heights.mid(); }
  double low() const { return shape.heights.lo; }
  double high() const { return shape.heights.hi; }
  // A point of the room in the block's own frame, its middle as origin.
  Point3 local(const Point3& point) const;
};

Block block_of(const checks::Body& body);
Block block_of(const checks::Shape& shape);

enum class Way { kLeft, kRight, kFront, kBack, kBottom, kTop };

// Shares, 0–1, of the target's points: on one side of the reference (beyond its face where `outside`, else beyond its middle) and within
// the reach of that face, grown by `margin` of its half; heights count for sides where `heights`.
double side_share(const Block& target, const Block& reference, Way way, bool outside, double margin, bool heights);
double inside_share(const Block& target, const Block& reference);
// In the half of the reference's box on that side; in the plan only where `flat`.
double half_share(const Block& target, const Block& reference, Way way, bool flat);
// Shared footprint over the smaller one, the reference grown by `grow` metres.
double cover(const Block& target, const Block& reference, double grow = 0);
// Share of the target's length that lies beyond the reference on that side, times how far the two are in line, in `frame`.
double beside_share(const Block& target, const Block& reference, Way way, const Frame& frame);
// Shortest distance, and the depth by which the two overlap.
double gap_between(const Block& a, const Block& b);

// 1 within [low, high], falling off outside as a bell of width `spread`.
double band(double value, double low, double high, double spread = 0.25);

}  // namespace layoutbox::scoring
