#include "layoutbox/furnish/simplify.h"

#include <meshoptimizer.h>

#include <vector>

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

void simplify(Mesh& mesh, std::size_t most) {
  const std::size_t count = mesh.positions.size();
  std::vector<std::uint32_t> indices(mesh.indices.size());
  indices.resize(meshopt_simplify(indices.data(), mesh.indices.data(), mesh.indices.size(), mesh.positions.front().data(), count,
                                  sizeof(Vec3f), most * 3, kLargestError, 0, nullptr));
  if (indices.empty()) return;  // a part that would vanish stays
  std::vector<unsigned> places(count);
  const std::size_t used = meshopt_optimizeVertexFetchRemap(places.data(), indices.data(), indices.size(), count);
  mesh.indices.resize(indices.size());
  meshopt_remapIndexBuffer(mesh.indices.data(), indices.data(), indices.size(), places.data());
  keep_used(mesh.positions, places, used);
  keep_used(mesh.normals, places, used);
  keep_used(mesh.uvs, places, used);
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
