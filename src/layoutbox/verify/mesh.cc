#include "layoutbox/verify/mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace layoutbox::checks {
namespace {

constexpr double kOnFloor = 0.001;  // m: what lies on the floor's edge is over it
constexpr double kPiece = 0.05;     // m: a triangle is judged in pieces of about this size
constexpr int kMostHalvings = 12;

Point3 operator+(Point3 a, Point3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Point3 operator-(Point3 a, Point3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point3 operator*(Point3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
double dot(Point3 a, Point3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 cross(Point3 a, Point3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

MeshBox box_of(const Triangle& triangle) {
  const auto [a, b, c] = triangle;
  return {{std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x})},
          {std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y})},
          {std::min({a.z, b.z, c.z}), std::max({a.z, b.z, c.z})}};
}

bool touch(const MeshBox& a, const MeshBox& b) { return overlap(a.x, b.x) >= 0 && overlap(a.y, b.y) >= 0 && overlap(a.z, b.z) >= 0; }
bool within(const MeshBox& a, const MeshBox& b) {
  const auto inside = [](Interval p, Interval q) { return p.lo >= q.lo && p.hi <= q.hi; };
  return inside(a.x, b.x) && inside(a.y, b.y) && inside(a.z, b.z);
}

// Where along from → from + way the line goes through the triangle; infinite where it does not.
double crossing(Point3 from, Point3 way, const Triangle& triangle) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const Point3 u = triangle[1] - triangle[0], v = triangle[2] - triangle[0], p = cross(way, v);
  const double size = dot(u, p);
  if (std::abs(size) < 1e-15) return kNone;
  const Point3 s = from - triangle[0];
  const double a = dot(s, p) / size;
  if (a < 0 || a > 1) return kNone;
  const Point3 q = cross(s, u);
  const double b = dot(way, q) / size;
  if (b < 0 || a + b > 1) return kNone;
  return dot(v, q) / size;
}

bool edge_cuts(const Triangle& a, const Triangle& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double at = crossing(a[i], a[(i + 1) % 3] - a[i], b);
    if (at >= 0 && at <= 1) return true;
  }
  return false;
}

struct Boxed {
  MeshBox box;
  const Triangle* triangle;
};

// Those of a mesh that reach into a box, from left to right.
std::vector<Boxed> in_box(const BodyMesh& mesh, const MeshBox& box) {
  std::vector<Boxed> found;
  for (const Triangle& triangle : mesh.triangles()) {
    const MeshBox own = box_of(triangle);
    if (touch(own, box)) found.push_back({own, &triangle});
  }
  std::sort(found.begin(), found.end(), [](const Boxed& p, const Boxed& q) { return p.box.x.lo < q.box.x.lo; });
  return found;
}

bool surfaces_cut(const BodyMesh& a, const BodyMesh& b) {
  const auto both = [](Interval p, Interval q) { return Interval{std::max(p.lo, q.lo), std::min(p.hi, q.hi)}; };
  const MeshBox shared{both(a.box().x, b.box().x), both(a.box().y, b.box().y), both(a.box().z, b.box().z)};
  const std::vector<Boxed> of_a = in_box(a, shared), of_b = in_box(b, shared);
  for (const Boxed& one : of_a) {
    for (const Boxed& other : of_b) {
      if (other.box.x.lo > one.box.x.hi) break;
      if (touch(one.box, other.box) && (edge_cuts(*one.triangle, *other.triangle) || edge_cuts(*other.triangle, *one.triangle)))
        return true;
    }
  }
  return false;
}

// A point is inside where a line from it leaves the mesh once more than it enters, along three directions of no axis: a mesh that is open
// somewhere has no inside that all three would see.
bool inside(const BodyMesh& mesh, Point3 point) {
  for (const Point3 way : {Point3{0.71, 0.13, 0.69}, Point3{-0.31, 0.83, 0.47}, Point3{0.17, -0.59, -0.79}}) {
    int crossings = 0;
    for (const Triangle& triangle : mesh.triangles()) {
      const double at = crossing(point, way, triangle);
      crossings += at > 0 && std::isfinite(at);
    }
    if (crossings % 2 == 0) return false;
  }
  return true;
}

double area_of(const Triangle& triangle) {
  const Point3 n = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  return std::sqrt(dot(n, n)) / 2;
}

// Halves the longest edge until the pieces are small.
double area_off(const Triangle& triangle, const Polygon& floor, int halvings) {
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3 edge = triangle[(i + 1) % 3] - triangle[i];
    if (dot(edge, edge) > most) most = dot(edge, edge), longest = i;
  }
  if (halvings == 0 || most <= kPiece * kPiece) {
    const Point3 middle = (triangle[0] + triangle[1] + triangle[2]) * (1.0 / 3);
    return distance(floor, {middle.x, middle.y}) <= kOnFloor ? 0 : area_of(triangle);
  }
  const Point3 from = triangle[longest], to = triangle[(longest + 1) % 3], top = triangle[(longest + 2) % 3], half = (from + to) * 0.5;
  return area_off({from, half, top}, floor, halvings - 1) + area_off({half, to, top}, floor, halvings - 1);
}

