// Bodies made from outlines and sheets: prisms, leaves, curtains, walls with holes.
#include "layoutbox/furnish/kit_base.h"
#include "layoutbox/furnish/kit_detail.h"

namespace layoutbox::kit {
namespace {

double turn(Vec2 a, Vec2 b, Vec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

bool inside(Vec2 p, Vec2 a, Vec2 b, Vec2 c) { return turn(a, b, p) >= -1e-12 && turn(b, c, p) >= -1e-12 && turn(c, a, p) >= -1e-12; }

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec2> outline) {
  std::vector<std::uint32_t> left(outline.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = static_cast<std::uint32_t>(i);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  while (left.size() > 3) {
    const std::size_t n = left.size();
    bool cut = false;
    for (std::size_t i = 0; i < n && !cut; ++i) {
      const std::uint32_t ia = left[(i + n - 1) % n], ib = left[i], ic = left[(i + 1) % n];
      const Vec2 a = outline[ia], b = outline[ib], c = outline[ic];
      if (turn(a, b, c) <= 1e-14) continue;
      const bool ear = std::none_of(left.begin(), left.end(),
                                    [&](std::uint32_t k) { return k != ia && k != ib && k != ic && inside(outline[k], a, b, c); });
      if (!ear) continue;
      triangles.push_back({ia, ib, ic});
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
      cut = true;
    }
    // Only points in line are left (or the outline crosses itself): fan over the rest, which has no area.
    if (!cut) break;
  }
  for (std::size_t i = 1; i + 1 < left.size(); ++i) triangles.push_back({left[0], left[i], left[i + 1]});
  return triangles;
}

Mesh prism(std::span<const Vec2> outline, double z0, double z1, bool smooth) {
  Maker maker;
  const std::size_t n = outline.size();
  std::vector<Vec> normals;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % n];
    normals.push_back(unit(Vec{b.y - a.y, a.x - b.x, 0}));
  }
  const auto shared = [&](std::size_t own, std::size_t neighbour) {
    return smooth && dot(normals[own], normals[neighbour]) > 0.6 ? normals[own] + normals[neighbour] : normals[own];
  };
  double along = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const Vec2 a = outline[i], b = outline[j];
    const Vec na = shared(i, (i + n - 1) % n), nb = shared(i, j);
    const double next = along + std::hypot(b.x - a.x, b.y - a.y);
    maker.quad(maker.vertex({a.x, a.y, z0}, na, {along, z0}), maker.vertex({b.x, b.y, z0}, nb, {next, z0}),
               maker.vertex({b.x, b.y, z1}, nb, {next, z1}), maker.vertex({a.x, a.y, z1}, na, {along, z1}));
    along = next;
  }
  const auto faces = triangulate(outline);
  for (const double z : {z0, z1}) {
    std::vector<std::uint32_t> corners;
    for (const Vec2 p : outline) corners.push_back(maker.vertex({p.x, p.y, z}, {0, 0, z == z0 ? -1.0 : 1.0}, {p.x, p.y}));
    for (const auto& [a, b, c] : faces) maker.triangle(corners[a], corners[b], corners[c]);
  }
  return maker.take();
}

Mesh prism(std::initializer_list<Vec2> outline, double z0, double z1, bool smooth) {
  return prism(std::span<const Vec2>(outline.begin(), outline.size()), z0, z1, smooth);
}

std::vector<Vec2> ellipse(Vec2 center, Vec2 radius, int usual_sides) {
  const int sides = sides_at_detail(usual_sides);
  std::vector<Vec2> points;
  for (int i = 0; i < sides; ++i) {
    const double a = 2 * kPi * i / sides;
    points.push_back({center.x + radius.x * std::cos(a), center.y + radius.y * std::sin(a)});
  }
  return points;
}

