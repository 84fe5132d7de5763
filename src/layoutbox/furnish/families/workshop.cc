// Studio, workshop and laboratory.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// One whose ledge the catalogue leaves free for a canvas.
void display_easel(Piece& p) {
  const int wood = p.main("oak");
  const Box s = p.spaces.front().box;
  const double t = 0.03, back = s.max.y + 0.03;
  for (const double k : {-1.0, 1.0}) {
    p.add(wood, beam({k * (p.w / 2 - 0.02), back - 0.005, 0.005}, {k * p.w * 0.12, back, p.h - 0.01}, {t, t}, 0.004));
    p.add(wood, beam({k * (p.w / 2 - 0.02), s.min.y + 0.02, 0.01}, {k * (p.w / 2 - 0.06), back - 0.03, s.min.z - 0.02}, {t, t}, 0.004));
  }
  p.add(wood, beam({0, p.d / 2 - 0.02, 0.005}, {0, back + 0.02, p.h - 0.1}, {t, t}, 0.004));
  p.add(wood, box(sides(-p.w / 2, p.w / 2, s.min.y, back, s.min.z - 0.03, s.min.z), 0.004));
  p.add(wood, box(sides(-p.w * 0.14, p.w * 0.14, back - 0.015, back + 0.02, p.h - 0.05, p.h), 0.004));
  p.add(wood, box(sides(-p.w / 2, p.w / 2, p.d / 2 - 0.03, p.d / 2, 0, 0.02), 0.004));
  // A painting that is begun, where nothing else stands on it.
  if (!p.may_show_contents() || p.spaces.front().held) return;
  const double x = p.w * 0.44, top = s.min.z + std::min(p.w * 1.1, (p.h - s.min.z) * 0.85), front = s.max.y - 0.025, tall = top - s.min.z;
  p.add(p.named("cotton"), box(sides(-x, x, front, s.max.y - 0.003, s.min.z, top), 0.003));
  const auto stroke = [&](int paint, double x0, double x1, double z0, double z1) {
    p.add(paint, box(sides(x0 * x, x1 * x, front - 0.003, front + 0.002, s.min.z + z0 * tall, s.min.z + z1 * tall), 0));
  };
  stroke(p.tinted("paper", {0.62, 0.78, 0.88}), -0.8, 0.8, 0.5, 0.88);
  stroke(p.tinted("paper", {0.45, 0.62, 0.38}), -0.8, 0.45, 0.2, 0.52);
  stroke(p.tinted("paper", {0.9, 0.62, 0.3}), 0.2, 0.55, 0.58, 0.78);
}

void easel(Piece& p) {
  if (!p.spaces.empty()) return display_easel(p);
  const int wood = p.main("oak");
  const double t = 0.03;
  for (const double s : {-1.0, 1.0}) p.add(wood, beam({s * 0.45, -0.3, 0}, {s * 0.06, 0.02, 1.0}, {t, t}, 0.004));
  p.add(wood, beam({0, 0.45, 0}, {0, 0.06, 0.95}, {t, t}, 0.004));
  p.add(wood, beam({0, -0.2, 0.3}, {0, 0.0, 1.0}, {t, t}, 0.004));
  p.add(wood, box(sides(-0.4, 0.4, -0.27, -0.17, 0.36, 0.385), 0.004));
  const Pose tilt = moved(0, -0.22, 0.385) * turned_x(-17);
  p.add(p.named("paper"), box(sides(-0.33, 0.33, -0.02, 0.01, 0, 0.5), 0.003), tilt);
  p.add(p.tinted("paper", p.accent()), box(sides(-0.25, 0.05, -0.023, -0.018, 0.08, 0.3), 0), tilt);
  p.add(p.tinted("paper", {0.86, 0.58, 0.36}), prism(ellipse({0.12, 0.33}, {0.1, 0.09}, 20), 0.018, 0.0235),
        tilt * Pose{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}});
  p.fit();
}

