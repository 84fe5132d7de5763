// Game tables, and what clinics need.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// Game tables play along their longer side; they are made with it along x and turned where it is y.
struct LongSide {
  double a, b;  // half lengths along and across
  Pose turn;
};
LongSide along(const Piece& p) { return p.w >= p.d ? LongSide{p.w / 2, p.d / 2, {}} : LongSide{p.d / 2, p.w / 2, turned_z(90)}; }

void pool_table(Piece& p) {
  const auto [a, b, turn] = along(p);
  const int wood = p.frame("mahogany"), cloth = p.color_asked() ? p.main("wool") : p.tinted("wool", {0.14, 0.42, 0.30}),
            dark = p.named("black_plastic");
  const double rim = std::min(0.12, b * 0.2), bed = p.h - 0.06;
  p.add(cloth, box(sides(-a + rim * 0.7, a - rim * 0.7, -b + rim * 0.7, b - rim * 0.7, bed - 0.05, bed), 0), turn);
  p.add(wood, box(sides(-a, a, -b, -b + rim, p.h - 0.16, p.h), 0.012), turn);
  p.add(wood, box(sides(-a, a, b - rim, b, p.h - 0.16, p.h), 0.012), turn);
  p.add(wood, box(sides(-a, -a + rim, -b + rim, b - rim, p.h - 0.16, p.h), 0.012), turn);
  p.add(wood, box(sides(a - rim, a, -b + rim, b - rim, p.h - 0.16, p.h), 0.012), turn);
  p.add(wood, box(sides(-a + 0.06, a - 0.06, -b + 0.06, b - 0.06, p.h - 0.25, p.h - 0.12), 0.01), turn);
  for (const double x : {-1.0, 0.0, 1.0}) {
    for (const double y : {-1.0, 1.0})
      p.add(dark, cylinder({x * (a - rim), y * (b - rim * (x == 0 ? 0.8 : 1)), p.h - 0.03}, 0.055, 0.03, 18), turn);
  }
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0})
      p.add(wood, taper({x * (a - 0.1), y * (b - 0.1), 0}, {0.05, 0.05}, {x * (a - 0.085), y * (b - 0.085), p.h - 0.24}, {0.065, 0.065}),
            turn);
  }
  static constexpr Color kBalls[] = {{0.90, 0.76, 0.2}, {0.2, 0.3, 0.66}, {0.8, 0.2, 0.18},
                                     {0.4, 0.2, 0.5},   {0.9, 0.5, 0.15}, {0.12, 0.4, 0.25}};
  int n = 0;
  for (int row = 0; row < 4; ++row) {
    for (int i = 0; i <= row; ++i)
      p.add(p.tinted("ceramic", kBalls[n++ % 6]),
            ellipsoid({a * 0.35 + 0.05 * row, (i - row / 2.0) * 0.058, bed + 0.028}, {0.028, 0.028, 0.028}, 10, 6), turn);
  }
  p.add(p.named("ceramic"), ellipsoid({-a * 0.45, 0.03, bed + 0.028}, {0.028, 0.028, 0.028}, 10, 6), turn);
}

