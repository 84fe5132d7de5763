// Kitchen and laundry: counters and machines.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

void counter(Piece& p) {
  const int body = p.main("lacquer"), top = worktop(p);
  const double slab_thick = std::min(0.04, p.h * 0.08), foot = std::min(0.08, p.h * 0.1);
  p.add(top, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, p.h - slab_thick, p.h), 0.005));
  const double under = p.clear_below(0);
  double front = -p.d / 2 + 0.02, back = p.d / 2 - 0.005;
  // A knee room along one side stays open: the body stands behind or before it.
  for (const FreeSpace& s : p.spaces) {
    if (s.box.min.z > 0.01 || under <= 0) continue;
    if (s.box.max.y < 0.35 * p.d)
      front = std::max(front, s.box.max.y);
    else
      back = std::min(back, s.box.min.y);
  }
  if (back - front < 0.05) {
    p.legs(p.frame("steel"), p.h - slab_thick, 0.05, 0.02);
    return;
  }
  p.add(p.named("black_plastic"), box(sides(-p.w / 2 + 0.02, p.w / 2 - 0.02, front + 0.04, back - 0.01, 0, foot), 0));
  Carcass c{sides(-p.w / 2 + 0.004, p.w / 2 - 0.004, front - 0.016, back, foot, p.h - slab_thick), body, body, p.part("handles", "steel")};
  c.drawers = p.count("drawers", 0);
  c.doors = p.count("doors", 0);
  carcass(p, c);
}

// A tall or low machine with one or two doors and bar handles.
void fridge(Piece& p) {
  const int steel = p.main("steel"), bar = p.named("chrome");
  machine_body(p, steel, sides(-p.w / 2, p.w / 2, -p.d / 2 + 0.075, p.d / 2, 0, p.h));
  const double low = std::min(0.06, p.h * 0.08), split = p.h > 1.2 ? low + (p.h - low) * 0.36 : p.h;
  if (p.says("open")) {
    open_inside(p, low + 0.04, p.h - 0.04, -p.d / 2 + 0.075, true);
    return swung_door(p, steel, low, p.h, -p.d / 2 + 0.075, p.w - 0.004);
  }
  const bool wide = p.w > 0.85;
  const auto door = [&](double x0, double x1, double z0, double z1, bool handle_right) {
    p.add(steel, rounded_box(sides(x0 + 0.002, x1 - 0.002, -p.d / 2 + 0.03, -p.d / 2 + 0.08, z0 + 0.003, z1 - 0.003), 0.01, 2));
    const double x = handle_right ? x1 - 0.05 : x0 + 0.05, len = std::min(0.5, (z1 - z0) * 0.6),
                 z = z0 > 0.3 ? z0 + len * 0.6 + 0.03 : z1 - len * 0.6;
    handle(p, bar, Handle::kVertical, {x, -p.d / 2 + 0.03, z}, len, 0.03);
  };
  if (wide) {
    door(-p.w / 2, 0, low, p.h, true);
    door(0, p.w / 2, low, p.h, false);
  } else {
    door(-p.w / 2, p.w / 2, low, split, false);
    if (split < p.h) door(-p.w / 2, p.w / 2, split, p.h, false);
  }
}

void oven_front(Piece& p, double z0, double z1, double face) {
  const int dark = p.named("screen"), bar = p.named("steel");
  p.add(dark, box(sides(-p.w / 2 + 0.04, p.w / 2 - 0.04, face - 0.012, face + 0.01, z0 + 0.02, z1 - 0.09), 0.004));
  handle(p, bar, Handle::kHorizontal, {0, face, z1 - 0.045}, p.w * 0.75, face + p.d / 2);
}

void burners(Piece& p, double level, double room) {
  const int black = p.named("black_metal"), glass = p.named("screen");
  p.add(glass, box(sides(-p.w / 2 + 0.02, p.w / 2 - 0.02, -p.d / 2 + 0.04, p.d / 2 - 0.04, level, level + room * 0.4), 0.002));
  for (const double x : {-0.24, 0.24}) {
    for (const double y : {-0.2, 0.22}) {
      const double r = std::min(p.w, p.d) * (x * y > 0 ? 0.16 : 0.12);
      p.add(black, lathe({{r * 0.86, 0}, {r, 0}, {r, room * 0.6}, {r * 0.86, room * 0.6}, {r * 0.86, 0}}, 28),
            moved(x * p.w, y * p.d, level + room * 0.4));
    }
  }
}

