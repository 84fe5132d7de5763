#include "layoutbox/furnish/kit.h"

#include "layoutbox/furnish/kit_base.h"

namespace layoutbox::kit {

double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
double length(Vec a) { return std::sqrt(dot(a, a)); }
Vec unit(Vec a) {
  const double l = length(a);
  return l > 1e-12 ? a * (1 / l) : Vec{0, 0, 1};
}

Pose operator*(const Pose& a, const Pose& b) {
  const auto direction = [&](Vec v) { return a.x * v.x + a.y * v.y + a.z * v.z; };
  return {direction(b.x), direction(b.y), direction(b.z), a.point(b.origin)};
}

Pose moved(Vec by) { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, by}; }
Pose moved(double x, double y, double z) { return moved(Vec{x, y, z}); }

Pose turned_x(double degrees) {
  const double c = std::cos(radians_from_degrees(degrees)), s = std::sin(radians_from_degrees(degrees));
  return {{1, 0, 0}, {0, c, s}, {0, -s, c}, {}};
}
Pose turned_y(double degrees) {
  const double c = std::cos(radians_from_degrees(degrees)), s = std::sin(radians_from_degrees(degrees));
  return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}, {}};
}
Pose turned_z(double degrees) {
  const double c = std::cos(radians_from_degrees(degrees)), s = std::sin(radians_from_degrees(degrees));
  return {{c, s, 0}, {-s, c, 0}, {0, 0, 1}, {}};
}
Pose scaled(double x, double y, double z) { return {{x, 0, 0}, {0, y, 0}, {0, 0, z}, {}}; }

Pose aimed(Vec from, Vec direction) {
  const Vec z = unit(direction);
  const Vec x = unit(cross(std::abs(z.z) > 0.99 ? Vec{0, 1, 0} : Vec{0, 0, 1}, z));
  return {x, cross(z, x), z, from};
}

Mesh posed(Mesh mesh, const Pose& pose) {
  // Normals go by the cofactors, so that uneven scaling and mirroring stay right.
  const Vec nx = cross(pose.y, pose.z), ny = cross(pose.z, pose.x), nz = cross(pose.x, pose.y);
  const bool mirrored = dot(pose.x, nx) < 0;
  for (Vec3f& p : mesh.positions) {
    const Vec q = pose.point({static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    p = {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
  }
  for (Vec3f& n : mesh.normals) {
    Vec q = unit(nx * static_cast<double>(n[0]) + ny * static_cast<double>(n[1]) + nz * static_cast<double>(n[2]));
    if (mirrored) q = q * -1.0;
    n = {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
  }
  if (mirrored) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  }
  return mesh;
}

void append(Mesh& to, const Mesh& from) {
  const auto base = static_cast<std::uint32_t>(to.positions.size());
  to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
  to.normals.insert(to.normals.end(), from.normals.begin(), from.normals.end());
  to.uvs.insert(to.uvs.end(), from.uvs.begin(), from.uvs.end());
  for (const std::uint32_t i : from.indices) to.indices.push_back(base + i);
}

Box bounds(const Mesh& mesh) {
  Box b{{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
  for (const Vec3f& f : mesh.positions) {
    const Vec p{static_cast<double>(f[0]), static_cast<double>(f[1]), static_cast<double>(f[2])};
    b.min = {std::min(b.min.x, p.x), std::min(b.min.y, p.y), std::min(b.min.z, p.z)};
    b.max = {std::max(b.max.x, p.x), std::max(b.max.y, p.y), std::max(b.max.z, p.z)};
  }
  return b;
}

}  // namespace layoutbox::kit
