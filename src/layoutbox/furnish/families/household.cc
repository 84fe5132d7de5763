// Household things by their own looks: airers, cages, tea sets, lanterns, brushes.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// A folding airer: legs that cross at both ends, rods from end to end, and a few things that dry.
void airer(Piece& p) {
  const int metal = p.main("painted_metal"), cap = p.named("grey_plastic");
  const double x = p.w / 2, y = p.d / 2, r = std::min(0.012, p.w * 0.02), top = p.h - r;
  for (const double s : {-1.0, 1.0}) {
    const double ex = s * (x - r);
    p.add(metal, rod({ex, -y + r, r}, {ex, y - r, top}, r, 10));
    p.add(metal, rod({ex, y - r, r}, {ex, -y + r, top}, r, 10));
    p.add(metal, rod({ex, -y + r, top}, {ex, y - r, top}, r * 0.8, 10));
    for (const double e : {-1.0, 1.0}) p.add(cap, ellipsoid({ex, e * (y - r), r}, {r, r, r}, 10, 6));
    p.add(metal, rod({-x + r, s * (y - r) * 0.72, r * 2 + p.h * 0.14}, {x - r, s * (y - r) * 0.72, r * 2 + p.h * 0.14}, r * 0.8, 8));
  }
  const int rods = std::max(5, static_cast<int>(p.d / 0.075));
  for (int i = 0; i < rods; ++i) {
    const double ry = (-y + r) + 2 * (y - r) * i / (rods - 1);
    p.add(metal, rod({-x, ry, top}, {x, ry, top}, r * 0.5, 8));
  }
  if (!p.may_show_contents()) return;
  const Color cloths[] = {p.accent(), {0.90, 0.87, 0.80}, {0.78, 0.62, 0.52}};
  int k = 0;
  for (const double at : {0.22, 0.55, 0.84}) {
    const double ry = -y + r + 2 * (y - r) * std::round(at * (rods - 1)) / (rods - 1), wide = p.w * (k == 1 ? 0.36 : 0.42),
                 cx = x * (k == 0   ? -0.4
                           : k == 1 ? 0.4
                                    : -0.15),
                 drop = std::min(p.h * 0.48, 0.55) * (k == 1 ? 0.8 : 1), t = r * 0.5 + 0.003;
    const int cloth = p.tinted("cotton", cloths[k++]);
    // Over the rod: an upside-down U, drawn along x.
    p.add(cloth,
          prism({{ry - t - 0.004, top - drop},
                 {ry - t, top - drop},
                 {ry - t, top + r * 0.5},
                 {ry + t, top + r * 0.5},
                 {ry + t, top - drop * 0.85},
                 {ry + t + 0.004, top - drop * 0.85},
                 {ry + t + 0.004, p.h},
                 {ry - t - 0.004, p.h}},
                cx - wide / 2, cx + wide / 2),
          Pose{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {}});
  }
}

// Wires round a space for plates.
void dish_rack(Piece& p) {
  const int wire = p.main("steel"), tray = p.named("black_plastic");
  const double x = p.w / 2, y = p.d / 2, r = std::min(0.004, x * 0.03);
  const double floor = p.spaces.empty() ? 0.02 : p.spaces.front().box.min.z;
  p.add(tray, box(sides(-x, x, -y, y, 0, floor), std::min(0.006, floor * 0.3)));
  for (const double z : {floor + (p.h - floor) * 0.45, p.h - r}) {
    for (const double s : {-1.0, 1.0}) {
      p.add(wire, rod({-x, s * (y - r), z}, {x, s * (y - r), z}, r, 8));
      p.add(wire, rod({s * (x - r), -y, z}, {s * (x - r), y, z}, r, 8));
    }
  }
  const int n = std::max(4, static_cast<int>(p.w / 0.05));
  for (int i = 0; i <= n; ++i) {
    for (const double s : {-1.0, 1.0}) {
      const double wx = -x + r + 2 * (x - r) * i / n;
      p.add(wire, rod({wx, s * (y - r), floor}, {wx, s * (y - r), p.h - r}, r * 0.8, 6));
    }
  }
  if (!p.may_show_contents() || p.spaces.empty() || p.spaces.front().held) return;
  const double plate = std::min({y * 0.86, (p.h - floor) * 0.95, 0.12});
  for (int i = 0; i < 5; ++i)
    p.add(p.named("ceramic"), lathe({{0, 0}, {plate * 0.7, 0}, {plate, 0.012}, {plate, 0.016}, {plate * 0.68, 0.005}, {0, 0.005}}, 28),
          aimed({-x * 0.72 + x * 0.22 * i, 0, floor + plate}, {1, 0, 0}));
}

