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

// A feather leaf: a stem through the points with pairs of narrow leaflets (one or two a step) from `bare` of its length on, longest in
// the middle.
void frond(Piece& p, std::initializer_list<Vec> points, double bare, double leaflet, double droop, int tone, int pairs) {
  const std::vector<Vec> stem = curve(points, 7);
  p.add(green(p, 0.1), tube(stem, 0.0045, 4));
  const int surface = green(p, 0.2 + 0.22 * (tone % 3));
  const auto n = static_cast<double>(stem.size() - 1);
  for (std::size_t k = 1; k < stem.size(); ++k) {
    const double t = static_cast<double>(k) / n, u = (t - bare) / (1 - bare);
    if (u < 0) continue;
    const Vec along = unit(stem[k] - stem[k - 1]), side = unit(cross(along, {0, 0, 1}));
    const double l = leaflet * (0.35 + 0.65 * std::sin(kPi * std::min(1.0, 0.25 + 0.72 * u)));
    for (const double s : {-1.0, 1.0}) {
      for (int i = 0; i < pairs; ++i) {
        const Vec root = stem[k] - (stem[k] - stem[k - 1]) * (0.5 * i);
        p.add(surface, leaf(root, root + side * (s * l) + along * (l * (0.35 + 0.5 * u)) + Vec{0, 0, -l * droop},
                            l * (pairs == 1 ? 0.3 : 0.2), l * 0.06, 2));
      }
    }
  }
  p.add(surface, leaf(stem.back(), stem.back() + unit(stem.back() - stem[stem.size() - 2]) * (leaflet * 0.5), leaflet * 0.14, 0, 2));
}

// Fronds rise from the pot and bow outwards; the tall ones in the middle first.
void palm(Piece& p, double from, double tall, double reach, int n) {
  for (int i = 0; i < n; ++i) {
    const double a = 2.39996 * i, t = (i + 0.5) / n, out = reach * (0.55 + 0.4 * t), top = tall * (1 - 0.5 * t);
    const auto at = [&](double share, double z) { return Vec{std::cos(a) * out * share, std::sin(a) * out * share, z}; };
    frond(p, {at(0.04, from), at(0.2, from + (top - from) * 0.6), at(0.55, top), at(1, top - out * (0.25 + 0.3 * t))}, 0.38, reach * 0.34,
          0.35, i, 2);
  }
}

void fern(Piece& p, double from, double tall, double reach) {
  constexpr int kFronds = 13;
  for (int i = 0; i < kFronds; ++i) {
    const double a = 2.39996 * i, t = (i + 0.5) / kFronds, out = reach * (0.5 + 0.42 * std::sqrt(t)), top = tall * (0.98 - 0.42 * t);
    const auto at = [&](double share, double z) { return Vec{std::cos(a) * out * share, std::sin(a) * out * share, z}; };
    frond(p, {at(0.05, from), at(0.4, top), at(0.8, top - out * 0.1), at(1, std::max(from * 0.5, top - out * (0.3 + 0.5 * t)))}, 0.12,
          reach * 0.2, 0.2, i, 1);
  }
}

// A blossom of `n` petals that looks along `way`.
void blossom(Piece& p, Vec at, Vec way, double size, int n, int petals) {
  const Pose pose = aimed(at, way);
  for (int k = 0; k < n; ++k) {
    const double t = 2 * kPi * k / n;
    p.add(petals, leaf({0, 0, 0}, {std::cos(t) * size, std::sin(t) * size, size * 0.25}, size * (k % 2 == 0 ? 1.0 : 0.75), size * 0.08, 3),
          pose);
  }
  p.add(p.tinted("paper", {0.90, 0.72, 0.30}), ellipsoid({0, 0, size * 0.14}, {size * 0.2, size * 0.2, size * 0.16}, 8, 5), pose);
}

