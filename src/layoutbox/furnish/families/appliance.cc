// Small machines of kitchen and house.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

void toaster(Piece& p) {
  const int body = p.main("steel"), dark = p.named("black_plastic");
  const double x = p.w / 2, y = p.d / 2, foot = p.h * 0.05, lever = std::min(0.02, p.w * 0.08);
  p.add(dark, box(sides(-x + lever + 0.01, x - lever - 0.01, -y + 0.01, y - 0.01, 0, foot + 0.005), 0.003));
  p.add(body, rounded_box(sides(-x + lever, x - lever, -y, y, foot, p.h), std::min({0.035, p.h * 0.25, y * 0.4}), 4));
  for (const double s : {-0.22, 0.22})
    p.add(dark, box(sides(-x * 0.66, x * 0.66, s * p.d - p.d * 0.07, s * p.d + p.d * 0.07, p.h - 0.02, p.h - 0.0005), 0));
  for (const double s : {-1.0, 1.0})
    p.add(dark, box(sides(s * x - (s > 0 ? lever : 0), s * x + (s > 0 ? 0 : lever), -0.02, 0.02, p.h * 0.55, p.h * 0.63), 0.004));
  p.fit();
}

// A slanted hood under a chimney.
void range_hood(Piece& p) {
  const int steel = p.main("steel");
  const double x = p.w / 2, y = p.d / 2, rim = std::min(0.05, p.h * 0.3), chimney = std::min(0.14, x * 0.5),
               deep = std::min(0.28, p.d * 0.6);
  p.add(steel, box(sides(-x, x, -y, y, 0, rim), 0.004));
  p.add(p.named("screen"), box(sides(-x * 0.3, x * 0.3, -y - 0.0005, -y + 0.01, rim * 0.25, rim * 0.75), 0));
  if (p.h > 0.25) {
    const double slope = std::min(0.2, (p.h - rim) * 0.4), cy = y - deep / 2;
    p.add(steel, taper({0, 0, rim}, {x - 0.004, y - 0.002}, {0, cy, rim + slope}, {chimney, deep / 2}));
    p.add(steel, box(sides(-chimney, chimney, y - deep, y, rim + slope, p.h), 0.003));
  } else {
    p.add(steel, taper({0, 0, rim}, {x - 0.004, y - 0.002}, {0, y * 0.2, p.h}, {x * 0.9, y * 0.8}));
  }
  const double z = 0.004;
  for (const double s : {-0.5, 0.5}) p.add(p.named("bulb"), box(sides(s * x - 0.03, s * x + 0.03, -0.03, 0.03, 0.0, z), 0));
  p.fit();
}

// A vessel with a spout to the left, a handle to the right and a lid: kettles and teapots.
void kettle(Piece& p) {
  const bool tea = p.word("kind", "") == "teapot" || p.says("teapot");
  const int body = tea ? p.main_accent("ceramic") : p.main("steel"), dark = tea ? body : p.named("black_plastic");
  const double r = 0.5, h = tea ? 0.78 : 1.15;
  if (tea) {
    p.add(body, ellipsoid({0, 0, 0.4}, {0.52, 0.52, 0.4}, 26, 14));
  } else {
    p.add(dark, cylinder({0, 0, 0}, r * 1.04, 0.1, 28));
    p.add(body, lathe({{0, 0.1}, {r, 0.1}, {r * 0.98, h * 0.5}, {r * 0.74, h * 0.94}, {0, h * 0.94}}, 28));
  }
  p.add(dark, lathe({{0, h * 0.93}, {r * 0.6, h * 0.93}, {r * 0.45, h}, {r * 0.1, h * 1.02}, {r * 0.16, h * 1.1}, {0, h * 1.12}}, 20));
  p.add(body, tube(curve({{-r * 0.8, 0, h * 0.4}, {-r * 1.25, 0, h * 0.62}, {-r * 1.5, 0, h * 0.9}}, 4), tea ? 0.07 : 0.09, 10));
  p.add(dark, tube(curve({{r * 0.82, 0, h * 0.86}, {r * 1.5, 0, h * 0.84}, {r * 1.55, 0, h * 0.4}, {r * 0.9, 0, h * 0.22}}, 4), 0.06, 8));
  p.fit();
}

