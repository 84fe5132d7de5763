// The readers of the single kinds of mesh files, for mesh_file.cc.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/furnish/mesh_file.h"

namespace layoutbox {

struct AssetPlace {
  std::string name;                            // as the user wrote it
  std::filesystem::path path;                  // where it is
  std::vector<std::filesystem::path> folders;  // where what it names must be
  MeshLimits limits;
};

// What is said of a file with more triangles than its limits allow.
Failure too_many_triangles(const AssetPlace& place);

Result<MeshFile> read_gltf(const AssetPlace& place);
Result<MeshFile> read_obj(const AssetPlace& place);

// Where a file of that name is in the folders; errors as of read_mesh_file().
Result<std::filesystem::path> find_asset(std::span<const std::filesystem::path> folders, const std::string& name);
// "image/png", "image/jpeg" or empty.
std::string_view image_kind(std::string_view bytes);

// A PNG is whole. Errors: kParse, with the name.
Status check_image(std::string_view bytes, const std::string& name);

}  // namespace layoutbox
