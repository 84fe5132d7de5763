// Clocks on walls and in tall cases, and dart boards.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// A face with marks and hands: x, y across it, z towards the viewer; its back at z = 0.
void clock_face(Piece& p, const Pose& at, double r, double thick) {
  const int face = p.named("paper"), hands = p.named("black_plastic");
  p.add(face, lathe({{0, 0}, {r, 0}, {r, thick}, {0, thick}}, 40), at);
  const auto mark = [&](double half, double from, double to, double low, double high, double turn) {
    p.add(hands, box(sides(-r * half, r * half, r * from, r * to, thick * low, thick * high), 0), at * turned_z(turn));
  };
  for (int i = 0; i < 12; ++i) mark(0.016, i % 3 == 0 ? 0.77 : 0.84, 0.93, 1, 1.4, 30 * i);
  mark(0.028, -0.09, 0.55, 1.5, 1.9, 60);
  mark(0.02, -0.11, 0.8, 2, 2.4, -60);
}

// Looks to −y: x stays, up is z.
Pose upright(Vec at, double tall) { return moved(at) * Pose{{1, 0, 0}, {0, 0, tall}, {0, -1, 0}, {}}; }

// Foot, waist with a glass door before the pendulum, hood with the face.
void longcase_clock(Piece& p) {
  const int wood = p.main("walnut"), brass = p.named("brass");
  const double x = p.w / 2, y = p.d / 2, foot = p.h * 0.24, hood = p.h * 0.68, gable = p.h * 0.93, waist = x * 0.7,
               t = std::min(0.03, x * 0.12);
  const double front = -y * 0.72;
  p.add(wood, box(sides(-x, x, -y, y, 0, foot * 0.16), 0.006));
  p.add(wood, box(sides(-x * 0.93, x * 0.93, -y * 0.93, y, foot * 0.16, foot * 0.9), 0.006));
  p.add(wood, box(sides(-x, x, -y, y, foot * 0.9, foot), 0.006));
  for (const double s : {-1.0, 1.0})
    p.add(wood, box(sides(s > 0 ? waist - t : -waist, s > 0 ? waist : -waist + t, front, y, foot, hood), 0.004));
  p.add(wood, box(sides(-waist + t, waist - t, y - 0.02, y, foot, hood), 0));
  for (const auto& [z0, z1] : {std::pair{foot, foot + 0.06}, {hood - 0.06, hood}})
    p.add(wood, box(sides(-waist + t, waist - t, front, front + 0.025, z0, z1), 0.003));
  const double swing = foot + (hood - foot) * 0.32, bob = std::min(0.07, waist * 0.42);
  p.add(brass, rod({0, 0, swing}, {0, 0, hood - 0.02}, 0.006, 8));
  p.add(brass, lathe({{0, 0}, {bob, 0}, {bob * 0.9, 0.012}, {0, 0.018}}, 26), upright({0, 0.004, swing}, 1));
  for (const double s : {-1.0, 1.0}) {
    p.add(brass, rod({s * waist * 0.5, 0.02, hood * 0.78}, {s * waist * 0.5, 0.02, hood * 0.9}, 0.02, 14));
    p.add(brass, rod({s * waist * 0.5, 0.02, hood * 0.9}, {s * waist * 0.5, 0.02, hood - 0.01}, 0.003, 6));
  }
  p.add(wood, box(sides(-x, x, -y, y, hood, hood + 0.035), 0.006));
  p.add(wood, box(sides(-x * 0.9, x * 0.9, -y * 0.86, y, hood + 0.035, gable - 0.03), 0.006));
  p.add(wood, box(sides(-x, x, -y, y, gable - 0.03, gable), 0.006));
  const double r = std::min(x * 0.78, (gable - hood - 0.065) * 0.44), middle = (hood + gable) / 2;
  const Pose face = upright({0, -y * 0.86, middle}, 1);
  p.add(brass, lathe({{r * 0.96, 0}, {r * 1.08, 0}, {r * 1.08, 0.012}, {r * 0.96, 0.012}, {r * 0.96, 0}}, 40), face);
  clock_face(p, face, r, 0.005);
  // A swan-necked top: an arch between two low shoulders.
  std::vector<Vec2> arch{{-x * 0.9, gable - 0.002}, {x * 0.9, gable - 0.002}};
  for (int i = 0; i <= 16; ++i) {
    const double u = 1 - i / 8.0;
    arch.push_back({u * x * 0.9, gable + (p.h - gable) * (0.25 + 0.75 * std::pow(std::cos(u * kPi / 2), 1.5))});
  }
  p.add(wood, prism(arch, -0.02, 0.02), upright({0, -y * 0.8, 0}, 1));
}

