#include "layoutbox/furnish/openings.h"

#include <algorithm>
#include <cmath>

#include "layoutbox/base/units.h"
#include "layoutbox/furnish/families/parts.h"
#include "layoutbox/furnish/opening_builder.h"

namespace layoutbox {
namespace {

using kit::append;
using kit::box;
using kit::sides;
using kit::Vec2;

// Boards round the opening on the room's side, and the lining of its reveal.
void add_frame(OpeningBuilder& b) {
  Mesh mesh;
  const bool window = b.opening.type == OpeningType::kWindow;
  const double out = 0.014, t = b.wall.thickness, bottom = window ? b.sill : 0, top = b.sill + b.h;
  for (const double x : {0.0, b.w}) {
    const bool near = x == 0.0;
    append(mesh, box(sides(near ? -kCasing : b.w, near ? 0 : b.w + kCasing, 0, out, bottom, top + kCasing), 0.003));
    append(mesh, box(sides(near ? 0 : b.w - kLining, near ? kLining : b.w, -t, out, bottom, top), 0.002));
  }
  append(mesh, box(sides(0, b.w, 0, out, top, top + kCasing), 0.003));
  append(mesh, box(sides(kLining, b.w - kLining, -t, out, top - kLining, top), 0.002));
  // Of a window it is of the same stuff as the bars; of a door its own.
  b.add(window || b.look.leaf == Leaf::kGlazed || b.look.leaf == Leaf::kPlanks ? b.body("lacquer") : b.palette.named("lacquer"),
        std::move(mesh));
}

// Where nothing was said of it, as such rooms have it.
Opening in_style(Opening opening, const Decor& decor) {
  const bool window = opening.type == OpeningType::kWindow;
  if (window && !decor.view.empty()) opening.attributes.insert(opening.attributes.begin(), decor.view);
  const std::string& words = window ? decor.window : decor.door;
  const std::size_t seen = window && !decor.view.empty() ? 1 : 0;
  if (opening.attributes.size() > seen || words.empty()) return opening;
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t end = std::min(words.find(',', at), words.size());
    opening.attributes.push_back(words.substr(at, end - at));
    at = end + 1;
  }
  return opening;
}

// Of what the wall's mesh is, for what is made to go on in it.
int surface_of_wall(const Model& model, const std::string& id) {
  const auto wall = std::ranges::find(model.nodes, id, &Node::id);
  return wall == model.nodes.end() || wall->parts.empty() ? 0 : wall->parts.front().surface;
}

}  // namespace

int OpeningBuilder::body(std::string_view usual) {
  std::string said;
  for (const std::string& word : opening.attributes) said += word + " ";
  const SurfaceWish wish = read_wish(said), framed = read_wish(look.frame);
  const auto solid = [](const NamedSurface* surface) { return surface->kind == "wood" || surface->kind == "metal"; };
  const NamedSurface* of = &named_surface(usual);
  for (const SurfaceWish* one : {&framed, &wish}) {
    const auto found = std::ranges::find_if(one->materials, solid);
    if (found == one->materials.end()) continue;
    of = *found;
    break;
  }
  return palette.add(wish.color ? colored(*of, *wish.color) : of->surface);
}

WallFrame::WallFrame(const Wall& wall) : start{m_from_mm(wall.start.x), m_from_mm(wall.start.y)} {
  const double dx = m_from_mm(wall.end.x) - start.x, dy = m_from_mm(wall.end.y) - start.y;
  length = std::hypot(dx, dy);
  along = length > 1e-9 ? Vec2{dx / length, dy / length} : Vec2{1, 0};
  inward = {-along.y, along.x};
  thickness = std::max(0.02, m_from_mm(wall.thickness));
  rotation_deg = std::atan2(along.y, along.x) * 180 / kPi;
}

Node WallFrame::node(const std::string& id, NodeKind kind, double offset) const {
  Node node;
  node.id = id;
  node.kind = kind;
  node.position = {static_cast<float>(start.x + along.x * offset), static_cast<float>(start.y + along.y * offset), 0};
  node.rotation_deg = static_cast<float>(rotation_deg);
  node.inward = Vec2f{static_cast<float>(inward.x), static_cast<float>(inward.y)};
  return node;
}

Vec2 WallFrame::local(Vec2 p, double offset) const {
  const double dx = p.x - start.x, dy = p.y - start.y;
  return {dx * along.x + dy * along.y - offset, dx * inward.x + dy * inward.y};
}

void add_openings(const Layout& layout, const Decor& decor, Palette& palette, Model& model) {
  for (const Opening& placed : layout.room.openings) {
    const Opening opening = in_style(placed, decor);
    const Wall* wall = layout.find_wall(opening.wall);
    if (wall == nullptr || !opening.offset) continue;
    const WallFrame frame(*wall);
    OpeningBuilder b{layout,
                     opening,
                     look_of(opening),
                     frame,
                     palette,
                     frame.node(opening.id, NodeKind::kOpening, m_from_mm(*opening.offset)),
                     m_from_mm(opening.width),
                     std::min(m_from_mm(opening.height), m_from_mm(layout.room.height) - 0.01 - m_from_mm(opening.sill)),
                     m_from_mm(opening.sill),
                     surface_of_wall(model, wall->id)};
    b.node.parent = wall->id;
    b.node.category = std::string(name_of(opening.type));
    if (b.look.shape == OpeningShape::kRectangle) add_frame(b);
    if (opening.type == OpeningType::kDoor) add_leaves(b);
    if (opening.type == OpeningType::kWindow) add_window(b);
    model.nodes.push_back(std::move(b.node));
  }
}

}  // namespace layoutbox
