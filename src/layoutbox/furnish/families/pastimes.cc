// What one plays, makes music and spins with: chess sets, drums, spinning wheels, scooters.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

void chess_set(Piece& p) {
  const int frame = p.main("walnut"), dark = p.tinted("lacquer", {0.20, 0.13, 0.09}), light = p.tinted("lacquer", {0.90, 0.82, 0.66});
  const double x = p.w / 2, y = p.d / 2, board = std::min(0.025, p.h * 0.25), field = 0.9 / 8, tall = p.h - board;
  p.add(frame, box(sides(-x, x, -y, y, 0, board - 0.001), 0.003));
  for (int i = 0; i < 8; ++i) {
    for (int k = 0; k < 8; ++k)
      p.add((i + k) % 2 != 0 ? light : dark, box(sides(p.w * (-0.45 + field * i), p.w * (-0.45 + field * (i + 1)),
                                                       p.d * (-0.45 + field * k), p.d * (-0.45 + field * (k + 1)), board - 0.003, board),
                                                 0));
  }
  static constexpr double kHeights[] = {0.62, 0.72, 0.8, 0.92, 1.0, 0.8, 0.72, 0.62};
  const double r = std::min(p.w, p.d) * field * 0.34;
  for (const int row : {0, 1, 6, 7}) {
    for (int i = 0; i < 8; ++i) {
      const bool pawn = row == 1 || row == 6;
      const double h = tall * (pawn ? 0.5 : kHeights[i]), cx = p.w * (-0.45 + field * (i + 0.5)), cy = p.d * (-0.45 + field * (row + 0.5));
      p.add(row < 4 ? light : dark,
            lathe({{0, 0},
                   {r, 0},
                   {r * 0.95, h * 0.1},
                   {r * 0.42, h * 0.25},
                   {r * 0.34, h * 0.6},
                   {r * 0.62, h * 0.7},
                   {r * 0.5, h * 0.88},
                   {0, h}},
                  10),
            moved(cx, cy, board));
    }
  }
}

void drum(Piece& p) {
  const int shell = p.main_accent("lacquer"), metal = p.named("chrome"), skin = p.named("cotton");
  const double r = 0.47, h = p.h / std::min(p.w, p.d);
  p.add(shell, lathe({{0, h * 0.03}, {r, h * 0.03}, {r, h * 0.97}, {0, h * 0.97}}, 36));
  p.add(skin, lathe({{0, h * 0.96}, {r * 0.98, h * 0.96}, {r * 0.96, h * 0.995}, {0, h}}, 36));
  for (const double z : {0.0, h * 0.93})
    p.add(metal,
          lathe({{r * 0.9, z}, {r * 1.05, z}, {r * 1.05, z + h * 0.06}, {r * 0.99, z + h * 0.06}, {r * 0.9, z + h * 0.03}, {r * 0.9, z}},
                36));
  for (int i = 0; i < 8; ++i) {
    const double a = kPi * (i + 0.5) / 4;
    p.add(metal, rod({std::cos(a) * r * 1.03, std::sin(a) * r * 1.03, h * 0.03}, {std::cos(a) * r * 1.03, std::sin(a) * r * 1.03, h * 0.96},
                     0.012, 6));
  }
  p.fit();
}

// Two rails on posts with feet.
void barre(Piece& p) {
  const int wood = p.main("oak"), metal = p.frame("black_metal");
  const double x = p.w / 2, y = p.d / 2, r = std::min(0.02, p.d * 0.08);
  const int n = std::max(2, static_cast<int>(p.w / 1.4) + 1);
  for (int i = 0; i < n; ++i) {
    const double px = -x + 0.12 + (p.w - 0.24) * i / (n - 1);
    p.add(metal, box(sides(px - 0.02, px + 0.02, -y, y, 0, 0.03), 0.004));
    p.add(metal, box(sides(px - 0.018, px + 0.018, -std::min(0.018, y), std::min(0.018, y), 0.025, p.h - r * 2), 0.004));
    for (const double z : {p.h - r, p.h * 0.76})
      p.add(metal, box(sides(px - 0.012, px + 0.012, -r, r * 2, z - r * 1.5, z - r * 0.5), 0.002));
  }
  for (const double z : {p.h - r, p.h * 0.76}) p.add(wood, rod({-x, z < p.h * 0.9 ? r : -r, z}, {x, z < p.h * 0.9 ? r : -r, z}, r, 14));
}

