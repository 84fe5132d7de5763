// Boxes of all kinds: bevelled, rounded, cushions, tapers, beams.
#include <array>

#include "layoutbox/furnish/kit_base.h"
#include "layoutbox/furnish/kit_detail.h"

namespace layoutbox::kit {
namespace {

double smallest(Vec v) { return std::min({v.x, v.y, v.z}); }
double component(Vec v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
Vec axis_vector(int axis, double k) { return {axis == 0 ? k : 0, axis == 1 ? k : 0, axis == 2 ? k : 0}; }

// The uv of a point on a face across `axis`: u along the longer side.
Vec2 face_uv(Vec p, Vec size, int axis) {
  const int b = (axis + 1) % 3, c = (axis + 2) % 3;
  const bool b_longer = component(size, b) > component(size, c);
  return b_longer ? Vec2{component(p, b), component(p, c)} : Vec2{component(p, c), component(p, b)};
}

// Shape of the rounded bodies: the same rings serve boxes and cushions.
struct Rounding {
  double radius;
  int steps;          // facets to a quarter turn
  int divisions;      // of each straight side
  double dome_above;  // how far the top swells above the straight body
  double dome_below;
};

// The outline's points on one level, as direction (of the corner's roundness) and the corner or side point it is pushed to.
struct RingPoint {
  Vec2 direction;
  Vec2 base;
};

std::vector<RingPoint> ring_points(Vec2 half, const Rounding& shape) {
  std::vector<RingPoint> points;
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    const double sx = quadrant == 0 || quadrant == 3 ? 1 : -1, sy = quadrant < 2 ? 1 : -1;
    for (int i = 0; i <= shape.steps; ++i) {
      const double a = kPi / 2 * (quadrant + static_cast<double>(i) / shape.steps);
      points.push_back({{std::cos(a), std::sin(a)}, {sx * half.x, sy * half.y}});
    }
    const RingPoint last = points.back();
    const double nx = quadrant < 1 || quadrant == 3 ? 1 : -1;
    const Vec2 next = quadrant == 0   ? Vec2{-half.x, half.y}
                      : quadrant == 1 ? Vec2{-half.x, -half.y}
                      : quadrant == 2 ? Vec2{half.x, -half.y}
                                      : Vec2{nx * half.x, half.y};
    for (int i = 1; i < shape.divisions; ++i) {
      const double t = static_cast<double>(i) / shape.divisions;
      points.push_back({last.direction, {last.base.x + (next.x - last.base.x) * t, last.base.y + (next.y - last.base.y) * t}});
    }
  }
  return points;
}

// The level face that closes a rounded body, swelling by `dome` in the middle.
void cap(Maker& maker, Vec center, Vec2 half, double dome, int divisions, double up) {
  std::vector<std::uint32_t> grid;
  const auto bulge = [](double t) { return (1 - t * t) * (1 - t * t); };
  const auto slope = [](double t) { return -4 * t * (1 - t * t); };
  for (int j = 0; j <= divisions; ++j) {
    for (int i = 0; i <= divisions; ++i) {
      const double u = 2.0 * i / divisions - 1, v = 2.0 * j / divisions - 1;
      const Vec p{center.x + half.x * u, center.y + half.y * v, center.z + up * dome * bulge(u) * bulge(v)};
      const Vec n{-dome * slope(u) * bulge(v) / std::max(half.x, 1e-6), -dome * bulge(u) * slope(v) / std::max(half.y, 1e-6), 1};
      grid.push_back(maker.vertex(p, {n.x, n.y, n.z * up}, half.x > half.y ? Vec2{p.x, p.y} : Vec2{p.y, p.x}));
    }
  }
  const auto at = [&](int i, int j) { return grid[static_cast<std::size_t>(j * (divisions + 1) + i)]; };
  for (int j = 0; j < divisions; ++j) {
    for (int i = 0; i < divisions; ++i) maker.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }
}

Mesh rounded_body(const Box& outer, const Rounding& shape) {
  Maker maker;
  Box body = outer;
  body.max.z -= shape.dome_above;
  body.min.z += shape.dome_below;
  const Vec c = body.center(), half = body.size() * 0.5;
  const double r = std::min(shape.radius, smallest(half));
  const Vec2 core{half.x - r, half.y - r};
  const auto points = ring_points(core, shape);
  const std::size_t columns = points.size();
  std::vector<std::uint32_t> previous, row;
  for (int half_turn = 0; half_turn < 2; ++half_turn) {
    for (int i = 0; i <= shape.steps; ++i) {
      const double a = kPi / 2 * (half_turn - 1 + static_cast<double>(i) / shape.steps);
      const double z = (half_turn == 0 ? -1 : 1) * (half.z - r) + r * std::sin(a);
      row.clear();
      double along = 0;
      for (std::size_t k = 0; k <= columns; ++k) {
        const RingPoint& p = points[k % columns];
        const Vec n{p.direction.x * std::cos(a), p.direction.y * std::cos(a), std::sin(a)};
        const Vec at{c.x + p.base.x + r * n.x, c.y + p.base.y + r * n.y, c.z + z};
        if (k > 0) {
          const RingPoint& q = points[k - 1];
          along += std::hypot(p.base.x + r * p.direction.x - q.base.x - r * q.direction.x,
                              p.base.y + r * p.direction.y - q.base.y - r * q.direction.y);
        }
        row.push_back(maker.vertex(at, n, {along, at.z}));
      }
      for (std::size_t k = 0; k < columns && !previous.empty(); ++k) maker.quad(previous[k], previous[k + 1], row[k + 1], row[k]);
      previous = row;
    }
  }
  cap(maker, {c.x, c.y, body.max.z}, core, shape.dome_above, shape.divisions, 1);
  cap(maker, {c.x, c.y, body.min.z}, core, shape.dome_below, shape.divisions, -1);
  return maker.take();
}

}  // namespace

Mesh box(const Box& b, double bevel) {
  Maker maker;
  const Vec size = b.size();
  const double e = std::max(0.0, std::min(bevel_at_detail(bevel), smallest(size) * 0.3));
  // Vertex of corner (sx, sy, sz) on the face across `axis`: the bevels between faces shade smoothly from one face to the other.
  std::array<std::array<std::uint32_t, 3>, 8> vertices{};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec sign{corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0};
    const Vec p{corner & 1 ? b.max.x : b.min.x, corner & 2 ? b.max.y : b.min.y, corner & 4 ? b.max.z : b.min.z};
    for (int axis = 0; axis < 3; ++axis) {
      Vec q = p;
      for (int other = 0; other < 3; ++other) {
        if (other != axis) q = q - axis_vector(other, component(sign, other) * e);
      }
      vertices[static_cast<std::size_t>(corner)][static_cast<std::size_t>(axis)] =
          maker.vertex(q, axis_vector(axis, component(sign, axis)), face_uv(q, size, axis));
    }
  }
  const auto at = [&](int corner, int axis) { return vertices[static_cast<std::size_t>(corner)][static_cast<std::size_t>(axis)]; };
  for (int axis = 0; axis < 3; ++axis) {
    const int a = 1 << axis, u = 1 << ((axis + 1) % 3), v = 1 << ((axis + 2) % 3);
    maker.quad(at(0, axis), at(u, axis), at(u | v, axis), at(v, axis));
    maker.quad(at(a, axis), at(a | u, axis), at(a | u | v, axis), at(a | v, axis));
    if (e <= 0) continue;
    // The four edges along this axis join the faces across the two other axes.
    for (const int side : {0, u, v, u | v}) {
      maker.quad(at(side, (axis + 1) % 3), at(side | a, (axis + 1) % 3), at(side | a, (axis + 2) % 3), at(side, (axis + 2) % 3));
    }
  }
  for (int corner = 0; corner < 8 && e > 0; ++corner) maker.triangle(at(corner, 0), at(corner, 1), at(corner, 2));
  return maker.take();
}