// A glass plate with rings, let into a counter.
void cooktop(Piece& p) {
  const double plate = std::max(p.h * 0.35, p.h - 0.012);
  burners(p, plate, p.h - plate);
  p.add(p.main("black_metal"), box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, plate), 0.002));
  for (int i = 0; i < 4; ++i) dial(p, p.named("steel"), {p.w * (-0.12 + 0.08 * i), -p.d / 2 + 0.006, plate * 0.6}, plate * 0.28, 0.006);
}

void stove(Piece& p) {
  if (p.h < 0.3) return cooktop(p);
  const int steel = p.main("steel"), black = p.named("black_plastic");
  const double room = 0.02, top = p.h - room, face = -p.d / 2 + 0.035;
  machine_body(p, steel, sides(-p.w / 2, p.w / 2, face, p.d / 2, 0, top), 0.006);
  oven_front(p, std::min(0.15, top * 0.2), top - 0.1, face);
  const int knobs = 5;
  for (int i = 0; i < knobs; ++i) dial(p, black, {-p.w * 0.36 + p.w * 0.72 * i / (knobs - 1), face + 0.002, top - 0.055}, 0.02, 0.025);
  burners(p, top, room);
}

// In a tall unit: a door below, the oven (or two) at hand's height, a door above.
void oven_tower(Piece& p) {
  const int body = p.part("fronts", "white"), bar = p.part("handles", "steel"), steel = p.main("steel");
  const double face = -p.d / 2 + 0.035, gap = 0.003, front = face - 0.018;
  p.add(body, box(sides(-p.w / 2, p.w / 2, face, p.d / 2, 0, p.h), 0.004));
  const auto panel = [&](int surface, double z0, double z1) {
    p.add(surface, box(sides(-p.w / 2 + gap, p.w / 2 - gap, front, face, z0 + gap, z1 - gap), 0.003));
  };
  const auto door = [&](double z0, double z1, double grip) {
    panel(body, z0, z1);
    handle(p, bar, Handle::kVertical, {p.w / 2 - 0.06, front, grip}, 0.16, front + p.d / 2);
  };
  constexpr double kPlinth = 0.08, kOven = 0.6, kSliver = 0.15;
  const int ovens = p.says("double") ? 2 : 1;
  const double low = ovens == 2 ? p.h * 0.2 : p.h * 0.32, each = std::min(kOven, (p.h - low) / ovens), high = low + ovens * each;
  door(kPlinth, low, low - 0.14);
  for (double z = low; z < high - kSliver; z += each) {
    panel(steel, z, z + each);
    oven_front(p, z, z + each - 0.06, front);
  }
  if (high + kSliver < p.h) door(high, p.h, high + 0.14);
}

void oven(Piece& p) {
  constexpr double kTower = 1.3;
  if (p.h > kTower && !p.says("open")) return oven_tower(p);
  const int steel = p.main("steel"), face_surface = p.named("black_plastic");
  const double face = -p.d / 2 + std::min(0.035, p.d * 0.1);
  p.add(steel, box(sides(-p.w / 2, p.w / 2, face, p.d / 2, 0, p.h), 0.006));
  if (p.says("open")) {
    open_inside(p, p.h * 0.06, p.h * 0.8, face, false);
    dropped_door(p, face_surface, p.h * 0.02, p.h * 0.78, face, false);
  } else {
    oven_front(p, 0, p.h * 0.82, face);
  }
  p.add(p.named("lit_screen"), box(sides(-0.05, 0.05, face - 0.003, face + 0.01, p.h * 0.88, p.h * 0.94), 0.001));
  for (const double s : {-1.0, 1.0}) dial(p, face_surface, {s * p.w * 0.32, face + 0.002, p.h * 0.9}, std::min(0.02, p.h * 0.04), 0.02);
}