void clock(Piece& p) {
  if (p.word("kind", "") == "grandfather") return longcase_clock(p);
  const int rim = p.main("black_metal");
  const double r = p.w / 2, y = p.d * 0.75;
  const Pose at = upright({0, p.d / 2, p.h / 2}, p.h / p.w);
  p.add(rim, lathe({{0, 0}, {r, 0}, {r, p.d}, {r * 0.9, p.d}, {r * 0.9, y - 0.002}, {0, y - 0.002}}, 40), at);
  clock_face(p, at * moved(0, 0, y - 0.003), r * 0.9, std::min(0.003 + p.d * 0.02, p.d * 0.09));
}

// Twenty sectors, in each a narrow ring outside and half way, and the bull's eye.
void dart_board(Piece& p) {
  const double r = p.w / 2, face = p.d * 0.8;
  const Pose at = upright({0, p.d / 2, p.h / 2}, p.h / p.w);
  p.add(p.named("black_plastic"), lathe({{0, 0}, {r, 0}, {r, face}, {r * 0.98, p.d}, {r * 0.955, p.d}, {r * 0.94, face}, {0, face}}, 60),
        at);
  const int dark = p.tinted("wool", {0.10, 0.10, 0.10}), pale = p.tinted("wool", {0.90, 0.84, 0.70}),
            red = p.tinted("wool", {0.74, 0.16, 0.15}), green = p.tinted("wool", {0.10, 0.44, 0.25});
  const auto sector = [&](int i, double from, double to, int surface) {
    const double a = kPi / 10 * (i - 0.5), b = kPi / 10 * (i + 0.5), m = (a + b) / 2;
    const auto on = [&](double angle, double k) { return Vec2{r * k * std::cos(angle), r * k * std::sin(angle)}; };
    p.add(surface, prism({on(a, from), on(a, to), on(m, to), on(b, to), on(b, from), on(m, from)}, face - 0.001, face + p.d * 0.06), at);
  };
  for (int i = 0; i < 20; ++i) {
    const bool even = i % 2 == 0;
    for (const auto& [from, to] : {std::pair{0.075, 0.43}, {0.475, 0.73}}) sector(i, from, to, even ? dark : pale);
    for (const auto& [from, to] : {std::pair{0.43, 0.475}, {0.73, 0.775}}) sector(i, from, to, even ? red : green);
    p.add(p.named("paper"), box(sides(-r * 0.02, r * 0.02, r * 0.83, r * 0.9, face - 0.001, face + 0.001), 0), at * turned_z(18 * i));
  }
  p.add(green, lathe({{0, face}, {r * 0.075, face}, {r * 0.075, face + p.d * 0.06}, {0, face + p.d * 0.06}}, 20), at);
  p.add(red, lathe({{0, face}, {r * 0.035, face}, {r * 0.035, face + p.d * 0.09}, {0, face + p.d * 0.09}}, 16), at);
}

}  // namespace

void add_clocks(Families& to) {
  to["clock"] = clock;
  to["dart_board"] = dart_board;
}

}  // namespace layoutbox::kit
