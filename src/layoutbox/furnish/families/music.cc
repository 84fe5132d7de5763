// Musical instruments.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// White and black keys along x from x0 to x1, their front edge at y.
void keys(Piece& p, double x0, double x1, double y, double deep, double z) {
  const int white = p.named("ceramic"), black = p.named("black_plastic");
  const int n = std::clamp(static_cast<int>((x1 - x0) / 0.0236), 7, 52);
  const double each = (x1 - x0) / n;
  p.add(white, box(sides(x0, x1, y, y + deep, z - 0.015, z), 0.001));
  for (int i = 1; i < n; ++i) {
    const int k = i % 7;
    if (k == 0 || k == 3) continue;
    const double x = x0 + each * i;
    p.add(black, box(sides(x - each * 0.3, x + each * 0.3, y + deep * 0.38, y + deep, z, z + 0.01), 0.001));
  }
}

void piano(Piece& p) {
  const int wood = p.main("ebony");
  double front = p.d / 2 - std::max(p.d * 0.55, p.d - 0.3), key_z = std::min(0.72, p.h * 0.58), in = 0.05;
  for (const FreeSpace& s : p.spaces) {
    if (s.box.min.z > 0.01) continue;
    front = std::max(front, s.box.max.y);
    key_z = std::max(key_z, s.box.max.z + 0.085);
    in = std::min(in, p.w / 2 - s.box.max.x);
  }
  const double body = p.d / 2 - front;
  p.add(wood, box(sides(-p.w / 2, p.w / 2, front, p.d / 2, 0, p.h - 0.025), 0.006));
  p.add(wood, box(sides(-p.w / 2, p.w / 2, front - 0.012, p.d / 2, p.h - 0.025, p.h), 0.006));
  for (const double s : {-1.0, 1.0}) {
    const double x0 = s > 0 ? p.w / 2 - in : -p.w / 2, x1 = x0 + in;
    p.add(wood, box(sides(x0, x1, -p.d / 2, front, key_z - 0.1, key_z + 0.06), 0.01));
    p.add(wood, box(sides(x0, x1, -p.d / 2 + 0.01, -p.d / 2 + 0.06, 0, key_z - 0.1), 0.006));
    p.add(wood, box(sides(x0, x1, -p.d / 2 + 0.06, front, 0, 0.05), 0.004));
  }
  p.add(wood, box(sides(-p.w / 2 + in, p.w / 2 - in, -p.d / 2 + 0.01, front, key_z - 0.08, key_z - 0.015), 0.004));
  keys(p, -p.w / 2 + in, p.w / 2 - in, -p.d / 2 + 0.02, std::min(0.15, p.d - body - 0.02), key_z + 0.004);
  if (p.h > key_z + 0.2)
    p.add(p.named("paper"), box(sides(-0.2, 0.2, front - 0.01, front - 0.004, key_z + 0.12, std::min(p.h - 0.03, key_z + 0.36)), 0));
  if (p.spaces.empty()) {
    for (const double x : {-0.08, 0.0, 0.08})
      p.add(p.named("brass"), box(sides(x - 0.012, x + 0.012, front - 0.09, front, 0.03, 0.045), 0.003));
  }
}

