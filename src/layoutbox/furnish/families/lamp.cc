// Lamps; each gives light.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// A hollow shade round the z axis, elliptical where width and depth differ.
void shade(Piece& p, int surface, double r_below, double r_above, double z0, double z1) {
  const double t = 0.004;
  p.add(surface, lathe({{r_below - t, z0}, {r_below, z0}, {r_above, z1}, {r_above - t, z1}, {r_below - t, z0}}, 36),
        scaled(1, p.d / p.w, 1));
}

// A foot at the left, and a bow that carries the shade over to the right.
void arc_lamp(Piece& p) {
  const int metal = p.frame("steel"), cloth = p.main("lampshade");
  const double r = std::min(p.d / 2, p.w * 0.2), tall = std::min(0.24, p.h * 0.14), level = p.clear_below(p.h * 0.6) + 0.01;
  double foot = r * 0.9;
  for (const FreeSpace& s : p.spaces) foot = std::min(foot, (s.box.min.x + p.w / 2) / 2);
  const double x0 = -p.w / 2 + foot, x1 = p.w / 2 - r, z = std::max(level, p.h - tall - 0.1), pipe = 0.012;
  p.add(metal, lathe({{0, 0}, {foot, 0}, {foot, 0.03}, {foot * 0.95, 0.04}, {0, 0.04}}, 28), moved(x0, 0, 0));
  p.add(metal, tube(curve({{x0, 0, 0.03},
                           {x0 - foot * 0.15, 0, p.h * 0.7},
                           {x0 + (x1 - x0) * 0.25, 0, p.h - pipe - 0.09},
                           {x0 + (x1 - x0) * 0.55, 0, p.h - pipe},
                           {x0 + (x1 - x0) * 0.85, 0, p.h - pipe - 0.06},
                           {x1, 0, z + tall}},
                          6),
                    pipe, 8));
  const Vec top{x0 + (x1 - x0) * 0.55, 0, p.h - pipe};
  p.add(metal, ellipsoid(top, {pipe, pipe, pipe}, 12, 6));
  p.add(cloth,
        lathe({{r - 0.004, z},
               {r, z},
               {r * 0.6, z + tall * 0.8},
               {0.02, z + tall},
               {0, z + tall},
               {0, z + tall - 0.004},
               {r * 0.58, z + tall * 0.78},
               {r - 0.004, z}},
              32),
        moved(x1, 0, 0) * scaled(1, p.d / 2 / r, 1));
  p.add(p.named("bulb"), ellipsoid({x1, 0, z + tall * 0.4}, {0.035, 0.035, 0.05}, 12, 6));
  p.light({x1, 0, z + tall * 0.3}, 25, 0.08);
}

void floor_lamp(Piece& p) {
  const int metal = p.frame("black_metal"), cloth = p.main("lampshade");
  if (p.w > 2 * p.d || p.word("kind", "") == "arc") return arc_lamp(p);
  const double r = p.w / 2, tall = std::min(0.32, p.h * 0.22), foot = std::min(r * 0.75, 0.16);
  const double k = p.d / p.w;
  if (p.says("tripod")) {
    for (int i = 0; i < 3; ++i) {
      const double a = kPi * (0.5 + 2.0 * i / 3);
      p.add(p.frame("oak"), leg({std::cos(a) * (r - 0.02), std::sin(a) * (r - 0.02) * k, 0}, {0, 0, p.h - tall * 0.9}, 0.011, 0.014));
    }
  } else {
    p.add(metal, lathe({{0, 0}, {foot, 0}, {foot, 0.015}, {foot * 0.9, 0.022}, {0.02, 0.03}, {0, 0.03}}, 28), scaled(1, k, 1));
    p.add(metal, cylinder({0, 0, 0.02}, 0.011, p.h - tall * 0.55 - 0.02, 12));
  }
  const int look = p.is_style("modern") ? 1 : p.is_style("traditional") ? 2 : p.variant(3);
  shade(p, cloth, r, r * (look == 1 ? 1 : look == 2 ? 0.5 : 0.72), p.h - tall, p.h);
  p.add(p.named("bulb"), ellipsoid({0, 0, p.h - tall * 0.5}, {0.035, 0.035, 0.05}, 12, 6));
  p.light({0, 0, p.h - tall * 0.5}, 25, 0.08);
}