// A wheel beside a leaning bench on three legs, with flyer, distaff and treadle.
void spinning_wheel(Piece& p) {
  const int wood = p.main("oak"), iron_surface = p.named("black_metal"), wool = p.named("wool");
  const double r = 0.36;
  const Vec hub{0.02, 0.18, 0.5};
  const Pose turn = aimed(hub, {1, 0, 0});
  p.add(wood, lathe({{r - 0.05, -0.022}, {r, -0.022}, {r, 0.022}, {r - 0.05, 0.022}, {r - 0.05, -0.022}}, 40), turn);
  p.add(wood, lathe({{0, -0.05}, {0.05, -0.05}, {0.06, 0}, {0.05, 0.05}, {0, 0.05}}, 18), turn);
  for (int i = 0; i < 10; ++i) {
    const double a = 2 * kPi * i / 10;
    p.add(wood, lathe({{0, 0}, {0.01, 0}, {0.017, 0.12}, {0.01, 0.2}, {0.012, r - 0.06}, {0, r - 0.06}}, 8),
          aimed(hub + Vec{0, std::cos(a) * 0.03, std::sin(a) * 0.03}, {0, std::cos(a), std::sin(a)}));
  }
  p.add(iron_surface, rod(hub - Vec{0.12, 0, 0}, hub + Vec{0.12, 0, 0}, 0.012, 8));
  // The bench leans up to the front; two posts carry the wheel.
  p.add(wood, beam({0, 0.42, 0.2}, {0, -0.42, 0.36}, {0.2, 0.05}, 0.012));
  for (const double s : {-1.0, 1.0}) {
    p.add(wood, rod({s * 0.09, 0.2, 0.24}, {s * 0.1, 0.18, 0.54}, 0.02, 10));
    p.add(wood, leg({s * 0.26, 0.46, 0}, {s * 0.07, 0.34, 0.22}, 0.018, 0.024));
  }
  p.add(wood, leg({0, -0.5, 0}, {0, -0.34, 0.34}, 0.018, 0.024));
  for (const double s : {-0.08, 0.08})
    p.add(wood, lathe({{0, 0}, {0.02, 0}, {0.028, 0.08}, {0.016, 0.14}, {0.024, 0.22}, {0, 0.24}}, 12), moved(s, -0.32 + s * 0.3, 0.35));
  p.add(wood, rod({-0.14, -0.34, 0.5}, {0.14, -0.3, 0.5}, 0.012, 8));
  p.add(wool, lathe({{0, 0}, {0.03, 0}, {0.05, 0.02}, {0.05, 0.1}, {0.03, 0.12}, {0, 0.12}}, 16), aimed({-0.06, -0.33, 0.5}, {1, 0, 0}));
  p.add(wood, rod({0.14, -0.4, 0.35}, {0.16, -0.42, 0.82}, 0.012, 8));
  p.add(wool, ellipsoid({0.16, -0.42, 0.86}, {0.065, 0.065, 0.11}, 14, 10));
  p.add(wood, box(sides(-0.12, 0.12, -0.1, 0.16, 0.05, 0.07), 0.006));
  p.add(iron_surface, rod({0.1, 0.14, 0.07}, {0.11, 0.18, 0.46}, 0.007, 6));
  p.fit();
}

void kick_scooter(Piece& p) {
  const int paint = p.main_accent("painted_metal"), dark = p.named("black_plastic"), metal = p.named("chrome");
  const Pose turn = p.w >= p.d ? turned_z(-90) : Pose{};
  const auto add = [&](int s, const Mesh& m) { p.add(s, m, turn); };
  add(paint, box(sides(-0.07, 0.07, -0.28, 0.36, 0.08, 0.11), 0.012));
  add(dark, box(sides(-0.06, 0.06, -0.22, 0.3, 0.108, 0.114), 0.002));
  add(paint, beam({0, -0.26, 0.1}, {0, -0.4, 0.22}, {0.05, 0.04}, 0.008));
  for (const double y : {-0.46, 0.42}) {
    add(dark, rod({-0.018, y, 0.09}, {0.018, y, 0.09}, 0.09, 26));
    add(metal, rod({-0.02, y, 0.09}, {0.02, y, 0.09}, 0.05, 18));
  }
  for (const double x : {-0.026, 0.026}) {
    add(metal, beam({x, -0.46, 0.09}, {x, -0.42, 0.24}, {0.008, 0.03}, 0.002));
    add(metal, beam({x, 0.34, 0.1}, {x, 0.42, 0.09}, {0.008, 0.03}, 0.002));
  }
  add(metal, rod({0, -0.42, 0.22}, {0, -0.34, 0.96}, 0.018, 12));
  add(metal, rod({-0.2, -0.335, 0.97}, {0.2, -0.335, 0.97}, 0.014, 10));
  for (const double s : {-1.0, 1.0}) add(dark, rod({s * 0.13, -0.335, 0.97}, {s * 0.23, -0.335, 0.97}, 0.02, 12));
  p.fit();
}

}  // namespace

void add_pastimes(Families& to) {
  to["chess_set"] = chess_set;
  to["drum"] = drum;
  to["barre"] = barre;
  to["spinning_wheel"] = spinning_wheel;
  to["kick_scooter"] = kick_scooter;
}

}  // namespace layoutbox::kit