void grand_piano(Piece& p) {
  const int wood = p.main("ebony");
  const double lid_closed = p.h * 0.98, low = p.h * 0.62, key_z = p.h * 0.72, x = p.w / 2, y = p.d / 2;
  const std::vector<Vec2> outline{{-x, -y + 0.22},     {x, -y + 0.22},        {x, y * 0.1},  {x * 0.82, y * 0.35},  {x * 0.45, y * 0.55},
                                  {x * 0.18, y * 0.8}, {-x * 0.15, y * 0.97}, {-x * 0.5, y}, {-x * 0.85, y * 0.93}, {-x, y * 0.75}};
  p.add(wood, prism(outline, low, lid_closed - 0.03, true));
  p.add(wood, prism(outline, lid_closed - 0.028, p.h, true));
  p.add(wood, box(sides(-x, x, -y, -y + 0.24, low, key_z - 0.02), 0.008));
  for (const double s : {-1.0, 1.0})
    p.add(wood, box(sides(s > 0 ? x - 0.06 : -x, s > 0 ? x : -x + 0.06, -y, -y + 0.24, key_z - 0.03, key_z + 0.06), 0.01));
  keys(p, -x + 0.06, x - 0.06, -y + 0.02, 0.15, key_z);
  for (const Vec2 at : {Vec2{-x * 0.82, -y + 0.3}, Vec2{x * 0.82, -y + 0.3}, Vec2{-x * 0.45, y * 0.7}}) {
    p.add(wood, lathe({{0, 0}, {0.03, 0}, {0.035, 0.05}, {0.05, low * 0.5}, {0.07, low}, {0, low}}, 14), moved(at.x, at.y, 0));
  }
  p.add(p.named("brass"), box(sides(-0.1, 0.1, -y + 0.35, -y + 0.4, 0.03, 0.06), 0.005));
  p.add(wood, box(sides(-0.08, 0.08, -y + 0.38, -y + 0.42, 0.05, low), 0.005));
}

void guitar(Piece& p) {
  const int wood = p.color_asked() ? p.main("lacquer") : p.main("teak"), neck = p.named("walnut"), dark = p.named("black_plastic");
  // Made 1 m high, standing, and fitted: two round bouts, neck, head.
  std::vector<Vec2> outline;
  for (int i = 0; i < 40; ++i) {
    // Half width over height: a wide lower bout, a waist, a narrower upper bout, round at both ends.
    const double a = 2 * kPi * i / 40 - kPi / 2, up = std::sin(a), end = std::pow(std::abs(std::cos(a)), 0.6);
    const double half = up < -0.2   ? 0.19
                        : up < 0.25 ? 0.19 - 0.055 * std::sin((up + 0.2) / 0.45 * kPi / 2)
                                    : 0.135 + 0.02 * std::sin((up - 0.25) / 0.75 * kPi);
    outline.push_back({(std::cos(a) < 0 ? -1 : 1) * end * half, 0.24 + up * 0.24});
  }
  const Pose upright{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}};
  p.add(wood, prism(outline, -0.045, 0.045, true), upright);
  p.add(dark, prism(ellipse({0, 0.3}, {0.05, 0.05}, 24), 0.044, 0.047), upright);
  p.add(neck, box(sides(-0.026, 0.026, -0.062, -0.04, 0.38, 0.88), 0.004));
  p.add(neck, box(sides(-0.04, 0.04, -0.058, -0.04, 0.86, 1.0), 0.006));
  p.add(neck, box(sides(-0.07, 0.07, -0.056, -0.044, 0.12, 0.145), 0.003));
  for (int i = -2; i <= 3; ++i) p.add(p.named("chrome"), box(sides(0.008 * i - 0.005, 0.008 * i - 0.0035, -0.0645, -0.063, 0.13, 0.9), 0));
  for (int i = 0; i < 3; ++i) {
    for (const double s : {-1.0, 1.0})
      p.add(p.named("chrome"), rod({s * 0.038, -0.05, 0.89 + 0.035 * i}, {s * 0.06, -0.05, 0.89 + 0.035 * i}, 0.006, 8));
  }
  if (p.mount() == Mount::kFloor) {
    for (const double s : {-1.0, 1.0}) p.add(dark, tube({{s * 0.12, -0.1, 0.005}, {s * 0.06, 0.06, 0.1}, {0, 0.1, 0.3}}, 0.008, 6));
    p.add(dark, tube({{0, 0.14, 0.005}, {0, 0.1, 0.3}, {0, 0.05, 0.6}}, 0.008, 6));
  }
  p.fit();
}

void drum(Piece& p, Vec center, double radius, double tall, int shell, const Pose& tilt = {}) {
  const Pose pose = moved(center) * tilt;
  p.add(shell, lathe({{0, 0}, {radius, 0}, {radius, tall}, {0, tall}}, 26), pose);
  p.add(p.named("ceramic"), lathe({{0, tall}, {radius * 0.97, tall}, {radius * 0.97, tall + 0.004}, {0, tall + 0.004}}, 26), pose);
  for (const double z : {0.0, tall}) p.add(p.named("chrome"), torus({0, 0, z}, radius, 0.009, 26, 6), pose);
}

