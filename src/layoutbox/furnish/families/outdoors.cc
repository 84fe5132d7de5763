// Sports gear, signs, umbrellas and other things that came in from outside; and what did not fit elsewhere.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

void cone_family(Piece& p) {
  const int orange = p.main("plastic"), white = p.named("plastic");
  const double base = std::min(0.04, p.h * 0.06), r = std::min(p.w, p.d) * 0.4;
  p.add(orange, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, base), 0.008));
  const auto ring = [&](double a, double b, double more) {
    const auto at = [&](double t) { return r * (1 - 0.86 * t) + more; };
    return cone({0, 0, base + (p.h - base) * a}, at(a), at(b), (p.h - base) * (b - a), 28);
  };
  p.add(orange, ring(0, 1, 0));
  p.add(white, ring(0.3, 0.45, 0.002));
  p.add(white, ring(0.62, 0.75, 0.002));
}

// A board with round ends, standing upright.
void surfboard(Piece& p) {
  const int body = p.main_accent("plastic"), line = p.named("plastic");
  std::vector<Vec2> outline;
  for (int i = 0; i < 32; ++i) {
    const double t = i / 32.0 * 2 * kPi, y = std::sin(t), narrow = y > 0 ? 1 - 0.35 * y * y : 1;
    outline.push_back({std::cos(t) * narrow * 0.5, y * 0.5 + 0.5});
  }
  const Pose up{{p.w, 0, 0}, {0, 0, p.h}, {0, -p.d, 0}, {0, 0, 0}};
  p.add(body, prism(outline, -0.35, 0.35, true), up);
  std::vector<Vec2> stripe{{-0.06, 0.04}, {0.06, 0.04}, {0.06, 0.96}, {-0.06, 0.96}};
  p.add(line, prism(stripe, 0.3, 0.4), up);
  p.add(p.named("black_plastic"), prism({{-0.05, 0.06}, {0.05, 0.06}, {0.02, 0.18}}, -0.6, -0.3), up);
  p.fit();
}

void skis(Piece& p) {
  const int paint = p.main_accent("plastic"), dark = p.named("black_plastic"), steel = p.named("steel");
  for (const double s : {-1.0, 1.0}) {
    p.add(paint, box(sides(s * 0.25 - 0.17, s * 0.25 + 0.17, -0.05, 0.05, 0, 0.94), 0.01));
    p.add(paint, beam({s * 0.25, 0, 0.93}, {s * 0.25, -0.3, 1.0}, {0.3, 0.04}));
    p.add(dark, box(sides(s * 0.25 - 0.13, s * 0.25 + 0.13, -0.3, 0.02, 0.36, 0.5), 0.02));
    p.add(steel, rod({s * 0.47, 0.1, 0}, {s * 0.46, 0.1, 0.68}, 0.022, 8));
  }
  p.fit();
}

void basketball_hoop(Piece& p) {
  const int board = p.named("frosted_glass"), red = p.tinted("painted_metal", {0.82, 0.28, 0.16}), white = p.named("cotton"),
            dark = p.frame("black_metal");
  const double x = p.w / 2, y = p.d / 2, thick = 0.03, low = p.h > 1.6 ? p.h - std::min(1.0, p.h * 0.35) : 0,
               r = std::min({0.23, x * 0.5, (p.d - thick) * 0.45});
  p.add(board, box(sides(-x, x, y - thick - (low > 0 ? 0.1 : 0), y - (low > 0 ? 0.1 : 0), low, p.h), 0.004));
  const double face = y - thick - (low > 0 ? 0.1 : 0), ring = low + (p.h - low) * 0.25;
  for (const auto& [z0, z1, half] : {std::tuple{0.28, 0.3, 0.3}, {0.62, 0.64, 0.3}})
    p.add(red, box(sides(-x * half, x * half, face - 0.002, face + 0.004, low + (p.h - low) * z0, low + (p.h - low) * z1), 0));
  for (const double s : {-0.3, 0.28})
    p.add(red, box(sides(x * s, x * s + 0.02, face - 0.002, face + 0.004, low + (p.h - low) * 0.28, low + (p.h - low) * 0.64), 0));
  p.add(red, torus({0, face - r - 0.02, ring}, r, 0.012, 26, 8));
  p.add(red, box(sides(-0.05, 0.05, face - 0.05, face, ring - 0.03, ring + 0.01), 0.003));
  for (int i = 0; i < 10; ++i) {
    const double a = 2 * kPi * i / 10, b = a + 0.5;
    const Vec c{0, face - r - 0.02, 0};
    p.add(white, rod({c.x + r * std::cos(a), c.y + r * std::sin(a), ring},
                     {c.x + r * 0.62 * std::cos(b), c.y + r * 0.62 * std::sin(b), ring - r * 1.5}, 0.005, 6));
  }
  if (low > 0) {
    p.add(dark, box(sides(-0.06, 0.06, y - 0.12, y, 0.04, p.h * 0.96), 0.006));
    p.add(dark, box(sides(-x * 0.7, x * 0.7, -y, y, 0, 0.1), 0.02));
  }
  p.fit();
}

