// Things of daily life that are like nothing else: extinguishers, brooms, stones and balls of wool, barriers, studio lights, a fish bowl …
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

void extinguisher(Piece& p) {
  const int red = p.color_asked() ? p.main("painted_metal") : p.tinted("painted_metal", {0.78, 0.12, 0.10}),
            dark = p.named("black_plastic"), steel = p.named("steel");
  const double r = std::min(p.w, p.d) * 0.42, tall = p.h * 0.8;
  p.add(dark, cylinder({0, 0, 0}, r * 1.02, p.h * 0.05, 28));
  p.add(red, lathe({{0, p.h * 0.04},
                    {r, p.h * 0.04},
                    {r, tall * 0.8},
                    {r * 0.86, tall * 0.91},
                    {r * 0.45, tall * 0.98},
                    {r * 0.28, tall},
                    {0, tall}},
                   28));
  p.add(p.named("paper"),
        lathe({{r * 0.99, tall * 0.34}, {r * 1.01, tall * 0.34}, {r * 1.01, tall * 0.62}, {r * 0.99, tall * 0.62}, {r * 0.99, tall * 0.34}},
              28));
  p.add(steel, cylinder({0, 0, tall - 0.004}, r * 0.3, p.h * 0.07, 16));
  p.add(p.named("brass"), rod({0, -r * 0.2, tall + p.h * 0.035}, {0, -r * 0.55, tall + p.h * 0.035}, r * 0.24, 14));
  const double z = tall + p.h * 0.06;
  p.add(dark, beam({-r * 0.15, 0, z}, {r * 1.1, 0, z + p.h * 0.03}, {r * 0.34, 0.012}, 0.003));
  p.add(dark, beam({-r * 0.15, 0, z + p.h * 0.03}, {r * 1.1, 0, p.h - 0.006}, {r * 0.34, 0.012}, 0.003));
  p.add(dark, tube(curve({{-r * 0.25, 0, z}, {-r * 1.0, 0, tall * 0.96}, {-r * 1.16, 0, tall * 0.6}, {-r * 1.12, 0, tall * 0.36}}, 5),
                   r * 0.11, 8));
  p.add(dark, cone({-r * 1.12, 0, tall * 0.14}, r * 0.2, r * 0.12, tall * 0.23, 14));
  p.fit();
}

// Stands on its head of bristles (strings for a mop).
void broom(Piece& p) {
  const int stick = p.named("pine"), head = p.main_accent("plastic"), hair = p.tinted("fur", {0.80, 0.68, 0.42});
  const double foot = std::min(0.2, p.h * 0.15), x = p.w / 2, y = p.d / 2;
  p.add(stick, rod({0, 0, foot}, {0, 0, p.h - 0.004}, 0.013, 12));
  p.add(head, ellipsoid({0, 0, p.h - 0.02}, {0.015, 0.015, 0.02}, 10, 6));
  if (p.says("mop")) {
    p.add(head, rounded_box(sides(-x * 0.4, x * 0.4, -y * 0.5, y * 0.5, foot * 0.8, foot * 1.15), 0.012));
    for (int i = 0; i < 26; ++i) {
      const double a = 2.39996 * i, out = std::sqrt((i + 0.5) / 26);
      const Vec end{std::cos(a) * out * (x - 0.012), std::sin(a) * out * (y - 0.012), 0.012};
      p.add(p.named("cotton"),
            tube(curve({{end.x * 0.35, end.y * 0.35, foot * 0.85}, {end.x * 0.85, end.y * 0.85, foot * 0.55}, end}, 3), 0.011, 6));
    }
    p.fit();
    return;
  }
  p.add(head, taper({0, 0, foot * 0.72}, {x * 0.9, y * 0.6}, {0, 0, foot * 1.0}, {x * 0.45, std::min(y * 0.6, 0.03)}));
  p.add(head, cone({0, 0, foot * 0.98}, 0.026, 0.017, foot * 0.4, 14));
  const int n = std::max(6, static_cast<int>(p.w / 0.022));
  for (int i = 0; i < n; ++i) {
    const double t = 2 * (i + 0.5) / n - 1;
    for (const double s : {-0.35, 0.35})
      p.add(hair,
            taper({t * x * 0.96, s * 1.6 * y, 0}, {x / n * 0.9, y * 0.4}, {t * x * 0.82, s * y, foot * 0.74}, {x / n * 0.6, y * 0.22}));
  }
  p.fit();
}

