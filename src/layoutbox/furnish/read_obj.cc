// OBJ by tinyobjloader.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include "layoutbox/base/files.h"
#include "layoutbox/furnish/mesh_readers.h"

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

namespace layoutbox {
namespace {

// A polygon of many thousand corners takes minutes to cut into triangles.
constexpr std::size_t kLongestLine = 1u << 16;

Failure broken(const AssetPlace& place, std::string_view why) {
  return fail(ErrorCode::kParse, fmt::format("\"{}\" cannot be read as OBJ: {}", place.name, why), place.name);
}

// A material file that the OBJ names; nothing where it is not there: without its colours it is still a shape.
Result<std::string> materials_in(const AssetPlace& place, const std::string& name) {
  const auto path = find_asset(place.folders, name);
  if (!path && path.error().code == ErrorCode::kIo) return std::string();
  auto text = path ? read_file(*path, place.limits.most_bytes) : Result<std::string>(Failure(path.error()));
  return text ? std::move(text) : Result<std::string>(broken(place, text.error().message));
}

// "v nan 0 1", which the library reads as zeros.
bool holds_no_number(std::string_view line) {
  const bool is_corner = line.starts_with("v ") || line.starts_with("vn ") || line.starts_with("vt ");
  return is_corner && line.substr(0, line.find('#')).find_first_of("nNiI", 2) != std::string_view::npos;
}

// All material files that it names, one after the other, each once.
Result<std::string> materials_of(const AssetPlace& place, const std::string& text) {
  std::string all, line;
  std::set<std::string> read;
  std::istringstream lines(text);
  while (std::getline(lines, line)) {
    if (line.size() > kLongestLine) return broken(place, "one of its lines is too long");
    if (holds_no_number(line)) return broken(place, fmt::format("a corner has no numbers: \"{}\"", line.substr(0, 60)));
    if (!line.starts_with("mtllib ")) continue;
    std::string name = line.substr(7);
    while (!name.empty() && (name.back() == '\r' || name.back() == ' ')) name.pop_back();
    if (!read.insert(name).second) continue;
    LAYOUTBOX_ASSIGN(const std::string part, materials_in(place, name));
    all += part + "\n";
    if (all.size() > place.limits.most_bytes) return broken(place, "the material files that it names are too large");
  }
  return all;
}

Result<Surface> surface_of(const AssetPlace& place, const tinyobj::material_t& material) {
  Surface surface;
  surface.name = place.name + "#" + material.name;
  surface.base = {double{material.diffuse[0]}, double{material.diffuse[1]}, double{material.diffuse[2]}};
  surface.second = surface.base;
  surface.roughness = material.roughness > 0 ? material.roughness : std::sqrt(2.0F / (2.0F + std::max(0.0F, material.shininess)));
  surface.metallic = material.metallic;
  surface.alpha = material.dissolve;
  if (!material.diffuse_texname.empty()) {
    auto bytes = read_image_file(place.folders, material.diffuse_texname);
    if (bytes) {
      surface.image = place.name + "#" + material.diffuse_texname;
      surface.image_data = std::make_shared<const std::string>(std::move(*bytes));
    } else if (bytes.error().code == ErrorCode::kParse) {  // one that is not there is done without
      return broken(place, bytes.error().message);
    }
  }
  return surface;
}

// Corner by corner: OBJ counts positions, normals and coordinates apart.
void add_shape(const tinyobj::attrib_t& all, const tinyobj::mesh_t& mesh, std::map<int, Part>& parts) {
  for (std::size_t face = 0; 3 * face + 2 < mesh.indices.size(); ++face) {
    const int material = face < mesh.material_ids.size() ? mesh.material_ids[face] : -1;
    Mesh& out = parts[material].mesh;
    std::array<kit::Vec, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(mesh.indices[3 * face + k].vertex_index);
      corner[k] = {double{all.vertices[3 * v]}, -double{all.vertices[3 * v + 2]}, double{all.vertices[3 * v + 1]}};
    }
    const kit::Vec flat = kit::unit(kit::cross(corner[1] - corner[0], corner[2] - corner[0]));
    for (std::size_t k = 0; k < 3; ++k) {
      const tinyobj::index_t& index = mesh.indices[3 * face + k];
      kit::Vec normal = flat;
      if (const auto n = static_cast<std::size_t>(index.normal_index); index.normal_index >= 0 && 3 * n + 2 < all.normals.size()) {
        normal = kit::unit({double{all.normals[3 * n]}, -double{all.normals[3 * n + 2]}, double{all.normals[3 * n + 1]}});
      }
      Vec2f uv{0, 0};
      if (const auto t = static_cast<std::size_t>(index.texcoord_index); index.texcoord_index >= 0 && 2 * t + 1 < all.texcoords.size()) {
        uv = {all.texcoords[2 * t], all.texcoords[2 * t + 1]};
      }
      out.indices.push_back(static_cast<std::uint32_t>(out.positions.size()));
      out.positions.push_back({static_cast<float>(corner[k].x), static_cast<float>(corner[k].y), static_cast<float>(corner[k].z)});
      out.normals.push_back({static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)});
      out.uvs.push_back(uv);
    }
  }
}

bool sound(const tinyobj::attrib_t& all, const tinyobj::mesh_t& mesh) {
  const auto count = static_cast<int>(all.vertices.size() / 3);
  return std::all_of(mesh.indices.begin(), mesh.indices.end(),
                     [&](const tinyobj::index_t& index) { return index.vertex_index >= 0 && index.vertex_index < count; }) &&
         std::all_of(all.vertices.begin(), all.vertices.end(), [](float v) { return std::isfinite(v); });
}

}  // namespace

Result<MeshFile> read_obj(const AssetPlace& place) {
  LAYOUTBOX_ASSIGN(const std::string text, read_file(place.path, place.limits.most_bytes));
  LAYOUTBOX_ASSIGN(const std::string materials, materials_of(place, text));
  tinyobj::ObjReader reader;
  tinyobj::ObjReaderConfig config;
  config.triangulate = true;
  if (!reader.ParseFromString(text, materials, config)) {
    const std::string why = reader.Error().substr(0, reader.Error().find('\n'));
    return broken(place, why.empty() ? "it is broken" : why);
  }
  MeshFile mesh;
  for (const tinyobj::material_t& material : reader.GetMaterials()) {
    LAYOUTBOX_ASSIGN(Surface surface, surface_of(place, material));
    mesh.surfaces.push_back(std::move(surface));
  }
  Surface plain;
  plain.name = place.name + "#plain";
  plain.base = plain.second = {0.8, 0.8, 0.8};
  mesh.surfaces.push_back(plain);
  std::map<int, Part> parts;
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    if (!sound(reader.GetAttrib(), shape.mesh)) {
      return broken(place, "a face names a vertex that is not there");
    }
    add_shape(reader.GetAttrib(), shape.mesh, parts);
  }
  const auto last = static_cast<int>(mesh.surfaces.size()) - 1;
  for (auto& [material, part] : parts) {
    part.surface = material >= 0 && material < last ? material : last;
    mesh.parts.push_back(std::move(part));
  }
  return mesh;
}

}  // namespace layoutbox