// A plate with writing: signs, name plates. "neon": glowing tubes on a dark plate.
void sign(Piece& p) {
  const bool neon = p.category() == "neon_sign" || p.says("neon");
  const double x = p.w / 2, y = p.d / 2;
  const int plate = neon ? p.named("black_plastic") : p.main_accent("painted_metal"),
            writing = neon ? p.named("ember") : p.named("plastic");
  p.add(plate, rounded_box(sides(-x, x, -y + p.d * 0.3, y, 0, p.h), std::min({0.02, p.d * 0.3, p.h * 0.2}), 3));
  const int lines = p.h > p.w * 0.55 ? 3 : 2;
  for (int i = 0; i < lines; ++i) {
    const double z = p.h * (1 - (i + 0.75) / (lines + 0.5)), half = x * (i == 0 ? 0.7 : 0.5), thick = p.h * 0.09;
    if (neon) {
      std::vector<Vec> path;
      for (int k = 0; k <= 12; ++k) path.push_back({-half + 2 * half * k / 12, -y + p.d * 0.15, z + thick * 0.7 * (k % 2 == 0 ? 1 : -1)});
      p.add(writing, tube(curve(path, 3), std::min(0.008, p.h * 0.03), 6));
    } else {
      p.add(writing, box(sides(-half, half, -y + p.d * 0.2, y * 0.5, z - thick / 2, z + thick / 2), 0));
    }
  }
  p.fit();
}

void ironing_board(Piece& p) {
  const int cloth = p.main_accent("cotton"), metal = p.frame("painted_metal");
  const double x = p.w / 2, y = p.d / 2, top = std::min(0.05, p.h * 0.07);
  std::vector<Vec2> outline;
  for (int i = 0; i <= 12; ++i) {  // one end narrow and round
    const double a = -kPi / 2 + kPi * i / 12;
    outline.push_back({x - y + y * std::cos(a), y * std::sin(a)});
  }
  outline.push_back({-x, y});
  outline.push_back({-x, -y});
  p.add(cloth, prism(outline, p.h - top, p.h));
  // Two frames of legs cross, in the strips that the room below leaves at the front and at the back.
  double strip = y;
  for (const FreeSpace& s : p.spaces) strip = std::min({strip, y + s.box.min.y, y - s.box.max.y});
  const double r = std::min(0.012, strip * 0.4), ly = y - r * 1.05, high = p.h - top;
  for (const double s : {-1.0, 1.0}) {
    p.add(metal, rod({-x * 0.62, s * ly, r}, {x * 0.5, s * ly, high}, r, 10));
    p.add(metal, rod({x * 0.62, s * ly, r}, {-x * 0.5, s * ly, high}, r * 0.9, 10));
    for (const double k : {-1.0, 1.0})
      p.add(p.named("black_plastic"), rod({k * x * 0.62 - 0.03, s * ly, r}, {k * x * 0.62 + 0.03, s * ly, r}, r, 10));
  }
}

// Rolled up, standing on its point.
void umbrella(Piece& p) {
  const int cloth = p.main_accent("cotton"), wood = p.frame("walnut"), steel = p.named("steel");
  p.add(steel, cylinder({0, 0, 0}, 0.03, 0.12, 10));
  p.add(cloth, lathe({{0, 0.08}, {0.05, 0.08}, {0.22, 0.42}, {0.26, 0.62}, {0.12, 0.72}, {0, 0.72}}, 9));
  p.add(steel, cylinder({0, 0, 0.7}, 0.025, 0.14, 10));
  p.add(wood, tube(curve({{0, 0, 0.82}, {0, 0, 0.95}, {0.12, 0, 1.0}, {0.22, 0, 0.94}, {0.22, 0, 0.87}}, 4), 0.035, 8));
  p.fit();
}