// A body moved in and out in slow waves, so that it looks found, not turned.
Mesh lumpy(Mesh mesh, Vec size, double amount) {
  for (Vec3f& q : mesh.positions) {
    const Vec at{static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2])};
    const double x = at.x / size.x, y = at.y / size.y, z = at.z / size.z;
    const double k = 1 + amount * (std::sin(5.1 * x + 1.3 * z + 1) + std::sin(4.3 * y - 2.1 * x + 2) + std::sin(6.0 * z + 2.2 * y));
    q = {static_cast<float>(at.x * k), static_cast<float>(at.y * k), static_cast<float>(at.z * k)};
  }
  return mesh;
}

// kind: stone, yarn (a ball of it), pinecone or clay (a lump on a board).
void stone(Piece& p) {
  const std::string kind = p.word("kind", "stone");
  const Vec r{p.w / 2, p.d / 2, p.h / 2};
  if (kind == "yarn") {
    const int wool = p.main_accent("wool");
    p.add(wool, ellipsoid({}, r * 0.95, 20, 12));
    static constexpr Vec kAround[] = {{1, 0.2, 0.3}, {-0.4, 1, 0.5}, {0.3, -0.6, 1}, {0.9, 0.8, -0.5}};
    for (const Vec& axis : kAround) {
      const Pose turn = scaled(r.x, r.y, r.z) * aimed({}, axis);
      for (const double z : {-0.32, -0.16, 0.0, 0.16, 0.32})
        p.add(wool, posed(torus({0, 0, z}, std::sqrt(0.93 - z * z), 0.055, 20, 5), turn));
    }
    p.fit();
    return;
  }
  if (kind == "pinecone") {
    const int scale = p.main("walnut");
    p.add(scale, ellipsoid({}, {r.x * 0.8, r.y * 0.6, r.z * 0.6}, 14, 8));
    for (int i = 0; i < 80; ++i) {
      const double a = 2.39996 * i, t = 1 - 2 * (i + 0.5) / 80, q = std::sqrt(1 - t * t);
      const Vec root{t * r.x * 0.72, std::cos(a) * q * r.y * 0.5, std::sin(a) * q * r.z * 0.5};
      const Vec tip{(t * 0.82 - 0.16) * r.x, std::cos(a) * (q * 0.9 + 0.08) * r.y, std::sin(a) * (q * 0.9 + 0.08) * r.z};
      p.add(scale, leaf(root, tip, r.y * 0.42, r.y * 0.05, 3));
    }
    p.fit();
    return;
  }
  if (kind == "clay") {
    const double board = std::min(0.015, p.h * 0.15);
    p.add(p.named("oak"), box(sides(-r.x, r.x, -r.y, r.y, 0, board), 0.002));
    p.add(p.main("terracotta"),
          lumpy(rounded_box({r * -0.9, {r.x * 0.9, r.y * 0.9, r.z * 0.95 - board}}, std::min({r.x, r.y, r.z}) * 0.45, 6), r, 0.035),
          moved(0, 0, r.z * 0.9 + board));
    p.fit();
    return;
  }
  p.add(p.main("stone"), lumpy(ellipsoid({}, r, 26, 16), r, 0.045));
  p.fit();
}

