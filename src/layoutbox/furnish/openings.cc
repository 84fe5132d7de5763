#include "layoutbox/furnish/openings.h"

#include <algorithm>
#include <cmath>

#include "layoutbox/base/units.h"
#include "layoutbox/furnish/families/parts.h"

namespace layoutbox {
namespace {

using kit::append;
using kit::box;
using kit::sides;
using kit::Vec2;

// One opening's parts while they are made: frame x along the wall from the near edge, y into the room, z up from the floor.
struct Builder {
  const Layout& layout;
  const Opening& opening;
  WallFrame wall;
  Palette& palette;
  Node node;
  double w, h, sill;

  void add(std::string_view surface, Mesh mesh) { node.parts.push_back({std::move(mesh), palette.named(surface)}); }
};

// Boards round the opening on the room's side, and the lining of its reveal.
void add_frame(Builder& b, bool to_floor) {
  Mesh mesh;
  const double lining = 0.02, out = 0.014, t = b.wall.thickness;
  const double bottom = to_floor ? 0 : b.sill, top = b.sill + b.h;
  for (const double x : {0.0, b.w}) {
    const bool near = x == 0.0;
    append(mesh, box(sides(near ? -kCasing : b.w, near ? 0 : b.w + kCasing, 0, out, bottom, top + kCasing), 0.003));
    append(mesh, box(sides(near ? 0 : b.w - lining, near ? lining : b.w, -t, out, bottom, top), 0.002));
  }
  append(mesh, box(sides(0, b.w, 0, out, top, top + kCasing), 0.003));
  append(mesh, box(sides(lining, b.w - lining, -t, out, top - lining, top), 0.002));
  b.add("lacquer", std::move(mesh));
}

// Whether a leaf from `hinge` in the direction of `angle` would meet an object.
bool leaf_is_free(const Builder& b, Vec2 hinge, Vec2 way, double length) {
  for (const PlacedObject& object : b.layout.objects) {
    if (object.position[2] > 1000 * b.h || object.size.height <= 30) continue;
    const Vec2 c = b.wall.local({m_from_mm(object.position[0]), m_from_mm(object.position[1])}, m_from_mm(*b.opening.offset));
    const double turn = radians_from_degrees(object.rotation_deg - b.wall.rotation_deg), cs = std::cos(turn), sn = std::sin(turn);
    for (int i = 0; i <= 20; ++i) {
      const double x = hinge.x + way.x * length * i / 20 - c.x, y = hinge.y + way.y * length * i / 20 - c.y;
      const bool within = std::abs(x * cs + y * sn) < m_from_mm(object.size.width) / 2 + 0.03 &&
                          std::abs(y * cs - x * sn) < m_from_mm(object.size.depth) / 2 + 0.03;
      if (within) return false;
    }
  }
  return true;
}

Mesh leaf_mesh(double width, double height, Mesh* handles) {
  const double t = 0.04;
  Mesh leaf = box(sides(0, width, -t / 2, t / 2, 0.008, height), 0.004);
  for (const double side : {-1.0, 1.0}) {
    // Two raised panels and a lever.
    for (const auto& [z0, z1] : {std::pair{0.12, 0.42}, {0.5, 0.94}}) {
      append(leaf, box(sides(width * 0.16, width * 0.84, side > 0 ? t / 2 - 0.002 : -t / 2 - 0.006,
                             side > 0 ? t / 2 + 0.006 : -t / 2 + 0.002, height * z0, height * z1),
                       0.004));
    }
    const double x = width - 0.07, z = std::min(1.02, height * 0.5), y = side * (t / 2 + 0.03);
    append(*handles, kit::rod({x, side * t / 2, z}, {x, y, z}, 0.009, 10));
    append(*handles, kit::rod({x + 0.009, y, z}, {x - 0.11, y, z}, 0.009, 10));
    append(*handles, kit::cylinder({x, side * t / 2, z - 0.02}, 0.016, 0.04, 12));
  }
  return leaf;
}

void add_leaf(Builder& b) {
  const double lining = 0.02, width = b.w - 2 * lining - 0.006, height = b.h - lining - 0.004, t = b.wall.thickness;
  const Swing swing = b.opening.swing;
  const bool hinge_left = swing == Swing::kInLeft || swing == Swing::kOutLeft;  // seen from inside, where x runs to the left
  const bool in = swing == Swing::kInLeft || swing == Swing::kInRight;
  const bool turns = in || swing == Swing::kOutLeft || swing == Swing::kOutRight;
  const double y = in ? -0.02 : -std::max(0.02, t - 0.02);
  const Vec2 hinge{hinge_left ? b.w - lining - 0.003 : lining + 0.003, turns ? y : -t / 2};
  double angle = 0;
  if (turns) {
    const bool given_up = b.layout.lists_as_given_up("door swing of " + b.opening.id);
    for (const double degrees : {50.0, 30.0, 15.0}) {
      const double a = radians_from_degrees(degrees);
      const Vec2 way{(hinge_left ? -1 : 1) * std::cos(a), (in ? 1 : -1) * std::sin(a)};
      if (given_up || (in && !leaf_is_free(b, hinge, way, width))) continue;
      angle = degrees;
      break;
    }
  }
  const double a = radians_from_degrees(angle);
  const kit::Vec way{(hinge_left ? -1 : 1) * std::cos(a), (in ? 1 : -1) * std::sin(a), 0};
  // A sliding leaf stands half within the wall.
  const double slid = swing == Swing::kSliding ? b.w * 0.45 : 0;
  const kit::Pose pose{way, {-way.y, way.x, 0}, {0, 0, 1}, {hinge.x - slid, hinge.y, 0}};
  Mesh handles;
  Mesh leaf = leaf_mesh(width, height, &handles);
  b.add("oak", posed(std::move(leaf), pose));
  b.add("steel", posed(std::move(handles), pose));
}

// How far the sill must reach into the room to carry what stands on it.
double sill_reach(const Builder& b) {
  double reach = 0.03;
  for (const PlacedObject& object : b.layout.objects) {
    if (object.supported_by != b.opening.id) continue;
    const Vec2 c = b.wall.local({m_from_mm(object.position[0]), m_from_mm(object.position[1])}, m_from_mm(*b.opening.offset));
    const double turn = radians_from_degrees(object.rotation_deg - b.wall.rotation_deg);
    const double half =
        std::abs(std::sin(turn)) * m_from_mm(object.size.width) / 2 + std::abs(std::cos(turn)) * m_from_mm(object.size.depth) / 2;
    reach = std::max(reach, c.y + half);
  }
  return std::min(reach, 0.6);
}

void add_window(Builder& b) {
  const double t = b.wall.thickness, y = -t * 0.6, bar = 0.045, deep = 0.05, lining = 0.02;
  const double x0 = lining, x1 = b.w - lining, z0 = b.sill, z1 = b.sill + b.h - lining;
  Mesh frame, glass;
  const auto add_bar = [&](double xa, double xb, double za, double zb) {
    append(frame, box(sides(xa, xb, y - deep / 2, y + deep / 2, za, zb), 0.004));
  };
  add_bar(x0, x0 + bar, z0, z1);
  add_bar(x1 - bar, x1, z0, z1);
  add_bar(x0 + bar, x1 - bar, z0, z0 + bar);
  add_bar(x0 + bar, x1 - bar, z1 - bar, z1);
  const int columns = std::max(1, static_cast<int>(std::lround((x1 - x0) / 0.7))), rows = z1 - z0 > 1.5 ? 2 : 1;
  const double pane_w = (x1 - x0 - 2 * bar) / columns, pane_h = (z1 - z0 - 2 * bar) / rows, half = 0.016;
  for (int i = 1; i < columns; ++i) add_bar(x0 + bar + pane_w * i - half, x0 + bar + pane_w * i + half, z0 + bar, z1 - bar);
  for (int j = 1; j < rows; ++j) add_bar(x0 + bar, x1 - bar, z0 + bar + pane_h * j - half, z0 + bar + pane_h * j + half);
  append(glass, box(sides(x0 + bar * 0.5, x1 - bar * 0.5, y - 0.004, y + 0.004, z0 + bar * 0.5, z1 - bar * 0.5), 0));
  b.add("lacquer", std::move(frame));
  b.add("glass", std::move(glass));
  if (b.sill > 0.15) {
    const double reach = sill_reach(b);
    b.add("lacquer", box(sides(-kCasing, b.w + kCasing, 0, reach, b.sill - 0.03, b.sill), 0.004));
    // Two millimetres above the wall within the opening: faces in one plane come out black.
    b.add("lacquer", box(sides(0, b.w, y, 0.001, b.sill - 0.01, b.sill + 0.002), 0));
  }
}

}  // namespace

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

void add_openings(const Layout& layout, Palette& palette, Model& model) {
  for (const Opening& opening : layout.room.openings) {
    const Wall* wall = layout.find_wall(opening.wall);
    if (wall == nullptr || !opening.offset) continue;
    const WallFrame frame(*wall);
    Builder b{layout,
              opening,
              frame,
              palette,
              frame.node(opening.id, NodeKind::kOpening, m_from_mm(*opening.offset)),
              m_from_mm(opening.width),
              std::min(m_from_mm(opening.height), m_from_mm(layout.room.height) - 0.01 - m_from_mm(opening.sill)),
              m_from_mm(opening.sill)};
    b.node.parent = wall->id;
    b.node.category = std::string(name_of(opening.type));
    add_frame(b, opening.type != OpeningType::kWindow);
    if (opening.type == OpeningType::kDoor) add_leaf(b);
    if (opening.type == OpeningType::kWindow) add_window(b);
    model.nodes.push_back(std::move(b.node));
  }
}

}  // namespace layoutbox
