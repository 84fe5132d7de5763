// Plants and flowers. They are grown freely and then fitted to their box.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

void pot(Piece& p, double radius, double tall, int surface) {
  p.add(surface, lathe({{0, 0},
                        {radius * 0.72, 0},
                        {radius * 0.95, tall * 0.85},
                        {radius, tall * 0.86},
                        {radius, tall},
                        {radius * 0.9, tall},
                        {radius * 0.88, tall * 0.9},
                        {0, tall * 0.9}},
                       28));
  p.add(p.named("soil"), lathe({{0, tall * 0.88}, {radius * 0.87, tall * 0.88}, {radius * 0.87, tall * 0.925}, {0, tall * 0.94}}, 20));
}

int green(Piece& p, double t) { return p.tinted("leaf", mixed({0.20, 0.42, 0.22}, {0.42, 0.62, 0.30}, t)); }

// Leaves on stems that bow outwards from the pot.
void bush(Piece& p, double tall, double reach, int n, double leaf_length, double leaf_width) {
  const double base = tall * 0.3;
  for (int i = 0; i < n; ++i) {
    const double a = 2.39996 * i, t = (i + 0.5) / n, lift = base + (tall - base) * (1 - t * 0.75);
    const double out = reach * (0.15 + 0.75 * std::sqrt(t)) * p.random(0.8, 1.0);
    const Vec root{std::cos(a) * out * 0.55, std::sin(a) * out * 0.55, lift * p.random(0.85, 1.0)};
    const Vec tip = root + Vec{std::cos(a) * leaf_length * (0.3 + 0.6 * t), std::sin(a) * leaf_length * (0.3 + 0.6 * t),
                               leaf_length * (0.75 - 0.85 * t)};
    p.add(green(p, 0.15 + 0.3 * (i % 3)), leaf(root, tip, leaf_width, leaf_length * 0.18, 5));
    p.add(green(p, 0.0), tube({{0, 0, base * 0.9}, {root.x * 0.5, root.y * 0.5, (base + root.z) * 0.5}, root}, 0.006, 5));
  }
}

void sword_leaves(Piece& p, double from, double tall, double reach, int n) {
  for (int i = 0; i < n; ++i) {
    const double a = 2.39996 * i, t = (i + 0.5) / n, top = tall * (1 - 0.45 * t);
    const Vec root{std::cos(a) * reach * 0.25 * t, std::sin(a) * reach * 0.25 * t, from};
    const Vec tip{std::cos(a) * reach * (0.15 + 0.55 * t), std::sin(a) * reach * (0.15 + 0.55 * t), top};
    p.add(green(p, 0.2 + 0.3 * (i % 3)), leaf(root, tip, reach * 0.3, reach * 0.06, 5));
  }
}

void palm(Piece& p, double from, double tall, double reach, int n) {
  for (int i = 0; i < n; ++i) {
    const double a = 2.39996 * i, t = (i + 0.5) / n, out = reach * p.random(0.75, 1), top = tall * (1 - 0.35 * t);
    const std::vector<Vec> stem = curve(
        {{0, 0, from}, {std::cos(a) * out * 0.35, std::sin(a) * out * 0.35, top}, {std::cos(a) * out, std::sin(a) * out, top - out * 0.35}},
        5);
    p.add(green(p, 0.1), tube(stem, 0.005, 5));
    for (std::size_t k = 3; k < stem.size(); ++k) {
      const Vec along = unit(stem[k] - stem[k - 1]), side = unit(cross(along, {0, 0, 1}));
      for (const double s : {-1.0, 1.0}) {
        const double l = reach * 0.34 * (1 - 0.4 * (static_cast<double>(k) - 3) / static_cast<double>(stem.size()));
        p.add(green(p, 0.25 + 0.2 * (i % 3)),
              leaf(stem[k], stem[k] + side * (s * l) + along * (l * 0.5) + Vec{0, 0, -l * 0.25}, l * 0.2, l * 0.05, 2));
      }
    }
  }
}

void plant(Piece& p) {
  const double r = std::min(p.w, p.d) / 2, pot_tall = std::min(p.h * 0.3, 0.36), pot_r = std::min(r * 0.62, pot_tall * 0.75);
  pot(p, pot_r, pot_tall, p.frame(p.says("white") ? "ceramic" : "terracotta"));
  const std::string kind = p.word("kind", p.says("palm")                                                     ? "palm"
                                          : p.says("snake plant") || p.says("sansevieria") || p.says("aloe") ? "sword"
                                          : p.says("cactus")                                                 ? "cactus"
                                                                                                             : "bush");
  if (kind == "cactus") {
    p.add(green(p, 0.1),
          ellipsoid({0, 0, pot_tall + (p.h - pot_tall) * 0.45}, {pot_r * 0.6, pot_r * 0.6, (p.h - pot_tall) * 0.55}, 14, 10));
    for (const double s : {-1.0, 1.0}) {
      const double z = pot_tall + (p.h - pot_tall) * (0.4 + 0.1 * s);
      p.add(green(p, 0.2),
            tube(curve({{0, 0, z}, {s * r * 0.7, 0, z}, {s * r * 0.85, 0, z + (p.h - pot_tall) * 0.3}}, 5), pot_r * 0.22, 10));
    }
  } else if (kind == "palm") {
    palm(p, pot_tall * 0.9, p.h, r, p.h > 1 ? 11 : 8);
  } else if (kind == "sword") {
    sword_leaves(p, pot_tall * 0.88, p.h, r, 13);
  } else {
    bush(p, p.h * 0.92, r * 0.85, p.h > 0.8 ? 26 : 18, std::min(r * 0.75, p.h * 0.4), std::min(r * 0.5, p.h * 0.28));
  }
  p.fit();
}

