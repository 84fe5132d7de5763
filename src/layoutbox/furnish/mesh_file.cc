#include "layoutbox/furnish/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "layoutbox/base/files.h"
#include "layoutbox/base/png_check.h"
#include "layoutbox/furnish/mesh_readers.h"

namespace layoutbox {
namespace {

namespace fs = std::filesystem;

// Whether a path lies within a folder, links followed.
bool lies_in(const fs::path& path, const fs::path& folder) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end();
}

constexpr double kFlat = 1e-9;  // metres: no length at all

double ratio(double wanted, double is) { return is > kFlat ? wanted / is : 1e9; }

kit::Box bounds_of(const MeshFile& mesh) {
  kit::Box box{{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
  for (const Part& part : mesh.parts) {
    const kit::Box b = kit::bounds(part.mesh);
    box.min = {std::min(box.min.x, b.min.x), std::min(box.min.y, b.min.y), std::min(box.min.z, b.min.z)};
    box.max = {std::max(box.max.x, b.max.x), std::max(box.max.y, b.max.y), std::max(box.max.z, b.max.z)};
  }
  return box;
}

void pose_parts(MeshFile& mesh, const kit::Pose& pose) {
  for (Part& part : mesh.parts) part.mesh = kit::posed(std::move(part.mesh), pose);
}

}  // namespace

Result<fs::path> find_asset(std::span<const fs::path> folders, const std::string& name) {
  const auto error = [&](ErrorCode code, std::string_view why, std::string_view hint) {
    return fail(code, fmt::format("the file \"{}\" {}", name, why), name, std::string(hint));
  };
  if (fs::path(name).is_absolute()) {
    return error(ErrorCode::kUsage, "is named by a whole path", "name it relative to the scene file, in its folder or below");
  }
  bool outside = false;
  for (const fs::path& folder : folders) {
    std::error_code code;
    const fs::path root = fs::canonical(folder.empty() ? "." : folder, code);
    if (code) continue;
    const fs::path path = fs::weakly_canonical(root / name, code);
    if (code || !lies_in(path, root)) {
      outside = true;
      continue;
    }
    if (fs::is_regular_file(path, code)) return path;
  }
  if (outside) return error(ErrorCode::kUsage, "lies outside the folder of the scene", "put it into that folder, or below it");
  return error(ErrorCode::kIo, "is not there", "names count from the scene file's folder, or from --assets");
}

Result<std::string> read_image_file(std::span<const fs::path> folders, const std::string& name, std::size_t most_bytes) {
  LAYOUTBOX_ASSIGN(const fs::path path, find_asset(folders, name));
  LAYOUTBOX_ASSIGN(std::string bytes, read_file(path, most_bytes));
  if (image_kind(bytes).empty()) return fail(ErrorCode::kParse, fmt::format("\"{}\" is neither a PNG nor a JPEG picture", name), name);
  LAYOUTBOX_CHECK(check_image(bytes, name));
  return bytes;
}

Status check_image(std::string_view bytes, const std::string& name) {
  if (image_kind(bytes) != "image/png") return {};
  const auto size = check_png(bytes);
  if (size) return {};
  return fail(ErrorCode::kParse, fmt::format("\"{}\": {}", name, size.error().message), name, "save it again");
}

std::string_view image_kind(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return "image/png";
  return bytes.starts_with("\xff\xd8\xff") ? "image/jpeg" : "";
}

Failure too_many_triangles(const AssetPlace& place) {
  return fail(ErrorCode::kTooLarge, fmt::format("\"{}\" has more than {} triangles", place.name, place.limits.most_triangles), place.name,
              "simplify it first (in Blender: the modifier Decimate)");
}

Result<MeshFile> read_mesh_file(std::span<const fs::path> folders, const std::string& name, const MeshLimits& limits) {
  LAYOUTBOX_ASSIGN(const fs::path path, find_asset(folders, name));
  std::error_code ignored;
  if (const auto bytes = fs::file_size(path, ignored); bytes > limits.most_bytes) {
    return fail(ErrorCode::kTooLarge,
                fmt::format("\"{}\" is {} MB large; at most {} MB are read", name, bytes >> 20, limits.most_bytes >> 20), name);
  }
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const AssetPlace place{name, path, {path.parent_path()}, limits};
  Result<MeshFile> mesh = fail(ErrorCode::kParse, fmt::format("\"{}\" is no glTF, GLB or OBJ file", name), name, "export it as GLB");
  if (ending == ".glb" || ending == ".gltf") mesh = read_gltf(place);
  if (ending == ".obj") mesh = read_obj(place);
  if (!mesh) return mesh;
  std::size_t triangles = 0;
  for (const Part& part : mesh->parts) triangles += part.mesh.indices.size() / 3;
  if (triangles == 0) return fail(ErrorCode::kParse, fmt::format("there are no triangles in \"{}\"", name), name);
  if (triangles > limits.most_triangles) return too_many_triangles(place);
  return mesh;
}

Status fit_mesh(MeshFile& mesh, kit::Vec size, std::string_view front, Mount mount) {
  // From the file's axes (x, y up, z) into ours, then about z.
  kit::Pose turn;
  std::string axis(front);
  std::erase_if(axis, [](char c) { return c == '+' || c == ' '; });
  std::transform(axis.begin(), axis.end(), axis.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (axis == "x") {
    turn = kit::turned_z(-90);
  } else if (axis == "-x") {
    turn = kit::turned_z(90);
  } else if (axis == "-z") {
    turn = kit::turned_z(180);
  } else if (axis == "y" || axis == "-y") {  // a file whose z is up: undo what was done for y
    turn = kit::turned_z(axis == "y" ? 180 : 0) * kit::turned_x(-90);
  } else if (!axis.empty() && axis != "z") {
    return fail(ErrorCode::kSchema, fmt::format("\"{}\" is no direction of a mesh", front), "meshFront", "use +x, -x, +y, -y, +z or -z");
  }
  pose_parts(mesh, turn);
  const kit::Box box = bounds_of(mesh);
  const kit::Vec has = box.size(), c = box.center();
  double kx = ratio(size.x, has.x), ky = ratio(size.y, has.y), kz = ratio(size.z, has.z);
  const double least = std::min({kx, ky, kz}), most = std::max({kx, ky, kz});
  if (most > least * 1.03) kx = ky = kz = least;
  const double up = mount == Mount::kCeiling || mount == Mount::kHung ? size.z - has.z * kz
                    : mount == Mount::kWall                           ? (size.z - has.z * kz) / 2
                                                                      : 0;
  const double back = mount == Mount::kWall ? size.y / 2 - has.y * ky / 2 : 0;
  const kit::Pose pose = kit::moved(0, back, up) * kit::scaled(kx, ky, kz) * kit::moved(-c.x, -c.y, -box.min.z);
  pose_parts(mesh, pose);
  return {};
}

void fit_wall_mesh(MeshFile& mesh, kit::Vec size) {
  const kit::Box box = bounds_of(mesh);
  const kit::Vec has = box.size(), c = box.center();
  const double kx = ratio(size.x, has.x), kz = ratio(size.z, has.z), ky = std::min({kx, kz, ratio(size.y, has.y)});
  const bool flat_x = has.x <= kFlat, flat_z = has.z <= kFlat;
  // Its front, −y, looks into the room, which is at +y of a wall's frame; the inner face is the wall's.
  pose_parts(mesh, kit::moved(size.x / 2, 0, 0) * kit::turned_z(180) * kit::scaled(flat_x ? 1 : kx, ky, flat_z ? 1 : kz) *
                       kit::moved(-c.x, -box.min.y, -box.min.z));
}

}  // namespace layoutbox