std::vector<Vec2> rounded_rectangle(Vec2 min, Vec2 max, double radius, int steps) {
  const double r = std::max(1e-4, std::min({radius, (max.x - min.x) / 2.001, (max.y - min.y) / 2.001}));
  std::vector<Vec2> points;
  for (int q = 0; q < 4; ++q) {
    const Vec2 c{q == 0 || q == 3 ? max.x - r : min.x + r, q < 2 ? max.y - r : min.y + r};
    for (int i = 0; i <= steps; ++i) {
      const double a = kPi / 2 * (q + static_cast<double>(i) / steps);
      points.push_back({c.x + r * std::cos(a), c.y + r * std::sin(a)});
    }
  }
  return points;
}

Mesh leaf(Vec root, Vec tip, double width, double arch, int usual_steps) {
  const int steps = steps_at_detail(usual_steps, 2);
  Maker maker;
  const Vec along = tip - root;
  const Vec flat = unit(along);
  const Vec across = unit(cross(std::abs(flat.z) > 0.98 ? Vec{0, 1, 0} : Vec{0, 0, 1}, flat));
  const Vec up = cross(flat, across);
  const double thickness = std::min(0.0025, 0.08 * width);
  const auto middle = [&](double t) { return root + along * t + up * (arch * 4 * t * (1 - t)); };
  for (const double side : {1.0, -1.0}) {
    std::vector<std::array<std::uint32_t, 3>> rows;
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const double half = i == 0 || i == steps ? 0 : width / 2 * std::pow(std::sin(kPi * std::pow(t, 0.85)), 0.8);
      const double fold = 0.25 * half;
      const Vec m = middle(t), n = up * side;
      const bool end = i == 0 || i == steps;
      const Vec core = end ? m : m - up * (side > 0 ? 0 : thickness);
      rows.push_back({maker.vertex(m - across * half + up * fold, n + across * (0.4 * side), {t * length(along), 0}),
                      maker.vertex(core, n, {t * length(along), half}),
                      maker.vertex(m + across * half + up * fold, n - across * (0.4 * side), {t * length(along), 2 * half})});
    }
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
      maker.quad(rows[i][0], rows[i][1], rows[i + 1][1], rows[i + 1][0]);
      maker.quad(rows[i][1], rows[i][2], rows[i + 1][2], rows[i + 1][1]);
    }
  }
  return maker.take();
}

Mesh waves(const Box& b, int folds, double thickness) {
  Maker maker;
  const int n = std::max(1, folds) * 8;
  const double amplitude = (b.size().y - thickness) / 2, middle = b.center().y;
  const auto y_at = [&](int i) { return middle + amplitude * std::sin(2 * kPi * i / 8.0); };
  const auto x_at = [&](int i) { return b.min.x + b.size().x * i / n; };
  std::vector<std::array<std::uint32_t, 4>> columns;  // back below, back above, front below, front above
  for (int i = 0; i <= n; ++i) {
    const double slope = amplitude * 2 * kPi / 8 * std::cos(2 * kPi * i / 8.0) / (b.size().x / n);
    const Vec normal{-slope, 1, 0};
    const double x = x_at(i), y = y_at(i), h = thickness / 2;
    columns.push_back({maker.vertex({x, y + h, b.min.z}, normal, {x, b.min.z}), maker.vertex({x, y + h, b.max.z}, normal, {x, b.max.z}),
                       maker.vertex({x, y - h, b.min.z}, normal * -1.0, {x, b.min.z}),
                       maker.vertex({x, y - h, b.max.z}, normal * -1.0, {x, b.max.z})});
  }
  for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
    const auto &a = columns[i], &c = columns[i + 1];
    maker.quad(a[0], c[0], c[1], a[1]);
    maker.quad(a[2], c[2], c[3], a[3]);
    const int k = static_cast<int>(i);
    for (const double z : {b.min.z, b.max.z}) {
      const double h = thickness / 2;
      maker.flat_quad({x_at(k), y_at(k) - h, z}, {x_at(k + 1), y_at(k + 1) - h, z}, {x_at(k + 1), y_at(k + 1) + h, z},
                      {x_at(k), y_at(k) + h, z}, {0, 0, z == b.min.z ? -1.0 : 1.0});
    }
  }
  for (const int i : {0, n}) {
    const double x = x_at(i), y = y_at(i), h = thickness / 2;
    maker.flat_quad({x, y - h, b.min.z}, {x, y + h, b.min.z}, {x, y + h, b.max.z}, {x, y - h, b.max.z}, {i == 0 ? -1.0 : 1.0, 0, 0});
  }
  return maker.take();
}

