// Towns and what is beyond the Earth.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/picture_sheet.h"

namespace layoutbox::kit::pictures {
namespace {

// Towers side by side from edge to edge, some with spires; `lit`: windows.
void towers(Piece& p, PictureSheet& on, const Color& wall, double foot, double least, double most, bool lit) {
  const Color light{0.98, 0.84, 0.50};
  for (double x = 0.02; x < 0.96;) {
    const double wide = p.random(0.07, 0.12), top = foot + p.random(least, most), end = std::min(x + wide, 0.98);
    on.bar(wall, x, end, foot, top);
    const int roof = p.pick(4);
    if (roof == 0) on.paint(wall, {{x, top}, {end, top}, {(x + end) / 2, top + 0.09}});
    if (roof == 1) on.bar(wall, (x + end) / 2 - 0.006, (x + end) / 2 + 0.006, top, top + 0.1);
    for (double z = foot + 0.07; lit && z < top - 0.03; z += 0.05) {
      for (double at = x + 0.014; at < end - 0.024; at += 0.026) {
        if (p.pick(5) < 2) on.bar(light, at, at + 0.013, z, z + 0.022);
      }
    }
    x = end + p.random(-0.01, 0.006);
  }
}

void city(Piece& p, PictureSheet& on) {
  const bool night = p.says("night") || p.says("neon") || p.turn(2) == 0;
  const Color sky = night ? Color{0.15, 0.19, 0.36} : Color{0.94, 0.72, 0.56},
              glow = night ? Color{0.44, 0.33, 0.52} : Color{0.98, 0.88, 0.72};
  const Color wall = night ? Color{0.08, 0.10, 0.19} : Color{0.33, 0.29, 0.42};
  on.fill(sky);
  on.bar(mixed(sky, glow, 0.5), 0, 1, 0, 0.72);
  on.bar(glow, 0, 1, 0, 0.5);
  on.disc({0.98, 0.94, 0.82}, {p.random(0.2, 0.8), 0.8}, 0.08);
  towers(p, on, mixed(wall, glow, 0.5), 0.2, 0.25, 0.55, false);
  towers(p, on, wall, 0.2, 0.12, 0.42, true);
  on.bar(mixed(wall, sky, 0.5), 0, 1, 0, 0.2);  // the river
  for (int i = 0; i < 14; ++i) {
    const double x = p.random(0.04, 0.86), z = p.random(0.03, 0.17);
    on.bar(mixed({0.98, 0.84, 0.50}, glow, 0.4), x, x + p.random(0.03, 0.1), z, z + 0.008);
  }
}

void stars(Piece& p, PictureSheet& on, int many) {
  for (int i = 0; i < many; ++i) on.disc({0.98, 0.96, 0.86}, {p.random(0.05, 0.95), p.random(0.05, 0.95)}, p.random(0.004, 0.012));
}

// A globe with bands, and a shadow along one side.
void globe(PictureSheet& on, const Color& color, const Color& bands) {
  on.round(color, {0, 0}, 0.5, 0.5);
  for (const double z : {-0.26, 0.02, 0.28}) {
    const double half = std::sqrt(0.24 - z * z), lower = std::sqrt(0.24 - (z - 0.08) * (z - 0.08));
    on.figure(bands, {{-lower, z - 0.08}, {lower, z - 0.08}, {half, z}, {-half, z}});
  }
  std::vector<Vec2> shadow;
  for (int i = 0; i <= 14; ++i) shadow.push_back({0.5 * std::sin(kPi * i / 14), -0.5 * std::cos(kPi * i / 14)});
  for (int i = 13; i > 0; --i) shadow.push_back({0.28 * std::sin(kPi * i / 14), -0.5 * std::cos(kPi * i / 14)});
  on.figure(mixed(color, kNight, 0.45), shadow);
}

// Half of a ring round a globe: the one behind it, or the one before.
std::vector<Vec2> half_ring(bool before) {
  std::vector<Vec2> ring;
  const double from = before ? kPi : 0;
  const auto at = [](double a, double r) {
    return Vec2{r * std::cos(a) + 0.12 * r * std::sin(a), 0.22 * r * std::sin(a) + 0.26 * r * std::cos(a)};
  };
  for (int i = 0; i <= 20; ++i) ring.push_back(at(from + kPi * i / 20, 0.95));
  for (int i = 20; i >= 0; --i) ring.push_back(at(from + kPi * i / 20, 0.7));
  return ring;
}

void planets(Piece& p, PictureSheet& on) {
  constexpr Color kGlobes[] = {{0.88, 0.66, 0.42}, {0.46, 0.62, 0.80}, {0.82, 0.46, 0.38}, {0.58, 0.48, 0.72}, {0.40, 0.66, 0.62}};
  const int first = p.turn(5);
  on.fill(kNight);
  on.paint({0.15, 0.18, 0.34}, {{0, 0.2}, {1, 0.62}, {1, 0.95}, {0, 0.5}});
  stars(p, on, 26);
  const bool left = p.pick(2) == 0;
  on.stand_at({left ? 0.44 : 0.56, 0.54}, left ? 0.8 : -0.8);
  on.figure({0.86, 0.78, 0.62}, half_ring(false));
  globe(on, kGlobes[first], mixed(kGlobes[first], kWhite, 0.3));
  on.figure({0.93, 0.86, 0.70}, half_ring(true));
  on.stand_at({left ? 0.84 : 0.16, 0.82}, 0.28);
  globe(on, kGlobes[(first + 1) % 5], mixed(kGlobes[(first + 1) % 5], kWhite, 0.2));
  on.stand_at({left ? 0.16 : 0.84, 0.17}, 0.38);
  globe(on, kGlobes[(first + 2) % 5], mixed(kGlobes[(first + 2) % 5], kDark, 0.2));
}

void castle(Piece& p, PictureSheet& on) {
  const Color stone{0.66, 0.64, 0.68}, shade{0.54, 0.52, 0.58}, roof = p.turn(2) == 0 ? Color{0.74, 0.36, 0.40} : Color{0.36, 0.42, 0.62};
  on.fill({0.78, 0.86, 0.94});
  on.bar({0.92, 0.90, 0.88}, 0, 1, 0, 0.5);
  on.paint({0.56, 0.68, 0.52}, rolling(0.3, 0.05, 0.8, p.random(0, 6)));
  on.stand_at({0.5, 0.26}, 0.95);
  for (const double x : {-0.5, 0.5, -0.16, 0.2}) {
    const bool tall = std::abs(x) < 0.4;
    const double half = tall ? 0.11 : 0.14, top = tall ? (x > 0 ? 0.92 : 0.76) : 0.56;
    on.block(tall ? shade : stone, x - half, x + half, -0.2, top);
    on.figure(roof, {{x - half - 0.05, top}, {x + half + 0.05, top}, {x, top + 0.36}});
    on.block(kDark, x - 0.03, x + 0.03, top - 0.2, top - 0.08);
  }
  on.block(stone, -0.5, 0.5, -0.2, 0.34);
  for (double x = -0.36; x < 0.34; x += 0.14) on.block(stone, x, x + 0.08, 0.34, 0.41);
  on.figure(kDark, smooth({{-0.11, -0.05}, {0.11, -0.05}, {0.11, 0.14}, {0, 0.25}, {-0.11, 0.14}}, 3));
  on.paint({0.42, 0.56, 0.40}, rolling(0.2, 0.05, 0.7, p.random(0, 6)));
}

// A shield in four quarters, with a band across or a cross.
void arms(Piece& p, PictureSheet& on) {
  constexpr Color kTinctures[] = {{0.62, 0.14, 0.14}, {0.16, 0.26, 0.48}, {0.18, 0.38, 0.26}, {0.34, 0.16, 0.36}};
  const Color first = kTinctures[p.turn(4)], gold{0.86, 0.68, 0.30};
  on.fill(mixed(first, kDark, 0.35));
  for (const double x : {0.05, 0.93}) on.bar(gold, x, x + 0.02, 0, 1);
  on.stand_at({0.5, 0.52}, 0.8);
  const std::vector<Vec2> shield{{-0.7, 0.8}, {0.7, 0.8},     {0.7, 0.1},   {0.6, -0.3}, {0.36, -0.68},
                                 {0, -0.92},  {-0.36, -0.68}, {-0.6, -0.3}, {-0.7, 0.1}};
  on.figure(gold, shield);
  on.figure(
      kCream,
      {{-0.63, 0.73}, {0.63, 0.73}, {0.63, 0.1}, {0.54, -0.27}, {0.32, -0.62}, {0, -0.83}, {-0.32, -0.62}, {-0.54, -0.27}, {-0.63, 0.1}});
  on.figure(first, {{-0.63, 0.73}, {0, 0.73}, {0, 0.05}, {-0.63, 0.05}});
  on.figure(first, {{0, 0.05}, {0.625, 0.05}, {0.54, -0.27}, {0.32, -0.62}, {0, -0.83}});
  if (p.pick(2) == 0) {
    on.block(gold, -0.09, 0.09, -0.7, 0.73);
    on.block(gold, -0.63, 0.63, -0.04, 0.14);
  } else {
    on.figure(gold, {{-0.63, 0.73}, {-0.42, 0.73}, {0.47, -0.4}, {0.37, -0.55}, {-0.63, 0.52}});
  }
}

}  // namespace

void add_travels(Drawings& to) { to.insert({{"city", city}, {"planets", planets}, {"castle", castle}, {"arms", arms}}); }

}  // namespace layoutbox::kit::pictures