// Posts with a rope between them; as many as the width asks for.
void rope_barrier(Piece& p) {
  const int metal = p.main("brass"), rope = p.tinted("velvet", {0.56, 0.10, 0.14});
  const double r = std::min(p.d / 2, p.w / 2), tube_r = std::min(0.025, r * 0.2);
  const int n = p.w < 4 * r ? 1 : 2 + static_cast<int>((p.w - 2 * r) / 2.2);
  Vec before{};
  for (int i = 0; i < n; ++i) {
    const double x = n == 1 ? 0 : -p.w / 2 + r + (p.w - 2 * r) * i / (n - 1);
    p.add(metal, lathe({{0, 0}, {r, 0}, {r, 0.012}, {r * 0.5, 0.03}, {tube_r * 1.3, 0.05}, {0, 0.05}}, 30), moved(x, 0, 0));
    p.add(metal, cylinder({x, 0, 0.04}, tube_r, p.h * 0.94 - 0.04, 16));
    p.add(metal,
          lathe({{0, p.h * 0.9},
                 {tube_r * 1.6, p.h * 0.9},
                 {tube_r * 1.6, p.h * 0.93},
                 {tube_r * 1.1, p.h * 0.945},
                 {tube_r * 1.5, p.h * 0.975},
                 {0, p.h}},
                18),
          moved(x, 0, 0));
    const Vec hook{x, 0, p.h * 0.9};
    if (i > 0) {
      std::vector<Vec> line;
      for (int k = 0; k <= 12; ++k) {
        const double t = k / 12.0;
        line.push_back(before + (hook - before) * t + Vec{0, 0, -4 * t * (1 - t) * p.h * 0.26});
      }
      p.add(rope, tube(line, std::min(0.022, r * 0.18), 10));
    }
    before = hook;
  }
  p.fit();
}

// A tripod with a glowing ring (kind: ring) or a soft box that looks to the front.
void studio_light(Piece& p) {
  const int metal = p.frame("black_metal");
  const double x = p.w / 2, y = p.d / 2, hub = p.h * 0.3;
  for (int i = 0; i < 3; ++i) {
    const double a = kPi * (0.5 + 2.0 * i / 3);
    p.add(metal, leg({std::cos(a) * (x - 0.012), std::sin(a) * (y - 0.012), 0}, {0, 0, hub}, 0.009, 0.011));
  }
  const bool ring = p.word("kind", "") == "ring";
  const double r = ring ? std::min(0.23, x * 0.7) : std::min(x * 0.75, p.h * 0.2), middle = p.h - r - (ring ? 0.02 : 0.0);
  p.add(metal, cylinder({0, 0, hub - 0.1}, 0.013, middle - hub + (ring ? 0.1 - r : 0.1), 12));
  if (ring) {
    const Pose up = moved(0, 0, middle) * Pose{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}};
    p.add(p.named("plastic"), lathe({{r * 0.78, -0.012}, {r * 1.02, -0.012}, {r * 1.02, 0.012}, {r * 0.78, 0.012}, {r * 0.78, -0.012}}, 44),
          up);
    p.add(p.named("bulb"), lathe({{r * 0.81, 0.01}, {r * 0.99, 0.01}, {r * 0.99, 0.022}, {r * 0.81, 0.022}, {r * 0.81, 0.01}}, 44), up);
    p.add(metal, box(sides(-0.04, 0.04, -0.012, 0.004, middle - 0.075, middle + 0.075), 0.006));
    p.add(metal, rod({0, 0, middle - r}, {0, 0, middle - 0.07}, 0.008, 8));
  } else {
    const Pose face{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, middle}};
    p.add(metal, taper({0, 0, -0.12}, {r * 0.3, r * 0.3}, {0, 0, 0.2}, {r, r}), face);
    p.add(p.named("lampshade"), rounded_box(sides(-r * 0.96, r * 0.96, -r * 0.96, r * 0.96, 0.195, 0.225), 0.012, 3), face);
  }
  p.light({0, -0.3, middle}, 20, 0.15);
  p.fit();
}