// Four posts, bars across and a loaded barbell.
void squat_rack(Piece& p) {
  const int steel = p.main("black_metal"), chrome = p.named("chrome"), rubber = p.named("black_plastic");
  const double x = p.w / 2, y = p.d / 2, t = std::min(0.07, p.w * 0.06), in = std::min(x * 0.62, 0.55);
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0})
      p.add(steel, box(sides(sx * in - t / 2, sx * in + t / 2, sy > 0 ? y - t : -y, sy > 0 ? y : -y + t, 0, p.h), 0.004));
    for (const double z : {0.02, p.h * 0.5, p.h - t})
      p.add(steel, box(sides(sx * in - t / 2, sx * in + t / 2, -y + t * 0.5, y - t * 0.5, z, z + t), 0.004));
  }
  for (const double s : {-1.0, 1.0}) p.add(steel, box(sides(-in, in, s > 0 ? y - t : -y, s > 0 ? y : -y + t, p.h - t, p.h), 0.004));
  const double z = p.h * 0.62, cy = -y + t * 1.6;
  p.add(chrome, rod({-x, cy, z}, {x, cy, z}, 0.016, 12));
  for (const double s : {-1.0, 1.0}) {
    for (const auto& [at, r] : {std::pair{0.84, 0.2}, {0.76, 0.15}}) {
      const double r_in = std::min(r, y - t * 1.0);
      p.add(rubber, rod({s * x * at - 0.02, cy + std::max(0.0, r_in - t * 1.6), z},
                        {s * x * at + 0.02, cy + std::max(0.0, r_in - t * 1.6), z}, r_in, 24));
    }
  }
  p.fit();
}

void iv_stand(Piece& p) {
  const int steel = p.main("chrome"), dark = p.named("black_plastic");
  const double r = std::min(p.w, p.d) / 2;
  for (int i = 0; i < 5; ++i) {
    const double a = kPi * (0.5 + 0.4 * i), x = std::cos(a) * (r - 0.02), y = std::sin(a) * (r - 0.02);
    p.add(steel, beam({0, 0, 0.09}, {x, y, 0.06}, {0.03, 0.02}, 0.004));
    p.add(dark, ellipsoid({x, y, 0.025}, {0.02, 0.02, 0.025}, 10, 6));
  }
  p.add(steel, cylinder({0, 0, 0.06}, 0.012, p.h - 0.08, 12));
  for (const double s : {-1.0, 1.0})
    p.add(steel, tube(curve({{0, 0, p.h - 0.04}, {s * r * 0.5, 0, p.h - 0.02}, {s * r * 0.62, 0, p.h - 0.05}}, 4), 0.006, 6));
  p.add(p.named("frosted_glass"), rounded_box(sides(r * 0.62 - 0.05, r * 0.62 + 0.05, -0.02, 0.02, p.h - 0.32, p.h - 0.06), 0.015, 3));
  p.add(p.named("plastic"), rod({r * 0.62, 0, p.h - 0.33}, {0.02, -0.02, p.h * 0.45}, 0.004, 6));
  p.add(dark, box(sides(-0.06, 0.06, -0.07, 0.02, p.h * 0.45, p.h * 0.58), 0.008));
  p.add(p.named("lit_screen"), box(sides(-0.04, 0.04, -0.072, -0.06, p.h * 0.5, p.h * 0.56), 0));
  p.fit();
}

void skateboard(Piece& p) {
  const int deck = p.main_accent("lacquer"), dark = p.named("black_plastic"), wheel = p.named("plastic"), steel = p.named("steel");
  const Pose turn = p.w >= p.d ? Pose{} : turned_z(90);
  p.add(deck, prism(rounded_rectangle({-0.34, -0.13}, {0.34, 0.13}, 0.1, 6), 0.1, 0.13, true), turn);
  p.add(dark, prism(rounded_rectangle({-0.34, -0.125}, {0.34, 0.125}, 0.1, 6), 0.13, 0.134, true), turn);
  for (const double s : {-1.0, 1.0}) {
    p.add(deck, beam({s * 0.32, 0, 0.115}, {s * 0.5, 0, 0.17}, {0.24, 0.03}, 0.01), turn);
    p.add(steel, rod({s * 0.25, -0.1, 0.05}, {s * 0.25, 0.1, 0.05}, 0.015, 8), turn);
    p.add(steel, box(sides(s * 0.25 - 0.04, s * 0.25 + 0.04, -0.04, 0.04, 0.05, 0.1), 0.004), turn);
    for (const double y : {-1.0, 1.0}) p.add(wheel, rod({s * 0.25, y * 0.08, 0.045}, {s * 0.25, y * 0.13, 0.045}, 0.045, 18), turn);
  }
  p.fit();
}