void ping_pong_table(Piece& p) {
  const auto [a, b, turn] = along(p);
  const int top = p.color_asked() ? p.main("lacquer") : p.tinted("lacquer", {0.16, 0.36, 0.56}), white = p.named("plastic"),
            dark = p.named("black_metal");
  const double net = std::min(0.15, p.h * 0.17), level = p.h - net;
  p.add(top,
        box(sides(-a, a, -b + (b > 0.7 ? 0.02 : 0), b - (b > 0.7 ? 0.02 : 0),
                  level - (p.clear_below(0) > 0 ? std::min(0.03, level - p.clear_below(0)) : 0.03), level - 0.001),
            0.003),
        turn);
  for (const double y : {-b + 0.03, 0.0, b - 0.03})
    p.add(white, box(sides(-a + 0.002, a - 0.002, y - 0.01, y + 0.01, level - 0.002, level), 0), turn);
  for (const double x : {-a + 0.014, a - 0.014})
    p.add(white, box(sides(x - 0.01, x + 0.01, -b + 0.045, b - 0.045, level - 0.002, level), 0), turn);
  p.add(p.tinted("mesh", {0.85, 0.86, 0.86}), box(sides(-0.003, 0.003, -b, b, level, p.h - 0.012), 0), turn);
  p.add(white, box(sides(-0.005, 0.005, -b, b, p.h - 0.014, p.h), 0.001), turn);
  double along_room = 0.05;
  for (const FreeSpace& s : p.spaces) along_room = std::min(along_room, a - 0.02 - (p.w >= p.d ? s.box.max.x : s.box.max.y));
  for (const double x : {-0.62, 0.62}) {
    const double s = x > 0 ? 1 : -1, room = std::clamp(along_room, 0.02, 0.05), c = s * (a - 0.02 - room / 2);
    for (const double y : {-0.9, 0.9})
      p.add(dark, box(sides(c - room / 2, c + room / 2, y * b - 0.025, y * b + 0.025, 0, level - 0.02), 0.004), turn);
    p.add(dark, box(sides(c - room * 0.4, c + room * 0.4, -0.9 * b, 0.9 * b, level * 0.3, level * 0.3 + 0.04), 0.004), turn);
  }
}

void foosball_table(Piece& p) {
  const auto [a, b, turn] = along(p);
  const int wood = p.main("oak"), pitch = p.tinted("wool", {0.22, 0.52, 0.32}), chrome = p.named("chrome"), dark = p.named("black_plastic");
  const double grip = std::min(0.14, b * 0.28), body = b - grip, z0 = p.h * 0.68, t = 0.03;
  p.add(wood, box(sides(-a, a, -body, -body + t, z0, p.h), 0.005), turn);
  p.add(wood, box(sides(-a, a, body - t, body, z0, p.h), 0.005), turn);
  p.add(wood, box(sides(-a, -a + t, -body + t, body - t, z0, p.h), 0.005), turn);
  p.add(wood, box(sides(a - t, a, -body + t, body - t, z0, p.h), 0.005), turn);
  p.add(pitch, box(sides(-a + t, a - t, -body + t, body - t, z0, z0 + 0.03), 0), turn);
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0})
      p.add(
          wood,
          box(sides(x * (a - 0.05) - 0.04, x * (a - 0.05) + 0.04, y * (body - 0.05) - 0.04, y * (body - 0.05) + 0.04, 0, z0 + 0.01), 0.005),
          turn);
  }
  for (int i = 0; i < 8; ++i) {
    const double x = -a + 2 * a * (i + 0.5) / 8, z = p.h - 0.06, side = i % 2 == 0 ? -1.0 : 1.0;
    p.add(chrome, rod({x, -side * (body + 0.03), z}, {x, side * (b - 0.11 * (grip / 0.14)), z}, 0.008, 8), turn);
    p.add(dark, rod({x, side * (b - 0.11 * (grip / 0.14)), z}, {x, side * b, z}, 0.016, 10), turn);
    const int team = p.tinted("plastic", i % 2 == 0 ? Color{0.80, 0.25, 0.22} : Color{0.24, 0.40, 0.70}), men = i == 0 || i == 7   ? 1
                                                                                                                : i == 1 || i == 6 ? 2
                                                                                                                                   : 3;
    for (int k = 0; k < men; ++k) {
      const double y = (k - (men - 1) / 2.0) * body * 0.5;
      p.add(team, box(sides(x - 0.012, x + 0.012, y - 0.015, y + 0.015, z - 0.09, z + 0.03), 0.005), turn);
    }
  }
}