void workbench(Piece& p) {
  const int wood = p.main("oak"), frame = p.frame("oak"), metal = p.named("black_metal");
  double level = p.h;
  if (const FreeSpace* s = p.open_above()) level = s->box.min.z;
  double lowest = level;
  for (const FreeSpace& s : p.spaces) {
    if (s.box.max.z < level - 0.001) lowest = std::min(lowest, level - s.box.max.z);
  }
  const double board = std::min({0.07, level * 0.1, lowest}), under = p.clear_below(0);
  p.add(wood, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, level - board, level), 0.006));
  p.legs(frame, level - board, 0.08, 0.02);
  // A shelf below, where the catalogue has one.
  for (const FreeSpace& s : p.spaces) {
    if (!s.carries || s.box.max.z > level - 0.01 || s.box.min.z < 0.03) continue;
    p.add(frame, box(sides(-p.w / 2 + 0.004, p.w / 2 - 0.004, -p.d / 2 + 0.01, p.d / 2 - 0.004, s.box.min.z - 0.028, s.box.min.z), 0.004));
  }
  if (under <= 0 && p.spaces.empty()) {
    p.add(frame, box(sides(-p.w / 2 + 0.03, p.w / 2 - 0.03, -p.d / 2 + 0.04, p.d / 2 - 0.03, level * 0.2, level * 0.2 + 0.03), 0.004));
    p.add(metal, box(sides(p.w * 0.28, p.w * 0.42, -p.d / 2 + 0.03, -p.d / 2 + 0.2, level * 0.2 + 0.03, level * 0.2 + 0.25), 0.008));
    fronts(p, frame, metal, {-p.w / 2 + 0.12, 0, level - board - 0.16, level - board, -p.d / 2 + 0.03, 1, 1, false, 0.3, 0.02});
  }
  // A tool wall, where the piece is higher than its top.
  if (p.h > level + 0.1) {
    const double y = p.d / 2 - 0.03;
    p.add(frame, box(sides(-p.w / 2, p.w / 2, y + 0.01, p.d / 2, level - 0.02, p.h), 0.004));
  }
}

// A hammer lying along its longer side, or a tool box where it is bulky.
void tool(Piece& p) {
  if (p.h > 0.08) {
    const int red = p.color_asked() ? p.main("painted_metal") : p.tinted("painted_metal", {0.76, 0.22, 0.18}),
              dark = p.named("black_plastic");
    const double lid = p.h * 0.55;
    p.add(red, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, lid), 0.006));
    p.add(red, box(sides(-p.w / 2 + 0.003, p.w / 2 - 0.003, -p.d / 2 + 0.003, p.d / 2 - 0.003, lid + 0.003, p.h * 0.8), 0.012));
    for (const double x : {-0.3, 0.3})
      p.add(p.named("chrome"), box(sides(x * p.w - 0.015, x * p.w + 0.015, -p.d / 2, -p.d / 2 + 0.01, lid - 0.03, lid + 0.03), 0.002));
    p.add(
        dark,
        tube(curve({{-p.w * 0.25, 0, p.h * 0.78}, {-p.w * 0.22, 0, p.h - 0.012}, {p.w * 0.22, 0, p.h - 0.012}, {p.w * 0.25, 0, p.h * 0.78}},
                   4),
             0.011, 8));
    p.fit();
    return;
  }
  const bool along = p.w >= p.d;
  const Pose turn = along ? Pose{} : turned_z(90);
  p.add(p.named("oak"), rod({-0.5, 0, 0.05}, {0.4, 0, 0.05}, 0.04, 10), turn);
  p.add(p.main("steel"), box(sides(0.38, 0.5, -0.18, 0.12, 0, 0.1), 0.01), turn);
  p.add(p.main("steel"), prism({{0.4, 0.11}, {0.48, 0.11}, {0.46, 0.24}, {0.42, 0.24}}, 0.03, 0.07), turn);
  p.fit();
}

void ladder(Piece& p) {
  const int metal = p.main("steel"), step = p.frame("steel");
  const bool leaning = p.d < 0.2;
  const double back = leaning ? -p.d / 2 + 0.02 : 0.02;
  const int n = std::max(2, static_cast<int>(p.h / 0.28));
  for (const double s : {-1.0, 1.0}) {
    p.add(metal, beam({s * (p.w / 2 - 0.02), -p.d / 2 + 0.02, 0}, {s * (p.w / 2 - 0.05) * (leaning ? 1 : 0.85), back, p.h - 0.02},
                      {0.035, 0.05}, 0.004));
    if (!leaning)
      p.add(metal,
            beam({s * (p.w / 2 - 0.02), p.d / 2 - 0.02, 0}, {s * (p.w / 2 - 0.05) * 0.85, back + 0.03, p.h - 0.05}, {0.03, 0.03}, 0.004));
  }
  for (int i = 1; i <= n; ++i) {
    const double t = (i - 0.3) / n, y = (-p.d / 2 + 0.02) * (1 - t) + back * t, half = (p.w / 2 - 0.03) * (1 - (leaning ? 0 : 0.15 * t));
    p.add(step, box(sides(-half, half, y - (leaning ? 0.015 : 0.04), y + (leaning ? 0.015 : 0.05), p.h * t - 0.03, p.h * t), 0.004));
  }
  p.fit();
}