// Strap leaves at the foot, two stems that bow over with blossoms in a row.
void orchid(Piece& p, double from, double tall, double reach) {
  const int petals =
      p.color_asked() ? p.main("paper") : p.tinted("paper", p.pick(2) == 0 ? Color{0.86, 0.46, 0.66} : Color{0.95, 0.92, 0.93});
  for (int i = 0; i < 6; ++i) {
    const double a = kPi / 3 * i + 0.3, out = reach * (i % 2 == 0 ? 0.85 : 0.65);
    p.add(green(p, 0.1 + 0.1 * (i % 2)),
          leaf({0, 0, from}, {std::cos(a) * out, std::sin(a) * out, from + tall * 0.03}, reach * 0.34, tall * 0.09, 5));
  }
  for (const double s : {-1.0, 1.0}) {
    const double lean = s < 0 ? 0.55 : 0.8, top = s < 0 ? tall * 0.97 : tall * 0.84;
    const std::vector<Vec> stem = curve({{s * reach * 0.05, 0, from},
                                         {s * reach * 0.12, 0, from + (top - from) * 0.6},
                                         {s * reach * 0.35, -reach * 0.1, top},
                                         {s * reach * lean, -reach * 0.3, top - tall * 0.1}},
                                        8);
    p.add(green(p, 0.2), tube(stem, std::min(0.004, reach * 0.03), 6));
    for (std::size_t k = 11; k < stem.size(); k += 3) {
      const double side = k % 2 == 0 ? 1.0 : -1.0;
      blossom(p, stem[k] + Vec{side * reach * 0.1, -reach * 0.05, 0}, {s * 0.35 + side * 0.25, -1, 0.1}, reach * 0.24, 5, petals);
    }
  }
}

// A rosette of thick leaves, the inner ones upright.
void succulent(Piece& p, double from, double tall, double reach) {
  constexpr int kLeaves = 34;
  for (int i = 0; i < kLeaves; ++i) {
    const double a = 2.39996 * i, t = (i + 0.5) / kLeaves, rise = kPi / 2 * (1 - 0.86 * t), l = reach * (0.35 + 0.6 * t);
    const Vec way{std::cos(a) * std::cos(rise), std::sin(a) * std::cos(rise), std::sin(rise)};
    const Pose pose = aimed({0, 0, from + (tall - from) * 0.3 * (1 - t)}, way);
    p.add(p.tinted("leaf", mixed({0.46, 0.62, 0.50}, {0.70, 0.72, 0.62}, 0.2 + 0.6 * (1 - t))),
          lathe({{0, 0}, {l * 0.1, l * 0.1}, {l * 0.26, l * 0.62}, {l * 0.2, l * 0.86}, {0, l}}, 9, 0.45), pose);
  }
}

void plant(Piece& p) {
  const double r = std::min(p.w, p.d) / 2, pot_tall = std::min(p.h * 0.3, 0.36), pot_r = std::min(r * 0.62, pot_tall * 0.75);
  pot(p, pot_r, pot_tall, p.frame(p.says("white") ? "ceramic" : "terracotta"));
  const std::string kind = p.word("kind", p.says("palm")                                                     ? "palm"
                                          : p.says("fern")                                                   ? "fern"
                                          : p.says("orchid")                                                 ? "orchid"
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
    palm(p, pot_tall * 0.9, p.h, r, p.h > 1 ? 8 : 7);
  } else if (kind == "fern") {
    fern(p, pot_tall * 0.9, p.h, r);
  } else if (kind == "orchid") {
    orchid(p, pot_tall * 0.9, p.h, r);
  } else if (kind == "succulent") {
    succulent(p, pot_tall * 0.88, p.h, r);
  } else if (kind == "sword") {
    sword_leaves(p, pot_tall * 0.88, p.h, r, 13);
  } else {
    bush(p, p.h * 0.92, r * 0.85, p.h > 0.8 ? 26 : 18, std::min(r * 0.75, p.h * 0.4), std::min(r * 0.5, p.h * 0.28));
  }
  p.fit();
}