// The whole rectangle over the floor: no corner of the floor reaches into it, and its own are over it.
bool wholly_over(const MeshBox& box, const Polygon& floor) {
  for (const Vec2d corner : floor) {
    if (corner.x > box.x.lo + kOnFloor && corner.x < box.x.hi - kOnFloor && corner.y > box.y.lo + kOnFloor &&
        corner.y < box.y.hi - kOnFloor)
      return false;
  }
  for (const Vec2d corner : {Vec2d{box.x.lo, box.y.lo}, Vec2d{box.x.hi, box.y.lo}, Vec2d{box.x.hi, box.y.hi}, Vec2d{box.x.lo, box.y.hi},
                             Vec2d{box.x.mid(), box.y.mid()}}) {
    if (distance(floor, corner) > kOnFloor) return false;
  }
  // Corners and middle may be over it with a corner of the floor between them: the area tells.
  const Polygon rectangle{{box.x.lo, box.y.lo}, {box.x.hi, box.y.lo}, {box.x.hi, box.y.hi}, {box.x.lo, box.y.hi}};
  const double area = box.x.length() * box.y.length();
  return signed_area(clip(floor, rectangle)) >= area - kOnFloor * 2 * (box.x.length() + box.y.length());
}

}  // namespace

BodyMesh::BodyMesh(std::vector<Triangle> triangles, Frame frame) : triangles_(std::move(triangles)), frame_(frame) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  box_ = {{kFar, -kFar}, {kFar, -kFar}, {kFar, -kFar}};
  for (const Triangle& triangle : triangles_) {
    const MeshBox own = box_of(triangle);
    box_ = {hull(box_.x, own.x), hull(box_.y, own.y), hull(box_.z, own.z)};
  }
}

BodyMesh BodyMesh::inset(double inset) const {
  Interval u{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}, v = u;
  const auto along = [](Point3 p, Vec2d axis) { return p.x * axis.x + p.y * axis.y; };
  for (const Triangle& triangle : triangles_) {
    for (const Point3& p : triangle) {
      u = hull(u, {along(p, frame_.x), along(p, frame_.x)});
      v = hull(v, {along(p, frame_.y), along(p, frame_.y)});
    }
  }
  const auto scale = [&](Interval length) { return length.half() > 0 ? std::max(0.0, 1 - inset / length.half()) : 0.0; };
  const double by_u = scale(u), by_v = scale(v), by_z = scale(box_.z);
  std::vector<Triangle> smaller = triangles_;
  for (Triangle& triangle : smaller) {
    for (Point3& p : triangle) {
      const double pu = u.mid() + (along(p, frame_.x) - u.mid()) * by_u, pv = v.mid() + (along(p, frame_.y) - v.mid()) * by_v;
      p = {frame_.x.x * pu + frame_.y.x * pv, frame_.x.y * pu + frame_.y.y * pv, box_.z.mid() + (p.z - box_.z.mid()) * by_z};
    }
  }
  return {std::move(smaller), frame_};
}

BodyMesh BodyMesh::lowered(double by) const {
  std::vector<Triangle> lower = triangles_;
  for (Triangle& triangle : lower) {
    for (Point3& p : triangle) p.z -= by;
  }
  return {std::move(lower), frame_};
}

bool meet(const BodyMesh& a, const BodyMesh& b) {
  if (!touch(a.box(), b.box())) return false;
  if (surfaces_cut(a, b)) return true;
  if (within(a.box(), b.box())) return inside(b, a.triangles()[0][0]);
  return within(b.box(), a.box()) && inside(a, b.triangles()[0][0]);
}

double depth_of_meeting(const BodyMesh& a, const BodyMesh& b, double most) {
  double met = 0, apart = most;
  while (apart - met > 0.001) {
    const double half = (met + apart) / 2;
    (meet(a.inset(half), b.inset(half)) ? met : apart) = half;
  }
  return apart;
}

double share_off(const BodyMesh& mesh, const Polygon& floor) {
  if (floor.empty()) return 1;
  if (wholly_over(mesh.box(), floor)) return 0;
  double off = 0, all = 0;
  for (const Triangle& triangle : mesh.triangles()) {
    all += area_of(triangle);
    if (!wholly_over(box_of(triangle), floor)) off += area_off(triangle, floor, kMostHalvings);
  }
  return all > 0 ? off / all : 0;
}

}  // namespace layoutbox::checks