void fish_bowl(Piece& p) {
  const double h = p.h;
  const Pose round = scaled(p.w / 2, p.d / 2, 1);
  p.add(p.named("glass"),
        lathe({{0, 0},
               {0.6, 0},
               {0.9, h * 0.2},
               {1, h * 0.46},
               {0.9, h * 0.76},
               {0.68, h * 0.93},
               {0.74, h},
               {0.7, h},
               {0.64, h * 0.93},
               {0.86, h * 0.76},
               {0.96, h * 0.46},
               {0.86, h * 0.21},
               {0.57, h * 0.02},
               {0, h * 0.02}},
              34),
        round);
  p.add(p.tinted("soil", {0.80, 0.70, 0.50}), lathe({{0, h * 0.022}, {0.56, h * 0.022}, {0.74, h * 0.13}, {0, h * 0.15}}, 26), round);
  // The water's surface only: a second clear body would dim what swims in it.
  p.add(p.named("water"), lathe({{0, h * 0.735}, {0.85, h * 0.735}, {0.85, h * 0.745}, {0, h * 0.745}}, 30), round);
  const int fish = p.tinted("wax", {0.95, 0.47, 0.13});
  for (const auto& [at, s] : {std::pair{Vec{-0.28, -0.3, 0.5}, 1.0}, {Vec{0.3, 0.1, 0.36}, -1.0}}) {
    const Vec c{at.x * p.w / 2, at.y * p.d / 2, at.z * h};
    const double l = p.w * 0.13;
    p.add(fish, ellipsoid(c, {l, l * 0.4, l * 0.55}, 14, 8));
    for (const double up : {-1.0, 1.0})
      p.add(fish, leaf(c + Vec{s * l * 0.85, 0, 0}, c + Vec{s * l * 1.8, 0, up * l * 0.5}, l * 0.5, 0.002, 3));
  }
  for (int i = 0; i < 4; ++i) {
    const double a = 1.9 * i + 0.6;
    const Vec root{std::cos(a) * p.w * 0.2, std::abs(std::sin(a)) * p.d * 0.2, h * 0.13};
    p.add(p.named("leaf"), leaf(root, root + Vec{0, 0, h * (0.34 + 0.05 * i)}, p.w * 0.07, p.w * 0.03, 4));
  }
}

void water_cooler(Piece& p) {
  const int body = p.main("plastic"), dark = p.named("black_plastic"), tap = p.named("steel");
  const double x = p.w / 2, y = p.d / 2, top = p.h * 0.68, r = std::min(x, y) * 0.88, front = -y * 0.86;
  p.add(body, rounded_box(sides(-x, x, front, y, 0, top), 0.03, 4));
  p.add(p.named("grey_plastic"), box(sides(-x * 0.8, x * 0.8, front - 0.004, front + 0.02, top * 0.52, top * 0.94), 0.006));
  p.add(dark, box(sides(-x * 0.7, x * 0.7, -y, front + 0.01, top * 0.5, top * 0.54), 0.005));
  for (const double s : {-1.0, 1.0}) {
    p.add(tap, rod({s * x * 0.35, front, top * 0.84}, {s * x * 0.35, -y + 0.015, top * 0.84}, 0.012, 10));
    p.add(s < 0 ? p.tinted("plastic", {0.24, 0.46, 0.76}) : p.tinted("plastic", {0.80, 0.22, 0.18}),
          box(sides(s * x * 0.35 - 0.014, s * x * 0.35 + 0.014, -y, -y + 0.03, top * 0.76, top * 0.87), 0.004));
  }
  const double z = top, b = p.h - top;
  p.add(p.tinted("frosted_glass", {0.42, 0.66, 0.86}), lathe({{0, z - 0.004},
                                                              {r * 0.45, z - 0.004},
                                                              {r * 0.45, z + b * 0.06},
                                                              {r, z + b * 0.22},
                                                              {r, z + b * 0.45},
                                                              {r * 0.93, z + b * 0.5},
                                                              {r, z + b * 0.55},
                                                              {r, z + b * 0.93},
                                                              {r * 0.9, p.h},
                                                              {0, p.h}},
                                                             30));
  p.fit();
}

