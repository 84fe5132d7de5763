#include "layoutbox/furnish/own_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/mesh_file.h"
#include "layoutbox/furnish/simplify.h"

namespace layoutbox {
namespace {

Failure of_whom(Error error, std::string_view what, std::string_view id) {
  error.message = fmt::format("the mesh of {}\"{}\": {}", what, id, error.message);
  return Failure(std::move(error));
}

// The file's parts with its surfaces, or in the colour of the scene's own material.
std::vector<Part> parts_of(MeshFile mesh, const Material* material, Palette& palette) {
  std::vector<Part> parts;
  for (Part& part : mesh.parts) {
    Surface surface = mesh.surfaces[static_cast<std::size_t>(part.surface)];
    if (material != nullptr && material->color) {
      surface.name = material->id;
      surface.base = surface.second = *material->color;
      surface.image.clear();
      surface.image_data.reset();
      if (material->roughness) surface.roughness = static_cast<float>(*material->roughness);
    }
    parts.push_back({std::move(part.mesh), palette.add(surface)});
  }
  return parts;
}

}  // namespace

const Material* scene_material(const Layout& layout, std::string_view id) {
  const auto found = std::find_if(layout.materials.begin(), layout.materials.end(), [&](const Material& m) { return m.id == id; });
  return id.empty() || found == layout.materials.end() ? nullptr : &*found;
}

Result<Node> own_mesh_node(const PlacedObject& object, const Material* material, Palette& palette, const FurnishOptions& options) {
  auto mesh = read_mesh_file(options.asset_folders, object.mesh);
  if (!mesh) return of_whom(mesh.error(), "", object.id);
  const kit::Vec size{m_from_mm(object.size.width), m_from_mm(object.size.depth), m_from_mm(object.size.height)};
  if (const Status fitted = fit_mesh(*mesh, size, object.mesh_front, object.mount); !fitted) return of_whom(fitted.error(), "", object.id);
  simplify(*mesh, most_triangles(options.detail));
  Node node;
  node.id = object.id;
  node.kind = NodeKind::kObject;
  node.category = object.category;
  node.name = object.name;
  node.parts = parts_of(std::move(*mesh), material, palette);
  return node;
}

Status replace_walls_by_own_meshes(const Layout& layout, Palette& palette, const FurnishOptions& options, Model& model) {
  if (options.asset_folders.empty()) return {};
  for (Node& node : model.nodes) {
    const Wall* wall = node.kind == NodeKind::kWall ? layout.find_wall(node.id) : nullptr;
    if (wall == nullptr || wall->mesh.empty()) continue;
    auto mesh = read_mesh_file(options.asset_folders, wall->mesh);
    if (!mesh) return of_whom(mesh.error(), "the wall ", wall->id);
    const double length = std::hypot(m_from_mm(wall->end.x - wall->start.x), m_from_mm(wall->end.y - wall->start.y));
    fit_wall_mesh(*mesh, {length, m_from_mm(wall->thickness), m_from_mm(layout.room.height)});
    simplify(*mesh, most_triangles(options.detail));
    node.parts = parts_of(std::move(*mesh), scene_material(layout, wall->material), palette);
  }
  return {};
}

Status read_own_images(std::vector<Surface>& surfaces, const FurnishOptions& options) {
  if (options.asset_folders.empty()) return {};
  for (Surface& surface : surfaces) {
    if (surface.image.empty() || surface.image_data) continue;
    LAYOUTBOX_ASSIGN(std::string bytes, read_image_file(options.asset_folders, surface.image));
    surface.image_data = std::make_shared<const std::string>(std::move(bytes));
  }
  return {};
}

}  // namespace layoutbox