// A tower over a drip tray, with a jug or with two spouts and a steam pipe.
void coffee_machine(Piece& p) {
  const bool espresso = p.says("espresso");
  const int body = p.main(espresso ? "steel" : "black_plastic"), dark = p.named("black_plastic"), chrome = p.named("chrome");
  const double x = p.w / 2, y = p.d / 2, base = p.h * 0.14, head = p.h * 0.68, back = y - p.d * 0.42;
  p.add(body, rounded_box(sides(-x, x, -y, y, 0, base), std::min(0.012, base * 0.3), 2));
  p.add(dark, box(sides(-x * 0.8, x * 0.8, -y + 0.012, back, base - 0.004, base + 0.002), 0));
  p.add(body, box(sides(-x + 0.002, x - 0.002, back, y - 0.002, base * 0.5, p.h * 0.9), 0.006));
  p.add(body, rounded_box(sides(-x, x, -y + p.d * 0.04, y, head, p.h), std::min(0.015, p.h * 0.05), 2));
  const double cy = (back - y) / 2;
  if (espresso) {
    const int heads = p.w > 0.55 ? 2 : 1;
    for (int i = 0; i < heads; ++i) {
      const double cx = heads == 1 ? 0 : (i == 0 ? -x * 0.45 : x * 0.45);
      p.add(chrome, cylinder({cx, cy, head - p.h * 0.07}, p.h * 0.08, p.h * 0.08, 18));
      p.add(dark, rod({cx, cy, head - p.h * 0.05}, {cx, -y + 0.002, head - p.h * 0.07}, p.h * 0.025, 8));
      p.add(p.named("ceramic"), lathe({{0, 0}, {p.h * 0.06, 0}, {p.h * 0.09, p.h * 0.14}, {0, p.h * 0.14}}, 16),
            moved(cx, cy, base + 0.002));
    }
    p.add(chrome, rod({x * 0.86, cy, head}, {x * 0.8, cy * 1.1, base + p.h * 0.16}, p.h * 0.015, 8));
    for (const double s : {-0.3, 0.0, 0.3}) dial(p, dark, {s * p.w, -y + p.d * 0.04 + 0.001, p.h * 0.86}, p.h * 0.035, p.d * 0.035);
  } else {
    const double r = std::min(x * 0.66, (back + y) * 0.44), tall = (head - base) * 0.8;
    p.add(p.named("glass"), lathe({{0, 0}, {r, 0}, {r * 1.02, tall * 0.6}, {r * 0.7, tall}, {0, tall}}, 24), moved(0, cy, base + 0.003));
    p.add(p.named("walnut"), lathe({{0, 0.004}, {r * 0.95, 0.004}, {r * 0.95, tall * 0.5}, {0, tall * 0.5}}, 20),
          moved(0, cy, base + 0.003));
    p.add(p.named("lit_screen"), box(sides(-x * 0.3, x * 0.3, -y + p.d * 0.04 - 0.001, -y + p.d * 0.04 + 0.01, p.h * 0.8, p.h * 0.88), 0));
  }
  p.fit();
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

void stand_mixer(Piece& p) {
  const int body = p.main_accent("painted_metal"), steel = p.named("steel");
  p.add(body, rounded_box(sides(-0.55, 0.5, -0.3, 0.3, 0, 0.1), 0.045, 3));
  p.add(body, rounded_box(sides(0.2, 0.48, -0.16, 0.16, 0.05, 0.75), 0.07, 3));
  p.add(body, rounded_box(sides(-0.5, 0.52, -0.19, 0.19, 0.66, 1.0), 0.14, 4));
  p.add(steel, cylinder({-0.24, 0, 0.5}, 0.05, 0.2, 12));
  p.add(steel, lathe({{0, 0.1}, {0.13, 0.1}, {0.27, 0.26}, {0.3, 0.52}, {0.285, 0.52}, {0.25, 0.27}, {0, 0.14}}, 26), moved(-0.24, 0, 0));
  p.fit();
}

void blender_jug(Piece& p) {
  const int base = p.color_asked() ? p.main("plastic") : p.named("black_plastic");
  p.add(base, taper({0, 0, 0}, {0.5, 0.5}, {0, 0, 0.34}, {0.34, 0.34}));
  dial(p, p.named("chrome"), {0, -0.42, 0.16}, 0.09, 0.05);
  p.add(p.named("glass"), lathe({{0, 0.34}, {0.3, 0.34}, {0.44, 0.92}, {0.41, 0.92}, {0.27, 0.37}, {0, 0.37}}, 22));
  p.add(base, lathe({{0, 0.92}, {0.45, 0.92}, {0.42, 0.98}, {0.15, 0.98}, {0.13, 1.04}, {0, 1.04}}, 22));
  p.add(base, tube(curve({{0.4, 0, 0.86}, {0.62, 0, 0.84}, {0.58, 0, 0.5}, {0.34, 0, 0.46}}, 4), 0.04, 8));
  p.fit();
}

void vacuum_cleaner(Piece& p) {
  const int paint = p.main_accent("plastic"), dark = p.named("black_plastic"), steel = p.named("steel");
  const double x = p.w / 2, y = p.d / 2, h = p.h;
  if (h < 0.2) {  // one that drives by itself
    p.add(dark, lathe({{0, 0}, {0.94, 0}, {1, 0.25}, {1, 0.75}, {0.95, 1}, {0, 1}}, 36), scaled(x, y, h));
    p.add(paint, lathe({{0, 0.99}, {0.62, 0.99}, {0.62, 1.02}, {0, 1.02}}, 30), scaled(x, y, h));
    p.add(p.named("chrome"), cylinder({0, -y * 0.5, h * 0.99}, std::min(x, y) * 0.16, h * 0.1, 18));
    p.fit();
    return;
  }
  p.add(dark, rounded_box(sides(-x, x, -y, -y + std::min(0.28, p.d * 0.7), 0, std::min(0.09, h * 0.12)), 0.025, 3));
  p.add(steel, rod({0, -y * 0.35, 0.05}, {0, y * 0.55, h * 0.86}, 0.016, 10));
  p.add(paint, rounded_box(sides(-x * 0.5, x * 0.5, -y * 0.3, y * 0.75, h * 0.28, h * 0.68), std::min(0.06, x * 0.3), 4));
  p.add(dark, tube(curve({{0, y * 0.5, h * 0.8}, {0, y * 0.62, h * 0.97}, {0, y * 0.95, h * 0.93}, {0, y * 0.9, h * 0.8}}, 4), 0.018, 8));
  p.fit();
}

void telephone(Piece& p) {
  const int body = p.main("black_plastic"), grey = p.named("grey_plastic");
  const double x = p.w / 2, y = p.d / 2, h = p.h;
  p.add(body, prism({{-y, 0}, {y, 0}, {y, h * 0.62}, {-y, h * 0.2}}, -x, x), Pose{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {}});
  p.add(body, rounded_box(sides(-x * 0.95, -x * 0.45, -y * 0.9, y * 0.9, h * 0.6, h), std::min(0.014, h * 0.18), 3));
  for (const double s : {-0.72, 0.72}) p.add(body, box(sides(-x * 0.9, -x * 0.5, s * y - 0.015, s * y + 0.015, h * 0.2, h * 0.7), 0.003));
  for (int i = 0; i < 12; ++i) {
    const double cx = x * (-0.12 + 0.34 * (i % 3)), t = (i / 3) / 4.0, cy = y * (-0.7 + 1.1 * t), z = h * (0.2 + 0.42 * (cy + y) / p.d);
    p.add(grey, box(sides(cx - x * 0.11, cx + x * 0.11, cy - y * 0.09, cy + y * 0.09, z - 0.006, z + h * 0.06), 0.002));
  }
  p.add(p.named("lit_screen"), box(sides(-x * 0.25, x * 0.8, y * 0.55, y * 0.85, h * 0.5, h * 0.64), 0.002));
  p.fit();
}

// A switch, thermostat or socket: a small plate on the wall with something on it.
void wall_plate(Piece& p) {
  const int plate = p.main("plastic");
  p.add(plate, rounded_box(sides(-p.w / 2, p.w / 2, -p.d / 2 + p.d * 0.3, p.d / 2, 0, p.h), std::min({0.006, p.d * 0.3, p.w * 0.2}), 3));
  const bool dial_on_it = p.says("thermostat") || p.category() == "thermostat";
  const double r = std::min(p.w, p.h) * 0.36;
  if (dial_on_it) {
    dial(p, p.named("screen"), {0, -p.d / 2 + p.d * 0.32, p.h / 2}, r, p.d * 0.32);
    dial(p, p.named("lit_screen"), {0, -p.d / 2 + p.d * 0.02, p.h / 2}, r * 0.4, p.d * 0.01);
  } else {
    p.add(plate, box(sides(-r * 0.9, r * 0.9, -p.d / 2, p.d / 2, p.h / 2 - r * 1.1, p.h / 2 + r * 1.1), std::min(0.003, p.d * 0.2)));
  }
}

void tissue_box(Piece& p) {
  const int card = p.main_accent("paper"), white = p.named("cotton");
  const double top = p.h * 0.72;
  p.add(card, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, top), 0.003));
  p.add(p.named("paper"), prism(ellipse({0, 0}, {p.w * 0.3, p.d * 0.2}, 24), top - 0.001, top + 0.002));
  p.add(white, leaf({-p.w * 0.02, 0, top}, {p.w * 0.06, -p.d * 0.05, p.h}, p.w * 0.3, p.h * 0.03));
  p.add(white, leaf({p.w * 0.04, p.d * 0.03, top}, {-p.w * 0.08, p.d * 0.08, p.h * 0.95}, p.w * 0.24, p.h * 0.03));
  p.fit();
}

