#include "layoutbox/export/gltf_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "layoutbox/base/units.h"

namespace layoutbox {
namespace {

constexpr float kFacing = 0.7f;  // of a unit normal: looks that way
constexpr float kFlush = 0.95f;  // looks straight that way: more than the mitred end of a wall at a sharp corner does
constexpr float kNear = 1e-4f;   // metres

float dot(const Vec3f& a, const Vec3f& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// A wall's direction into the room, in the node's own frame: `inward` is the room's, normals are the node's.
Vec3f inward_of(const Node& wall) {
  const double turn = radians_from_degrees(double{wall.rotation_deg}), c = std::cos(turn), s = std::sin(turn);
  const double x = double{(*wall.inward)[0]}, y = double{(*wall.inward)[1]};
  return {static_cast<float>(c * x + s * y), static_cast<float>(c * y - s * x), 0};
}

struct FaceReach {
  float least = std::numeric_limits<float>::max(), most = std::numeric_limits<float>::lowest();
};

// How far a wall reaches along itself and upwards: what looks outwards there is no reveal.
struct WallReach {
  FaceReach along, up;
  Vec3f direction;

  WallReach(const Mesh& mesh, const Vec3f& inward) : direction{inward[1], -inward[0], 0} {
    for (const Vec3f& p : mesh.positions) {
      for (const auto& [reach, value] : {std::pair{&along, dot(p, direction)}, {&up, p[2]}}) {
        reach->least = std::min(reach->least, value);
        reach->most = std::max(reach->most, value);
      }
    }
  }

  bool is_at_end(const Vec3f& p, bool upright) const {
    const FaceReach& reach = upright ? up : along;
    const float value = upright ? p[2] : dot(p, direction);
    return value < reach.least + kNear || value > reach.most - kNear;
  }
};

template <class Keep>
std::vector<std::uint32_t> kept(const Mesh& mesh, const Keep& keep) {
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    if (keep(&mesh.indices[i])) indices.insert(indices.end(), {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
  }
  return indices;
}

}  // namespace

std::vector<std::uint32_t> exported_triangles(const Mesh& mesh, const Node& node) {
  if (node.kind == NodeKind::kCeiling) {
    return kept(mesh, [&](const std::uint32_t* corner) { return mesh.normals[corner[0]][2] <= kFacing; });
  }
  if (node.kind != NodeKind::kWall || !node.inward) return mesh.indices;
  const Vec3f inward = inward_of(node);
  const WallReach reach(mesh, inward);
  return kept(mesh, [&](const std::uint32_t* corner) {
    const Vec3f& normal = mesh.normals[corner[0]];
    const float in = dot(normal, inward);
    if (in > kFlush) return true;
    if (in < -kFacing) return false;
    const bool upright = std::abs(normal[2]) > kFacing;
    return std::none_of(corner, corner + 3, [&](std::uint32_t i) { return reach.is_at_end(mesh.positions[i], upright); });
  });
}

}  // namespace layoutbox
