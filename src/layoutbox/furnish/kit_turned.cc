// Round bodies: lathe, cylinders, rods and tubes, ellipsoids.
#include "layoutbox/furnish/kit_base.h"
#include "layoutbox/furnish/kit_detail.h"

namespace layoutbox::kit {
namespace {

const double kSmoothCosine = std::cos(radians_from_degrees(40));

Vec2 outward(Vec2 a, Vec2 b) {
  const double l = std::hypot(b.x - a.x, b.y - a.y);
  return l > 1e-12 ? Vec2{(b.y - a.y) / l, -(b.x - a.x) / l} : Vec2{1, 0};
}

// The normal at an end of a profile's segment: shared with its neighbour where the edge between them is blunt.
Vec2 joint_normal(Vec2 own, Vec2 neighbour) {
  if (own.x * neighbour.x + own.y * neighbour.y < kSmoothCosine) return own;
  return {own.x + neighbour.x, own.y + neighbour.y};
}

}  // namespace

Mesh lathe(std::span<const Vec2> profile, int usual_sides, double squash) {
  const int sides = sides_at_detail(usual_sides);
  Maker maker;
  const std::size_t n = profile.size();
  const bool closed = n > 2 && std::hypot(profile[0].x - profile[n - 1].x, profile[0].y - profile[n - 1].y) < 1e-9;
  std::vector<Vec2> normals;
  for (std::size_t i = 0; i + 1 < n; ++i) normals.push_back(outward(profile[i], profile[i + 1]));
  double along = 0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const Vec2 a = profile[i], b = profile[i + 1], own = normals[i];
    const bool has_before = i > 0 || closed, has_after = i + 2 < n || closed;
    const Vec2 na = has_before ? joint_normal(own, normals[i > 0 ? i - 1 : n - 2]) : own;
    const Vec2 nb = has_after ? joint_normal(own, normals[i + 2 < n ? i + 1 : 0]) : own;
    const bool flat = std::abs(own.x) < 0.1;
    const double next = along + std::hypot(b.x - a.x, b.y - a.y), r = std::max(a.x, b.x);
    std::uint32_t previous_a = 0, previous_b = 0;
    for (int k = 0; k <= sides; ++k) {
      const double t = 2 * kPi * k / sides, c = k == sides ? 1 : std::cos(t), s = k == sides ? 0 : std::sin(t);
      const auto put = [&](Vec2 p, Vec2 m, double u) {
        const Vec at{p.x * c, p.x * s * squash, p.y};
        return maker.vertex(at, {m.x * c, m.x * s / squash, m.y}, flat ? Vec2{at.x, at.y} : Vec2{u, t * r});
      };
      const std::uint32_t va = put(a, na, along), vb = put(b, nb, next);
      if (k > 0) maker.quad(previous_a, va, vb, previous_b);
      previous_a = va;
      previous_b = vb;
    }
    along = next;
  }
  return maker.take();
}

Mesh lathe(std::initializer_list<Vec2> profile, int sides, double squash) {
  return lathe(std::span<const Vec2>(profile.begin(), profile.size()), sides, squash);
}

Mesh cylinder(Vec below, double radius, double height, int sides) { return cone(below, radius, radius, height, sides); }

Mesh cone(Vec below, double radius_below, double radius_above, double height, int sides) {
  const double e = std::min({0.004, 0.2 * height, 0.25 * std::max(radius_below, radius_above)});
  std::vector<Vec2> profile{{0, 0}};
  if (radius_below > e) profile.push_back({radius_below - e, 0});
  const double slope = (radius_above - radius_below) / height;
  if (radius_below > e) profile.push_back({radius_below + slope * e, e});
  if (radius_above > e) {
    profile.push_back({radius_above - slope * e, height - e});
    profile.push_back({radius_above - e, height});
  }
  profile.push_back({0, height});
  return posed(lathe(profile, sides), moved(below));
}

Mesh leg(Vec below, Vec above, double radius_below, double radius_above, int sides) {
  return posed(lathe({{0, 0}, {radius_below, 0}, {radius_above, 1}, {0, 1}}, sides), {{1, 0, 0}, {0, 1, 0}, above - below, below});
}

Mesh rod(Vec from, Vec to, double radius, int sides) {
  return posed(lathe({{0, 0}, {radius, 0}, {radius, length(to - from)}, {0, length(to - from)}}, sides), aimed(from, to - from));
}

namespace {

// The way a path runs at one of its points: between the ways from the point before and to the next.
Vec tangent_at(std::span<const Vec> path, std::size_t i, bool closed) {
  const std::size_t n = path.size();
  const Vec before = i > 0 ? path[i - 1] : closed ? path[n - 1] : path[0];
  const Vec after = i + 1 < n ? path[i + 1] : closed ? path[0] : path[n - 1];
  return unit(unit(after - path[i]) * (i + 1 < n || closed ? 1.0 : 0.0) + unit(path[i] - before) * (i > 0 || closed ? 1.0 : 0.0));
}

// A section of a tube: its middle, two directions across, the radius.
struct Section {
  Vec middle, across, up;
  double radius;
  int sides;