void hand_dryer(Piece& p) {
  const int body = p.main("painted_metal"), dark = p.named("black_plastic");
  p.add(body, rounded_box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, p.h * 0.12, p.h), std::min({0.04, p.d * 0.3, p.w * 0.2}), 4));
  p.add(dark, taper({0, -p.d * 0.12, 0}, {p.w * 0.22, p.d * 0.16}, {0, 0, p.h * 0.16}, {p.w * 0.3, p.d * 0.28}));
  p.add(p.named("lit_screen"), box(sides(-p.w * 0.06, p.w * 0.06, -p.d / 2 - 0.001, -p.d / 2 + 0.01, p.h * 0.8, p.h * 0.84), 0));
  p.fit();
}

void game_controller(Piece& p) {
  const int body = p.main("black_plastic"), grey = p.named("grey_plastic");
  p.add(body, rounded_box(sides(-0.38, 0.38, -0.14, 0.22, 0.12, 0.36), 0.1, 4));
  for (const double s : {-1.0, 1.0}) {
    p.add(body, ellipsoid({s * 0.36, -0.12, 0.2}, {0.15, 0.3, 0.17}, 16, 10),
          moved(s * 0.36, 0, 0) * turned_z(-s * 22) * moved(-s * 0.36, 0, 0));
    p.add(grey, cylinder({s * 0.16, -0.04, 0.34}, 0.055, 0.09, 14));
  }
  const Color dots[] = {{0.8, 0.25, 0.25}, {0.3, 0.6, 0.35}, {0.25, 0.45, 0.8}, {0.9, 0.75, 0.3}};
  for (int i = 0; i < 4; ++i)
    p.add(p.tinted("plastic", dots[i]),
          cylinder({0.32 + 0.06 * std::cos(i * kPi / 2), 0.1 + 0.06 * std::sin(i * kPi / 2), 0.34}, 0.024, 0.05, 10));
  p.fit();
}