void rocking_horse(Piece& p) {
  const int wood = p.frame("oak"), body = p.main_accent("lacquer"), mane = p.tinted("wool", {0.36, 0.25, 0.17}),
            dark = p.named("black_plastic");
  const Pose turn = p.w >= p.d ? Pose{} : turned_z(90);
  const auto add = [&](int s, const Mesh& m) { p.add(s, m, turn); };
  for (const double y : {-0.17, 0.17}) {
    add(wood, tube(curve({{-0.5, y, 0.14}, {-0.25, y, 0.035}, {0, y, 0.02}, {0.25, y, 0.035}, {0.5, y, 0.14}}, 5), 0.025, 8));
    for (const double x : {-0.22, 0.2}) add(wood, beam({x * 1.3, y, 0.05}, {x, y * 0.5, 0.4}, {0.06, 0.05}, 0.01));
  }
  add(body, ellipsoid({0, 0, 0.46}, {0.3, 0.13, 0.14}, 18, 10));
  add(body, beam({-0.2, 0, 0.48}, {-0.36, 0, 0.78}, {0.13, 0.14}, 0.03));
  add(body, ellipsoid({-0.43, 0, 0.78}, {0.15, 0.07, 0.085}, 14, 8));
  add(mane, beam({-0.16, 0, 0.58}, {-0.3, 0, 0.88}, {0.04, 0.07}, 0.01));
  add(mane, tube(curve({{0.28, 0, 0.52}, {0.42, 0, 0.5}, {0.46, 0, 0.3}}, 4), 0.035, 8));
  add(wood, rod({-0.34, -0.15, 0.72}, {-0.34, 0.15, 0.72}, 0.018, 10));
  for (const double y : {-0.06, 0.06}) add(dark, ellipsoid({-0.46, y, 0.81}, {0.016, 0.012, 0.016}, 8, 4));
  add(p.named("leather"), box(sides(-0.06, 0.2, -0.12, 0.12, 0.56, 0.62), 0.02));
  p.fit();
}

// A car to sit in: body, glass house, wheels; drives along its longer side.
void car(Piece& p) {
  const int paint = p.color_asked() ? p.main("painted_metal") : p.tinted("painted_metal", {0.60, 0.14, 0.14}), glass = p.named("screen"),
            tyre = p.named("black_plastic"), chrome = p.named("chrome");
  const Pose turn = p.w >= p.d ? Pose{} : turned_z(90);
  const auto add = [&](int s, const Mesh& m) { p.add(s, m, turn); };
  if (p.says("pickup") || p.says("truck")) {  // a cab, and behind it a bed between walls
    add(paint, rounded_box(sides(-2.1, 0.5, -0.85, 0.85, 0.34, 0.98), 0.1, 3));
    add(glass, taper({-0.25, 0, 0.96}, {0.75, 0.76}, {-0.2, 0, 1.5}, {0.55, 0.64}));
    add(paint, rounded_box(sides(-0.78, 0.38, -0.66, 0.66, 1.48, 1.56), 0.035, 2));
    add(paint, box(sides(0.48, 2.1, -0.85, 0.85, 0.34, 0.62), 0.02));
    for (const double y : {-1.0, 1.0}) add(paint, box(sides(0.48, 2.1, y < 0 ? -0.85 : 0.77, y < 0 ? -0.77 : 0.85, 0.6, 1.0), 0.02));
    add(paint, box(sides(2.02, 2.1, -0.8, 0.8, 0.6, 1.0), 0.02));
    add(tyre, box(sides(0.5, 2.03, -0.77, 0.77, 0.62, 0.64), 0));
  } else {
    add(paint, rounded_box(sides(-2.1, 2.1, -0.85, 0.85, 0.28, 0.82), 0.16, 4));
    add(glass, taper({0.15, 0, 0.8}, {1.25, 0.74}, {0.2, 0, 1.32}, {0.78, 0.6}));
    add(paint, rounded_box(sides(-0.62, 1.0, -0.62, 0.62, 1.3, 1.38), 0.035, 2));
  }
  for (const double x : {-1.3, 1.3}) {
    for (const double y : {-1.0, 1.0}) {
      add(tyre, rod({x, y * 0.66, 0.32}, {x, y * 0.88, 0.32}, 0.32, 26));
      add(chrome, rod({x, y * 0.87, 0.32}, {x, y * 0.89, 0.32}, 0.19, 20));
    }
  }
  for (const double y : {-0.58, 0.58}) {
    add(p.named("lit_screen"), rounded_box(sides(-2.12, -2.04, y - 0.16, y + 0.16, 0.54, 0.66), 0.03, 2));
    add(p.tinted("plastic", {0.7, 0.1, 0.1}), rounded_box(sides(2.04, 2.12, y - 0.16, y + 0.16, 0.56, 0.68), 0.03, 2));
  }
  p.fit();
}

}  // namespace

void add_outdoor_things(Families& to) {
  to["cone"] = cone_family;
  to["surfboard"] = surfboard;
  to["skis"] = skis;
  to["basketball_hoop"] = basketball_hoop;
  to["sign"] = sign;
  to["ironing_board"] = ironing_board;
  to["umbrella"] = umbrella;
  to["squat_rack"] = squat_rack;
  to["iv_stand"] = iv_stand;
  to["skateboard"] = skateboard;
  to["rocking_horse"] = rocking_horse;
  to["car"] = car;
}

}  // namespace layoutbox::kit