Mesh pierced_slab(double length, double z0, double z1, double y0, double y1, std::span<const Hole> holes, double more_at_start,
                  double more_at_end) {
  std::vector<double> xs{0, length}, zs{z0, z1};
  for (const Hole& hole : holes) {
    xs.insert(xs.end(), {hole.x0, hole.x1});
    zs.insert(zs.end(), {hole.z0, hole.z1});
  }
  const auto tidy = [](std::vector<double>& v) {
    std::sort(v.begin(), v.end());
    v.erase(std::unique(v.begin(), v.end(), [](double a, double b) { return b - a < 1e-6; }), v.end());
  };
  tidy(xs);
  tidy(zs);
  const auto solid = [&](std::ptrdiff_t i, std::ptrdiff_t j) {
    if (i < 0 || j < 0 || i + 1 >= std::ssize(xs) || j + 1 >= std::ssize(zs)) return false;
    const double x = (xs[static_cast<std::size_t>(i)] + xs[static_cast<std::size_t>(i + 1)]) / 2;
    const double z = (zs[static_cast<std::size_t>(j)] + zs[static_cast<std::size_t>(j + 1)]) / 2;
    return std::none_of(holes.begin(), holes.end(), [&](const Hole& h) { return x > h.x0 && x < h.x1 && z > h.z0 && z < h.z1; });
  };
  const auto outer_x = [&](double x) { return x <= 0 ? -more_at_start : x >= length ? length + more_at_end : x; };
  Maker maker;
  const auto face = [&](Vec a, Vec b, Vec c, Vec d, Vec n) {
    const auto uv = [&](Vec p) { return std::abs(n.y) > 0.5 ? Vec2{p.x, p.z} : std::abs(n.x) > 0.5 ? Vec2{p.y, p.z} : Vec2{p.x, p.y}; };
    const Vec exact = cross(c - a, d - b);
    const Vec out = dot(exact, n) < 0 ? exact * -1.0 : exact;
    maker.quad(maker.vertex(a, out, uv(a)), maker.vertex(b, out, uv(b)), maker.vertex(c, out, uv(c)), maker.vertex(d, out, uv(d)));
  };
  for (std::ptrdiff_t i = 0; i + 1 < std::ssize(xs); ++i) {
    for (std::ptrdiff_t j = 0; j + 1 < std::ssize(zs); ++j) {
      if (!solid(i, j)) continue;
      const double xa = xs[static_cast<std::size_t>(i)], xb = xs[static_cast<std::size_t>(i + 1)];
      const double za = zs[static_cast<std::size_t>(j)], zb = zs[static_cast<std::size_t>(j + 1)];
      const double oa = outer_x(xa), ob = outer_x(xb);
      face({xa, y1, za}, {xb, y1, za}, {xb, y1, zb}, {xa, y1, zb}, {0, 1, 0});
      face({oa, y0, za}, {ob, y0, za}, {ob, y0, zb}, {oa, y0, zb}, {0, -1, 0});
      if (!solid(i - 1, j)) face({xa, y1, za}, {oa, y0, za}, {oa, y0, zb}, {xa, y1, zb}, {-1, 0, 0});
      if (!solid(i + 1, j)) face({xb, y1, za}, {ob, y0, za}, {ob, y0, zb}, {xb, y1, zb}, {1, 0, 0});
      if (!solid(i, j - 1)) face({xa, y1, za}, {xb, y1, za}, {ob, y0, za}, {oa, y0, za}, {0, 0, -1});
      if (!solid(i, j + 1)) face({xa, y1, zb}, {xb, y1, zb}, {ob, y0, zb}, {oa, y0, zb}, {0, 0, 1});
    }
  }
  return maker.take();
}

}  // namespace layoutbox::kit