// The machine alone in a box of 1 by 0.5 by 0.9; `on`: where that is.
void sewing_head(Piece& p, int body, const Pose& on) {
  const int metal = p.named("chrome"), dark = p.named("grey_plastic");
  p.add(body, rounded_box(sides(-0.5, 0.5, -0.22, 0.22, 0, 0.16), 0.04, 3), on);
  p.add(body, rounded_box(sides(0.24, 0.46, -0.16, 0.18, 0.14, 0.76), 0.06, 3), on);
  p.add(body, rounded_box(sides(-0.46, 0.46, -0.14, 0.16, 0.52, 0.78), 0.07, 3), on);
  p.add(body, rounded_box(sides(-0.46, -0.26, -0.13, 0.14, 0.38, 0.7), 0.04, 3), on);
  p.add(metal, rod({-0.36, 0, 0.17}, {-0.36, 0, 0.4}, 0.015, 8), on);
  p.add(metal, box(sides(-0.44, -0.26, -0.1, 0.1, 0.16, 0.175), 0.005), on);
  p.add(dark, rod({0.46, 0, 0.64}, {0.52, 0, 0.64}, 0.11, 22), on);
  p.add(dark, rod({0.34, -0.165, 0.5}, {0.34, -0.14, 0.5}, 0.05, 18), on);
  p.add(p.tinted("wool", p.accent()), cylinder({0.1, 0, 0.77}, 0.04, 0.12, 14), on);
}

// On its own table where that is part of it: a top on two sides of iron, between them the treadle.
void sewing_machine(Piece& p) {
  constexpr double kOfTable = 0.7;
  if (p.spaces.empty()) {
    sewing_head(p, p.main("plastic"), {});
    p.fit();
    return;
  }
  const int wood = p.main("oak"), iron = p.named("black_metal");
  const double top = kOfTable * p.h, under = p.spaces[0].box.max.z, high = p.h - top;
  p.add(wood, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, std::max(under, top - 0.04), top), 0.005));
  for (const double side : {-1.0, 1.0}) {
    const double outer = side * (p.w / 2 - 0.01), inner = side * (p.w / 2 - 0.04);
    p.add(iron, box(sides(std::min(inner, outer), std::max(inner, outer), -p.d / 2 + 0.03, p.d / 2 - 0.03, 0, under), 0.003));
  }
  p.add(iron, box(sides(-p.w / 2 + 0.04, p.w / 2 - 0.04, p.d / 2 - 0.05, p.d / 2 - 0.03, 0.05, 0.2), 0.003));
  sewing_head(p, p.named("black_metal"), moved(0.1 * p.w, 0.05 * p.d, top) * scaled(0.45 * p.w, 0.45 * p.w, high / 0.9));
}

void telescope(Piece& p) {
  const int tube_surface = p.main("plastic"), dark = p.named("black_plastic"), wood = p.frame("oak");
  for (int i = 0; i < 3; ++i) {
    const double a = kPi * (0.5 + 2.0 * i / 3);
    p.add(wood, rod({std::cos(a) * 0.38, std::sin(a) * 0.38, 0}, {0, 0, 0.95}, 0.018, 8));
  }
  p.add(dark, cylinder({0, 0, 0.92}, 0.05, 0.1, 16));
  const Vec low{0, 0.38, 0.86}, high{0, -0.42, 1.35}, way = unit(high - low);
  p.add(tube_surface, rod(low, high, 0.065, 24));
  p.add(dark, rod(high - way * 0.16, high + way * 0.02, 0.078, 24));
  p.add(dark, rod(low - way * 0.12, low, 0.03, 16));
  p.add(dark, rod({0.08, 0.2, 1.06}, {0.08, -0.02, 1.195}, 0.02, 12));
  p.fit();
}

void microscope(Piece& p) {
  const int body = p.main("plastic"), dark = p.named("black_plastic"), metal = p.named("chrome");
  p.add(body, rounded_box(sides(-0.3, 0.3, -0.4, 0.4, 0, 0.12), 0.05, 3));
  p.add(body, tube(curve({{0, 0.3, 0.08}, {0, 0.34, 0.5}, {0, 0.22, 0.9}, {0, 0.0, 1.0}}, 5), 0.1, 12));
  p.add(dark, box(sides(-0.28, 0.28, -0.28, 0.24, 0.4, 0.45), 0.01));
  p.add(metal, rod({0, -0.06, 0.46}, {0, -0.06, 0.8}, 0.06, 14));
  const Vec low{0, -0.02, 0.95}, eye{0, -0.4, 1.4};
  p.add(dark, rod(low, eye, 0.08, 18));
  p.add(metal, rod(eye - unit(eye - low) * 0.1, eye, 0.095, 18));
  for (const double s : {-1.0, 1.0}) p.add(dark, rod({s * 0.08, 0.3, 0.42}, {s * 0.2, 0.3, 0.42}, 0.09, 16));
  p.fit();
}