void drum_kit(Piece& p) {
  const int shell = p.main_accent("lacquer"), chrome = p.named("chrome"), brass = p.named("brass");
  const Pose forward = turned_x(90);
  drum(p, {0, -0.05, 0.29}, 0.28, 0.4, shell, forward);
  drum(p, {-0.17, -0.2, 0.62}, 0.15, 0.2, shell, turned_x(18));
  drum(p, {0.17, -0.2, 0.62}, 0.16, 0.22, shell, turned_x(18));
  drum(p, {0.55, 0.15, 0.2}, 0.2, 0.36, shell);
  drum(p, {-0.45, 0.2, 0.5}, 0.18, 0.14, shell);
  for (const Vec& foot : {Vec{0.55, 0.15, 0}, Vec{-0.45, 0.2, 0}}) {
    for (int i = 0; i < 3; ++i) {
      const double a = 2 * kPi * i / 3;
      p.add(chrome,
            rod(foot + Vec{std::cos(a) * 0.19, std::sin(a) * 0.19, 0}, foot + Vec{std::cos(a) * 0.1, std::sin(a) * 0.1, 0.5}, 0.008, 6));
    }
  }
  for (const Vec& c : {Vec{-0.65, -0.2, 1.05}, Vec{0.6, -0.3, 1.15}, Vec{-0.72, 0.25, 0.85}}) {
    p.add(chrome, rod({c.x, c.y, 0}, c, 0.01, 8));
    for (int i = 0; i < 3; ++i)
      p.add(chrome, rod({c.x + std::cos(2.1 * i) * 0.16, c.y + std::sin(2.1 * i) * 0.16, 0}, {c.x, c.y, 0.25}, 0.007, 6));
    p.add(brass, lathe({{0, 0}, {0.2, -0.012}, {0.2, -0.008}, {0.05, 0.008}, {0.03, 0.022}, {0, 0.025}}, 26), moved(c) * turned_x(-10));
  }
  p.add(p.named("black_leather"), cylinder({0, 0.5, 0.45}, 0.16, 0.07, 22));
  p.add(chrome, cylinder({0, 0.5, 0.02}, 0.02, 0.44, 10));
  for (int i = 0; i < 3; ++i) p.add(chrome, rod({std::cos(2.1 * i) * 0.18, 0.5 + std::sin(2.1 * i) * 0.18, 0}, {0, 0.5, 0.2}, 0.008, 6));
  p.fit();
}

void music_stand(Piece& p) {
  const int metal = p.frame("black_metal");
  const double desk_tall = std::min(0.34, p.h * 0.28), z = p.h - desk_tall;
  for (int i = 0; i < 3; ++i) {
    const double a = kPi * (0.5 + 2.0 * i / 3);
    p.add(metal, rod({std::cos(a) * p.w * 0.45, std::sin(a) * p.d * 0.45, 0.008}, {0, 0, p.h * 0.25}, 0.008, 8));
  }
  p.add(metal, cylinder({0, 0, p.h * 0.15}, 0.01, z - p.h * 0.1, 10));
  const Pose tilt = moved(0, -p.d * 0.12, z) * turned_x(-18);
  p.add(metal, box(sides(-p.w / 2, p.w / 2, 0, 0.006, 0, desk_tall), 0.002), tilt);
  p.add(metal, box(sides(-p.w / 2, p.w / 2, -0.05, 0.002, 0, 0.008), 0.002), tilt);
  p.add(p.named("paper"), box(sides(-p.w * 0.4, p.w * 0.4, -0.004, 0, 0.01, desk_tall * 0.9), 0), tilt);
  p.fit();
}

}  // namespace

void add_music(Families& to) {
  to["piano"] = piano;
  to["grand_piano"] = grand_piano;
  to["guitar"] = guitar;
  to["drum_kit"] = drum_kit;
  to["music_stand"] = music_stand;
}

}  // namespace layoutbox::kit
