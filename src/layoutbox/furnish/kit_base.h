// What the kit's own files share: adding vertices and triangles that face outwards.
#pragma once

#include <algorithm>
#include <cmath>

#include "layoutbox/base/units.h"
#include "layoutbox/furnish/kit.h"

namespace layoutbox::kit {

class Maker {
 public:
  std::uint32_t vertex(Vec position, Vec normal, Vec2 uv) {
    mesh_.positions.push_back(single(position));
    mesh_.normals.push_back(single(unit(normal)));
    mesh_.uvs.push_back({static_cast<float>(uv.x), static_cast<float>(uv.y)});
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }

  // Wound so that it faces the way its vertices' normals point; a triangle without area is left out.
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vec face = cross(position(b) - position(a), position(c) - position(a));
    if (a == b || b == c || c == a || length(face) < 1e-15) return;
    if (dot(face, normal(a) + normal(b) + normal(c)) < 0) std::swap(b, c);
    mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
  }

  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }

  // As given, whatever the normals say: where a surface bends so sharply that they mislead.
  void wound_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh_.indices.insert(mesh_.indices.end(), {a, b, c, a, c, d});
  }

  // Four corners in a plane, with a normal of their own; u runs along the longer side.
  void flat_quad(Vec a, Vec b, Vec c, Vec d, Vec outward) {
    Vec n = cross(c - a, d - b);
    if (dot(n, outward) < 0) n = n * -1.0;
    const double ab = std::max(length(b - a), length(c - d));
    const double ad = std::max(length(d - a), length(c - b));
    const bool along_ab = ab >= ad;
    const auto uv = [&](double s, double t) { return along_ab ? Vec2{s * ab, t * ad} : Vec2{t * ad, s * ab}; };
    quad(vertex(a, n, uv(0, 0)), vertex(b, n, uv(1, 0)), vertex(c, n, uv(1, 1)), vertex(d, n, uv(0, 1)));
  }

  void wound_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh_.indices.insert(mesh_.indices.end(), {a, b, c}); }

  Mesh take() { return std::move(mesh_); }

 private:
  static Vec3f single(Vec v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }
  static Vec wide(const Vec3f& v) { return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])}; }
  Vec position(std::uint32_t i) const { return wide(mesh_.positions[i]); }
  Vec normal(std::uint32_t i) const { return wide(mesh_.normals[i]); }

  Mesh mesh_;
};

}  // namespace layoutbox::kit
