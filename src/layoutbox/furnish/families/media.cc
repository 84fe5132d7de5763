// Small devices by their own looks: record players, radios, headphones, binoculars, irons.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// A record: grooves as rings, a coloured label.
void disc(Piece& p, Vec at, double radius, double thick) {
  const double r = radius, t = thick;
  p.add(p.named("black_plastic"), lathe({{0, 0}, {r, 0}, {r, t}, {r * 0.72, t}, {r * 0.71, t * 0.7}, {r * 0.69, t}, {0, t}}, 40),
        moved(at));
  p.add(p.tinted("paper", {0.84, 0.36, 0.24}), lathe({{0, t * 0.9}, {r * 0.33, t * 0.9}, {r * 0.33, t * 1.15}, {0, t * 1.15}}, 28),
        moved(at));
  p.add(p.named("chrome"), cylinder(at + Vec{0, 0, t}, r * 0.03, t * 1.6, 8));
}

void record_player(Piece& p) {
  const int wood = p.main("walnut"), chrome = p.named("chrome"), dark = p.named("black_plastic");
  const double x = p.w / 2, y = p.d / 2, foot = p.h * 0.1, deck = p.h * 0.62, r = std::min(p.d * 0.44, p.w * 0.38),
               cx = -x + r + p.w * 0.06;
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) p.add(dark, cylinder({sx * x * 0.8, sy * y * 0.78, 0}, std::min(0.022, x * 0.12), foot * 1.1, 16));
  }
  p.add(wood, box(sides(-x, x, -y, y, foot, deck), 0.006));
  p.add(p.named("grey_plastic"), box(sides(-x * 0.96, x * 0.96, -y * 0.95, y * 0.95, deck - 0.002, deck + p.h * 0.02), 0.001));
  p.add(chrome, lathe({{0, 0}, {r, 0}, {r * 1.01, p.h * 0.05}, {r * 0.98, p.h * 0.06}, {0, p.h * 0.06}}, 40),
        moved(cx, 0, deck + p.h * 0.02));
  disc(p, {cx, 0, deck + p.h * 0.08}, r * 0.96, std::max(0.002, p.h * 0.02));
  // The arm turns behind on the right and rests with its head over the record.
  const Vec pivot{x * 0.76, y * 0.6, deck};
  p.add(chrome, lathe({{0, 0}, {0.03, 0}, {0.028, p.h * 0.12}, {0.012, p.h * 0.16}, {0.012, p.h - deck}, {0, p.h - deck}}, 18),
        moved(pivot));
  const double level = deck + (p.h - deck) * 0.8;
  p.add(chrome, tube(curve({{pivot.x, pivot.y + y * 0.26, level},
                            {pivot.x, pivot.y, level},
                            {pivot.x + x * 0.04, -y * 0.2, level},
                            {cx + r * 0.72, -y * 0.48, level - p.h * 0.06}},
                           5),
                     0.0045, 8));
  p.add(dark, rod({pivot.x, pivot.y + y * 0.14, level}, {pivot.x, pivot.y + y * 0.3, level}, std::min(0.014, (p.h - level) * 0.95), 14));
  p.add(dark, beam({cx + r * 0.76, -y * 0.44, level - p.h * 0.04}, {cx + r * 0.58, -y * 0.56, level - p.h * 0.1}, {0.016, 0.012}, 0.002));
  p.add(chrome, cylinder({x * 0.78, -y * 0.72, deck + p.h * 0.02}, 0.017, p.h * 0.08, 16));
}

// Records lying or in a stack: sleeves, the topmost disc halfway out of its own.
void record(Piece& p) {
  const double x = p.w / 2, y = p.d / 2;
  const Color base = p.accent();
  if (p.h > 0.03) {
    const int n = std::clamp(static_cast<int>(p.h / 0.006), 3, 14);
    for (int i = 0; i < n; ++i)
      p.add(p.tinted("paper", mixed(base, {0.90, 0.86, 0.78}, 0.12 + 0.7 * p.random())),
            box(sides(-x, x, -y + (i % 3) * 0.003, y - (i % 2) * 0.002, p.h * i / n, p.h * (i + 0.85) / n), 0));
    p.fit();
    return;
  }
  p.add(p.tinted("paper", base), box(sides(-x, x, -y, y, 0, p.h * 0.45), 0));
  disc(p, {0, 0, p.h * 0.45}, std::min(x, y) * 0.92, p.h * 0.2);
  p.fit();
}