// A bed on wheels with a raised head end, rails and a mattress.
void hospital_bed(Piece& p) {
  const int frame = p.frame("painted_metal"), mattress = p.named("cotton"),
            blanket = p.color_asked() ? p.main("cotton") : p.tinted("cotton", {0.62, 0.78, 0.84}), dark = p.named("black_plastic");
  const FreeSpace* open = p.open_above();
  const double level = open != nullptr ? open->box.min.z : std::min(0.6, p.h * 0.65), under = std::max(p.clear_below(0), level - 0.28),
               head = open != nullptr ? open->box.max.y : p.d / 2 - 0.05;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const double cx = x * (p.w / 2 - 0.03), cy = y * (p.d / 2 - 0.06);
      p.add(frame, box(sides(cx - 0.02, cx + 0.02, cy - 0.02, cy + 0.02, 0.09, under + 0.02), 0.004));
      p.add(dark, rod({cx - 0.014, cy, 0.05}, {cx + 0.014, cy, 0.05}, 0.05, 14));
    }
  }
  p.add(frame, box(sides(-p.w / 2, p.w / 2, -p.d / 2 + 0.01, p.d / 2 - 0.01, under, under + 0.07), 0.008));
  p.add(mattress,
        rounded_box(sides(-p.w / 2 + 0.03, p.w / 2 - 0.03, -p.d / 2 + 0.04, std::min(head, p.d / 2 - 0.03), under + 0.07, level - 0.03),
                    0.03, 3));
  p.add(blanket, rounded_box(sides(-p.w / 2 + 0.02, p.w / 2 - 0.02, -p.d / 2 + 0.04, head - 0.62, level - 0.1, level), 0.025, 3));
  p.add(mattress, pillow(sides(-p.w * 0.32, p.w * 0.32, head - 0.5, head - 0.06, level - 0.07, level), 8));
  const int board = p.named("plastic"), rail = p.named("steel");
  p.add(board, rounded_box(sides(-p.w / 2 + 0.02, p.w / 2 - 0.02, std::max(head, p.d / 2 - 0.04), p.d / 2, under, p.h), 0.015, 3));
  p.add(board, rounded_box(sides(-p.w / 2 + 0.02, p.w / 2 - 0.02, -p.d / 2, -p.d / 2 + 0.035, under, level + 0.12), 0.015, 3));
  // Side rails beside the mattress, where it leaves room for them: what tells it from a bed at home.
  const double from = -p.d * 0.1, to = head - 0.12, rise = std::min(0.3, p.h - level - 0.03);
  if (open == nullptr || p.w / 2 - open->box.max.x < 0.04) return;
  for (const double x : {-p.w / 2 + 0.015, p.w / 2 - 0.015}) {
    for (const double share : {0.4, 0.7, 1.0}) p.add(rail, rod({x, from, level + rise * share}, {x, to, level + rise * share}, 0.012, 8));
    for (const double y : {from, (from + to) / 2, to}) p.add(rail, rod({x, y, under + 0.03}, {x, y, level + rise}, 0.012, 8));
  }
}