void webcam(Piece& p) {
  const int body = p.main("black_plastic");
  p.add(body, rounded_box(sides(-0.5, 0.5, -0.2, 0.2, 0.5, 0.9), 0.15, 4));
  dial(p, p.named("chrome"), {0, -0.19, 0.7}, 0.14, 0.04);
  dial(p, p.named("screen"), {0, -0.22, 0.7}, 0.1, 0.03);
  p.add(body, cylinder({0, 0, 0.1}, 0.06, 0.42, 12));
  p.add(body, rounded_box(sides(-0.28, 0.28, -0.24, 0.24, 0, 0.12), 0.05, 3));
  p.fit();
}

// A bottle with a pump.
void pump_bottle(Piece& p) {
  const int body = p.main_accent("ceramic"), metal = p.named("chrome");
  p.add(body, lathe({{0, 0}, {0.42, 0}, {0.46, 0.08}, {0.46, 0.56}, {0.3, 0.68}, {0, 0.68}}, 26));
  p.add(metal, cylinder({0, 0, 0.67}, 0.17, 0.1, 16));
  p.add(metal, cylinder({0, 0, 0.76}, 0.05, 0.16, 10));
  p.add(metal, rod({0.05, 0, 0.95}, {-0.4, 0, 0.93}, 0.05, 10));
  p.fit();
}

}  // namespace

void add_appliances(Families& to) {
  to["microwave"] = microwave;
  to["toaster"] = toaster;
  to["range_hood"] = range_hood;
  to["kettle"] = kettle;
  to["coffee_machine"] = coffee_machine;
  to["stand_mixer"] = stand_mixer;
  to["blender_jug"] = blender_jug;
  to["vacuum_cleaner"] = vacuum_cleaner;
  to["telephone"] = telephone;
  to["wall_plate"] = wall_plate;
  to["tissue_box"] = tissue_box;
  to["hand_dryer"] = hand_dryer;
  to["game_controller"] = game_controller;
  to["webcam"] = webcam;
  to["pump_bottle"] = pump_bottle;
}

}  // namespace layoutbox::kit