// A glowing body on a foot: a rough lump of salt, a cone of glass with blobs, a small globe.
void glowing_lamp(Piece& p, std::string_view kind) {
  const double r = p.w / 2, k = p.d / p.w;
  if (kind == "lava") {
    const int metal = p.named("steel"), blob = p.tinted("ember", {0.96, 0.32, 0.20});
    p.add(metal, lathe({{0, 0}, {r, 0}, {r * 0.62, p.h * 0.24}, {r * 0.7, p.h * 0.28}, {0, p.h * 0.28}}, 28), scaled(1, k, 1));
    p.add(p.tinted("frosted_glass", {0.98, 0.62, 0.36}),
          lathe({{0, p.h * 0.27}, {r * 0.68, p.h * 0.27}, {r * 0.78, p.h * 0.4}, {r * 0.4, p.h * 0.86}, {0, p.h * 0.86}}, 28),
          scaled(1, k, 1));
    p.add(metal, lathe({{0, p.h * 0.85}, {r * 0.42, p.h * 0.85}, {r * 0.3, p.h}, {0, p.h}}, 22), scaled(1, k, 1));
    for (const auto& [z, s] : {std::pair{0.4, 0.3}, {0.56, 0.2}, {0.7, 0.14}})
      p.add(blob, ellipsoid({r * 0.1 * (s - 0.2), -r * 0.28, p.h * z}, {r * s, r * s, r * s * 1.3}, 12, 8));
  } else if (kind == "salt") {
    p.add(p.named("walnut"), cylinder({0, 0, 0}, r * 0.86, p.h * 0.1, 24));
    std::vector<std::vector<Vec>> rings;
    static constexpr Vec2 kSide[] = {{0.72, 0.09}, {0.98, 0.25}, {0.86, 0.5}, {0.6, 0.76}, {0.3, 0.96}};
    for (const Vec2& at : kSide) {
      std::vector<Vec> ring;
      for (int i = 0; i < 9; ++i) {
        const double a = 2 * kPi * i / 9, rough = 1 + 0.12 * (p.random() - 0.5);
        ring.push_back({std::cos(a) * r * at.x * rough, std::sin(a) * r * k * at.x * rough, p.h * (at.y + 0.05 * (p.random() - 0.5))});
      }
      rings.push_back(ring);
    }
    p.add(p.tinted("lampshade", {0.98, 0.62, 0.44}), loft(rings));
    p.fit();
  } else {
    p.add(p.main("plastic"), lathe({{0, 0}, {r * 0.7, 0}, {r * 0.74, p.h * 0.14}, {r * 0.5, p.h * 0.2}, {0, p.h * 0.2}}, 26),
          scaled(1, k, 1));
    p.add(p.named("lampshade"), ellipsoid({0, 0, p.h * 0.58}, {r, r * k, p.h * 0.42}, 26, 16));
  }
  p.light({0, 0, p.h * 0.6}, 5, 0.05);
}

void table_lamp(Piece& p) {
  if (const std::string kind = p.word("kind", ""); kind == "lava" || kind == "salt" || kind == "globe") return glowing_lamp(p, kind);
  const double r = p.w / 2, tall = p.h * 0.42, k = p.d / p.w, neck = p.h - tall;
  const int base = p.main_accent("ceramic"), cloth = p.color_asked() ? p.main("lampshade") : p.named("lampshade"), metal = p.named("brass");
  const int look = p.is_style("modern") || p.is_style("minimalist") ? 1 : p.is_style("traditional") ? 0 : p.variant(3);
  if (look == 1) {  // a slim column on a plate
    p.add(base, lathe({{0, 0}, {r * 0.5, 0}, {r * 0.5, neck * 0.06}, {r * 0.1, neck * 0.1}, {r * 0.1, neck * 0.95}, {0, neck * 0.95}}, 24),
          scaled(1, k, 1));
  } else if (look == 2) {  // a ball
    const double ball = std::min(r * 0.72, neck * 0.44);
    p.add(base, lathe({{0, 0}, {ball * 0.7, 0}, {ball * 0.7, neck * 0.08}, {0, neck * 0.08}}, 22), scaled(1, k, 1));
    p.add(base, ellipsoid({0, 0, neck * 0.06 + ball * 0.95}, {ball, ball * k, ball}, 22, 14));
    p.add(metal, cylinder({0, 0, neck * 0.5}, std::min(0.008, r * 0.1), neck * 0.46, 10));
  } else
    p.add(base,
          lathe({{0, 0},
                 {r * 0.42, 0},
                 {r * 0.45, neck * 0.05},
                 {r * 0.58, neck * 0.35},
                 {r * 0.52, neck * 0.6},
                 {r * 0.2, neck * 0.85},
                 {r * 0.14, neck * 0.95},
                 {0, neck * 0.95}},
                24),
          scaled(1, k, 1));
  p.add(metal, cylinder({0, 0, neck * 0.94}, std::min(0.008, r * 0.1), tall * 0.45, 8));
  shade(p, cloth, r, r * (look == 1 ? 0.95 : 0.68), p.h - tall, p.h);
  p.add(p.named("bulb"), ellipsoid({0, 0, p.h - tall * 0.5}, {r * 0.2, r * 0.2, r * 0.28}, 10, 6));
  p.light({0, 0, p.h - tall * 0.5}, 10, 0.05);
}