void radio(Piece& p) {
  const int wood = p.main("walnut"), brass = p.named("brass"), dark = p.named("black_plastic");
  const double x = p.w / 2, y = p.d / 2, body = p.h * 0.82, face = -y + p.d * 0.06, foot = p.h * 0.04;
  p.add(wood, rounded_box(sides(-x, x, face, y, foot, body), std::min({x, y, body}) * 0.22, 4));
  for (const double s : {-0.7, 0.7}) p.add(dark, box(sides(s * x - 0.012, s * x + 0.012, -y * 0.6, y * 0.8, 0, foot * 1.5), 0.002));
  // Speaker cloth with bars before it, the dial in a window, two knobs.
  const double z0 = body * 0.18, z1 = body * 0.86;
  p.add(p.tinted("linen", {0.80, 0.72, 0.56}), box(sides(-x * 0.84, x * 0.08, face - p.d * 0.012, face + 0.004, z0, z1), 0.002));
  for (int i = 1; i < 5; ++i) {
    const double z = z0 + (z1 - z0) * i / 5;
    p.add(brass, box(sides(-x * 0.84, x * 0.08, face - p.d * 0.03, face, z - p.h * 0.008, z + p.h * 0.008), 0));
  }
  p.add(p.tinted("lampshade", {0.98, 0.88, 0.62}), box(sides(x * 0.2, x * 0.84, face - p.d * 0.015, face + 0.004, body * 0.55, z1), 0.001));
  p.add(p.tinted("plastic", {0.8, 0.2, 0.16}), box(sides(x * 0.42, x * 0.445, face - p.d * 0.03, face, body * 0.57, z1 - body * 0.02), 0));
  for (const double s : {0.34, 0.7})
    dial(p, brass, {s * x, face + 0.002, body * 0.33}, std::min(x * 0.13, body * 0.13), p.d * 0.06 + 0.002);
  p.add(brass, tube(curve({{-x * 0.6, 0, body * 0.95}, {-x * 0.5, 0, p.h * 0.98}, {x * 0.5, 0, p.h * 0.98}, {x * 0.6, 0, body * 0.95}}, 4),
                    p.h * 0.025, 8));
  p.fit();
}

// A receiver with a display, a large knob and rows of keys.
void stereo(Piece& p) {
  const int metal = p.main("black_metal"), steel = p.named("steel");
  const double x = p.w / 2, y = p.d / 2, foot = std::min(0.015, p.h * 0.1), face = -y + 0.02;
  p.add(metal, box(sides(-x, x, face + 0.004, y, foot, p.h), 0.004));
  p.add(p.named("black_plastic"), box(sides(-x, x, face - 0.002, face + 0.006, foot, p.h), 0.003));
  for (const double s : {-0.8, 0.8}) p.add(steel, cylinder({s * x, -y * 0.6, 0}, 0.018, foot + 0.002, 14));
  for (const double s : {-0.8, 0.8}) p.add(steel, cylinder({s * x, y * 0.6, 0}, 0.018, foot + 0.002, 14));
  const double mid = (foot + p.h) / 2;
  dial(p, steel, {x * 0.68, face, mid}, std::min(0.035, (p.h - foot) * 0.34), face + y - 0.0005);
  dial(p, steel, {-x * 0.8, face, mid}, std::min(0.016, (p.h - foot) * 0.16), 0.012);
  p.add(p.named("lit_screen"), box(sides(-x * 0.5, x * 0.3, face - 0.004, face, mid, p.h - (p.h - foot) * 0.18), 0.001));
  for (int i = 0; i < 6; ++i) {
    const double kx = -x * 0.5 + x * 0.8 * (i + 0.5) / 6;
    p.add(steel,
          box(sides(kx - x * 0.045, kx + x * 0.045, face - 0.005, face, foot + (p.h - foot) * 0.2, foot + (p.h - foot) * 0.32), 0.001));
  }
  // Slots for the heat.
  for (int i = 0; i < 7; ++i)
    p.add(p.named("black_plastic"),
          box(sides(-x * 0.6, x * 0.6, y * (-0.3 + 0.14 * i), y * (-0.25 + 0.14 * i), p.h - 0.002, p.h + 0.0004), 0));
}

void router(Piece& p) {
  const int body = p.main("plastic"), light = p.named("lit_screen");
  p.add(body, rounded_box(sides(-0.5, 0.5, -0.3, 0.3, 0, 0.14), 0.06, 3));
  for (const double x : {-0.38, 0.0, 0.38}) p.add(p.named("black_plastic"), beam({x, 0.26, 0.08}, {x, 0.34, 0.75}, {0.05, 0.03}, 0.01));
  for (int i = 0; i < 4; ++i) p.add(light, box(sides(-0.2 + 0.12 * i, -0.15 + 0.12 * i, -0.305, -0.28, 0.06, 0.08), 0));
  p.fit();
}

// On their cups, the band above.
void headphones(Piece& p) {
  const int body = p.main("black_plastic"), pad = p.named("black_leather");
  p.add(
      body,
      tube(curve({{-0.42, 0, 0.3}, {-0.46, 0, 0.62}, {-0.28, 0, 0.95}, {0, 0, 1.06}, {0.28, 0, 0.95}, {0.46, 0, 0.62}, {0.42, 0, 0.3}}, 6),
           0.045, 8));
  p.add(pad, tube(curve({{-0.28, 0, 0.9}, {0, 0, 1.0}, {0.28, 0, 0.9}}, 6), 0.06, 8));
  for (const double s : {-1.0, 1.0}) {
    p.add(body, lathe({{0, 0}, {0.2, 0}, {0.23, 0.04}, {0.2, 0.12}, {0, 0.13}}, 24), aimed({s * 0.38, 0, 0.24}, {s, 0, 0}));
    p.add(pad, torus({0, 0, 0}, 0.15, 0.065, 24, 10), aimed({s * 0.35, 0, 0.24}, {s, 0, 0}));
  }
  p.fit();
}

