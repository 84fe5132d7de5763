#include "layoutbox/furnish/simplify.h"

#include <meshoptimizer.h>

#include <array>
#include <vector>

#include "layoutbox/furnish/kit.h"

namespace layoutbox {
namespace {

constexpr float kLargestError = 0.02f;  // of a part's size

std::size_t triangles_of(const Mesh& mesh) { return mesh.indices.size() / 3; }

// What no triangle names any more goes.
template <class Row>
void keep_used(std::vector<Row>& rows, const std::vector<unsigned>& places, std::size_t used) {
  if (rows.empty()) return;
  std::vector<Row> kept(used);
  meshopt_remapVertexBuffer(kept.data(), rows.data(), rows.size(), sizeof(Row), places.data());
  rows = std::move(kept);
}

// Rows go to their places; rows that have the same place become one.
void put(Mesh& mesh, const std::vector<unsigned>& places, std::size_t used) {
  meshopt_remapIndexBuffer(mesh.indices.data(), mesh.indices.data(), mesh.indices.size(), places.data());
  keep_used(mesh.positions, places, used);
  keep_used(mesh.normals, places, used);
  keep_used(mesh.uvs, places, used);
}

// Corners that are the same become one: readers of files without shared corners (OBJ, STL turned into glTF) give each triangle its own,
// and no edge of such a mesh can collapse.
void weld(Mesh& mesh, bool with_normals) {
  std::vector<meshopt_Stream> streams = {{mesh.positions.data(), sizeof(Vec3f), sizeof(Vec3f)}};
  if (with_normals && !mesh.normals.empty()) streams.push_back({mesh.normals.data(), sizeof(Vec3f), sizeof(Vec3f)});
  if (!mesh.uvs.empty()) streams.push_back({mesh.uvs.data(), sizeof(Vec2f), sizeof(Vec2f)});
  std::vector<unsigned> places(mesh.positions.size());
  const std::size_t used = meshopt_generateVertexRemapMulti(places.data(), mesh.indices.data(), mesh.indices.size(), mesh.positions.size(),
                                                            streams.data(), streams.size());
  put(mesh, places, used);
}

// Each corner looks where the triangles around it look, larger ones more.
void smooth_normals(Mesh& mesh) {
  std::vector<kit::Vec> sums(mesh.positions.size());
  const auto at = [&](std::uint32_t i) { return kit::Vec{mesh.positions[i][0], mesh.positions[i][1], mesh.positions[i][2]}; };
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const auto [a, b, c] = std::array{mesh.indices[t], mesh.indices[t + 1], mesh.indices[t + 2]};
    const kit::Vec area = kit::cross(at(b) - at(a), at(c) - at(a));
    for (const std::uint32_t i : {a, b, c}) sums[i] = sums[i] + area;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const kit::Vec n = kit::unit(sums[i]);
    mesh.normals[i] = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
  }
}

void collapse(Mesh& mesh, std::size_t most) {
  const std::size_t count = mesh.positions.size();
  std::vector<std::uint32_t> indices(mesh.indices.size());
  indices.resize(meshopt_simplify(indices.data(), mesh.indices.data(), mesh.indices.size(), mesh.positions.front().data(), count,
                                  sizeof(Vec3f), most * 3, kLargestError, 0, nullptr));
  if (indices.empty()) return;  // a part that would vanish stays
  mesh.indices = std::move(indices);
  std::vector<unsigned> places(count);
  const std::size_t used = meshopt_optimizeVertexFetchRemap(places.data(), mesh.indices.data(), mesh.indices.size(), count);
  put(mesh, places, used);
}

void simplify(Mesh& mesh, std::size_t most) {
  weld(mesh, true);
  collapse(mesh, most);
  if (triangles_of(mesh) <= 2 * most) return;
  // Flat triangles, each with its own normal: of so many none is seen as one, and a smooth surface is what they were cut from.
  weld(mesh, false);
  if (!mesh.normals.empty()) smooth_normals(mesh);
  collapse(mesh, most);
}

}  // namespace

std::size_t most_triangles(Detail detail) {
  switch (detail) {
    case Detail::kLow: return 5'000;
    case Detail::kUsual: return 20'000;
    case Detail::kHigh: return 100'000;
  }
  return 20'000;
}

void simplify(MeshFile& mesh, std::size_t most) {
  std::size_t all = 0;
  for (const Part& part : mesh.parts) all += triangles_of(part.mesh);
  if (all <= most) return;
  for (Part& part : mesh.parts) {
    if (!part.mesh.indices.empty()) simplify(part.mesh, triangles_of(part.mesh) * most / all);
  }
}

}  // namespace layoutbox