void bicycle(Piece& p) {
  const int paint = p.color_asked() ? p.main("painted_metal") : p.tinted("painted_metal", p.accent()), dark = p.named("black_plastic"),
            metal = p.named("chrome");
  // Made along x, 1.75 m long, its front to the left; turned where the piece is deeper than wide.
  const Pose turn = p.w >= p.d ? Pose{} : turned_z(90);
  const double r = 0.34, xf = -0.52, xb = 0.52;
  for (const double x : {xf, xb}) {
    p.add(dark, torus({0, 0, 0}, r - 0.018, 0.018, 34, 6), turn * aimed({x, 0, r}, {0, 1, 0}));
    p.add(metal, torus({0, 0, 0}, r - 0.045, 0.01, 30, 5), turn * aimed({x, 0, r}, {0, 1, 0}));
    for (int i = 0; i < 7; ++i) {
      const double a = kPi * i / 7;
      p.add(metal,
            rod({x + std::cos(a) * (r - 0.04), 0, r + std::sin(a) * (r - 0.04)},
                {x - std::cos(a) * (r - 0.04), 0, r - std::sin(a) * (r - 0.04)}, 0.002, 4),
            turn);
    }
    p.add(metal, rod({x, -0.05, r}, {x, 0.05, r}, 0.02, 10), turn);
  }
  const Vec pedal{0.08, 0, 0.3}, seat{0.22, 0, 0.86}, headlow{-0.36, 0, 0.68}, head{-0.4, 0, 0.85};
  for (const auto& [from, to] :
       {std::pair{pedal, seat}, {pedal, headlow}, {seat - Vec{0.02, 0, 0.08}, head - Vec{-0.01, 0, 0.04}}, {headlow, head}})
    p.add(paint, rod(from, to, 0.018, 10), turn);
  for (const double s : {-0.05, 0.05}) {
    p.add(paint, rod(pedal + Vec{0, s * 0.6, 0}, {xb, s, r}, 0.01, 8), turn);
    p.add(paint, rod(seat - Vec{0.01, 0, 0.06}, {xb, s, r}, 0.009, 8), turn);
    p.add(paint, rod(headlow, {xf, s, r}, 0.013, 8), turn);
    p.add(metal, rod(pedal + Vec{0, s, 0}, pedal + Vec{s > 0 ? 0.12 : -0.12, s * 1.6, s > 0 ? -0.1 : 0.1}, 0.01, 6), turn);
    p.add(dark,
          box(sides(pedal.x + (s > 0 ? 0.12 : -0.12) - 0.04, pedal.x + (s > 0 ? 0.12 : -0.12) + 0.04, s * 1.6 - 0.04, s * 1.6 + 0.04,
                    pedal.z + (s > 0 ? -0.11 : 0.09), pedal.z + (s > 0 ? -0.09 : 0.11)),
              0.003),
          turn);
  }
  p.add(metal, rod(pedal - Vec{0, 0.045, 0}, pedal + Vec{0, -0.04, 0}, 0.09, 22), turn);
  p.add(metal, rod(seat, seat + Vec{0.02, 0, 0.08}, 0.013, 8), turn);
  p.add(dark, rounded_box(sides(0.12, 0.38, -0.07, 0.07, 0.93, 0.99), 0.025, 3), turn);
  p.add(metal, rod(head, head + Vec{-0.03, 0, 0.13}, 0.013, 8), turn);
  p.add(dark, tube(curve({{-0.28, -0.28, 1.0}, {-0.42, -0.2, 1.0}, {-0.44, 0, 0.98}, {-0.42, 0.2, 1.0}, {-0.28, 0.28, 1.0}}, 4), 0.014, 8),
        turn);
  p.fit();
}

// A tyre on its rim, lying or standing as its box says.
void car_part(Piece& p) {
  const bool lying = p.h < std::min(p.w, p.d);
  const Pose turn = lying ? Pose{} : p.w < p.d ? turned_y(90) : turned_x(90);
  p.add(p.named("black_plastic"),
        lathe({{0.3, -0.12}, {0.46, -0.13}, {0.5, -0.09}, {0.5, 0.09}, {0.46, 0.13}, {0.3, 0.12}, {0.3, -0.12}}, 36), turn);
  p.add(p.main("steel"),
        lathe({{0, -0.02}, {0.29, -0.06}, {0.305, -0.11}, {0.305, 0.11}, {0.29, 0.1}, {0.26, 0.03}, {0.08, 0.05}, {0, 0.06}}, 30), turn);
  p.fit();
}

}  // namespace

void add_workshop(Families& to) {
  to["easel"] = easel;
  to["workbench"] = workbench;
  to["tool"] = tool;
  to["ladder"] = ladder;
  to["sewing_machine"] = sewing_machine;
  to["telescope"] = telescope;
  to["microscope"] = microscope;
  to["bicycle"] = bicycle;
  to["car_part"] = car_part;
}

}  // namespace layoutbox::kit