// Bars all round; a tall one is domed and has a perch, a low one is a crate with a pad.
void cage(Piece& p) {
  const int bar = p.main("black_metal"), tray = p.named("black_plastic");
  const double x = p.w / 2, y = p.d / 2, r = std::min({0.004, x * 0.02}), base = std::min(0.05, p.h * 0.08);
  const bool bird = p.category() == "bird_cage" || p.says("bird") || p.says("parrot");
  const double top = bird ? p.h * 0.78 : p.h - r;
  p.add(tray, box(sides(-x, x, -y, y, 0, base), std::min(0.01, base * 0.3)));
  const auto around = [&](double z, double thick) {
    for (const double s : {-1.0, 1.0}) {
      p.add(bar, rod({-x, s * (y - thick), z}, {x, s * (y - thick), z}, thick, 6));
      p.add(bar, rod({s * (x - thick), -y, z}, {s * (x - thick), y, z}, thick, 6));
    }
  };
  around(top, r * 1.4);
  around(base + (top - base) * 0.5, r);
  const Vec apex{0, 0, p.h - 0.03};
  const auto upright = [&](double bx, double by) {
    p.add(bar, rod({bx, by, base - 0.002}, {bx, by, top}, r, 5));
    if (bird) p.add(bar, tube(curve({{bx, by, top}, {bx * 0.75, by * 0.75, top + (p.h - top) * 0.6}, apex}, 3), r, 5));
  };
  const int nx = std::clamp(static_cast<int>(p.w / 0.05), 5, 16), ny = std::clamp(static_cast<int>(p.d / 0.05), 5, 18);
  for (int i = 0; i <= nx; ++i) {
    for (const double s : {-1.0, 1.0}) upright(-x + r + 2 * (x - r) * i / nx, s * (y - r));
  }
  for (int i = 1; i < ny; ++i) {
    for (const double s : {-1.0, 1.0}) upright(s * (x - r), -y + r + 2 * (y - r) * i / ny);
  }
  if (bird) {
    p.add(bar, torus({0, 0, 0}, 0.02, 0.004, 16, 6), aimed({0, 0, p.h - 0.022}, {0, 1, 0}));
    p.add(p.named("oak"),
          rod({-x * 0.9, 0, base + (top - base) * 0.42}, {x * 0.9, 0, base + (top - base) * 0.42}, std::min(0.008, x * 0.05), 8));
    const Vec at{x * 0.15, 0, base + (top - base) * 0.42};
    const double k = std::min(x, y) * 0.3;
    p.add(p.tinted("wax", {0.94, 0.78, 0.26}), ellipsoid(at + Vec{0, 0, k * 0.9}, {k * 0.5, k * 0.55, k * 0.9}, 14, 8));
    p.add(p.tinted("wax", {0.94, 0.78, 0.26}), ellipsoid(at + Vec{0, -k * 0.15, k * 1.9}, {k * 0.4, k * 0.42, k * 0.4}, 12, 8));
    p.add(p.tinted("wax", {0.86, 0.46, 0.2}), cone({0, 0, 0}, k * 0.14, k * 0.02, k * 0.35, 8),
          aimed(at + Vec{0, -k * 0.5, k * 1.85}, {0, -1, -0.2}));
  } else {
    for (int i = 1; i < nx; ++i) p.add(bar, rod({-x + 2 * x * i / nx, -y + r, top}, {-x + 2 * x * i / nx, y - r, top}, r, 5));
    p.add(p.main_accent("wool"),
          cushion(sides(-x * 0.9, x * 0.9, -y * 0.9, y * 0.9, base - 0.002, base + std::min(0.07, p.h * 0.12)), 0.03, true, 5));
    around(base + (top - base) * 0.95, r);
  }
  p.fit();
}

