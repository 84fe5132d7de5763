#include "layoutbox/furnish/room_shell.h"

#include <algorithm>
#include <cmath>

#include "layoutbox/base/units.h"
#include "layoutbox/furnish/families/parts.h"
#include "layoutbox/furnish/openings.h"
#include "layoutbox/furnish/roof_shell.h"

namespace layoutbox {
namespace {

using kit::Vec2;

constexpr double kSlab = 0.12;    // thickness of floor and ceiling
constexpr double kParapet = 1.0;  // m

Vec2 metres(Point p) { return {m_from_mm(p.x), m_from_mm(p.y)}; }

const Material* material_of(const Layout& layout, const std::string& id) {
  const auto found = std::find_if(layout.materials.begin(), layout.materials.end(), [&](const Material& m) { return m.id == id; });
  return found == layout.materials.end() || id.empty() ? nullptr : &*found;
}

// A floor's own surface for a wood, stone or cloth that the text names.
std::string floor_of(const NamedSurface& named) {
  const std::string& name = named.surface.name;
  if (named.kind == "wood") {
    if (name == "reclaimed_wood") return "barn_boards";
    if (name == "walnut" || name == "mahogany" || name == "ebony" || name == "cherry") return "walnut_planks";
    return name == "birch" || name == "pine" || name == "bamboo" ? "pale_planks" : "oak_planks";
  }
  if (name == "marble") return "marble_floor";
  if (name == "stone" || name == "stone_wall") return "stone_floor";
  if (name == "brick") return "brick_floor";
  return named.kind == "fabric" ? "carpet" : name;
}

// A wall's own surface for what the text names: boards of a wood, small tiles, rough blocks.
std::string wall_of(const NamedSurface& named) {
  const std::string& name = named.surface.name;
  if (named.kind == "wood" && name != "lacquer" && name != "cork")
    return name == "walnut" || name == "mahogany" || name == "ebony" ? "dark_panelling" : "panelling";
  if (name == "tiles") return "wall_tiles";
  return name == "stone" || name == "stone_floor" ? "stone_wall" : name;
}

// Of several materials the one that is a floor's own ("oak herringbone"), laid of the wood that is named with it.
Surface laid(const SurfaceWish& wish) {
  const auto wood = std::ranges::find(wish.materials, "wood", [](const NamedSurface* m) -> std::string_view { return m->kind; });
  const auto floor = std::ranges::find(wish.materials, "floor", [](const NamedSurface* m) -> std::string_view { return m->kind; });
  const bool both = wood != wish.materials.end() && floor != wish.materials.end() && (*floor)->surface.texture == "parquet";
  if (!both) return named_surface(floor_of(*wish.materials.front())).surface;
  Surface surface = (*floor)->surface;
  const Surface& planks = named_surface(floor_of(**wood)).surface;
  surface.base = planks.base, surface.second = planks.second;
  surface.name += "_of_" + (*wood)->surface.name;
  return surface;
}

// Black walls and floors are a little lighter than black things before them.
Color seen_in_picture(const Color& color) {
  constexpr double kDark = 0.18, kLifted = 0.3;
  return std::max({color.r, color.g, color.b}) < kDark ? mixed(color, {0.36, 0.36, 0.38}, kLifted) : color;
}

Surface surface_for(const Layout& layout, const std::string& asked, std::string_view usual, bool is_floor) {
  const Material* own = material_of(layout, asked);
  const SurfaceWish wish = read_wish(asked);
  const NamedSurface* named = &named_surface(usual);
  if (!wish.materials.empty()) named = &named_surface(is_floor ? floor_of(*wish.materials.front()) : wall_of(*wish.materials.front()));
  std::optional<Color> color = own != nullptr && own->color ? own->color : wish.color;
  if (color && (own == nullptr || !own->color)) color = seen_in_picture(*color);
  Surface surface = color ? colored(*named, *color) : is_floor && !wish.materials.empty() ? laid(wish) : named->surface;
  if (own == nullptr) return surface;
  surface.name = own->id;
  if (own->roughness) surface.roughness = static_cast<float>(*own->roughness);
  if (!own->texture.empty()) {
    surface.image = own->texture;
    surface.scale = static_cast<float>(1 / std::max(1e-3, own->uv_scale[0]));
  }
  return surface;
}

std::vector<Vec2> outline_of(const Room& room) {
  std::vector<Vec2> outline;
  for (const Point p : room.polygon) outline.push_back(metres(p));
  return outline;
}

void add_floor(const Layout& layout, const Decor& decor, Palette& palette, Model& model) {
  const std::vector<Vec2> outline = outline_of(layout.room);
  Mesh top = kit::prism(outline, -0.02, 0), body = kit::prism(outline, -kSlab, -0.02);
  // Boards run along the longer side of the room; uvs of level faces are x and y.
  const kit::Box b = kit::bounds(top);
  if (b.size().y > b.size().x) {
    for (Vec2f& uv : top.uvs) std::swap(uv[0], uv[1]);
  }
  Node node;
  node.id = "floor";
  node.kind = NodeKind::kFloor;
  const std::string& asked = layout.room.floor_material;
  // "A grey floor" is what such rooms have, in grey; where nobody says what room it is, no boards.
  const SurfaceWish own = read_wish(decor.floor);
  const std::string usual = asked.empty() || own.materials.empty() ? "oak_planks"
                            : layout.room.type.empty()             ? "vinyl_floor"
                                                                   : floor_of(*own.materials.front());
  const Surface surface = surface_for(layout, asked.empty() ? decor.floor : asked, usual, true);
  node.parts = {{std::move(top), palette.add(surface)}, {std::move(body), palette.named("walnut")}};
  model.nodes.push_back(std::move(node));
}

// How far the outer face of a wall reaches beyond its inner corner, where it meets the outer face of the next one.
double mitre(Vec2 along, double own, Vec2 next_along, double next) {
  const double turn = along.x * next_along.y - along.y * next_along.x;
  if (std::abs(turn) < 1e-3) return 0;
  const Vec2 n{along.y, -along.x}, m{next_along.y, -next_along.x};
  const Vec2 gap{m.x * next - n.x * own, m.y * next - n.y * own};
  const double reach = (gap.x * next_along.y - gap.y * next_along.x) / turn;
  return std::clamp(reach, -4 * own, 4 * own);
}

// How much of a wall stands behind furniture, in m².
double furnished(const Layout& layout, const Wall& wall) {
  constexpr double kAt = 0.12;  // m
  const WallFrame frame(wall);
  double area = 0;
  for (const PlacedObject& object : layout.objects) {
    if (object.mount != Mount::kFloor) continue;
    const double turn = radians_from_degrees(object.rotation_deg - frame.rotation_deg);
    const double width = m_from_mm(object.size.width), depth = m_from_mm(object.size.depth);
    const double reach = 0.5 * (std::abs(width * std::sin(turn)) + std::abs(depth * std::cos(turn)));
    const kit::Vec2 at = frame.local({m_from_mm(object.position[0]), m_from_mm(object.position[1])}, 0);
    if (at.x < 0 || at.x > frame.length || std::abs(at.y - reach) > kAt) continue;
    area += (std::abs(width * std::cos(turn)) + std::abs(depth * std::sin(turn))) * m_from_mm(object.size.height);
  }
  return area;
}

// The wall of a colour of its own: the one that most of the furniture stands at.
bool is_feature(const Layout& layout, const Wall& wall) {
  const auto most = std::ranges::max_element(layout.room.walls, {}, [&](const Wall& w) { return furnished(layout, w); });
  return most->id == wall.id;
}

// What a wall is of: as asked, else as the room's look has it.
Surface wall_surface(const Layout& layout, const Decor& decor, const Wall& wall) {
  const std::string& asked = wall.material.empty() ? layout.room.wall_material : wall.material;
  const SurfaceWish wish = read_wish(asked);
  const bool of_scheme = decor.scheme_walls && decor.accents.size() > 1 && wish.materials.empty() && wish.color &&
                         std::ranges::find(decor.accents, *wish.color) != decor.accents.end();
  if (!asked.empty() && !of_scheme) return surface_for(layout, asked, "plaster", false);
  if (!decor.wall_finish.empty()) {
    const SurfaceWish finish = read_wish(decor.wall_finish);
    const NamedSurface* named = finish.materials.empty() ? nullptr : &named_surface(wall_of(*finish.materials.front()));
    const bool dyed = named != nullptr && named->tint && (named->surface.texture == "tiles" || named->surface.texture == "stripes");
    return decor.colors_said && dyed ? colored(*named, decor.wall) : surface_for(layout, decor.wall_finish, "tiles", false);
  }
  const bool feature = decor.feature && is_feature(layout, wall);
  return colored(named_surface("plaster"), feature ? *decor.feature : decor.wall);
}

void add_wall(const Layout& layout, const Catalog& catalog, const Decor& decor, std::size_t index, Palette& palette, Model& model) {
  const auto& walls = layout.room.walls;
  const Wall& wall = walls[index];
  const WallFrame frame(wall), before(walls[(index + walls.size() - 1) % walls.size()]), after(walls[(index + 1) % walls.size()]);
  const bool house = !decor.parapet || std::ranges::any_of(layout.room.openings, [&](const Opening& o) { return o.wall == wall.id; });
  const RoofEdge roof = roof_over(layout, catalog, frame, m_from_mm(layout.room.height));
  const double height = house ? roof.height : std::min(kParapet, roof.height);
  std::vector<kit::Hole> holes;
  std::vector<std::pair<double, double>> skirting{{0, frame.length}};
  for (const Opening& opening : layout.room.openings) {
    if (opening.wall != wall.id || !opening.offset) continue;
    const double x0 = std::max(0.0, m_from_mm(*opening.offset)), x1 = std::min(frame.length, x0 + m_from_mm(opening.width));
    const double z0 = m_from_mm(opening.sill), z1 = std::min(height - 0.01, z0 + m_from_mm(opening.height));
    if (x1 - x0 < 0.05 || z1 - z0 < 0.05) continue;
    holes.push_back({x0, x1, z0, z1});
    if (z0 > 0.1) continue;
    const auto last = skirting.back();  // openings come in any order: cut every piece that this one meets
    std::vector<std::pair<double, double>> left;
    for (const auto& [a, b] : skirting) {
      if (x0 - kCasing > a) left.emplace_back(a, std::min(b, x0 - kCasing));
      if (x1 + kCasing < b) left.emplace_back(std::max(a, x1 + kCasing), b);
    }
    skirting = left.empty() ? std::vector<std::pair<double, double>>{{last.second, last.second}} : left;
  }
  Node node = frame.node(wall.id, NodeKind::kWall);
  // The end at the start is the mirror image of the one at the end.
  const double at_end = mitre(frame.along, frame.thickness, after.along, after.thickness);
  const double at_start = mitre({-frame.along.x, frame.along.y}, frame.thickness, {-before.along.x, before.along.y}, before.thickness);
  const Surface surface = wall_surface(layout, decor, wall);
  Mesh body = kit::pierced_slab(frame.length, -kSlab, height, -frame.thickness, 0, holes, at_start, at_end);
  if (!roof.lines.empty()) body = cut_under(std::move(body), roof.lines, frame.thickness);
  if (surface.texture == "planks") {  // boards stand upright
    for (Vec2f& uv : body.uvs) std::swap(uv[0], uv[1]);
  }
  node.parts.push_back({std::move(body), palette.add(surface)});
  // Brick, stone, tiles and concrete have none.
  const bool bare = surface.texture == "bricks" || surface.texture == "tiles" || surface.name == "concrete";
  if (!decor.skirting || bare) skirting.clear();
  Mesh boards;
  for (const auto& [a, b] : skirting) {
    if (b - a > 0.02) kit::append(boards, kit::box(kit::sides(a, b, 0, 0.012, 0, 0.08), 0.004));
  }
  if (!boards.indices.empty()) node.parts.push_back({std::move(boards), palette.named("lacquer")});
  model.nodes.push_back(std::move(node));
}

void add_ceiling(const Layout& layout, const Catalog& catalog, Palette& palette, Model& model) {
  const double height = m_from_mm(layout.room.height);
  Node node;
  node.id = "ceiling";
  node.kind = NodeKind::kCeiling;
  const int surface = palette.add(surface_for(layout, layout.room.ceiling_material, "plaster", false));
  node.parts.push_back({kit::prism(outline_of(layout.room), height, height + kSlab), surface});
  model.nodes.push_back(std::move(node));
  add_roof_panels(layout, catalog, surface, model);
}

}  // namespace

void add_room_shell(const Layout& layout, const Catalog& catalog, const Decor& decor, Palette& palette, Model& model) {
  if (layout.room.polygon.size() < 3) return;
  add_floor(layout, decor, palette, model);
  for (std::size_t i = 0; i < layout.room.walls.size(); ++i) add_wall(layout, catalog, decor, i, palette, model);
  add_openings(layout, decor, palette, model);
  add_ceiling(layout, catalog, palette, model);
}

}  // namespace layoutbox
