// What tests ask of a finished piece.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include "layoutbox/furnish/kit.h"

namespace layoutbox::mesh_checks {

inline kit::Box bounds_of(const Node& node) {
  kit::Box b{{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
  for (const Part& part : node.parts) {
    const kit::Box m = kit::bounds(part.mesh);
    b.min = {std::min(b.min.x, m.min.x), std::min(b.min.y, m.min.y), std::min(b.min.z, m.min.z)};
    b.max = {std::max(b.max.x, m.max.x), std::max(b.max.y, m.max.y), std::max(b.max.z, m.max.z)};
  }
  return b;
}

inline std::size_t triangles_of(const Node& node) {
  std::size_t n = 0;
  for (const Part& part : node.parts) n += part.mesh.indices.size() / 3;
  return n;
}

// Edges, by position (to a micrometre), that are not walked as often one way as the other: 0 for a closed, consistently wound mesh.
inline int open_edges(const Mesh& mesh) {
  using Key = std::array<long, 3>;
  const auto key = [&](std::uint32_t i) {
    const Vec3f& p = mesh.positions[i];
    return Key{std::lround(static_cast<double>(p[0]) * 1e6), std::lround(static_cast<double>(p[1]) * 1e6),
               std::lround(static_cast<double>(p[2]) * 1e6)};
  };
  std::map<std::pair<Key, Key>, int> balance;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Key a = key(mesh.indices[i + k]), b = key(mesh.indices[i + (k + 1) % 3]);
      if (a == b) continue;
      if (a < b) {
        ++balance[{a, b}];
      } else {
        --balance[{b, a}];
      }
    }
  }
  return static_cast<int>(std::count_if(balance.begin(), balance.end(), [](const auto& e) { return e.second != 0; }));
}

// Volume by the signed tetrahedra of its triangles: positive when the faces look outwards.
inline double volume(const Mesh& mesh) {
  double v = 0;
  const auto at = [&](std::size_t i) {
    const Vec3f& p = mesh.positions[mesh.indices[i]];
    return kit::Vec{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) v += dot(at(i), cross(at(i + 1), at(i + 2))) / 6;
  return v;
}

// Whether a triangle reaches into a box (separating axes), the box made smaller by `slack` on all sides.
inline bool reaches_into(kit::Vec a, kit::Vec b, kit::Vec c, const kit::Box& outer, double slack) {
  using kit::Vec;
  const Vec center = outer.center(), half = outer.size() * 0.5 - Vec{slack, slack, slack};
  if (half.x <= 0 || half.y <= 0 || half.z <= 0) return false;
  const std::array<Vec, 3> p{a - center, b - center, c - center};
  const std::array<Vec, 3> edges{p[1] - p[0], p[2] - p[1], p[0] - p[2]};
  const std::array<Vec, 3> axes{Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0, 0, 1}};
  const auto separates = [&](const Vec& axis) {
    if (length(axis) < 1e-12) return false;
    const double r = half.x * std::abs(axis.x) + half.y * std::abs(axis.y) + half.z * std::abs(axis.z);
    const double u = dot(p[0], axis), v = dot(p[1], axis), w = dot(p[2], axis);
    return std::min({u, v, w}) > r || std::max({u, v, w}) < -r;
  };
  if (separates(cross(edges[0], edges[1]))) return false;
  for (const Vec& axis : axes) {
    if (separates(axis)) return false;
    for (const Vec& edge : edges) {
      if (separates(cross(axis, edge))) return false;
    }
  }
  return true;
}

// The first corner of a triangle of the node that reaches into the box, as text; empty when none does.
inline std::string intrusion(const Node& node, const kit::Box& space, double slack) {
  for (const Part& part : node.parts) {
    const auto at = [&](std::size_t i) {
      const Vec3f& p = part.mesh.positions[part.mesh.indices[i]];
      return kit::Vec{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
    };
    for (std::size_t i = 0; i + 2 < part.mesh.indices.size(); i += 3) {
      if (!reaches_into(at(i), at(i + 1), at(i + 2), space, slack)) continue;
      const kit::Vec m = (at(i) + at(i + 1) + at(i + 2)) * (1.0 / 3);
      return "triangle about (" + std::to_string(m.x) + ", " + std::to_string(m.y) + ", " + std::to_string(m.z) + ")";
    }
  }
  return {};
}

}  // namespace layoutbox::mesh_checks