Mesh rounded_box(const Box& b, double radius, int steps) { return rounded_body(b, {radius, steps_at_detail(steps), 1, 0, 0}); }

Mesh cushion(const Box& b, double radius, bool flat_below, int steps) {
  const double dome = std::min(0.18 * b.size().z, 0.06);
  return rounded_body(b, {radius, steps_at_detail(3), std::max(2, steps_at_detail(steps) / 4 * 2), dome, flat_below ? 0 : dome});
}

Mesh pillow(const Box& b, int steps) {
  const int n = std::max(4, steps_at_detail(steps) / 2 * 2);
  const Vec c = b.center(), half = b.size() * 0.5;
  const auto swell = [](double t) { return std::sqrt(std::max(0.0, 1 - std::pow(std::abs(t), 2.6))); };
  const auto point = [&](double u, double v, double side) {
    // Sides are drawn in between the corners, as a filled bag's are.
    const double x = u * (1 - 0.05 * (1 - v * v)), y = v * (1 - 0.05 * (1 - u * u));
    return Vec{c.x + half.x * x, c.y + half.y * y, c.z + side * half.z * swell(u) * swell(v)};
  };
  Maker maker;
  for (const double side : {1.0, -1.0}) {
    std::vector<std::uint32_t> grid;
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        const double u = std::sin(kPi / 2 * (2.0 * i / n - 1)), v = std::sin(kPi / 2 * (2.0 * j / n - 1)), e = 0.02;
        const Vec du = point(std::min(1.0, u + e), v, side) - point(std::max(-1.0, u - e), v, side);
        const Vec dv = point(u, std::min(1.0, v + e), side) - point(u, std::max(-1.0, v - e), side);
        const Vec p = point(u, v, side);
        grid.push_back(maker.vertex(p, cross(du, dv) * side, {p.x, p.y}));
      }
    }
    const auto at = [&](int i, int j) { return grid[static_cast<std::size_t>(j * (n + 1) + i)]; };
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) maker.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return maker.take();
}

Mesh taper(Vec below, Vec2 half_below, Vec above, Vec2 half_above) {
  const auto corner = [](Vec c, Vec2 h, int i) { return Vec{c.x + (i == 0 || i == 3 ? -h.x : h.x), c.y + (i < 2 ? -h.y : h.y), c.z}; };
  Maker maker;
  const Vec middle = (below + above) * 0.5;
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    const Vec a = corner(below, half_below, i), b = corner(below, half_below, j);
    const Vec c = corner(above, half_above, j), d = corner(above, half_above, i);
    maker.flat_quad(a, b, c, d, (a + b + c + d) * 0.25 - middle);
  }
  maker.flat_quad(corner(below, half_below, 0), corner(below, half_below, 1), corner(below, half_below, 2), corner(below, half_below, 3),
                  below - above);
  maker.flat_quad(corner(above, half_above, 0), corner(above, half_above, 1), corner(above, half_above, 2), corner(above, half_above, 3),
                  above - below);
  return maker.take();
}

Mesh beam(Vec from, Vec to, Vec2 size, double bevel) {
  const double l = length(to - from);
  const Vec x = unit(to - from);
  const Vec y = unit(cross(std::abs(x.z) > 0.99 ? Vec{0, 1, 0} : Vec{0, 0, 1}, x));
  return posed(box({{0, -size.x / 2, -size.y / 2}, {l, size.x / 2, size.y / 2}}, bevel), {x, y, cross(x, y), from});
}

}  // namespace layoutbox::kit