void binoculars(Piece& p) {
  const int body = p.main("black_plastic"), rim = p.named("grey_plastic"), lens = p.tinted("screen", {0.16, 0.22, 0.36});
  // Lying on the table, the large lenses to the front.
  for (const double s : {-1.0, 1.0}) {
    const Pose turn = aimed({s * 0.27, -0.5, 0.22}, {0, 1, 0});
    p.add(body, lathe({{0, 0.02}, {0.2, 0.02}, {0.22, 0}, {0.22, 0.2}, {0.17, 0.34}, {0.17, 0.72}, {0.12, 0.8}, {0, 0.8}}, 26), turn);
    p.add(lens, lathe({{0, 0.005}, {0.19, 0.005}, {0.19, 0.03}, {0, 0.03}}, 26), turn);
    p.add(rim, lathe({{0, 0.78}, {0.125, 0.78}, {0.14, 0.86}, {0.14, 0.98}, {0.1, 1.0}, {0, 0.97}}, 22), turn);
    p.add(rim, lathe({{0.2, 0.02}, {0.23, 0.02}, {0.23, 0.06}, {0.2, 0.06}, {0.2, 0.02}}, 26), turn);
  }
  p.add(body, box(sides(-0.28, 0.28, -0.1, 0.16, 0.16, 0.32), 0.03));
  p.add(rim, rod({0, -0.02, 0.34}, {0, 0.24, 0.34}, 0.07, 16));
  p.add(body, rod({0, 0.1, 0.27}, {0, 0.42, 0.27}, 0.05, 12));
  p.add(body, box(sides(-0.26, 0.26, 0.32, 0.4, 0.2, 0.3), 0.02));
  p.fit();
}

void iron(Piece& p) {
  const int body = p.main_accent("plastic"), steel = p.named("steel"), dark = p.named("black_plastic");
  // A sole that runs to a point at the front, the handle over it.
  const auto sole = [](double k, double shift) {
    std::vector<Vec2> outline;
    for (const auto& [x, y] : {std::pair{0.0, -1.0},
                               {0.2, -0.72},
                               {0.36, -0.32},
                               {0.44, 0.2},
                               {0.44, 0.85},
                               {0.36, 0.98},
                               {-0.36, 0.98},
                               {-0.44, 0.85},
                               {-0.44, 0.2},
                               {-0.36, -0.32},
                               {-0.2, -0.72}})
      outline.push_back({x * k, y * k + shift});
    return outline;
  };
  p.add(steel, prism(sole(1, 0), 0, 0.08, true));
  p.add(body, loft(std::vector<std::vector<Vec>>{ring_at(sole(0.95, 0), 0.08), ring_at(sole(0.9, 0.02), 0.3), ring_at(sole(0.7, 0.1), 0.48),
                                                 ring_at(sole(0.42, 0.2), 0.54)}));
  p.add(dark,
        tube(curve({{0, 0.8, 0.36}, {0, 0.86, 0.8}, {0, 0.5, 0.98}, {0, -0.2, 0.94}, {0, -0.5, 0.72}, {0, -0.48, 0.36}}, 5), 0.11, 10));
  dial(p, p.named("plastic"), {0, -0.14, 0.5}, 0.14, 0.05);
  p.fit();
}

// Lying on its side would hide it: it stands on its handle, nozzle to the left.
void hair_dryer(Piece& p) {
  const int body = p.main_accent("plastic"), dark = p.named("black_plastic");
  p.add(body, lathe({{0, 0}, {0.15, 0}, {0.2, 0.03}, {0.23, 0.2}, {0.22, 0.4}, {0.16, 0.62}, {0.14, 0.7}, {0, 0.7}}, 26),
        aimed({0.34, 0, 0.82}, {-1, 0, 0}));
  p.add(dark, lathe({{0, 0}, {0.14, 0}, {0.17, 0.2}, {0, 0.2}}, 24), aimed({-0.34, 0, 0.82}, {-1, 0, 0}));
  p.add(dark, lathe({{0, -0.01}, {0.13, -0.01}, {0.13, 0.02}, {0, 0.02}}, 24), aimed({0.34, 0, 0.82}, {-1, 0, 0}));
  p.add(body, tube(curve({{0.18, 0, 0.7}, {0.22, 0, 0.4}, {0.28, 0, 0.08}}, 5), 0.1, 12));
  p.add(dark, box(sides(0.08, 0.16, -0.03, 0.03, 0.42, 0.56), 0.01));
  p.add(dark, cylinder({0.285, 0, 0}, 0.06, 0.08, 12));
  p.fit();
}

}  // namespace

void add_media(Families& to) {
  to["record_player"] = record_player;
  to["record"] = record;
  to["radio"] = radio;
  to["stereo"] = stereo;
  to["router"] = router;
  to["headphones"] = headphones;
  to["binoculars"] = binoculars;
  to["iron"] = iron;
  to["hair_dryer"] = hair_dryer;
}

}  // namespace layoutbox::kit