void exam_table(Piece& p) {
  const int pad = p.main("leather"), body = p.frame("painted_metal"), paper = p.named("paper");
  const FreeSpace* open = p.open_above();
  const double level = open != nullptr ? open->box.min.z : p.h, foot = std::min(0.1, level * 0.12);
  if (p.clear_below(0) > 0) {
    p.legs(p.frame("oak"), level - 0.1, 0.045, 0);
  } else {
    p.add(body, box(sides(-p.w / 2 + 0.05, p.w / 2 - 0.05, -p.d / 2 + 0.1, p.d / 2 - 0.1, foot, level - 0.1), 0.008));
    p.add(p.named("black_plastic"), box(sides(-p.w / 2 + 0.08, p.w / 2 - 0.08, -p.d / 2 + 0.14, p.d / 2 - 0.14, 0, foot), 0.002));
  }
  // The pad in two parts, one for the head; a strip of paper over it, or where one lies face down, a hole for the face.
  const double neck = p.d / 2 - p.d * 0.27;
  p.add(pad, rounded_box(sides(-p.w / 2, p.w / 2, -p.d / 2, neck - 0.008, level - 0.1, level - 0.003), 0.03, 3));
  p.add(pad, rounded_box(sides(-p.w / 2, p.w / 2, neck + 0.008, p.d / 2, level - 0.1, level - 0.003), 0.03, 3));
  p.add(body, box(sides(-p.w / 2 + 0.04, p.w / 2 - 0.04, neck - 0.02, neck + 0.02, level - 0.09, level - 0.03), 0));
  if (p.says("massage"))
    p.add(p.named("black_plastic"), lathe({{0, level - 0.01}, {0.1, level - 0.01}, {0.1, level}, {0, level}}, 20),
          moved(0, neck + p.d * 0.14, 0) * scaled(0.8, 1, 1));
  else
    p.add(paper, box(sides(-p.w * 0.27, p.w * 0.27, -p.d / 2 + 0.02, p.d / 2 - 0.03, level - 0.006, level), 0));
  if (p.h > level + 0.01)
    p.add(pad,
          rounded_box(sides(-p.w / 2 + 0.02, p.w / 2 - 0.02, open != nullptr ? open->box.max.y : p.d / 2 - 0.3, p.d / 2, level - 0.05, p.h),
                      0.03, 3));
}

void wheelchair(Piece& p) {
  const int seat = p.main("black_leather"), metal = p.frame("chrome"), dark = p.named("black_plastic");
  const double r = 0.3, half = 0.3;
  for (const double s : {-1.0, 1.0}) {
    p.add(dark, torus({0, 0, 0}, r - 0.018, 0.018, 30, 6), aimed({s * half, 0.18, r}, {1, 0, 0}));
    p.add(metal, torus({0, 0, 0}, r * 0.82, 0.008, 28, 5), aimed({s * (half + 0.03), 0.18, r}, {1, 0, 0}));
    for (int i = 0; i < 6; ++i) {
      const double a = kPi * i / 6;
      p.add(metal, rod({s * half, 0.18 + std::cos(a) * (r - 0.02), r + std::sin(a) * (r - 0.02)},
                       {s * half, 0.18 - std::cos(a) * (r - 0.02), r - std::sin(a) * (r - 0.02)}, 0.003, 4));
    }
    p.add(dark, rod({s * 0.22 - 0.015, -0.32, 0.08}, {s * 0.22 + 0.015, -0.32, 0.08}, 0.08, 16));
    p.add(metal, tube(curve({{s * 0.24, 0.42, 0.92}, {s * 0.24, 0.33, 0.9}, {s * 0.24, 0.3, 0.5}, {s * 0.24, 0.24, 0.2}}, 4), 0.013, 8));
    p.add(metal, tube({{s * 0.25, 0.26, 0.45}, {s * 0.25, -0.28, 0.45}, {s * 0.2, -0.42, 0.12}}, 0.013, 8));
    p.add(dark, rounded_box(sides(s * 0.265 - 0.02, s * 0.265 + 0.02, -0.2, 0.2, 0.68, 0.71), 0.01, 2));
    p.add(metal, rod({s * 0.25, -0.15, 0.46}, {s * 0.25, -0.15, 0.68}, 0.01, 8));
    p.add(dark, box(sides(s * 0.11 - 0.08, s * 0.11 + 0.08, -0.5, -0.38, 0.1, 0.12), 0.004));
  }
  p.add(seat, cushion(sides(-0.22, 0.22, -0.24, 0.28, 0.46, 0.515), 0.02));
  p.add(seat, rounded_box(sides(-0.21, 0.21, 0.29, 0.33, 0.53, 0.88), 0.015, 2));
  p.fit();
}

}  // namespace

void add_games_and_clinic(Families& to) {
  to["pool_table"] = pool_table;
  to["ping_pong_table"] = ping_pong_table;
  to["foosball_table"] = foosball_table;
  to["hospital_bed"] = hospital_bed;
  to["exam_table"] = exam_table;
  to["wheelchair"] = wheelchair;
}

}  // namespace layoutbox::kit
