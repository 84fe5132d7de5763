// Any bytes as a mesh of the user's own: the first byte says which kind of file. Nothing may crash, and what is read can be fitted to a
// size.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "layoutbox/base/files.h"
#include "layoutbox/furnish/mesh_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace layoutbox;
  if (size == 0) return 0;
  static const auto folder = TemporaryFolder::make("fuzz-mesh").value();
  const std::array<const char*, 3> names{"mesh.obj", "mesh.gltf", "mesh.glb"};
  const std::string name = names[data[0] % names.size()];
  std::ofstream(folder.path() / name, std::ios::binary)
      .write(reinterpret_cast<const char*>(data + 1), static_cast<std::streamsize>(size - 1));
  const std::array<std::filesystem::path, 1> folders{folder.path()};
  Result<MeshFile> mesh = read_mesh_file(folders, name);
  if (!mesh) return 0;
  for (const Part& part : mesh->parts) {
    const std::size_t count = part.mesh.positions.size();
    if (part.mesh.normals.size() != count || part.mesh.uvs.size() != count) std::abort();
    for (const std::uint32_t index : part.mesh.indices) {
      if (index >= count) std::abort();
    }
  }
  MeshFile wall = *mesh;
  if (!fit_mesh(*mesh, {1, 1, 1}, "", Mount::kFloor)) std::abort();
  fit_wall_mesh(wall, {4, 0.1, 3});
  return 0;
}