// An engine and two wagons on an oval of track.
void train_set(Piece& p) {
  const int wood = p.named("birch"), rail = p.named("walnut"), dark = p.named("black_plastic");
  const double gauge = std::min({0.035, p.w * 0.05, p.d * 0.06}), x = p.w / 2 - gauge * 1.7, y = p.d / 2 - gauge * 1.7,
               bed = std::min(0.012, p.h * 0.15);
  const auto on = [&](double a, double out) {
    const double c = std::cos(a), s = std::sin(a);
    const auto corner = [](double v) { return std::copysign(std::sqrt(std::abs(v)), v); };  // an oval with straight sides
    return Vec{corner(c) * x + c * out, corner(s) * y + s * out, bed};
  };
  constexpr int kSteps = 48;
  std::vector<Vec> inner, outer;
  for (int i = 0; i < kSteps; ++i) {
    const double a = 2 * kPi * i / kSteps;
    inner.push_back(on(a, -gauge));
    outer.push_back(on(a, gauge));
    p.add(wood, beam(on(a, -gauge * 1.7) - Vec{0, 0, bed / 2}, on(a, gauge * 1.7) - Vec{0, 0, bed / 2}, {gauge * 0.8, bed}));
  }
  for (const auto* line : {&inner, &outer}) p.add(rail, tube(*line, bed * 0.5, 6, true));
  static constexpr Color kCars[] = {{0.78, 0.24, 0.20}, {0.26, 0.48, 0.74}, {0.93, 0.74, 0.28}};
  const double l = std::min(p.w * 0.1, 0.14), high = p.h - bed * 1.5;
  for (int i = 0; i < 3; ++i) {
    const double at = -p.w * 0.18 + i * l * 2.25, half = gauge * 1.15, low = bed * 1.5;
    const Pose pose = moved(at, on(-kPi / 2, 0).y, low);
    const int paint = p.tinted("lacquer", kCars[i]);
    p.add(paint, rounded_box(sides(-l, l, -half, half, high * 0.16, high * (i == 0 ? 0.34 : 0.62)), half * 0.2, 2), pose);
    for (const double wx : {-0.6, 0.6})
      p.add(dark, rod({wx * l, -half * 1.08, high * 0.16}, {wx * l, half * 1.08, high * 0.16}, high * 0.16, 14), pose);
    if (i > 0) continue;
    p.add(paint, rod({-l * 0.95, 0, high * 0.5}, {l * 0.3, 0, high * 0.5}, half * 0.8, 18), pose);
    p.add(dark, rod({-l, 0, high * 0.5}, {-l * 0.9, 0, high * 0.5}, half * 0.84, 18), pose);
    p.add(dark, cone({-l * 0.6, 0, high * 0.6}, half * 0.25, half * 0.4, high * 0.38, 12), pose);
    p.add(p.tinted("lacquer", kCars[1]), box(sides(l * 0.25, l, -half, half, high * 0.3, high * 0.9), half * 0.1), pose);
    p.add(dark, box(sides(l * 0.15, l * 1.05, -half * 1.1, half * 1.1, high * 0.88, high), half * 0.08), pose);
  }
  p.fit();
}

}  // namespace

void add_odd_things(Families& to) {
  to["extinguisher"] = extinguisher;
  to["broom"] = broom;
  to["stone"] = stone;
  to["rope_barrier"] = rope_barrier;
  to["studio_light"] = studio_light;
  to["fish_bowl"] = fish_bowl;
  to["water_cooler"] = water_cooler;
  to["train_set"] = train_set;
}

}  // namespace layoutbox::kit
