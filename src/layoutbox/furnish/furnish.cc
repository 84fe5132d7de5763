#include "layoutbox/furnish/furnish.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "layoutbox/catalog/toppled.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/furnish/kit_detail.h"
#include "layoutbox/furnish/own_meshes.h"
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

// Of what was raised onto legs: the spaces of its body as if that stood on the floor, and by how much it is raised, m.
double lower_onto_floor(std::vector<FreeSpace>& spaces) {
  const auto below = std::ranges::find(spaces, kSpaceUnderIt, &FreeSpace::name);
  if (below == spaces.end()) return 0;
  const double raised = below->box.max.z;
  spaces.erase(below);
  for (FreeSpace& space : spaces) space.box.min.z -= raised, space.box.max.z -= raised;
  return raised;
}

// Curtains that share a window: at which side of `object` the other one of its kind begins.
int side_of_twin(const PlacedObject& object, const Layout& layout) {
  constexpr double kGap = 200;  // mm
  const double turn = object.rotation_deg * std::numbers::pi / 180;
  for (const PlacedObject& other : layout.objects) {
    if (other.id == object.id || other.category != object.category || other.mount != object.mount) continue;
    const double dx = other.position[0] - object.position[0], dy = other.position[1] - object.position[1];
    const double along = dx * std::cos(turn) + dy * std::sin(turn), across = dy * std::cos(turn) - dx * std::sin(turn);
    if (std::abs(across) > kGap || std::abs(along) > (object.size.width + other.size.width) / 2.0 + kGap) continue;
    return along < 0 ? -1 : 1;
  }
  return 0;
}

// On its side, or on its back, as toppled() has it.
Node laid_down(Node node, const CatalogEntry& entry, const Size& upright) {
  const double w = m_from_mm(upright.width), d = m_from_mm(upright.depth), h = m_from_mm(upright.height);
  const kit::Pose pose = falls_sideways(entry) ? kit::Pose{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {-h / 2, 0, w / 2}}
                                               : kit::Pose{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}, {0, -h / 2, d / 2}};
  for (Part& part : node.parts) part.mesh = kit::posed(std::move(part.mesh), pose);
  for (Light& light : node.lights) {
    const kit::Vec at = pose.point(
        {static_cast<double>(light.position[0]), static_cast<double>(light.position[1]), static_cast<double>(light.position[2])});
    light.position = {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)};
  }
  return node;
}

// Its top to the room, its bottom to the wall, as hung_flat() has it.
Node hung_up(Node node, const CatalogEntry& entry, const Size& lying) {
  const double w = m_from_mm(lying.width), d = m_from_mm(lying.depth), h = m_from_mm(lying.height);
  const kit::Pose pose = hangs_lengthwise(entry) ? kit::Pose{{0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, h / 2, w / 2}}
                                                 : kit::Pose{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, h / 2, d / 2}};
  for (Part& part : node.parts) part.mesh = kit::posed(std::move(part.mesh), pose);
  return node;
}

// By what is said of it: "an old workbench".
double wear_of(const PlacedObject& object) {
  double wear = wear_said(object.name);
  for (const std::string& word : object.attributes) wear = std::max(wear, wear_said(word));
  return wear;
}

Result<Node> object_node(const PlacedObject& object, const Catalog& catalog, const Layout* layout, Palette& palette, const Decor& decor,
                         const FurnishOptions& options) {
  const CatalogEntry& entry = catalog.entry_or_nearest(object.category);
  const Material* material = layout == nullptr ? nullptr : scene_material(*layout, object.material);
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
  const bool lies = is_toppled(object.attributes, object.mount);
  PlacedObject upright = object;
  if (lies) upright.size = toppled(entry, object.size), upright.spaces.clear();
  const bool flat = hangs_flat(entry, object.mount) && object.size.depth <= object.size.height;
  if (flat) upright.size = laid_flat(entry, object.size), upright.spaces.clear();
  std::vector<FreeSpace> spaces = free_spaces(upright, entry, lies || flat ? nullptr : layout);
  const double raised = lower_onto_floor(spaces);
  PlacedObject body = upright;
  body.size.height -= static_cast<Mm>(std::lround(raised * 1000));
  const double before = palette.wear_from_now(std::max(decor.wear, wear_of(object)));
  kit::Piece piece(body, entry, std::move(spaces), material, palette, decor, options.seed, options.contents);
  if (layout != nullptr && entry.is(Trait::kCurtain)) piece.twin = side_of_twin(object, *layout);
  piece.bears =
      layout != nullptr && std::ranges::any_of(layout->objects, [&](const PlacedObject& o) { return o.supported_by == object.id; });
  kit::family_or_generic(entry.shape.family)(piece);
  if (raised > 0) piece.raise(raised);
  palette.wear_from_now(before);
  if (flat) return placed(hung_up(piece.take_node(), entry, upright.size));
  return placed(lies ? laid_down(piece.take_node(), entry, upright.size) : piece.take_node());
}

Status check_size(const PlacedObject& object) {
  if (object.size.width > 0 && object.size.depth > 0 && object.size.height > 0) return {};
  return fail(ErrorCode::kSchema,
              fmt::format("\"{}\" is {} × {} × {} mm large", object.id, object.size.width, object.size.depth, object.size.height),
              object.id, "every side of an object must be greater than 0");
}

}  // namespace

std::string_view name_of(Detail detail) { return detail == Detail::kLow ? "low" : detail == Detail::kHigh ? "high" : "usual"; }

std::optional<Detail> detail_from_name(std::string_view name) {
  for (const Detail detail : {Detail::kLow, Detail::kUsual, Detail::kHigh}) {
    if (name_of(detail) == name) return detail;
  }
  return std::nullopt;
}

Result<Model> furnish(const Layout& layout, const Catalog& catalog, const FurnishOptions& options) {
  Model model;
  Palette palette;
  const kit::DetailScope detail(options.detail);
  const Decor decor = decor_of(layout, options.seed);
  model.daylight = decor.daylight;
  palette.wear_from_now(decor.wear);
  add_room_shell(layout, catalog, decor, palette, model);
  LAYOUTBOX_CHECK(replace_walls_by_own_meshes(layout, palette, options, model));
  for (const PlacedObject& object : layout.objects) {
    LAYOUTBOX_CHECK(check_size(object));
    LAYOUTBOX_ASSIGN(Node node, object_node(object, catalog, &layout, palette, decor, options));
    model.nodes.push_back(std::move(node));
  }
  model.surfaces = palette.take();
  LAYOUTBOX_CHECK(read_own_images(model.surfaces, options));
  return model;
}

Result<Model> furnish_object(const PlacedObject& object, const Catalog& catalog, const FurnishOptions& options) {
  LAYOUTBOX_CHECK(check_size(object));
  PlacedObject alone = object;
  alone.position = {0, 0, 0};
  alone.rotation_deg = 0;
  Model model;
  Palette palette;
  const kit::DetailScope detail(options.detail);
  LAYOUTBOX_ASSIGN(Node node, object_node(alone, catalog, nullptr, palette, {}, options));
  model.nodes.push_back(std::move(node));
  model.surfaces = palette.take();
  return model;
}

}  // namespace layoutbox
