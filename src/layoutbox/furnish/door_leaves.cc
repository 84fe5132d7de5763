// Doors: how a leaf is made, and where it stands.
#include <algorithm>
#include <cmath>

#include "layoutbox/base/units.h"
#include "layoutbox/furnish/families/parts.h"
#include "layoutbox/furnish/opening_builder.h"

namespace layoutbox {
namespace {

using kit::append;
using kit::box;
using kit::posed;
using kit::sides;
using kit::Vec;
using kit::Vec2;

constexpr double kLeafThickness = 0.04;
constexpr double kBelowLeaf = 0.008;

// A leaf of w × h metres in its own frame: x from the hinge, y across, z up.
struct LeafMeshes {
  double w, h;
  Mesh body, panes, paper, fittings;
};

void add_lever(LeafMeshes& leaf) {
  const double t = kLeafThickness;
  for (const double side : {-1.0, 1.0}) {
    const double x = leaf.w - 0.05, z = std::min(1.02, leaf.h * 0.5), y = side * (t / 2 + 0.03);
    append(leaf.fittings, kit::rod({x, side * t / 2, z}, {x, y, z}, 0.009, 10));
    append(leaf.fittings, kit::rod({x + 0.009, y, z}, {x - 0.11, y, z}, 0.009, 10));
    append(leaf.fittings, kit::cylinder({x, side * t / 2, z - 0.02}, 0.016, 0.04, 12));
  }
}

// An upright bar on both faces.
void add_pull(LeafMeshes& leaf, double x, double length) {
  const double t = kLeafThickness, z = std::min(1.02, leaf.h * 0.5);
  for (const double side : {-1.0, 1.0}) {
    const double y = side * (t / 2 + 0.03);
    append(leaf.fittings, kit::rod({x, y, z - length / 2}, {x, y, z + length / 2}, 0.01, 10));
    for (const double end : {-0.4, 0.4})
      append(leaf.fittings, kit::rod({x, side * t / 2, z + end * length}, {x, y, z + end * length}, 0.008, 8));
  }
}

// Two raised panels and a lever.
void make_panelled(LeafMeshes& leaf) {
  const double t = kLeafThickness;
  leaf.body = box(sides(0, leaf.w, -t / 2, t / 2, kBelowLeaf, leaf.h), 0.004);
  for (const double side : {-1.0, 1.0}) {
    for (const auto& [z0, z1] : {std::pair{0.12, 0.42}, {0.5, 0.94}}) {
      append(leaf.body, box(sides(leaf.w * 0.16, leaf.w * 0.84, side > 0 ? t / 2 - 0.002 : -t / 2 - 0.006,
                                  side > 0 ? t / 2 + 0.006 : -t / 2 + 0.002, leaf.h * z0, leaf.h * z1),
                            0.004));
    }
  }
  add_lever(leaf);
}

// Stiles and rails round the field x0 … x1, z0 … z1, and bars that part it.
void add_grid(Mesh& mesh, const LeafMeshes& leaf, const kit::Box& field, int columns, int rows, double bar) {
  const double y = kLeafThickness / 2, thin = kLeafThickness * 0.3;
  append(mesh, box(sides(0, field.min.x, -y, y, kBelowLeaf, leaf.h), 0.003));
  append(mesh, box(sides(field.max.x, leaf.w, -y, y, kBelowLeaf, leaf.h), 0.003));
  append(mesh, box(sides(field.min.x, field.max.x, -y, y, kBelowLeaf, field.min.z), 0.003));
  append(mesh, box(sides(field.min.x, field.max.x, -y, y, field.max.z, leaf.h), 0.003));
  const Vec size = field.size();
  for (int i = 1; i < columns; ++i) {
    const double x = field.min.x + size.x * i / columns;
    append(mesh, box(sides(x - bar / 2, x + bar / 2, -thin, thin, field.min.z, field.max.z), 0.002));
  }
  for (int j = 1; j < rows; ++j) {
    const double z = field.min.z + size.z * j / rows;
    append(mesh, box(sides(field.min.x, field.max.x, -thin, thin, z - bar / 2, z + bar / 2), 0.002));
  }
}

// A pane in a slim frame; with bars where it is a French door or of steel.
void make_glazed(LeafMeshes& leaf, bool barred) {
  const double stile = barred ? 0.07 : 0.06;
  const kit::Box field = sides(stile, leaf.w - stile, 0, 0, barred ? 0.2 : 0.09, leaf.h - stile);
  const int columns = barred && leaf.w > 0.6 ? 2 : 1, rows = barred ? 4 : 1;
  add_grid(leaf.body, leaf, field, columns, rows, 0.022);
  leaf.panes = box(sides(field.min.x - 0.01, field.max.x + 0.01, -0.004, 0.004, field.min.z - 0.01, field.max.z + 0.01), 0);
  add_pull(leaf, leaf.w - stile / 2, 0.22);
}

// Five boards over one another, with raised fields.
void make_sectional(LeafMeshes& leaf) {
  constexpr int kSections = 5;
  const double t = kLeafThickness, high = (leaf.h - kBelowLeaf) / kSections;
  const int fields = std::max(2, static_cast<int>(std::lround(leaf.w / 0.65)));
  for (int i = 0; i < kSections; ++i) {
    const double z = kBelowLeaf + high * i;
    append(leaf.body, box(sides(0, leaf.w, -t / 2, t / 2, z + 0.003, z + high - 0.003), 0.006));
    for (int k = 0; k < fields; ++k) {
      const double x0 = leaf.w * k / fields + 0.06, x1 = leaf.w * (k + 1) / fields - 0.06;
      append(leaf.body, box(sides(x0, x1, t / 2 - 0.002, t / 2 + 0.008, z + 0.09, z + high - 0.09), 0.005));
    }
  }
  append(leaf.fittings, box(sides(leaf.w / 2 - 0.08, leaf.w / 2 + 0.08, t / 2, t / 2 + 0.03, 0.12, 0.15), 0.004));
}

// Upright boards with ledges and a brace on the room's side.
void make_planks(LeafMeshes& leaf) {
  const double t = kLeafThickness * 0.6, front = t / 2, ledge = 0.13;
  const int n = std::max(3, static_cast<int>(std::lround(leaf.w / 0.16)));
  for (int i = 0; i < n; ++i)
    append(leaf.body, box(sides(leaf.w * i / n + 0.002, leaf.w * (i + 1) / n - 0.002, -t / 2, t / 2, kBelowLeaf, leaf.h), 0.004));
  for (const double side : {-1.0, 1.0}) {
    const double y0 = side > 0 ? front - 0.001 : -front - 0.018, y1 = side > 0 ? front + 0.018 : -front + 0.001;
    for (const double z : {leaf.h * 0.07, leaf.h * 0.48, leaf.h * 0.86})
      append(leaf.body, box(sides(0.01, leaf.w - 0.01, y0, y1, z, z + ledge), 0.004));
    const double y = (y0 + y1) / 2;
    for (const double z : {0.07, 0.48}) {
      const double from = leaf.h * z + ledge + 0.02, to = leaf.h * (z < 0.3 ? 0.48 : 0.86) - 0.02;
      append(leaf.body, kit::beam({0.09, y, from}, {leaf.w - 0.09, y, to}, {0.1, 0.016}, 0.003));
    }
  }
}

// Paper in a thin lattice over a low board.
void make_lattice(LeafMeshes& leaf) {
  const double stile = 0.035;
  const kit::Box field = sides(stile, leaf.w - stile, 0, 0, leaf.h * 0.18, leaf.h - stile);
  add_grid(leaf.body, leaf, field, std::max(2, static_cast<int>(std::lround(leaf.w / 0.27))),
           std::max(4, static_cast<int>(std::lround(leaf.h / 0.3))), 0.014);
  leaf.paper = box(sides(field.min.x - 0.005, field.max.x + 0.005, -0.003, 0.003, field.min.z - 0.005, field.max.z + 0.005), 0);
}

// A half door of slats at the height of one's chest.
void make_half(LeafMeshes& leaf) {
  const double t = kLeafThickness, z0 = leaf.h * 0.26, z1 = leaf.h * 0.72, stile = 0.07;
  for (const double x : {0.0, leaf.w - stile}) append(leaf.body, box(sides(x, x + stile, -t / 2, t / 2, z0, z1), 0.004));
  for (const double z : {z0, (z0 + z1) / 2 - 0.03, z1 - 0.07})
    append(leaf.body, box(sides(stile, leaf.w - stile, -t / 2, t / 2, z, z + 0.07), 0.004));
  for (double z = z0 + 0.09; z < z1 - 0.1; z += 0.045)
    append(leaf.body, kit::beam({stile, 0, z}, {leaf.w - stile, 0, z}, {0.035, 0.008}, 0.002));
}

LeafMeshes make_leaf(const OpeningBuilder& b, double w, double h) {
  LeafMeshes leaf{w, h, {}, {}, {}, {}};
  switch (b.look.leaf) {
    case Leaf::kPanelled: make_panelled(leaf); break;
    case Leaf::kGlazed: make_glazed(leaf, !b.look.frame.empty() || (b.look.leaves == 2 && !b.look.slides)); break;
    case Leaf::kSectional: make_sectional(leaf); break;
    case Leaf::kPlanks: make_planks(leaf); break;
    case Leaf::kLattice: make_lattice(leaf); break;
    case Leaf::kHalf: make_half(leaf); break;
  }
  return leaf;
}

std::string_view usual_surface(Leaf leaf) {
  switch (leaf) {
    case Leaf::kGlazed: return "lacquer";
    case Leaf::kSectional: return "painted_metal";
    case Leaf::kPlanks: return "reclaimed_wood";
    case Leaf::kLattice: return "walnut";
    default: return "oak";
  }
}

void put(OpeningBuilder& b, LeafMeshes leaf, const kit::Pose& pose) {
  b.add(b.body(usual_surface(b.look.leaf)), posed(std::move(leaf.body), pose));
  b.add("glass", posed(std::move(leaf.panes), pose));
  b.add("paper", posed(std::move(leaf.paper), pose));
  b.add(b.look.rail || b.look.leaf == Leaf::kPlanks ? "black_metal" : "steel", posed(std::move(leaf.fittings), pose));
}

// Whether a leaf from `hinge` in the direction of `way` would meet an object.
bool leaf_is_free(const OpeningBuilder& b, Vec2 hinge, Vec2 way, double length) {
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

// A leaf that hangs at one side of the opening and stands open as far as it may; `ajar`: not shut.
void put_hinged(OpeningBuilder& b, bool hinge_left, double width, double height, bool ajar) {
  const Swing swing = b.opening.swing;
  const bool in = swing == Swing::kInLeft || swing == Swing::kInRight;
  const bool turns = swing != Swing::kNone && swing != Swing::kSliding;
  const double t = b.wall.thickness, y = in ? -0.02 : -std::max(0.02, t - 0.02);
  const Vec2 hinge{hinge_left ? b.w - kLining - 0.003 : kLining + 0.003, turns && b.look.leaf != Leaf::kHalf ? y : -t / 2};
  const bool given_up = b.layout.lists_as_given_up("door swing of " + b.opening.id);
  double angle = 0;
  for (const double degrees : {50.0, 30.0, 15.0}) {
    const double a = radians_from_degrees(degrees);
    const Vec2 way{(hinge_left ? -1 : 1) * std::cos(a), (in ? 1 : -1) * std::sin(a)};
    if (!turns || !ajar || given_up || (in && !leaf_is_free(b, hinge, way, width))) continue;
    angle = degrees;
    break;
  }
  const double a = radians_from_degrees(angle);
  const Vec way{(hinge_left ? -1 : 1) * std::cos(a), (in ? 1 : -1) * std::sin(a), 0};
  put(b, make_leaf(b, width, height), {way, {-way.y, way.x, 0}, {0, 0, 1}, {hinge.x, hinge.y, 0}});
}

// Two leaves on two tracks, shut.
void put_sliding_pair(OpeningBuilder& b, double height) {
  const double lap = 0.04, width = (b.w - 2 * kLining + lap) / 2, t = b.wall.thickness, y = -t / 2, track = kLeafThickness * 0.55;
  put(b, make_leaf(b, width, height), kit::moved(kLining, y - track, 0));
  const kit::Pose other{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {b.w - kLining, y + track, 0}};
  put(b, make_leaf(b, width, height), other);
  b.add("steel", box(sides(kLining, b.w - kLining, y - 2 * track, y + 2 * track, 0, 0.006), 0));
}

// Before the wall, on rollers, with the rail on towards the longer piece of wall.
void put_on_rail(OpeningBuilder& b, double height) {
  const double over = 0.04, thick = 0.025, y = 0.05, width = b.w + 2 * over, z = height + 0.09;
  LeafMeshes leaf = make_leaf(b, width, height + over);
  add_pull(leaf, width - 0.1, 0.3);
  for (const double x : {0.18, 0.82}) {
    append(leaf.fittings, box(sides(width * x - 0.02, width * x + 0.02, 0.03, 0.036, height - 0.2, z + 0.03), 0.001));
    append(leaf.fittings,
           posed(kit::cylinder({0, 0, -0.012}, 0.045, 0.024, 20), kit::moved(width * x, 0.018, z + 0.03) * kit::turned_x(90)));
  }
  put(b, std::move(leaf), kit::moved(-over, y, 0));
  const double before = m_from_mm(*b.opening.offset), after = b.wall.length - before - b.w;
  const double x0 = before > after ? -std::min(before - 0.02, b.w) : -over,
               x1 = before > after ? b.w + over : b.w + std::min(after - 0.02, b.w);
  b.add("black_metal", box(sides(x0, x1, y + 0.012, y + 0.024, z - 0.035, z), 0.002));
  Mesh holders;
  for (const double x : {x0 + 0.08, (x0 + x1) / 2, x1 - 0.08})
    append(holders, kit::rod({x, 0, z - 0.017}, {x, y + thick / 2, z - 0.017}, 0.012, 10));
  b.add("black_metal", std::move(holders));
}

}  // namespace

void add_leaves(OpeningBuilder& b) {
  const double height = b.h - kLining - 0.004, width = b.w - 2 * kLining - 0.006;
  const bool two = has_two_leaves(b.opening);
  const Swing swing = b.opening.swing;
  if (b.look.rail) return put_on_rail(b, height);
  if (b.look.leaf == Leaf::kSectional) return put(b, make_leaf(b, width, height), kit::moved(kLining + 0.003, -b.wall.thickness / 2, 0));
  if (swing == Swing::kSliding && two) return put_sliding_pair(b, height);
  if (swing == Swing::kSliding) {  // half within the wall
    const double slid = b.w * 0.45;
    return put(b, make_leaf(b, width, height), kit::moved(kLining + 0.003 - slid, -b.wall.thickness / 2, 0));
  }
  const bool hinge_left = swing == Swing::kInLeft || swing == Swing::kOutLeft;  // seen from inside, where x runs to the left
  if (!two) return put_hinged(b, hinge_left, width, height, true);
  // The leaf that is used stands ajar; those to the outside are shut.
  const double half = (width - 0.004) / 2;
  put_hinged(b, hinge_left, half, height, !b.look.outside);
  put_hinged(b, !hinge_left, half, height, false);
}

}  // namespace layoutbox
