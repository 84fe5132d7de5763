// Windows: frame, bars, panes and sill; round and arched ones stand in a piece of wall of that shape.
#include <algorithm>
#include <cmath>
#include <vector>

#include "layoutbox/base/units.h"
#include "layoutbox/furnish/families/parts.h"
#include "layoutbox/furnish/opening_builder.h"

namespace layoutbox {
namespace {

using kit::append;
using kit::box;
using kit::posed;
using kit::sides;
using kit::Vec2;

constexpr double kDeep = 0.05;  // of the frame, across the wall
constexpr int kArcSteps = 16;   // of a quarter turn

// An outline in the plane of the wall (along it, up), drawn out from y0 to y1.
Mesh upright(const std::vector<Vec2>& outline, double y0, double y1) {
  return posed(kit::prism(outline, -y1, -y0), {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}});
}

// How a pane is parted and framed.
struct Bars {
  double y, frame, half;  // where across the wall, width of the frame, half the width of a bar
  Mesh mesh;
  void add(double x0, double x1, double z0, double z1) { append(mesh, box(sides(x0, x1, y - kDeep / 2, y + kDeep / 2, z0, z1), 0.003)); }
};

struct Arch {
  Vec2 center, radius;
  Vec2 at(double quarter_turns, double less = 0) const {
    const double a = kPi / 2 * quarter_turns;
    return {center.x + (radius.x - less) * std::cos(a), center.y + (radius.y - less) * std::sin(a)};
  }
  // Points from one quarter turn to another, both ends included.
  std::vector<Vec2> points(double from, double to, double less = 0) const {
    std::vector<Vec2> line;
    const int steps = static_cast<int>(kArcSteps * std::abs(to - from));
    for (int i = 0; i <= steps; ++i) line.push_back(at(from + (to - from) * i / steps, less));
    return line;
  }
};

// What is left of the wall in that corner of the opening, outside the arch. quarter 0: towards the wall's end and up, then
// counter-clockwise.
Mesh spandrel(const OpeningBuilder& b, const Arch& arch, int quarter) {
  std::vector<Vec2> outline = arch.points(quarter + 1, quarter);
  const double sx = quarter == 0 || quarter == 3 ? 1 : -1, sz = quarter < 2 ? 1 : -1;
  outline.push_back({arch.center.x + sx * arch.radius.x, arch.center.y + sz * arch.radius.y});
  Mesh mesh = upright(outline, -b.wall.thickness, 0);
  // The wall's pattern goes on over it.
  for (Vec2f& uv : mesh.uvs) uv[0] += static_cast<float>(m_from_mm(*b.opening.offset));
  return mesh;
}

// A bent piece of the frame.
Mesh ring(const Arch& arch, double from, double to, double wide, double y0, double y1) {
  std::vector<Vec2> outline = arch.points(from, to);
  const std::vector<Vec2> inner = arch.points(to, from, wide);
  outline.insert(outline.end(), inner.begin(), inner.end());
  return upright(outline, y0, y1);
}

void finish(OpeningBuilder& b, Bars& bars, Mesh glass) {
  b.add(b.body("lacquer"), std::move(bars.mesh));
  const SurfaceWish pane = read_wish(b.look.pane);
  b.add(b.palette.add(pane.materials.empty() ? named_surface("glass").surface : pane.materials.front()->surface), std::move(glass));
}

void add_round(OpeningBuilder& b, Bars& bars) {
  const Arch arch{{b.w / 2, b.sill + b.h / 2}, {b.w / 2, b.h / 2}};
  Mesh wall;
  for (int quarter = 0; quarter < 4; ++quarter) append(wall, spandrel(b, arch, quarter));
  b.add(b.wall_surface, std::move(wall));
  const double y0 = bars.y - kDeep / 2, y1 = bars.y + kDeep / 2, trim = 0.05;
  for (const double from : {0.0, 2.0}) {
    append(bars.mesh, ring(arch, from, from + 2, bars.frame, y0, y1));
    // A trim on the wall, round the opening.
    const Arch outer{arch.center, {arch.radius.x + trim, arch.radius.y + trim}};
    append(bars.mesh, ring(outer, from, from + 2, trim, 0, 0.014));
  }
  if (b.w > 0.65) {
    bars.add(b.w / 2 - bars.half, b.w / 2 + bars.half, b.sill + bars.frame, b.sill + b.h - bars.frame);
    bars.add(bars.frame, b.w / 2 - bars.half, arch.center.y - bars.half, arch.center.y + bars.half);
    bars.add(b.w / 2 + bars.half, b.w - bars.frame, arch.center.y - bars.half, arch.center.y + bars.half);
  }
  std::vector<Vec2> disc = arch.points(0, 4, bars.frame / 2);
  disc.pop_back();
  finish(b, bars, upright(disc, bars.y - 0.004, bars.y + 0.004));
}

void add_sill(OpeningBuilder& b, double y);

void add_arched(OpeningBuilder& b, Bars& bars) {
  const double rise = std::min(b.w / 2, b.h * 0.6), spring = b.sill + b.h - rise;
  const Arch arch{{b.w / 2, spring}, {b.w / 2, rise}};
  Mesh wall;
  for (const int quarter : {0, 1}) append(wall, spandrel(b, arch, quarter));
  b.add(b.wall_surface, std::move(wall));
  append(bars.mesh, ring(arch, 0, 2, bars.frame, bars.y - kDeep / 2, bars.y + kDeep / 2));
  bars.add(0, bars.frame, b.sill, spring);
  bars.add(b.w - bars.frame, b.w, b.sill, spring);
  bars.add(bars.frame, b.w - bars.frame, b.sill, b.sill + bars.frame);
  bars.add(bars.frame, b.w - bars.frame, spring - bars.half, spring + bars.half);
  bars.add(b.w / 2 - bars.half, b.w / 2 + bars.half, b.sill + bars.frame, spring - bars.half);
  bars.add(b.w / 2 - bars.half, b.w / 2 + bars.half, spring + bars.half, b.sill + b.h - bars.frame);
  std::vector<Vec2> pane = arch.points(0, 2, bars.frame / 2);
  pane.push_back({bars.frame / 2, b.sill + bars.frame / 2});
  pane.push_back({b.w - bars.frame / 2, b.sill + bars.frame / 2});
  finish(b, bars, upright(pane, bars.y - 0.004, bars.y + 0.004));
  add_sill(b, bars.y);
}

// How far the sill must reach into the room to carry what stands on it.
double sill_reach(const OpeningBuilder& b) {
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

void add_sill(OpeningBuilder& b, double y) {
  if (b.sill <= 0.15) return;
  const double reach = sill_reach(b);
  b.add("lacquer", box(sides(-kCasing, b.w + kCasing, 0, reach, b.sill - 0.03, b.sill), 0.004));
  // Two millimetres above the wall within the opening: faces in one plane come out black.
  b.add("lacquer", box(sides(0, b.w, y, 0.001, b.sill - 0.01, b.sill + 0.002), 0));
}

void add_rectangular(OpeningBuilder& b, Bars& bars, bool fine) {
  const double x0 = kLining, x1 = b.w - kLining, z0 = b.sill, z1 = b.sill + b.h - kLining, bar = bars.frame, half = bars.half;
  bars.add(x0, x0 + bar, z0, z1);
  bars.add(x1 - bar, x1, z0, z1);
  bars.add(x0 + bar, x1 - bar, z0, z0 + bar);
  bars.add(x0 + bar, x1 - bar, z1 - bar, z1);
  const double pitch = fine ? 0.42 : 0.7;
  const int columns = std::max(1, static_cast<int>(std::lround((x1 - x0) / pitch)));
  const int rows = fine ? std::max(1, static_cast<int>(std::lround((z1 - z0) / 0.5))) : z1 - z0 > 1.5 ? 2 : 1;
  const double pane_w = (x1 - x0 - 2 * bar) / columns, pane_h = (z1 - z0 - 2 * bar) / rows;
  for (int i = 1; i < columns; ++i) bars.add(x0 + bar + pane_w * i - half, x0 + bar + pane_w * i + half, z0 + bar, z1 - bar);
  for (int j = 1; j < rows; ++j) bars.add(x0 + bar, x1 - bar, z0 + bar + pane_h * j - half, z0 + bar + pane_h * j + half);
  finish(b, bars, box(sides(x0 + bar * 0.5, x1 - bar * 0.5, bars.y - 0.004, bars.y + 0.004, z0 + bar * 0.5, z1 - bar * 0.5), 0));
  add_sill(b, bars.y);
}

// A bay: panes along three sides of it, under a roof and over a board of their own.
void add_bay(OpeningBuilder& b, Bars& bars) {
  const double out = std::min(0.5, b.w / 4), t = b.wall.thickness, z0 = b.sill, z1 = b.sill + b.h, bar = bars.frame;
  const std::vector<Vec2> foot{{0, -t}, {out, -t - out}, {b.w - out, -t - out}, {b.w, -t}};
  Mesh glass;
  for (std::size_t side = 0; side + 1 < foot.size(); ++side) {
    const Vec2 a = foot[side], e = foot[side + 1];
    const double length = std::hypot(e.x - a.x, e.y - a.y);
    const int panes = std::max(1, static_cast<int>(std::lround(length / 0.7)));
    for (int i = 0; i <= panes; ++i) {
      const double x = a.x + (e.x - a.x) * i / panes, y = a.y + (e.y - a.y) * i / panes;
      append(bars.mesh, box(sides(x - bar / 2, x + bar / 2, y - bar / 2, y + bar / 2, z0, z1), 0.003));
    }
    for (const double z : {z0 + bar / 2, z1 - bar / 2}) append(bars.mesh, kit::beam({a.x, a.y, z}, {e.x, e.y, z}, {bar, bar}));
    append(glass, kit::beam({a.x, a.y, (z0 + z1) / 2}, {e.x, e.y, (z0 + z1) / 2}, {0.008, b.h - 2 * bar}));
  }
  const std::vector<Vec2> level{foot[0], foot[1], foot[2], foot[3]};
  Mesh boards = kit::prism(level, z0 - 0.05, z0);
  append(boards, kit::prism(level, z1, z1 + 0.05));
  b.add("lacquer", std::move(boards));
  finish(b, bars, std::move(glass));
  add_sill(b, -t);
}

}  // namespace

void add_window(OpeningBuilder& b) {
  const bool fine = read_wish(b.look.frame).fitting(named_surface("steel")) != nullptr;  // many small panes in thin bars of metal
  Bars bars{-b.wall.thickness * 0.6, fine ? 0.035 : 0.045, fine ? 0.01 : 0.016, {}};
  if (b.look.bay) return add_bay(b, bars);
  switch (b.look.shape) {
    case OpeningShape::kRectangle: add_rectangular(b, bars, fine); break;
    case OpeningShape::kRound: add_round(b, bars); break;
    case OpeningShape::kArched: add_arched(b, bars); break;
  }
}

}  // namespace layoutbox
