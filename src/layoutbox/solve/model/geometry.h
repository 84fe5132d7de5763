// Upright boxes on integer millimetres, quarter turns, and the part of a room's bounding box that is not room.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "layoutbox/base/units.h"

namespace layoutbox::placement {

using Vec3 = std::array<Mm, 3>;

struct GridBox {
  Vec3 lo{}, hi{};
  Mm extent(int axis) const { return hi[axis] - lo[axis]; }
  bool empty() const { return lo[0] >= hi[0] || lo[1] >= hi[1] || lo[2] >= hi[2]; }
  GridBox shifted(const Vec3& by) const {
    return {{lo[0] + by[0], lo[1] + by[1], lo[2] + by[2]}, {hi[0] + by[0], hi[1] + by[1], hi[2] + by[2]}};
  }
  friend bool operator==(const GridBox&, const GridBox&) = default;
};

// They share more than a face.
inline bool overlap(const GridBox& a, const GridBox& b) {
  return a.lo[0] < b.hi[0] && b.lo[0] < a.hi[0] && a.lo[1] < b.hi[1] && b.lo[1] < a.hi[1] && a.lo[2] < b.hi[2] && b.lo[2] < a.hi[2];
}

inline bool overlap_in_plan(const GridBox& a, const GridBox& b) {
  return a.lo[0] < b.hi[0] && b.lo[0] < a.hi[0] && a.lo[1] < b.hi[1] && b.lo[1] < a.hi[1];
}

inline GridBox intersection(const GridBox& a, const GridBox& b) {
  GridBox both;
  for (int k = 0; k < 3; ++k) {
    both.lo[k] = std::max(a.lo[k], b.lo[k]);
    both.hi[k] = std::min(a.hi[k], b.hi[k]);
  }
  return both;
}

inline std::int64_t floor_area(const GridBox& a) { return a.empty() ? 0 : std::int64_t{a.extent(0)} * a.extent(1); }

// Distance along one axis between two boxes; 0 where they meet or overlap.
inline Mm gap_along(const GridBox& a, const GridBox& b, int axis) {
  return std::max({0, a.lo[axis] - b.hi[axis], b.lo[axis] - a.hi[axis]});
}

// Shortest distance between two boxes in three dimensions, rounded down.
Mm gap_between(const GridBox& a, const GridBox& b);

// `box` less `hole`: at most six boxes, cut so that pieces that reach over the full width stay whole.
void subtract(const GridBox& box, const GridBox& hole, std::vector<GridBox>& out);

// `box` less all `holes`.
std::vector<GridBox> less(const GridBox& box, std::span<const GridBox> holes);

// The smallest upright box around `box` (in a frame whose origin is the turning point) turned counter-clockwise about z; exact for
// quarter turns, else rounded outward.
GridBox turned(const GridBox& box, double degrees);

// An upright box within the turned one, about the same middle; of all such boxes the one of greatest area. Exact for quarter turns, else
// rounded inward.
GridBox turned_within(const GridBox& box, double degrees);

// A direction in the plan: the axis it runs along and which way.
struct Direction {
  int axis = 0;
  int sign = 1;
  friend bool operator==(const Direction&, const Direction&) = default;
};

// Where the direction (given at turn 0) points after a turn. REQUIRES: degrees is a multiple of 90.
Direction turned(Direction direction, int degrees);

// True when every edge of the polygon runs along x or y.
bool is_rectilinear(std::span<const Point> polygon);

// Boxes (from z_lo to z_hi) that cover what of the polygon's bounding box is not inside the polygon. Exact for right angles; along other
// edges the boxes reach at most `step` into the polygon, never less than its edge.
std::vector<GridBox> outside_of(std::span<const Point> polygon, Mm z_lo, Mm z_hi, Mm step);

// The cells between the polygon's corners that lie outside of it and that no edge passes through.
std::vector<GridBox> wholly_outside_of(std::span<const Point> polygon, Mm z_lo, Mm z_hi);

bool contains(std::span<const Point> polygon, double x, double y);

}  // namespace layoutbox::placement