void dishwasher(Piece& p) {
  const int body = p.main("steel");
  const double face = -p.d / 2 + 0.03;
  machine_body(p, body, sides(-p.w / 2, p.w / 2, face + 0.02, p.d / 2, 0, p.h), 0.006);
  if (p.says("open")) {
    open_inside(p, p.h * 0.12, p.h - 0.03, face + 0.02, false);
    return dropped_door(p, body, p.h * 0.1, p.h * 0.86, face + 0.02, true);
  }
  p.add(body, box(sides(-p.w / 2 + 0.003, p.w / 2 - 0.003, face, face + 0.022, p.h * 0.1, p.h - 0.003), 0.005));
  handle(p, p.named("chrome"), Handle::kHorizontal, {0, face, p.h * 0.86}, p.w * 0.7, 0.03);
  p.add(p.named("screen"), box(sides(-p.w * 0.15, p.w * 0.15, face - 0.002, face + 0.004, p.h * 0.93, p.h * 0.96), 0));
}

void washing_machine(Piece& p) {
  const int body = p.main("painted_metal"), chrome = p.named("chrome"), glass = p.named("screen"), dark = p.named("grey_plastic");
  const double face = -p.d / 2 + 0.035, r = std::min(p.w * 0.34, p.h * 0.24), z = p.h * 0.45;
  machine_body(p, body, sides(-p.w / 2, p.w / 2, face, p.d / 2, 0, p.h), 0.012);
  if (p.word("kind", "") == "dryer") {  // a closed door in the body's colour, and the grille of its heat exchanger
    p.add(body, lathe({{0, 0}, {r * 1.08, 0}, {r * 1.08, 0.02}, {r * 0.9, 0.034}, {0, 0.034}}, 36),
          aimed({0, face + 0.002, z}, {0, -1, 0}));
    p.add(chrome, lathe({{r * 0.6, 0.02}, {r * 0.66, 0.02}, {r * 0.66, 0.036}, {r * 0.6, 0.036}, {r * 0.6, 0.02}}, 36),
          aimed({0, face + 0.002, z}, {0, -1, 0}));
    for (int i = 0; i < 5; ++i)
      p.add(dark, box(sides(p.w * 0.2, p.w * 0.42, face - 0.003, face + 0.004, p.h * (0.07 + 0.016 * i), p.h * (0.078 + 0.016 * i)), 0));
    dial(p, chrome, {0, face + 0.001, p.h * 0.91}, std::min(0.035, p.h * 0.04), 0.02);
    p.add(p.named("lit_screen"), box(sides(p.w * 0.18, p.w * 0.4, face - 0.003, face + 0.004, p.h * 0.885, p.h * 0.935), 0.001));
    return;
  }
  p.add(chrome, lathe({{r * 0.76, 0}, {r, 0}, {r, 0.02}, {r * 0.9, 0.033}, {r * 0.76, 0.033}, {r * 0.76, 0}}, 36),
        aimed({0, face + 0.002, z}, {0, -1, 0}));
  p.add(glass, lathe({{0, 0}, {r * 0.77, 0}, {r * 0.77, 0.02}, {r * 0.4, 0.037}, {0, 0.037}}, 32), aimed({0, face + 0.002, z}, {0, -1, 0}));
  p.add(dark, box(sides(-p.w * 0.44, -p.w * 0.12, face - 0.004, face + 0.004, p.h * 0.87, p.h * 0.95), 0.002));
  dial(p, chrome, {p.w * 0.05, face + 0.001, p.h * 0.91}, std::min(0.03, p.h * 0.035), 0.02);
  p.add(p.named("lit_screen"), box(sides(p.w * 0.18, p.w * 0.4, face - 0.003, face + 0.004, p.h * 0.885, p.h * 0.935), 0.001));
}

}  // namespace

void add_kitchen(Families& to) {
  to["counter"] = counter;
  to["fridge"] = fridge;
  to["stove"] = stove;
  to["oven"] = oven;
  to["dishwasher"] = dishwasher;
  to["washing_machine"] = washing_machine;
}

}  // namespace layoutbox::kit
