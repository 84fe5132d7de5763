// Kitchen and laundry: counters, sinks and machines.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

void counter(Piece& p) {
  const int body = p.main("lacquer"), top = p.named(p.says("marble") ? "marble" : p.says("wood") || p.says("wooden") ? "oak" : "granite");
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
  Carcass c{sides(-p.w / 2 + 0.004, p.w / 2 - 0.004, front - 0.016, back, foot, p.h - slab_thick), body, body, p.named("steel")};
  c.drawers = p.count("drawers", 0);
  c.doors = p.count("doors", 0);
  carcass(p, c);
}

// A tall or low machine with one or two doors and bar handles.
void fridge(Piece& p) {
  const int steel = p.main("steel"), bar = p.named("chrome");
  machine_body(p, steel, sides(-p.w / 2, p.w / 2, -p.d / 2 + 0.075, p.d / 2, 0, p.h));
  const double low = std::min(0.06, p.h * 0.08), split = p.h > 1.2 ? low + (p.h - low) * 0.36 : p.h;
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
      p.add(black, lathe({{r * 0.8, 0}, {r, 0}, {r, room * 0.6}, {r * 0.8, room * 0.6}, {r * 0.8, 0}}, 28),
            moved(x * p.w, y * p.d, level + room * 0.4));
    }
  }
}

// A glass plate with rings, let into a counter.
void cooktop(Piece& p) {
  burners(p, 0, p.h);
  p.add(p.main("black_metal"), box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, p.h * 0.35), 0.002));
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

void oven(Piece& p) {
  const int steel = p.main("steel"), face_surface = p.named("black_plastic");
  const double face = -p.d / 2 + std::min(0.035, p.d * 0.1);
  p.add(steel, box(sides(-p.w / 2, p.w / 2, face, p.d / 2, 0, p.h), 0.006));
  oven_front(p, 0, p.h * 0.82, face);
  p.add(p.named("lit_screen"), box(sides(-0.05, 0.05, face - 0.003, face + 0.01, p.h * 0.88, p.h * 0.94), 0.001));
  for (const double s : {-1.0, 1.0}) dial(p, face_surface, {s * p.w * 0.32, face + 0.002, p.h * 0.9}, std::min(0.02, p.h * 0.04), 0.02);
}

void dishwasher(Piece& p) {
  const int body = p.main("steel");
  const double face = -p.d / 2 + 0.03;
  machine_body(p, body, sides(-p.w / 2, p.w / 2, face + 0.02, p.d / 2, 0, p.h), 0.006);
  p.add(body, box(sides(-p.w / 2 + 0.003, p.w / 2 - 0.003, face, face + 0.022, p.h * 0.1, p.h - 0.003), 0.005));
  handle(p, p.named("chrome"), Handle::kHorizontal, {0, face, p.h * 0.86}, p.w * 0.7, 0.03);
  p.add(p.named("screen"), box(sides(-p.w * 0.15, p.w * 0.15, face - 0.002, face + 0.004, p.h * 0.93, p.h * 0.96), 0));
}

void washing_machine(Piece& p) {
  const int body = p.main("painted_metal"), chrome = p.named("chrome"), glass = p.named("screen"), dark = p.named("grey_plastic");
  const double face = -p.d / 2 + 0.035, r = std::min(p.w * 0.34, p.h * 0.24), z = p.h * 0.45;
  machine_body(p, body, sides(-p.w / 2, p.w / 2, face, p.d / 2, 0, p.h), 0.012);
  p.add(chrome, lathe({{r * 0.76, 0}, {r, 0}, {r, 0.02}, {r * 0.9, 0.033}, {r * 0.76, 0.033}, {r * 0.76, 0}}, 36),
        aimed({0, face + 0.002, z}, {0, -1, 0}));
  p.add(glass, lathe({{0, 0}, {r * 0.77, 0}, {r * 0.77, 0.02}, {r * 0.4, 0.037}, {0, 0.037}}, 32), aimed({0, face + 0.002, z}, {0, -1, 0}));
  p.add(dark, box(sides(-p.w * 0.44, -p.w * 0.12, face - 0.004, face + 0.004, p.h * 0.87, p.h * 0.95), 0.002));
  dial(p, chrome, {p.w * 0.05, face + 0.001, p.h * 0.91}, std::min(0.03, p.h * 0.035), 0.02);
  p.add(p.named("lit_screen"), box(sides(p.w * 0.18, p.w * 0.4, face - 0.003, face + 0.004, p.h * 0.885, p.h * 0.935), 0.001));
}

void microwave(Piece& p) {
  const int body = p.main("black_plastic"), glass = p.named("screen");
  const double face = -p.d / 2 + 0.03, foot = p.h * 0.04;
  p.add(body, box(sides(-p.w / 2, p.w / 2, face, p.d / 2, foot, p.h), 0.006));
  for (const double x : {-0.38, 0.38})
    p.add(p.named("black_plastic"), box(sides(x * p.w - p.w * 0.04, x * p.w + p.w * 0.04, -p.d * 0.3, p.d * 0.4, 0, foot + 0.002), 0));
  p.add(p.named("steel"), box(sides(-p.w / 2 + 0.004, p.w * 0.24, face - 0.008, face + 0.002, foot + 0.006, p.h - 0.006), 0.003));
  p.add(glass, box(sides(-p.w / 2 + 0.04, p.w * 0.17, face - 0.011, face, p.h * 0.2, p.h * 0.85), 0.002));
  handle(p, p.named("chrome"), Handle::kVertical, {p.w * 0.205, face - 0.006, p.h * 0.52}, p.h * 0.6, 0.024);
  p.add(p.named("lit_screen"), box(sides(p.w * 0.29, p.w * 0.45, face - 0.002, face + 0.004, p.h * 0.76, p.h * 0.87), 0.001));
  for (int i = 0; i < 6; ++i) {
    const double x = p.w * (0.3 + 0.09 * (i % 2)), z = p.h * (0.58 - 0.15 * (i / 2));
    p.add(p.named("grey_plastic"), box(sides(x, x + p.w * 0.06, face - 0.003, face + 0.004, z, z + p.h * 0.08), 0.001));
  }
}