// Bulbs on a cord that sags between hooks, more than a metre apart.
void string_light(Piece& p) {
  const int cord = p.main("black_plastic"), glow = p.named("bulb");
  const int sags = std::max(1, static_cast<int>(std::lround(p.w / 1.1))), each = std::max(6, static_cast<int>(p.w / sags / 0.13)),
            n = sags * each;
  std::vector<Vec> line;
  for (int i = 0; i <= n; ++i) {
    const double t = 2.0 * (i % each) / each - 1;
    line.push_back({p.w * (static_cast<double>(i) / n - 0.5), 0, p.h * (0.3 + 0.7 * t * t)});
  }
  p.add(cord, tube(line, 0.004, 5));
  for (int i = 1; i < n; ++i) p.add(glow, ellipsoid(line[static_cast<std::size_t>(i)] - Vec{0, 0, p.h * 0.2}, {0.026, 0.026, 0.034}, 8, 6));
  p.light({0, 0, p.h * 0.1}, 10, 0.2);
  p.fit();
}

// A shade that glows, unless something hard or dark was asked: seen from above, what is not lit is a dark ball.
std::string_view pendant_surface(const Piece& p) {
  if (p.says("glass")) return "frosted_glass";
  for (const char* hard :
       {"metal", "brass", "copper", "steel", "iron", "gold", "chrome", "bronze", "industrial", "surgical", "ceramic", "wooden", "rattan"}) {
    if (p.says(hard)) return "painted_metal";
  }
  return p.is_style("industrial") ? "black_metal" : "lampshade";
}