// A tray with a pot, cups on saucers and a sugar bowl.
void tea_set(Piece& p) {
  const int china = p.main_accent("ceramic"), tray = p.named("oak"), tea = p.tinted("wax", {0.52, 0.26, 0.10});
  const double x = p.w / 2, y = p.d / 2, t = std::min(0.012, p.h * 0.1), rim = t * 2.2;
  p.add(tray, box(sides(-x, x, -y, y, 0, t), t * 0.3));
  for (const double s : {-1.0, 1.0}) {
    p.add(tray, box(sides(s > 0 ? x - t : -x, s > 0 ? x : -x + t, -y, y, t * 0.8, rim), t * 0.2));
    p.add(tray, box(sides(-x + t * 0.9, x - t * 0.9, s > 0 ? y - t : -y, s > 0 ? y : -y + t, t * 0.8, rim), t * 0.2));
  }
  const double r = std::min({x * 0.4, y * 0.52, (p.h - t) * 0.6}), h = p.h - t, cx = -x * 0.3, cy = y * 0.22;
  const Pose at = moved(cx, cy, t);
  p.add(china,
        lathe({{0, 0},
               {r * 0.62, 0},
               {r * 0.64, h * 0.04},
               {r * 0.92, h * 0.2},
               {r, h * 0.42},
               {r * 0.86, h * 0.62},
               {r * 0.56, h * 0.76},
               {0, h * 0.76}},
              28),
        at);
  p.add(china, lathe({{0, h * 0.75}, {r * 0.58, h * 0.75}, {r * 0.44, h * 0.84}, {r * 0.1, h * 0.88}, {r * 0.17, h * 0.95}, {0, h}}, 22),
        at);
  p.add(china, tube(curve({{-r * 0.85, 0, h * 0.35}, {-r * 1.22, 0, h * 0.5}, {-r * 1.42, 0, h * 0.72}}, 5), r * 0.11, 10), at);
  p.add(china,
        tube(curve({{r * 0.82, 0, h * 0.62}, {r * 1.35, 0, h * 0.62}, {r * 1.38, 0, h * 0.32}, {r * 0.9, 0, h * 0.22}}, 5), r * 0.08, 8),
        at);
  const double c = std::min({x * 0.17, y * 0.24, h * 0.4});
  for (const auto& [sx, sy] : {std::pair{0.46, 0.45}, {0.72, -0.1}, {0.3, -0.5}, {-0.3, -0.6}}) {
    const Pose place = moved(sx * x, sy * y, t);
    p.add(china, lathe({{0, 0}, {c * 0.7, 0}, {c * 1.35, c * 0.22}, {c * 1.35, c * 0.28}, {c * 0.6, c * 0.1}, {0, c * 0.1}}, 24), place);
    p.add(china,
          lathe({{0, c * 0.1},
                 {c * 0.5, c * 0.1},
                 {c * 0.86, c * 0.55},
                 {c * 0.9, c * 1.1},
                 {c * 0.82, c * 1.1},
                 {c * 0.76, c * 0.6},
                 {c * 0.3, c * 0.3},
                 {0, c * 0.3}},
                22),
          place);
    p.add(tea, lathe({{0, c * 0.7}, {c * 0.79, c * 0.7}, {c * 0.8, c * 0.86}, {0, c * 0.86}}, 20), place);
    p.add(china,
          tube(curve({{c * 0.84, 0, c * 0.95}, {c * 1.25, 0, c * 0.9}, {c * 1.2, 0, c * 0.5}, {c * 0.78, 0, c * 0.45}}, 3), c * 0.08, 6),
          place * turned_z(-40));
  }
}

