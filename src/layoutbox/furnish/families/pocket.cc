// Small things that lie about: crayons, keys, a stethoscope, pens with a ruler; drinking bottles, a bell.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

constexpr Color kBright[] = {{0.84, 0.28, 0.24}, {0.24, 0.48, 0.76}, {0.95, 0.76, 0.26},
                             {0.34, 0.62, 0.38}, {0.92, 0.54, 0.22}, {0.56, 0.40, 0.68}};

// Side by side, tips to the back.
void crayons(Piece& p) {
  const int n = std::clamp(static_cast<int>(p.w / 0.014), 3, 12);
  const double r = std::min(p.w / n * 0.48, p.h / 2);
  for (int i = 0; i < n; ++i) {
    const double x = -p.w / 2 + p.w * (i + 0.5) / n, tip = p.d / 2 - p.d * (i % 3 == 1 ? 0.06 : 0.0);
    const int wax = p.tinted("wax", kBright[i % 6]);
    p.add(wax, rod({x, -p.d / 2, r}, {x, tip - p.d * 0.16, r}, r, 10));
    p.add(wax, cone({0, 0, 0}, r * 0.72, r * 0.3, p.d * 0.16, 10), aimed({x, tip - p.d * 0.16, r}, {0, 1, 0}));
    p.add(p.named("black_plastic"), rod({x, -p.d * 0.36, r}, {x, -p.d * 0.33, r}, r * 1.02, 10));
  }
  p.fit();
}

// A pen, a pencil and a ruler.
void stationery(Piece& p) {
  const double lane = p.w / 3, r = std::min(lane * 0.3, p.h / 2), y = p.d / 2;
  p.add(p.tinted("plastic", {0.93, 0.78, 0.36}), box(sides(-p.w / 2, -p.w / 2 + lane, -y, y, 0, p.h * 0.25), 0));
  for (int i = 0; i < 8; ++i)
    p.add(p.named("black_plastic"),
          box(sides(-p.w / 2 + lane * 0.6, -p.w / 2 + lane * 0.98, p.d * (i / 8.0 - 0.46), p.d * (i / 8.0 - 0.455), p.h * 0.24, p.h * 0.27),
              0));
  for (const double s : {0.0, 1.0}) {
    const double x = s * lane;
    const int paint = s == 0 ? p.tinted("lacquer", kBright[2]) : p.main_accent("plastic");
    p.add(paint, rod({x, -y * 0.94, r}, {x, y * 0.72, r}, r, s == 0 ? 6 : 14));
    p.add(s == 0 ? p.named("pine") : p.named("steel"), cone({0, 0, 0}, r * 0.95, r * 0.15, p.d * 0.13, 12),
          aimed({x, y * 0.72, r}, {0, 1, 0}));
    p.add(s == 0 ? p.tinted("plastic", {0.86, 0.52, 0.52}) : p.named("black_plastic"), rod({x, -y, r}, {x, -y * 0.9, r}, r * 1.05, 12));
  }
  p.fit();
}

void keys(Piece& p) {
  const int metal = p.main("brass");
  const double r = p.d * 0.3, t = std::max(0.0012, p.h * 0.1);
  p.add(p.named("steel"), torus({-p.w * 0.28, 0, p.h * 0.5}, r, t, 26, 6));
  for (const auto& [turn, level] : {std::pair{-26.0, 0.3}, {4.0, 0.55}, {30.0, 0.75}}) {
    const Pose pose = moved(-p.w * 0.28 + r, 0, p.h * level) * turned_z(turn);
    const double l = p.w * 0.55;
    p.add(metal, lathe({{l * 0.06, 0}, {l * 0.17, 0}, {l * 0.17, t * 2}, {l * 0.06, t * 2}, {l * 0.06, 0}}, 18),
          pose * moved(l * 0.12, 0, 0));
    p.add(metal,
          prism({{l * 0.27, -l * 0.05},
                 {l, -l * 0.05},
                 {l, l * 0.05},
                 {l * 0.9, l * 0.09},
                 {l * 0.8, l * 0.04},
                 {l * 0.7, l * 0.08},
                 {l * 0.6, l * 0.05},
                 {l * 0.27, l * 0.05}},
                0, t * 2),
          pose);
  }
  p.fit();
}