void pendant(Piece& p) {
  if (p.w > 12 * p.d) return string_light(p);
  if (p.w > 1.6 * p.d) {
    // A bar on two cords.
    const int shell = p.frame("black_metal");
    const double bar = std::min(0.08, p.h * 0.3);
    p.add(shell, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, bar * 0.3, bar), 0.006));
    p.add(p.named("lampshade"), box(sides(-p.w / 2 + 0.01, p.w / 2 - 0.01, -p.d / 2 + 0.01, p.d / 2 - 0.01, 0, bar * 0.4), 0.003));
    for (const double x : {-0.3, 0.3}) p.add(shell, cylinder({x * p.w, 0, bar - 0.002}, 0.003, p.h - bar - 0.008, 6));
    p.add(shell, box(sides(-p.w * 0.33, p.w * 0.33, -std::min(0.03, p.d * 0.4), std::min(0.03, p.d * 0.4), p.h - 0.02, p.h), 0.004));
    for (const double x : {-0.3, 0.0, 0.3}) p.light({x * p.w, 0, -0.02}, 12, 0.05);
    return;
  }
  const double r = p.w / 2, tall = std::min({0.3, p.h * 0.6, r * 1.3}), k = p.d / p.w;
  const std::string_view shade = pendant_surface(p);  // of no accent: one loud ball spoils a room
  const int metal = p.named("black_metal"), outside = p.color_asked() || shade != "lampshade" ? p.main(shade) : p.named(shade);
  if (p.word("kind", "") == "lantern") {
    const double high = std::min(p.h * 0.8, r * 3.2);
    lantern(p, high);
    p.add(metal, cylinder({0, 0, high - 0.01}, 0.005, p.h - high + 0.01, 8));
    p.light({0, 0, high * 0.35}, 15, 0.05);
    p.fit();
    return;
  }
  if (p.word("kind", "") == "globe" || p.says("globe")) {
    const double ball = std::min(r, p.h * 0.46);
    const bool paper = p.category() == "paper_lantern";
    const int surface = p.named("lampshade");
    p.add(surface, ellipsoid({0, 0, ball}, {r, r * k, ball}, 32, 18));
    for (int j = 1; paper && j < 8; ++j) {
      const double a = kPi * j / 8 - kPi / 2;
      p.add(surface, torus({0, 0, 0}, r * std::cos(a), 0.003, 32, 5), moved(0, 0, ball + ball * std::sin(a)) * scaled(1, k, 1));
    }
    p.add(metal, cylinder({0, 0, ball * 1.96}, 0.004, p.h - ball * 1.96 - 0.01, 8));
    p.add(metal, cylinder({0, 0, p.h - std::min(0.03, p.h * 0.1)}, std::min(0.05, r * 0.5), std::min(0.03, p.h * 0.1), 20));
    p.fit();
    p.light({0, 0, -0.02}, 25, 0.1);
    return;
  }
  p.add(metal, cylinder({0, 0, p.h - std::min(0.03, p.h * 0.1)}, std::min(0.05, r * 0.5), std::min(0.03, p.h * 0.1), 20));
  p.add(metal, cylinder({0, 0, tall * 0.95}, 0.004, p.h - tall, 8));
  // A dome: an arc from the rim up to the neck, and back inside.
  std::vector<Vec2> profile;
  for (int i = 0; i <= 8; ++i) {
    const double a = kPi / 2 * i / 8;
    profile.push_back({r * std::cos(a) + 0.02 * (i == 8 ? 1 : 0), tall * std::sin(a)});
  }
  profile.push_back({0.0, tall});
  std::vector<Vec2> inside;
  for (int i = 0; i <= 8; ++i) {
    const double a = kPi / 2 * (8 - i) / 8;
    inside.push_back({(r - 0.006) * std::cos(a), (tall - 0.006) * std::sin(a)});
  }
  inside.front().x = 0;
  profile.insert(profile.end(), inside.begin(), inside.end());
  profile.push_back(profile.front());
  p.add(outside, lathe(profile, 32), scaled(1, k, 1));
  p.add(p.named("bulb"),
        ellipsoid({0, 0, tall * 0.45}, {std::min(0.045, r * 0.3), std::min(0.045, r * 0.3), std::min(0.05, tall * 0.3)}, 14, 8));
  p.light({0, 0, std::max(0.02, tall * 0.1)}, 30, 0.06);
}

void chandelier(Piece& p) {
  const double r = p.w / 2, k = p.d / p.w;
  const int metal = p.frame("brass"), glow = p.named("bulb"), wax = p.named("ceramic");
  const double body = std::min(p.h * 0.55, r * 1.1);
  p.add(metal, cylinder({0, 0, p.h - 0.03}, std::min(0.06, r * 0.4), 0.03, 20));
  p.add(metal, cylinder({0, 0, body * 0.6}, 0.008, p.h - body * 0.6, 8));
  p.add(metal,
        lathe({{0, 0}, {0.03, 0.02}, {0.05, body * 0.2}, {0.02, body * 0.35}, {0.04, body * 0.5}, {0.012, body * 0.65}, {0, body * 0.65}},
              18));
  const int n = std::max(4, (p.count("arms", p.w > 0.5 ? 8 : 4) + 3) / 4 * 4);  // a multiple of four reaches all four sides
  for (int i = 0; i < n; ++i) {
    const double a = 2 * kPi * i / n, c = std::cos(a), s = std::sin(a) * k, e = r - 0.026;
    p.add(metal, tube(curve({{0.03 * c, 0.03 * s, body * 0.4}, {e * 0.5 * c, e * 0.5 * s, body * 0.18}, {e * c, e * s, body * 0.4}}, 5),
                      0.007, 7));
    p.add(metal, lathe({{0, 0}, {0.024, 0.012}, {0.026, 0.016}, {0, 0.016}}, 12), moved(e * c, e * s, body * 0.4));
    p.add(wax, cylinder({e * c, e * s, body * 0.4 + 0.014}, 0.011, 0.06, 10));
    p.add(glow, ellipsoid({e * c, e * s, body * 0.4 + 0.095}, {0.014, 0.014, 0.025}, 8, 6));
  }
  p.light({0, 0, body * 0.5}, 45, 0.15);
}