void tap(Piece& p, double y, double z, double tall, double reach) {
  const int chrome = p.named("chrome");
  const double r = 0.009;
  p.add(chrome, cylinder({0, y, z}, 0.02, 0.02, 14));
  p.add(
      chrome,
      tube(curve({{0, y, z + 0.01}, {0, y, z + tall * 0.7}, {0, y - reach * 0.4, z + tall - r}, {0, y - reach, z + tall * 0.6}}, 5), r, 8));
  p.add(chrome, ellipsoid({0, y - reach * 0.4, z + tall - r}, {r, r, r}, 10, 6));
  for (const double s : {-1.0, 1.0}) p.add(chrome, rod({s * 0.07, y, z}, {s * 0.07, y, z + std::min(0.04, tall * 0.6)}, 0.014, 10));
}

void urinal(Piece& p) {
  const int ceramic = p.main("ceramic");
  p.add(ceramic, rounded_box(sides(-p.w * 0.42, p.w * 0.42, p.d / 2 - std::min(0.08, p.d * 0.3), p.d / 2, p.h * 0.1, p.h), 0.03, 3));
  p.add(ceramic, rounded_box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, p.h * 0.34), std::min(p.w, p.d) * 0.3, 4));
  for (const double s : {-1.0, 1.0})
    p.add(ceramic, rounded_box(sides(s > 0 ? p.w * 0.36 : -p.w / 2, s > 0 ? p.w / 2 : -p.w * 0.36, -p.d * 0.1, p.d / 2 - 0.01, p.h * 0.15,
                                     p.h * 0.97),
                               0.03, 3));
  p.add(p.named("chrome"), cylinder({0, p.d / 2 - 0.04, p.h - 0.012}, 0.02, 0.012, 14));
}

// A wash basin or kitchen sink: a bowl in a top, on a cabinet, a pedestal or a wall. Where the bowl's space reaches far above its floor,
// the rim lies lower than the top and a tap stands on it.
void sink(Piece& p) {
  if (p.category() == "urinal") return urinal(p);
  const int ceramic = p.main("ceramic");
  const FreeSpace* bowl = p.open_above();
  const Box in = bowl != nullptr ? bowl->box : sides(-p.w * 0.36, p.w * 0.36, -p.d * 0.36, p.d * 0.2, p.h - std::min(0.14, p.h * 0.5), p.h);
  const double deep = p.h - in.min.z, tall = deep > 0.18 ? deep - 0.13 : 0, rim = p.h - tall, floor = in.min.z - 0.015;
  const double body = p.mount() == Mount::kWall ? 0 : std::max(0.0, std::min(floor, rim - 0.06)), x = p.w / 2, y = p.d / 2;
  p.add(ceramic, box(sides(-x, x, -y, y, body, in.min.z), 0.01));
  p.add(ceramic, box(sides(-x, in.min.x, -y, y, in.min.z - 0.004, rim), 0.008));
  p.add(ceramic, box(sides(in.max.x, x, -y, y, in.min.z - 0.004, rim), 0.008));
  p.add(ceramic, box(sides(in.min.x - 0.008, in.max.x + 0.008, -y, in.min.y, in.min.z - 0.004, rim), 0.008));
  p.add(ceramic, box(sides(in.min.x - 0.008, in.max.x + 0.008, in.max.y, y, in.min.z - 0.004, rim), 0.008));
  p.add(p.named("chrome"), lathe({{0, 0}, {0.022, 0}, {0.022, 0.0008}, {0, 0.0008}}, 16), moved(in.center().x, in.center().y, in.min.z));
  if (tall > 0) tap(p, (in.max.y + y) / 2, rim - 0.002, tall + 0.002, std::min(0.02, (y - in.max.y) * 0.3));
  if (p.mount() == Mount::kWall || body < 0.1) return;
  if (p.w > 0.55 || p.says("vanity")) {
    const int wood = p.frame("oak");
    carcass(p, {sides(-x + 0.01, x - 0.01, -y + 0.005, y, 0.08, body), wood, wood, p.named("steel")});
    p.add(p.named("black_plastic"), box(sides(-x + 0.03, x - 0.03, -y + 0.06, y - 0.002, 0, 0.08), 0));
    return;
  }
  p.add(ceramic, lathe({{0, 0}, {0.13, 0}, {0.12, 0.03}, {0.075, 0.25}, {0.08, body * 0.7}, {0.14, body + 0.005}, {0, body + 0.005}}, 24),
        moved(0, p.d * 0.1, 0));
}

}  // namespace

void add_kitchen(Families& to) {
  to["counter"] = counter;
  to["fridge"] = fridge;
  to["stove"] = stove;
  to["oven"] = oven;
  to["dishwasher"] = dishwasher;
  to["washing_machine"] = washing_machine;
  to["microwave"] = microwave;
  to["sink"] = sink;
}

}  // namespace layoutbox::kit