void stethoscope(Piece& p) {
  const int rubber = p.tinted("plastic", {0.16, 0.24, 0.38}), steel = p.named("steel");
  const double x = p.w / 2, y = p.d / 2, r = std::min({p.h * 0.3, p.w * 0.03, p.d * 0.05});
  p.add(rubber, tube(curve({{-x * 0.2, y * 0.55, r},
                            {x * 0.35, y * 0.7, r},
                            {x * 0.8, y * 0.1, r},
                            {x * 0.3, -y * 0.5, r},
                            {-x * 0.35, -y * 0.55, r},
                            {-x * 0.65, -y * 0.45, r}},
                           6),
                     r, 8));
  p.add(steel, cylinder({-x * 0.72, -y * 0.45, 0}, std::min(x, y) * 0.28, p.h * 0.5, 26));
  p.add(steel, cylinder({-x * 0.72, -y * 0.45, 0}, std::min(x, y) * 0.12, p.h, 18));
  for (const double s : {-1.0, 1.0}) {
    const std::vector<Vec> arm =
        curve({{-x * 0.2, y * 0.55, r}, {-x * 0.5, y * (0.55 + s * 0.3), r * 1.2}, {-x * 0.92, y * (0.55 + s * 0.22), r * 1.4}}, 5);
    p.add(steel, tube(arm, r * 0.6, 8));
    p.add(p.named("black_plastic"), ellipsoid(arm.back(), {r * 1.2, r * 1.2, r * 1.2}, 10, 6));
  }
  p.fit();
}

void pocket(Piece& p) {
  const std::string kind = p.word("kind", "keys");
  if (kind == "crayons") return crayons(p);
  if (kind == "stationery") return stationery(p);
  if (kind == "medical") return stethoscope(p);
  keys(p);
}

// A drinking bottle with a cap and its loop.
void flask(Piece& p) {
  const int body = p.main_accent("painted_metal"), dark = p.named("black_plastic");
  const double h = p.h;
  const Pose oval = scaled(p.w / 2, p.d / 2, 1);
  p.add(body, lathe({{0, 0}, {0.94, 0}, {1, h * 0.02}, {1, h * 0.66}, {0.82, h * 0.76}, {0.62, h * 0.79}, {0, h * 0.79}}, 28), oval);
  p.add(p.named("steel"), lathe({{0, h * 0.785}, {0.62, h * 0.785}, {0.62, h * 0.81}, {0, h * 0.81}}, 24), oval);
  p.add(dark, lathe({{0, h * 0.805}, {0.68, h * 0.805}, {0.68, h * 0.92}, {0.6, h * 0.93}, {0, h * 0.93}}, 24), oval);
  const double r = p.w * 0.045;
  p.add(dark,
        tube(curve({{-p.w * 0.2, 0, h * 0.92}, {-p.w * 0.17, 0, h - r * 1.2}, {p.w * 0.17, 0, h - r * 1.2}, {p.w * 0.2, 0, h * 0.92}}, 4),
             r, 8));
  p.fit();
}

void bell(Piece& p) {
  const double h = p.h;
  const Pose oval = scaled(p.w / 2, p.d / 2, h);
  p.add(p.named("black_plastic"), lathe({{0, 0}, {1, 0}, {0.98, 0.1}, {0.9, 0.16}, {0, 0.16}}, 34), oval);
  p.add(p.main("brass"), lathe({{0, 0.18}, {0.9, 0.18}, {0.88, 0.3}, {0.74, 0.56}, {0.42, 0.76}, {0, 0.83}}, 34), oval);
  p.add(p.named("steel"), lathe({{0, 0.8}, {0.1, 0.8}, {0.1, 0.9}, {0.17, 0.92}, {0.17, 0.98}, {0.1, 1}, {0, 1}}, 16), oval);
}

}  // namespace

void add_pocket_things(Families& to) {
  to["pocket"] = pocket;
  to["flask"] = flask;
  to["bell"] = bell;
}

}  // namespace layoutbox::kit