// A low bowl, a trunk that winds, and clouds of leaves at the ends of its branches.
void bonsai(Piece& p) {
  const double x = p.w / 2, y = p.d / 2, bowl = p.h * 0.16;
  const int clay = p.frame("terracotta"), bark = p.named("walnut");
  p.add(clay, box(sides(-x * 0.66, x * 0.66, -y * 0.5, y * 0.5, p.h * 0.02, bowl), 0.01));
  p.add(clay, box(sides(-x * 0.72, x * 0.72, -y * 0.55, y * 0.55, bowl * 0.8, bowl), 0.004));
  for (const double s : {-1.0, 1.0})
    p.add(clay, box(sides(s * x * 0.5 - x * 0.1, s * x * 0.5 + x * 0.1, -y * 0.4, y * 0.4, 0, p.h * 0.03), 0.003));
  p.add(p.named("soil"), box(sides(-x * 0.62, x * 0.62, -y * 0.46, y * 0.46, bowl - 0.002, bowl + p.h * 0.012), 0.004));
  const Vec bend{-x * 0.22, 0, p.h * 0.4}, fork{x * 0.16, 0, p.h * 0.6};
  p.add(bark, tube(curve({{x * 0.06, 0, bowl}, bend, fork}, 6), std::min(0.05, x * 0.11), 9));
  const std::pair<Vec, double> clouds[] = {{{-x * 0.52, y * 0.08, p.h * 0.56}, 0.46},
                                           {{x * 0.6, -y * 0.1, p.h * 0.66}, 0.4},
                                           {{x * 0.02, y * 0.1, p.h * 0.86}, 0.52},
                                           {{-x * 0.2, -y * 0.34, p.h * 0.7}, 0.34}};
  for (const auto& [at, size] : clouds) {
    p.add(bark, tube(curve({at.x < 0 ? bend : fork, (at + fork) * 0.5, at}, 4), std::min(0.02, x * 0.05), 7));
    const Vec half{x * size, y * size * 0.95, p.h * 0.13};
    p.add(green(p, 0.0), ellipsoid(at, half * 0.82, 12, 7));
    for (int i = 0; i < 46; ++i) {
      const double a = 2.39996 * i, z = 0.95 - 1.3 * (i + 0.5) / 46, q = std::sqrt(1 - z * z);
      const Vec n{std::cos(a) * q, std::sin(a) * q, z}, root = at + Vec{n.x * half.x, n.y * half.y, n.z * half.z} * 0.8;
      p.add(green(p, 0.15 + 0.25 * (i % 3)), leaf(root, root + n * (x * 0.13), x * 0.11, x * 0.01, 2));
    }
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
  if (p.word("kind", "") == "bonsai") return bonsai(p);
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

// A pail full of cut flowers.
void flower_pail(Piece& p) {
  static constexpr Color kPetals[] = {{0.86, 0.24, 0.40}, {0.96, 0.78, 0.24}, {0.95, 0.94, 0.92}, {0.62, 0.40, 0.72}, {0.92, 0.46, 0.20}};
  const double r = std::min(p.w, p.d) / 2, pail = p.h * 0.45;
  p.add(p.frame("steel"), cone({0, 0, 0}, r * 0.62, r * 0.8, pail, 18));
  p.add(green(p, 0.2), cone({0, 0, pail - 0.005}, r * 0.55, r * 0.85, p.h * 0.42, 14));
  const int first = p.pick(5), n = 15;
  for (int i = 0; i < n; ++i) {
    const double a = 2.39996 * i, out = r * 0.82 * std::sqrt((i + 0.3) / n), b = r * 0.2;
    const int petals = p.color_asked() ? p.main("paper") : p.tinted("paper", kPetals[(first + i % 2) % 5]);
    p.add(petals, ellipsoid({std::cos(a) * out, std::sin(a) * out, p.h - b - r * 0.5 * i / n}, {b, b, b * 0.8}, 9, 5));
  }
  p.fit();
}

void flower_vase(Piece& p) {
  if (p.word("kind", "") == "bucket") return flower_pail(p);
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