// Globes in a row on a bar, or a tube before a picture.
void bar_lamp(Piece& p) {
  const int metal = p.frame("brass"), shade_surface = p.named("lampshade");
  const double x = p.w / 2, y = p.d / 2, r = std::min(p.h, p.d * 0.8) / 2;
  const int n = p.count("bulbs", 0);
  if (n == 0) {
    const double tube_radius = std::min(0.02, r * 0.5);
    p.add(metal, rod({-x, -y + tube_radius * 1.2, p.h - tube_radius * 1.2}, {x, -y + tube_radius * 1.2, p.h - tube_radius * 1.2},
                     tube_radius * 1.2, 16));
    p.add(shade_surface, rod({-x * 0.94, -y + tube_radius * 1.6, p.h - tube_radius * 2},
                             {x * 0.94, -y + tube_radius * 1.6, p.h - tube_radius * 2}, tube_radius, 14));
    p.add(metal, tube(curve({{0, y - 0.01, p.h * 0.2}, {0, 0, p.h * 0.8}, {0, -y + tube_radius * 2, p.h - tube_radius}}, 5), 0.007, 8));
    p.add(metal, box(sides(-std::min(0.05, x * 0.4), std::min(0.05, x * 0.4), y - 0.014, y, 0, p.h * 0.5), 0.004));
    p.light({0, -y + tube_radius, p.h * 0.5}, 8, 0.04);
    p.fit();
    return;
  }
  p.add(metal, box(sides(-x, x, y - 0.025, y, p.h * 0.3, p.h * 0.7), 0.006));
  for (int i = 0; i < n; ++i) {
    const double cx = -x + p.w * (i + 0.5) / n, globe = std::min(r, x / n * 0.86);
    p.add(metal, rod({cx, y - 0.02, p.h / 2}, {cx, -y + globe * 1.7, p.h / 2}, globe * 0.4, 14));
    p.add(shade_surface, ellipsoid({cx, -y + globe, p.h / 2}, {globe, globe, p.h / 2}, 20, 12));
    p.light({cx, -y + globe, p.h / 2}, 14.0 / n, 0.05);
  }
}

void wall_lamp(Piece& p) {
  if (p.word("kind", "") == "bar") return bar_lamp(p);
  const int metal = p.frame("brass"), cloth = p.named("lampshade");
  const double r = std::min(p.w / 2, p.d * 0.45), y = -p.d / 2 + r;
  p.add(metal, box(sides(-std::min(0.05, p.w * 0.35), std::min(0.05, p.w * 0.35), p.d / 2 - 0.015, p.d / 2, 0, std::min(p.h, 0.2)), 0.004));
  p.add(metal, tube(curve({{0, p.d / 2 - 0.01, p.h * 0.25}, {0, p.d / 4, p.h * 0.15}, {0, y, p.h * 0.3}}, 5), 0.007, 8));
  p.add(cloth, lathe({{0, p.h * 0.35}, {p.w / 2, p.h * 0.35}, {p.w * 0.32, p.h}, {0, p.h}}, 28),
        moved(0, y, 0) * scaled(1, 2 * r / p.w, 1));
  p.light({0, y - r * 0.2, p.h * 0.7}, 10, 0.05);
}

void ceiling_lamp(Piece& p) {
  if (p.w > 1.6 * p.d || p.d > 1.6 * p.w) {
    p.add(p.frame("painted_metal"), box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, p.h * 0.45, p.h), 0.006));
    p.add(p.named("lampshade"),
          rounded_box(sides(-p.w / 2 + 0.01, p.w / 2 - 0.01, -p.d / 2 + 0.01, p.d / 2 - 0.01, 0, p.h * 0.5), std::min(p.h * 0.2, 0.02), 3));
    p.light({0, 0, -0.02}, 35, 0.12);
    return;
  }
  const double r = p.w / 2, k = p.d / p.w;
  p.add(p.frame("steel"), lathe({{0, p.h * 0.7}, {r * 0.96, p.h * 0.7}, {r, p.h * 0.75}, {r, p.h}, {0, p.h}}, 36), scaled(1, k, 1));
  p.add(p.named("lampshade"), lathe({{0, 0}, {r * 0.5, p.h * 0.1}, {r * 0.82, p.h * 0.35}, {r * 0.94, p.h * 0.7}, {0, p.h * 0.7}}, 36),
        scaled(1, k, 1));
  p.light({0, 0, -0.02}, 35, 0.12);
}

}  // namespace

void add_lamps(Families& to) {
  to["floor_lamp"] = floor_lamp;
  to["table_lamp"] = table_lamp;
  to["pendant"] = pendant;
  to["chandelier"] = chandelier;
  to["wall_lamp"] = wall_lamp;
  to["ceiling_lamp"] = ceiling_lamp;
}

}  // namespace layoutbox::kit