  Vec normal(int s) const {
    const double a = 2 * kPi * (s % sides) / sides;
    return across * std::cos(a) + up * std::sin(a);
  }
};

std::vector<std::uint32_t> add_section(Maker& maker, const Section& section, double along) {
  std::vector<std::uint32_t> ring;
  for (int s = 0; s <= section.sides; ++s) {
    const Vec normal = section.normal(s);
    ring.push_back(maker.vertex(section.middle + normal * section.radius, normal, {along, 2 * kPi * s / section.sides * section.radius}));
  }
  return ring;
}

void close_end(Maker& maker, const Section& section, Vec outwards) {
  std::vector<std::uint32_t> rim;
  for (int s = 0; s < section.sides; ++s)
    rim.push_back(maker.vertex(section.middle + section.normal(s) * section.radius, outwards, {0, 0}));
  for (std::size_t s = 1; s + 1 < rim.size(); ++s) maker.triangle(rim[0], rim[s], rim[s + 1]);
}

}  // namespace

Mesh tube(std::span<const Vec> path, double radius, int usual_sides, bool closed) {
  const std::size_t n = path.size();
  if (n < 2) return {};
  Maker maker;
  const Vec first = tangent_at(path, 0, closed), across_first = unit(cross(std::abs(first.z) > 0.9 ? Vec{0, 1, 0} : Vec{0, 0, 1}, first));
  Vec side = across_first;
  std::vector<std::uint32_t> previous;
  double along = 0;
  for (std::size_t k = 0; k < (closed ? n + 1 : n); ++k) {
    const std::size_t i = k % n;
    const Vec t = tangent_at(path, i, closed);
    if (k < n) side = unit(side - t * dot(side, t));
    // A closed tube ends on its own first ring, turned as that one is.
    const Vec across = k == n ? across_first : side;
    const Section section{path[i], across, cross(t, across), radius, sides_at_detail(usual_sides)};
    if (k > 0) along += length(path[i] - path[(k - 1) % n]);
    std::vector<std::uint32_t> ring = add_section(maker, section, along);
    for (std::size_t s = 0; s + 1 < ring.size() && !previous.empty(); ++s)
      maker.wound_quad(previous[s], previous[s + 1], ring[s + 1], ring[s]);
    if (!closed && k == 0) close_end(maker, section, t * -1.0);
    if (!closed && k + 1 == n) close_end(maker, section, t);
    previous = std::move(ring);
  }
  return maker.take();
}

Mesh tube(std::initializer_list<Vec> path, double radius, int sides, bool closed) {
  return tube(std::span<const Vec>(path.begin(), path.size()), radius, sides, closed);
}

std::vector<Vec> curve(std::span<const Vec> points, int usual_steps, bool closed) {
  const int steps = steps_at_detail(usual_steps, 2);
  // Catmull-Rom through the points.
  const int n = static_cast<int>(points.size());
  const auto at = [&](int i) { return points[static_cast<std::size_t>(closed ? (i + n) % n : std::clamp(i, 0, n - 1))]; };
  std::vector<Vec> line;
  for (int i = 0; i < (closed ? n : n - 1); ++i) {
    const Vec a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
    for (int k = 0; k < steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      line.push_back((b * 2.0 + (c - a) * t + (a * 2.0 - b * 5.0 + c * 4.0 - d) * (t * t) + (b * 3.0 - a - c * 3.0 + d) * (t * t * t)) *
                     0.5);
    }
  }
  if (!closed) line.push_back(points.back());
  return line;
}

std::vector<Vec> curve(std::initializer_list<Vec> points, int steps, bool closed) {
  return curve(std::span<const Vec>(points.begin(), points.size()), steps, closed);
}

Mesh torus(Vec center, double radius, double thickness, int sides, int section) {
  std::vector<Vec2> profile;
  for (int i = 0; i <= section; ++i) {
    const double a = 2 * kPi * (i % section) / section;
    profile.push_back({radius + thickness * std::cos(a), thickness * std::sin(a)});
  }
  return posed(lathe(profile, sides), moved(center));
}

Mesh ellipsoid(Vec center, Vec radius, int sides, int usual_rings) {
  const int rings = steps_at_detail(usual_rings, 4);
  std::vector<Vec2> profile;
  for (int i = 0; i <= rings; ++i) {
    const double a = kPi * i / rings - kPi / 2;
    profile.push_back({i == 0 || i == rings ? 0 : std::cos(a), std::sin(a)});
  }
  Mesh mesh = lathe(profile, sides);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) mesh.normals[i] = mesh.positions[i];
  return posed(std::move(mesh), moved(center) * scaled(radius.x, radius.y, radius.z));
}

}  // namespace layoutbox::kit