void tree(Piece& p) {
  const double r = std::min(p.w, p.d) / 2, trunk = p.h * 0.45;
  if (p.says("christmas") || p.word("kind", "") == "conifer") {
    p.add(p.named("walnut"), cylinder({0, 0, 0}, std::min(0.05, r * 0.15), p.h * 0.2, 10));
    const int tiers = std::clamp(static_cast<int>(p.h / 0.3), 4, 7);
    for (int i = 0; i < tiers; ++i) {
      const double z = p.h * (0.12 + 0.82 * i / tiers), next = std::min(p.h, z + p.h * 1.25 / tiers), rr = r * (1 - 0.85 * i / tiers);
      p.add(green(p, 0.05 + 0.05 * (i % 2)), lathe({{0, z + 0.02}, {rr, z}, {rr * 0.45, z + (next - z) * 0.5}, {0, next}}, 14));
      for (int k = 0; k < 6; ++k) {
        const double a = kPi * (k / 3.0 + 0.17 * i);
        p.add(p.named(k % 2 == 0 ? "brass" : "copper"),
              ellipsoid({std::cos(a) * rr * 0.92, std::sin(a) * rr * 0.92, z + 0.01}, {0.028, 0.028, 0.028}, 8, 6));
      }
    }
    p.fit();
    return;
  }
  const double pot_tall = std::min(p.h * 0.2, 0.4);
  pot(p, std::min(r * 0.5, pot_tall * 0.6), pot_tall, p.frame("terracotta"));
  p.add(p.named("walnut"),
        tube(curve({{0, 0, pot_tall * 0.9}, {0.03, 0.01, trunk * 0.8}, {-0.01, 0, p.h * 0.6}}, 4), std::min(0.025, r * 0.1), 8));
  const Vec crown{0, 0, p.h * 0.68};
  p.add(green(p, 0.0), ellipsoid(crown, {r * 0.55, r * 0.55, p.h * 0.17}, 12, 8));
  for (int i = 0; i < 90; ++i) {
    const double a = 2.39996 * i, z = 1 - 2 * (i + 0.5) / 90, q = std::sqrt(1 - z * z), out = r * 0.75;
    const Vec at = crown + Vec{std::cos(a) * q * out, std::sin(a) * q * out, z * p.h * 0.24} * p.random(0.75, 1);
    const Vec way = unit(at - crown + Vec{0, 0, p.h * 0.05});
    p.add(green(p, 0.2 + 0.3 * (i % 3)), leaf(at, at + way * (r * 0.36), r * 0.22, r * 0.03, 3));
  }
  p.fit();
}

void flower_vase(Piece& p) {
  const double r = std::min(p.w, p.d) / 2, tall = p.h * 0.45, vase = std::min(r * 0.55, tall * 0.45);
  p.add(p.named("ceramic"), lathe({{0, 0},
                                   {vase * 0.6, 0},
                                   {vase, tall * 0.35},
                                   {vase * 0.9, tall * 0.6},
                                   {vase * 0.45, tall * 0.88},
                                   {vase * 0.55, tall},
                                   {vase * 0.4, tall},
                                   {vase * 0.35, tall * 0.88},
                                   {0, tall * 0.8}},
                                  22));
  static constexpr Color kPetals[] = {{0.90, 0.55, 0.60}, {0.95, 0.80, 0.45}, {0.80, 0.35, 0.38}, {0.93, 0.90, 0.86}, {0.68, 0.55, 0.78}};
  const int n = p.h > 0.25 ? 7 : 5;
  for (int i = 0; i < n; ++i) {
    const double a = 2.39996 * i, out = r * 0.75 * std::sqrt((i + 0.3) / n), z = p.h * (0.93 - 0.2 * i / n), b = r * 0.26;
    const Vec top{std::cos(a) * out, std::sin(a) * out, z};
    p.add(green(p, 0.3), tube({{0, 0, tall * 0.85}, {top.x * 0.6, top.y * 0.6, (tall + z) * 0.55}, top}, std::min(0.003, r * 0.05), 5));
    const int petals = p.color_asked() ? p.main("paper") : p.tinted("paper", kPetals[static_cast<std::size_t>((i + p.pick(2)) % 5)]);
    for (int k = 0; k < 6; ++k) {
      const double t = 2 * kPi * k / 6;
      p.add(petals, leaf(top, top + Vec{std::cos(t) * b, std::sin(t) * b, b * 0.5}, b * 0.9, b * 0.1, 3));
    }
    p.add(p.tinted("paper", {0.92, 0.75, 0.3}), ellipsoid(top + Vec{0, 0, b * 0.18}, {b * 0.25, b * 0.25, b * 0.2}, 8, 4));
    p.add(green(p, 0.4), leaf({top.x * 0.4, top.y * 0.4, tall * 1.1}, {top.x * 1.1, top.y * 1.1, tall * 1.25}, b * 0.6, b * 0.2, 3));
  }
  p.fit();
}

}  // namespace

void add_plants(Families& to) {
  to["plant"] = plant;
  to["tree"] = tree;
  to["flower_vase"] = flower_vase;
}

}  // namespace layoutbox::kit
