// Land, sea and towns.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/picture_sheet.h"

namespace layoutbox::kit::pictures {
namespace {

// What light a scene lies in: from sky to foreground.
struct Hour {
  Color sky, glow, sun, far, near, deep;
};
constexpr Hour kHours[] = {
    {{0.68, 0.82, 0.90}, {0.90, 0.93, 0.92}, {0.99, 0.95, 0.82}, {0.56, 0.68, 0.76}, {0.36, 0.50, 0.56}, {0.18, 0.31, 0.33}},  // day
    {{0.93, 0.70, 0.52}, {0.98, 0.86, 0.66}, {0.99, 0.94, 0.80}, {0.74, 0.54, 0.54}, {0.50, 0.38, 0.46}, {0.27, 0.23, 0.33}},  // evening
    {{0.80, 0.80, 0.88}, {0.95, 0.86, 0.84}, {0.98, 0.93, 0.88}, {0.62, 0.64, 0.76}, {0.42, 0.48, 0.60}, {0.22, 0.29, 0.38}},  // morning
    {{0.20, 0.27, 0.42}, {0.34, 0.42, 0.56}, {0.95, 0.94, 0.86}, {0.28, 0.36, 0.50}, {0.18, 0.26, 0.38}, {0.09, 0.14, 0.22}},  // night
};
constexpr Color kSand{0.90, 0.80, 0.62}, kTrunk{0.36, 0.27, 0.22}, kLeaf{0.34, 0.50, 0.34};

Hour an_hour(Piece& p) { return kHours[p.says("night") || p.says("moonlit") ? 3 : p.says("sunset") ? 1 : p.turn(3)]; }

// The sky, paler towards the horizon, and its sun.
void sky(Piece& p, PictureSheet& on, const Hour& hour, double horizon) {
  on.fill(hour.sky);
  on.bar(mixed(hour.sky, hour.glow, 0.5), 0, 1, 0, horizon + (1 - horizon) * 0.62);
  on.bar(hour.glow, 0, 1, 0, horizon + (1 - horizon) * 0.3);
  on.disc(hour.sun, {p.random(0.22, 0.78), horizon + (1 - horizon) * p.random(0.42, 0.66)}, p.random(0.07, 0.1));
}

// A mountain with snow on the side of its summit.
void peak(PictureSheet& on, Vec2 top, double half, double foot, const Color& rock, const Color& shade) {
  const double high = top.y - foot, snow = 0.32;
  on.paint(rock, {{top.x - half, foot}, {top.x + half, foot}, top});
  on.paint(shade, {{top.x + half * 0.1, foot},
                   {top.x + half, foot},
                   top,
                   {top.x - half * 0.06, top.y - high * 0.4},
                   {top.x + half * 0.16, top.y - high * 0.62}});
  on.paint(kWhite, {{top.x - half * snow, top.y - high * snow},
                    {top.x - half * 0.16, top.y - high * 0.24},
                    {top.x - half * 0.04, top.y - high * 0.36},
                    {top.x + half * 0.12, top.y - high * 0.22},
                    {top.x + half * snow * 0.92, top.y - high * snow * 0.92},
                    top});
}

void pine(PictureSheet& on, const Color& color, Vec2 foot, double high) {
  on.stand_at(foot, high);
  on.block(color, -0.05, 0.05, 0, 0.25);
  on.figure(color, {{-0.42, 0.18},
                    {0.42, 0.18},
                    {0.22, 0.55},
                    {0.3, 0.55},
                    {0.14, 0.95},
                    {0.2, 0.95},
                    {0, 1.5},
                    {-0.2, 0.95},
                    {-0.14, 0.95},
                    {-0.3, 0.55},
                    {-0.22, 0.55}});
}

void mountains(Piece& p, PictureSheet& on) {
  const Hour hour = an_hour(p);
  const double lean = p.random(-0.12, 0.12);
  sky(p, on, hour, 0.36);
  on.paint(mixed(hour.far, hour.glow, 0.45),
           {{0, 0.3}, {1, 0.3}, {1, 0.52}, {0.86, 0.6}, {0.7, 0.5}, {0.5, 0.62}, {0.3, 0.5}, {0.12, 0.6}, {0, 0.5}});
  peak(on, {0.26 - lean, p.random(0.62, 0.7)}, 0.3, 0.28, hour.far, mixed(hour.far, hour.near, 0.5));
  peak(on, {0.64 + lean, p.random(0.74, 0.84)}, 0.4, 0.26, mixed(hour.far, hour.near, 0.35), mixed(hour.near, hour.far, 0.2));
  if (p.pick(2) == 0) {  // a lake
    on.bar(mixed(hour.sky, hour.near, 0.3), 0, 1, 0, 0.27);
    for (int i = 0; i < 4; ++i) {
      const double x = p.random(0.1, 0.6), z = 0.21 - 0.045 * i;
      on.bar(hour.glow, x, x + p.random(0.12, 0.3), z, z + 0.008);
    }
  } else {
    on.paint(mixed(hour.near, kLeaf, 0.3), rolling(0.24, 0.03, 1.2, p.random(0, 6)));
  }
  on.paint(hour.deep, rolling(0.08, 0.025, 0.9, p.random(0, 6)));
  for (const double x : {0.08, 0.2, 0.83, 0.93}) pine(on, hour.deep, {x, 0.05}, p.random(0.22, 0.36));
}

void landscape(Piece& p, PictureSheet& on) {
  const Hour hour = kHours[p.turn(3)];
  sky(p, on, hour, 0.45);
  const Color field{0.62, 0.68, 0.40}, wheat{0.86, 0.74, 0.42};
  on.paint(mixed(hour.far, kLeaf, 0.25), rolling(0.5, 0.05, 0.8, p.random(0, 6)));
  on.paint(mixed(field, hour.near, 0.25), rolling(0.36, 0.05, 0.7, p.random(0, 6)));
  on.paint(mixed(wheat, hour.glow, 0.15), rolling(0.2, 0.04, 0.6, p.random(0, 6)));
  const double at = p.pick(2) == 0 ? 0.26 : 0.72;
  const double road = 1 - at;
  on.paint(mixed(kSand, hour.glow, 0.4), {{road - 0.16, 0},
                                          {road + 0.1, 0},
                                          {road + 0.06, 0.1},
                                          {road + 0.085, 0.2},
                                          {road + 0.04, 0.3},
                                          {road + 0.025, 0.3},
                                          {road + 0.02, 0.2},
                                          {road - 0.06, 0.1}});
  on.stand_at({at, 0.22}, 1);
  on.stroke(kTrunk, {{0, -0.06}, {0.02, 0.2}, {0, 0.45}}, 0.07, 0.03);
  for (const Vec2 q : {Vec2{-0.17, 0.5}, Vec2{0.17, 0.48}, Vec2{0, 0.66}}) on.round(mixed(kLeaf, hour.deep, 0.25), q, 0.23, 0.2);
  on.round(mixed(kLeaf, hour.glow, 0.15), {-0.06, 0.62}, 0.15, 0.12);
}

void forest(Piece& p, PictureSheet& on) {
  const Hour hour = kHours[p.turn(3)];
  const bool birches = p.says("birch") || (!p.says("pine") && p.pick(2) == 0);
  sky(p, on, hour, 0.3);
  const Color green = mixed(kLeaf, hour.deep, 0.4);
  for (int row = 0; row < (birches ? 1 : 3); ++row) {
    const Color shade = mixed(mixed(green, hour.glow, 0.6), green, row / 2.0);
    on.paint(shade, rolling(0.3 - 0.1 * row, 0.02, 1.4, p.random(0, 6)));
    for (int i = 0; i < 7 - row; ++i)
      pine(on, shade, {(i + p.random(0.2, 0.8)) / (7 - row), 0.22 - 0.1 * row}, p.random(0.45, 0.6) + 0.1 * row);
  }
  if (!birches) return;
  on.paint(mixed(green, kSand, 0.4), rolling(0.14, 0.02, 1, p.random(0, 6)));
  for (int i = 0; i < 5; ++i) {
    const double x = (i + p.random(0.25, 0.75)) / 5, half = p.random(0.018, 0.03), lean = p.random(-0.03, 0.03);
    on.paint(kWhite, {{x - half, p.random(0.04, 0.1)}, {x + half, 0.08}, {x + lean + half * 0.7, 1}, {x + lean - half * 0.7, 1}});
    for (int k = 0; k < 5; ++k) {
      const double z = 0.14 + 0.16 * k + p.random(0, 0.1), middle = x + lean * z;
      on.bar(kDark, middle - half * 0.8, middle + half * p.random(-0.4, 0.5), z, z + 0.012);
    }
  }
}

// Water from `level` down, with the light of the sun on it.
void water(Piece& p, PictureSheet& on, const Hour& hour, double level) {
  const Color sea = mixed({0.24, 0.48, 0.60}, hour.near, 0.35);
  on.bar(mixed(sea, hour.glow, 0.35), 0, 1, 0, level);
  on.paint(mixed(sea, hour.glow, 0.12), rolling(level * 0.72, 0.012, 2.5, p.random(0, 6)));
  on.paint(sea, rolling(level * 0.44, 0.018, 2, p.random(0, 6)));
  for (int i = 0; i < 6; ++i) {
    const double x = p.random(0.05, 0.75), z = level * (0.9 - 0.13 * i);
    on.bar(hour.glow, x, x + p.random(0.06, 0.2), z, z + 0.007);
  }
}

void sea(Piece& p, PictureSheet& on) {
  const Hour hour = an_hour(p);
  const double level = p.random(0.42, 0.5);
  sky(p, on, hour, level);
  water(p, on, hour, level);
  if (p.pick(2) == 0) {  // a sail
    on.stand_at({p.random(0.25, 0.75), level - 0.05}, p.pick(2) == 0 ? 0.5 : -0.5);
    on.figure(kWhite, {{0.05, 0.14}, {0.46, 0.14}, {0.05, 0.95}});
    on.figure(mixed(kWhite, hour.far, 0.3), {{-0.02, 0.14}, {-0.34, 0.14}, {-0.02, 0.8}});
    on.figure(mixed(kTrunk, hour.near, 0.3), {{-0.34, 0}, {0.36, 0}, {0.5, 0.12}, {-0.46, 0.12}});
  } else {  // breakers on a shore
    on.paint(kWhite, rolling(0.15, 0.03, 0.8, p.random(0, 6)));
    on.paint(kSand, rolling(0.1, 0.03, 0.7, p.random(0, 6)));
  }
}

void beach(Piece& p, PictureSheet& on) {
  const Hour hour = kHours[p.turn(2)];
  sky(p, on, hour, 0.46);
  water(p, on, hour, 0.46);
  const double side = p.pick(2) == 0 ? 1 : -1;
  const auto across = [side](double x) { return side > 0 ? x : 1 - x; };
  on.paint(kWhite, {{across(0), 0}, {across(1), 0}, {across(1), 0.06}, {across(0.66), 0.15}, {across(0.34), 0.21}, {across(0), 0.36}});
  on.paint(kSand, {{across(0), 0}, {across(1), 0}, {across(0.62), 0.13}, {across(0.32), 0.185}, {across(0), 0.33}});
  on.stand_at({across(0.2), 0.18}, side * 1.15);
  on.stroke(kTrunk, {{-0.1, -0.1}, {0, 0.35}, {0.2, 0.85}}, 0.08, 0.05);
  for (const Vec2 tip : {Vec2{-0.3, 0.7}, Vec2{-0.2, 1.05}, Vec2{0.2, 1.18}, Vec2{0.56, 1.06}, Vec2{0.68, 0.72}, Vec2{0.38, 0.5}})
    on.stroke(mixed(kLeaf, hour.deep, 0.2), {{0.2, 0.86}, {(tip.x + 0.2) / 2, (tip.y + 0.86) / 2 + 0.1}, tip}, 0.13, 0.01);
}

void ship(Piece& p, PictureSheet& on) {
  const Hour hour = an_hour(p);
  sky(p, on, hour, 0.34);
  water(p, on, hour, 0.34);
  const Color hull = mixed(kTrunk, {0.46, 0.26, 0.18}, 0.4), cloth{0.95, 0.91, 0.80};
  on.stand_at({0.5, 0.27}, p.pick(2) == 0 ? 0.92 : -0.92);
  for (const double x : {-0.42, 0.02, 0.42}) {
    const double high = x == 0.02 ? 1.28 : 1.06;
    on.stroke(kTrunk, {{x, 0.15}, {x, high}}, 0.03);
    for (int k = 0; k < 3; ++k) {
      const double z = 0.3 + (high - 0.36) / 3 * k, tall = (high - 0.36) / 3 - 0.04, half = 0.22 - 0.045 * k;
      on.figure(mixed(cloth, hour.glow, 0.25 * k), smooth({{x - half, z},
                                                           {x, z + 0.03},
                                                           {x + half, z},
                                                           {x + half * 0.96, z + tall / 2},
                                                           {x + half * 0.8, z + tall},
                                                           {x - half * 0.8, z + tall},
                                                           {x - half * 0.76, z + tall / 2}},
                                                          3));
    }
    on.figure({0.72, 0.24, 0.20}, {{x, high}, {x + 0.16, high - 0.05}, {x, high - 0.1}});
  }
  on.stroke(kTrunk, {{0.6, 0.2}, {0.95, 0.42}}, 0.03, 0.015);
  on.figure(
      hull,
      {{-0.62, -0.06}, {0.5, -0.06}, {0.66, 0.08}, {0.74, 0.24}, {0.4, 0.16}, {-0.36, 0.16}, {-0.42, 0.28}, {-0.76, 0.3}, {-0.72, 0.1}});
  on.figure({0.86, 0.72, 0.44}, {{-0.71, 0.1}, {0.68, 0.1}, {0.7, 0.135}, {-0.72, 0.135}});
  on.paint(mixed({0.24, 0.48, 0.60}, hour.near, 0.5), rolling(0.24, 0.014, 3, p.random(0, 6)));
}

}  // namespace

void add_scenery(Drawings& to) {
  to.insert({{"mountains", mountains}, {"landscape", landscape}, {"forest", forest}, {"sea", sea}, {"beach", beach}, {"ship", ship}});
}

}  // namespace layoutbox::kit::pictures
