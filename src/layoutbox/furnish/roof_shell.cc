#include "layoutbox/furnish/roof_shell.h"

#include <algorithm>
#include <cmath>

#include "layoutbox/base/units.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/furnish/families/parts.h"

namespace layoutbox {
namespace {

using kit::Vec2;

constexpr double kRoofTouches = 0.05;  // metres

struct Slope {
  Vec2 middle, back;  // back: towards its knee wall
  double width, depth, low, high;
};

std::vector<Slope> slopes_of(const Layout& layout, const Catalog& catalog) {
  std::vector<Slope> slopes;
  for (const PlacedObject& object : layout.objects) {
    if (!catalog.entry_or_nearest(object.category).is(Trait::kRoofSlope)) continue;
    const double turn = radians_from_degrees(object.rotation_deg), low = m_from_mm(object.position[2]);
    slopes.push_back({{m_from_mm(object.position[0]), m_from_mm(object.position[1])},
                      {-std::sin(turn), std::cos(turn)},
                      m_from_mm(object.size.width),
                      m_from_mm(object.size.depth),
                      low,
                      low + m_from_mm(object.size.height)});
  }
  return slopes;
}

// A corner of a triangle.
struct CutCorner {
  Vec3f at, normal;
  Vec2f uv;
};

CutCorner between(const CutCorner& a, const CutCorner& b, float share) {
  const auto mix = [share](const auto& from, const auto& to) {
    auto mixed = from;
    for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i] += share * (to[i] - from[i]);
    return mixed;
  };
  return {mix(a.at, b.at), a.normal, mix(a.uv, b.uv)};
}

float above(const CutCorner& corner, const RoofLine& line) {
  const double slope = (line.high_z - line.low_z) / (line.high_x - line.low_x);
  return static_cast<float>(double{corner.at[2]} - line.low_z - slope * (double{corner.at[0]} - line.low_x));
}

// What of the triangle is below the line, as corners in its order.
std::vector<CutCorner> below(const std::array<CutCorner, 3>& triangle, const RoofLine& line) {
  std::vector<CutCorner> left;
  for (std::size_t i = 0; i < 3; ++i) {
    const CutCorner &a = triangle[i], &b = triangle[(i + 1) % 3];
    const float over_a = above(a, line), over_b = above(b, line);
    if (over_a <= 0) left.push_back(a);
    if ((over_a < 0 && over_b > 0) || (over_a > 0 && over_b < 0)) left.push_back(between(a, b, over_a / (over_a - over_b)));
  }
  return left;
}

Mesh cut_under(const Mesh& mesh, const RoofLine& line) {
  Mesh cut;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const auto corner = [&](std::size_t i) {
      const std::uint32_t k = mesh.indices[t + i];
      return CutCorner{mesh.positions[k], mesh.normals[k], mesh.uvs[k]};
    };
    const std::vector<CutCorner> left = below({corner(0), corner(1), corner(2)}, line);
    const auto first = static_cast<std::uint32_t>(cut.positions.size());
    for (const CutCorner& c : left) cut.positions.push_back(c.at), cut.normals.push_back(c.normal), cut.uvs.push_back(c.uv);
    for (std::uint32_t i = 2; i < left.size(); ++i) cut.indices.insert(cut.indices.end(), {first, first + i - 1, first + i});
  }
  return cut;
}

}  // namespace

RoofEdge roof_over(const Layout& layout, const Catalog& catalog, const WallFrame& wall, double height) {
  RoofEdge edge{height, {}};
  for (const Slope& slope : slopes_of(layout, catalog)) {
    const Vec2 at = wall.local(slope.middle, 0);
    const double along = slope.back.x * wall.along.x + slope.back.y * wall.along.y,
                 inward = slope.back.x * wall.inward.x + slope.back.y * wall.inward.y;
    const bool knee = inward < -0.9 && std::abs(at.y - slope.depth / 2) < kRoofTouches && slope.width > wall.length - kRoofTouches;
    if (knee) edge.height = std::min(edge.height, slope.low + 0.02);
    const double low = at.x + along * slope.depth / 2, end = along > 0 ? wall.length : 0;
    const bool gable = std::abs(along) > 0.9 && std::abs(at.y - slope.width / 2) < kRoofTouches && std::abs(low - end) < kRoofTouches;
    if (gable) edge.lines.push_back({end, slope.low, at.x - along * slope.depth / 2, slope.high});
  }
  return edge;
}

Mesh cut_under(Mesh mesh, const std::vector<RoofLine>& lines, double thickness) {
  constexpr double kCap = 0.02, kOver = 0.004, kInset = 0.001;
  for (const RoofLine& line : lines) mesh = cut_under(mesh, line);
  for (const RoofLine& line : lines) {
    // The wall reaches out round the corner by its thickness.
    const double out = line.low_x < line.high_x ? -thickness : thickness, slope = (line.high_z - line.low_z) / (line.high_x - line.low_x);
    const Vec2 low{line.low_x + out, line.low_z + slope * out + kOver}, high{line.high_x, line.high_z + kOver};
    std::vector<Vec2> outline{{low.x, low.y - kCap}, {high.x, high.y - kCap}, {high.x, high.y}, {low.x, low.y}};
    if (low.x > high.x) std::ranges::reverse(outline);
    // Drawn along the wall's depth: x, z of the wall are the outline's.
    kit::append(mesh, kit::posed(kit::prism(outline, kInset, thickness), kit::Pose{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}}));
  }
  return mesh;
}

void add_roof_panels(const Layout& layout, const Catalog& catalog, int surface, Model& model) {
  constexpr double kThick = 0.04;
  int number = 0;
  for (const PlacedObject& object : layout.objects) {
    if (!catalog.entry_or_nearest(object.category).is(Trait::kRoofSlope)) continue;
    const double w = m_from_mm(object.size.width) / 2, d = m_from_mm(object.size.depth) / 2, h = m_from_mm(object.size.height);
    std::vector<std::pair<double, double>> fields{{-w, w}};  // along the wall, but for windows
    for (const Space& space : object.spaces) {
      if (!space.name.starts_with("window")) continue;
      const double a = space.min[0] / 1000, b = space.max[0] / 1000;
      const auto [from, to] = fields.back();
      fields.back() = {from, a};
      fields.emplace_back(b, to);
    }
    Node node;
    node.id = "roof" + std::to_string(++number);
    node.kind = NodeKind::kCeiling;
    node.position = {static_cast<float>(m_from_mm(object.position[0])), static_cast<float>(m_from_mm(object.position[1])),
                     static_cast<float>(m_from_mm(object.position[2]))};
    node.rotation_deg = static_cast<float>(object.rotation_deg);
    const std::vector<Vec2> outline{{-d, h}, {d, 0}, {d, kThick}, {-d, h + kThick}};
    for (const auto& [a, b] : fields) {
      if (b - a > 0.02)
        node.parts.push_back({kit::posed(kit::prism(outline, a, b), kit::Pose{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {}}), surface});
    }
    model.nodes.push_back(std::move(node));
  }
}

}  // namespace layoutbox