void lantern_on_foot(Piece& p) {
  lantern(p, p.h);
  p.fit();
}

void toilet_brush(Piece& p) {
  const int white = p.main("ceramic"), chrome = p.named("chrome");
  const double r = p.w / 2, h = p.h, cup = h * 0.42;
  p.add(white, lathe({{0, 0}, {r * 0.92, 0}, {r, cup * 0.1}, {r * 0.86, cup * 0.92}, {r * 0.8, cup}, {r * 0.3, cup}, {0, cup}}, 28),
        scaled(1, p.d / p.w, 1));
  p.add(chrome,
        lathe({{0, cup * 0.98}, {r * 0.14, cup * 0.98}, {r * 0.14, h * 0.8}, {r * 0.2, h * 0.84}, {r * 0.2, h * 0.98}, {0, h}}, 14));
}

void pen_holder(Piece& p) {
  const double r = std::min(p.w, p.d) / 2, cup = p.h * 0.62;
  vessel(p, p.main_accent("plastic"), {{r * 0.96, 0}, {r, cup}}, r * 0.08, p.h * 0.04, 26);
  static constexpr Color kPens[] = {{0.86, 0.62, 0.20}, {0.20, 0.34, 0.62}, {0.74, 0.22, 0.20}, {0.16, 0.17, 0.19}, {0.26, 0.52, 0.36}};
  for (int i = 0; i < 5; ++i) {
    const double a = 2 * kPi * i / 5 + 0.3, out = r * 0.52;
    const Vec low{std::cos(a) * out * 0.4, std::sin(a) * out * 0.4, p.h * 0.05},
        high{std::cos(a) * out * 1.25, std::sin(a) * out * 1.25, p.h * (0.86 + 0.035 * i)};
    p.add(p.tinted("plastic", kPens[i]), rod(low, high - unit(high - low) * p.h * 0.06, r * 0.1, 8));
    p.add(p.named("wax"), cone({0, 0, 0}, r * 0.1, r * 0.02, p.h * 0.06, 8), aimed(high - unit(high - low) * p.h * 0.06, high - low));
  }
  p.fit();
}

}  // namespace

void lantern(Piece& p, double high) {
  const int metal = p.main("black_metal");
  const double x = p.w / 2, y = p.d / 2, t = std::min(x, y) * 0.12, body = high * 0.72, ring = high * 0.1;
  for (const double z : {0.0, body - t}) p.add(metal, box(sides(-x, x, -y, y, z, z + t), t * 0.2));
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0})
      p.add(metal, box(sides(sx > 0 ? x * 0.96 - t : -x * 0.96, sx > 0 ? x * 0.96 : t - x * 0.96, sy > 0 ? y * 0.96 - t : -y * 0.96,
                             sy > 0 ? y * 0.96 : t - y * 0.96, t * 0.9, body - t * 0.9),
                       0));
  }
  p.add(metal, taper({0, 0, body - 0.001}, {x * 0.92, y * 0.92}, {0, 0, high - ring}, {x * 0.25, y * 0.25}));
  p.add(metal, torus({0, 0, 0}, ring * 0.42, ring * 0.1, 18, 6), aimed({0, 0, high - ring * 0.52}, {0, 1, 0}));
  const double wax = body * 0.42, r = std::min(x, y) * 0.42;
  p.add(p.named("wax"), cylinder({0, 0, t}, r, wax, 20));
  p.add(p.named("ember"), lathe({{0, 0}, {r * 0.2, wax * 0.12}, {r * 0.14, wax * 0.26}, {0, wax * 0.45}}, 10), moved(0, 0, t + wax));
  p.light({0, 0, t + wax * 1.5}, 3, 0.03);
}

void add_household(Families& to) {
  to["airer"] = airer;
  to["dish_rack"] = dish_rack;
  to["cage"] = cage;
  to["tea_set"] = tea_set;
  to["lantern"] = lantern_on_foot;
  to["toilet_brush"] = toilet_brush;
  to["pen_holder"] = pen_holder;
}

}  // namespace layoutbox::kit
