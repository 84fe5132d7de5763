#include "layoutbox/furnish/furnish.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/mesh_file.h"
#include "layoutbox/furnish/piece.h"
#include "layoutbox/furnish/room_shell.h"

namespace layoutbox {
namespace {

using kit::FreeSpace;

// Whether `other` reaches into a space of `object`: its box turned into the object's frame, a hair smaller than it is.
bool reaches_into(const PlacedObject& object, const kit::Box& space, const PlacedObject& other) {
  const double turn = radians_from_degrees(object.rotation_deg), c = std::cos(turn), s = std::sin(turn);
  const double dx = m_from_mm(other.position[0] - object.position[0]), dy = m_from_mm(other.position[1] - object.position[1]);
  const double x = dx * c + dy * s, y = dy * c - dx * s, z = m_from_mm(other.position[2] - object.position[2]);
  const double relative = radians_from_degrees(other.rotation_deg - object.rotation_deg), rc = std::abs(std::cos(relative)),
               rs = std::abs(std::sin(relative));
  const double w = m_from_mm(other.size.width) / 2, d = m_from_mm(other.size.depth) / 2, e = 0.001;
  const double hx = w * rc + d * rs - e, hy = w * rs + d * rc - e;
  return x + hx > space.min.x && x - hx < space.max.x && y + hy > space.min.y && y - hy < space.max.y &&
         z + m_from_mm(other.size.height) - e > space.min.z && z + e < space.max.z;
}

std::vector<FreeSpace> free_spaces(const PlacedObject& object, const CatalogEntry& entry, const Layout* layout) {
  std::vector<FreeSpace> spaces;
  for (const Space& space : object.spaces.empty() ? spaces_at(entry, object.size) : object.spaces) {
    const auto metres = [](const std::array<double, 3>& p) { return kit::Vec{p[0] / 1000, p[1] / 1000, p[2] / 1000}; };
    FreeSpace free{space.name, {metres(space.min), metres(space.max)}, space.carries, false};
    const kit::Vec size = free.box.size();
    if (std::min({size.x, size.y, size.z}) <= 0) continue;
    if (layout != nullptr) {
      free.held = std::any_of(layout->objects.begin(), layout->objects.end(),
                              [&](const PlacedObject& other) { return other.id != object.id && reaches_into(object, free.box, other); });
    }
    spaces.push_back(std::move(free));
  }
  return spaces;
}

// An object's own mesh, as a node. Surfaces that an own material covers take its colour.
Result<Node> own_mesh_node(const PlacedObject& object, const Material* material, Palette& palette, const FurnishOptions& options) {
  auto mesh = read_mesh_file(options.asset_folders, object.mesh);
  Status fitted;
  if (mesh) {
    const kit::Vec size{m_from_mm(object.size.width), m_from_mm(object.size.depth), m_from_mm(object.size.height)};
    fitted = fit_mesh(*mesh, size, object.mesh_front, object.mount);
  }
  if (!mesh || !fitted) {
    Error error = mesh ? fitted.error() : mesh.error();
    error.message = fmt::format("the mesh of \"{}\": {}", object.id, error.message);
    return Failure(std::move(error));
  }
  Node node;
  node.id = object.id;
  node.kind = NodeKind::kObject;
  node.category = object.category;
  node.name = object.name;
  for (Part& part : mesh->parts) {
    Surface surface = mesh->surfaces[static_cast<std::size_t>(part.surface)];
    if (material != nullptr && material->color) {
      surface.name = material->id;
      surface.base = surface.second = *material->color;
      surface.image.clear();
      surface.image_data.reset();
      if (material->roughness) surface.roughness = static_cast<float>(*material->roughness);
    }
    node.parts.push_back({std::move(part.mesh), palette.add(surface)});
  }
  return node;
}

// Reads the image files that surfaces name. Without folders they stay names.
Status read_images(std::vector<Surface>& surfaces, const FurnishOptions& options) {
  if (options.asset_folders.empty()) return {};
  for (Surface& surface : surfaces) {
    if (surface.image.empty() || surface.image_data) continue;
    LAYOUTBOX_ASSIGN(std::string bytes, read_image_file(options.asset_folders, surface.image));
    surface.image_data = std::make_shared<const std::string>(std::move(bytes));
  }
  return {};
}

Result<Node> object_node(const PlacedObject& object, const Catalog& catalog, const Layout* layout, Palette& palette, const Decor& decor,
                         const FurnishOptions& options) {
  const CatalogEntry& entry = catalog.entry_or_nearest(object.category);
  const Material* material = nullptr;
  if (layout != nullptr && !object.material.empty()) {
    const auto found =
        std::find_if(layout->materials.begin(), layout->materials.end(), [&](const Material& m) { return m.id == object.material; });
    if (found != layout->materials.end()) material = &*found;
  }
  const auto placed = [&](Node node) {
    node.position = {static_cast<float>(m_from_mm(object.position[0])), static_cast<float>(m_from_mm(object.position[1])),
                     static_cast<float>(m_from_mm(object.position[2]))};
    node.rotation_deg = static_cast<float>(object.rotation_deg);
    return node;
  };
  if (!object.mesh.empty() && !options.asset_folders.empty()) {
    LAYOUTBOX_ASSIGN(Node node, own_mesh_node(object, material, palette, options));
    return placed(std::move(node));
  }
  kit::Piece piece(object, entry, free_spaces(object, entry, layout), material, palette, decor, options.seed, options.contents);
  kit::family_or_generic(entry.shape.family)(piece);
  return placed(piece.take_node());
}

Status check_size(const PlacedObject& object) {
  if (object.size.width > 0 && object.size.depth > 0 && object.size.height > 0) return {};
  return fail(ErrorCode::kSchema,
              fmt::format("\"{}\" is {} × {} × {} mm large", object.id, object.size.width, object.size.depth, object.size.height),
              object.id, "every side of an object must be greater than 0");
}

}  // namespace

Result<Model> furnish(const Layout& layout, const Catalog& catalog, const FurnishOptions& options) {
  Model model;
  Palette palette;
  const Decor decor = decor_of(layout, options.seed);
  add_room_shell(layout, decor, palette, model);
  for (const PlacedObject& object : layout.objects) {
    LAYOUTBOX_CHECK(check_size(object));
    LAYOUTBOX_ASSIGN(Node node, object_node(object, catalog, &layout, palette, decor, options));
    model.nodes.push_back(std::move(node));
  }
  model.surfaces = palette.take();
  LAYOUTBOX_CHECK(read_images(model.surfaces, options));
  return model;
}

Result<Model> furnish_object(const PlacedObject& object, const Catalog& catalog, const FurnishOptions& options) {
  LAYOUTBOX_CHECK(check_size(object));
  PlacedObject alone = object;
  alone.position = {0, 0, 0};
  alone.rotation_deg = 0;
  Model model;
  Palette palette;
  LAYOUTBOX_ASSIGN(Node node, object_node(alone, catalog, nullptr, palette, {}, options));
  model.nodes.push_back(std::move(node));
  model.surfaces = palette.take();
  return model;
}

}  // namespace layoutbox
