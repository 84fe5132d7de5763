// Wild animals, and those that are no more.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/picture_sheet.h"

namespace layoutbox::kit::pictures {
namespace {

constexpr Color kHides[] = {{0.27, 0.52, 0.33}, {0.20, 0.47, 0.52}, {0.76, 0.42, 0.26}, {0.47, 0.38, 0.60}};

// A plain with hills and a sun, or a mountain that smokes.
void wilderness(Piece& p, PictureSheet& on, bool volcano) {
  const Color sky = mixed(kGay[p.pick(2)], kCream, 0.65);
  on.fill(sky);
  on.disc({0.98, 0.86, 0.56}, {p.pick(2) == 0 ? 0.2 : 0.8, 0.8}, 0.1);
  if (volcano) {
    on.stand_at({p.pick(2) == 0 ? 0.24 : 0.76, 0.28}, 1);
    const Color rock{0.56, 0.46, 0.44};
    for (const Vec2 q : {Vec2{0.02, 0.78}, Vec2{0.1, 0.9}, Vec2{0.2, 1.0}})
      on.round(mixed(sky, kDark, 0.18), q, 0.1 + q.x * 0.3, 0.1 + q.x * 0.2);
    on.figure(rock, {{-0.6, 0}, {0.6, 0}, {0.12, 0.7}, {-0.12, 0.7}});
    on.figure({0.86, 0.40, 0.28}, {{-0.12, 0.7}, {-0.16, 0.6}, {-0.05, 0.64}, {0.0, 0.48}, {0.07, 0.62}, {0.16, 0.58}, {0.12, 0.7}});
  }
  on.paint({0.82, 0.80, 0.58}, rolling(0.3, 0.03, 0.8, p.random(0, 6)));
  on.paint({0.70, 0.72, 0.48}, rolling(0.18, 0.02, 0.7, p.random(0, 6)));
}

void long_neck(PictureSheet& on, const Color& hide) {
  const Color far = mixed(hide, kDark, 0.25);
  for (const double x : {-0.12, 0.32}) on.figure(far, {{x - 0.09, 0}, {x + 0.07, 0}, {x + 0.1, 0.45}, {x - 0.1, 0.45}});
  on.figure(hide, smooth({{-0.82, 1.16},
                          {-0.72, 1.28},
                          {-0.54, 1.28},
                          {-0.44, 1.12},
                          {-0.38, 0.82},
                          {-0.16, 0.68},
                          {0.1, 0.72},
                          {0.4, 0.6},
                          {0.66, 0.36},
                          {1.0, 0.2},
                          {0.66, 0.24},
                          {0.44, 0.26},
                          {0.1, 0.24},
                          {-0.26, 0.26},
                          {-0.46, 0.46},
                          {-0.58, 0.8},
                          {-0.62, 1.06},
                          {-0.74, 1.08}}));
  for (const double x : {-0.24, 0.2}) on.figure(hide, {{x - 0.09, 0}, {x + 0.09, 0}, {x + 0.13, 0.4}, {x - 0.12, 0.4}});
  for (const Vec2 q : {Vec2{-0.1, 0.58}, Vec2{0.1, 0.6}, Vec2{0.28, 0.52}, Vec2{-0.4, 0.68}})
    on.round(mixed(hide, kCream, 0.45), q, 0.055, 0.045);
  on.round(kDark, {-0.64, 1.19}, 0.025, 0.03);
  on.stroke(kDark, {{-0.8, 1.13}, {-0.72, 1.12}}, 0.015);
}

void tyrant(PictureSheet& on, const Color& hide) {
  const Color far = mixed(hide, kDark, 0.25);
  on.figure(far, smooth({{0.1, 0.5}, {0.34, 0.46}, {0.36, 0.24}, {0.3, 0.02}, {0.14, 0.0}, {0.2, 0.2}}, 4));
  on.figure(hide, smooth({{-0.78, 1.04},
                          {-0.74, 1.2},
                          {-0.5, 1.3},
                          {-0.28, 1.22},
                          {-0.16, 0.98},
                          {0.06, 0.78},
                          {0.36, 0.6},
                          {0.66, 0.5},
                          {1.0, 0.62},
                          {0.7, 0.34},
                          {0.3, 0.26},
                          {0.0, 0.32},
                          {-0.2, 0.5},
                          {-0.3, 0.8},
                          {-0.4, 0.93}}));
  on.figure(hide, {{-0.42, 0.98}, {-0.74, 0.9}, {-0.7, 0.84}, {-0.3, 0.84}});
  for (double x = -0.72; x < -0.46; x += 0.075) on.figure(kWhite, {{x, 1.04}, {x + 0.06, 1.04}, {x + 0.03, 0.97}});
  on.figure(mixed(hide, kCream, 0.5), smooth({{-0.22, 0.72}, {-0.06, 0.4}, {-0.2, 0.48}, {-0.3, 0.7}}, 4));
  on.stroke(far, {{-0.2, 0.66}, {-0.36, 0.58}, {-0.4, 0.66}}, 0.06, 0.035);
  on.figure(hide, smooth({{-0.1, 0.5}, {0.2, 0.52}, {0.22, 0.26}, {0.1, 0.1}, {0.06, 0.0}, {-0.2, 0.0}, {-0.06, 0.1}, {0.0, 0.24}}, 4));
  on.round(kWhite, {-0.5, 1.18}, 0.05, 0.05);
  on.round(kDark, {-0.52, 1.18}, 0.028, 0.028);
}

void dinosaur(Piece& p, PictureSheet& on) {
  const Color hide = kHides[p.turn(4)];
  wilderness(p, on, true);
  on.stand_at({0.5, 0.13}, p.pick(2) == 0 ? 0.95 : -0.95);
  p.turn(2) == 0 ? long_neck(on, hide) : tyrant(on, hide);
  for (const double x : {0.07, 0.95}) {
    on.stand_at({x, 0.05}, 0.6);
    for (const double s : {-0.5, -0.2, 0.2, 0.5}) on.stroke({0.32, 0.46, 0.32}, {{0, 0}, {s * 0.5, 0.4}, {s, 0.5}}, 0.07, 0.01);
  }
}

void elephant(Piece& p, PictureSheet& on) {
  const Color hide{0.58, 0.60, 0.64}, shade = mixed(hide, kDark, 0.25);
  wilderness(p, on, false);
  on.stand_at({0.5, 0.12}, p.pick(2) == 0 ? 0.95 : -0.95);
  for (const double x : {-0.06, 0.42}) on.block(shade, x, x + 0.17, 0, 0.5);
  on.stroke(shade, {{0.62, 0.76}, {0.74, 0.6}, {0.72, 0.4}}, 0.04, 0.03);
  on.figure(hide, smooth({{-0.36, 0.42}, {-0.4, 0.8}, {-0.1, 1.04}, {0.36, 1.02}, {0.64, 0.8}, {0.64, 0.46}, {0.3, 0.32}, {-0.1, 0.32}}));
  for (const double x : {-0.28, 0.26}) on.block(hide, x, x + 0.18, 0, 0.5);
  on.stroke(hide, {{-0.5, 0.86}, {-0.72, 0.6}, {-0.74, 0.28}, {-0.86, 0.2}}, 0.24, 0.09);
  on.round(hide, {-0.44, 0.92}, 0.28, 0.27);
  on.figure(kWhite, smooth({{-0.6, 0.74}, {-0.72, 0.58}, {-0.9, 0.56}, {-0.72, 0.5}, {-0.54, 0.64}}, 3));
  on.figure(shade, smooth({{-0.34, 1.1}, {-0.06, 1.1}, {0.02, 0.84}, {-0.12, 0.56}, {-0.26, 0.62}, {-0.34, 0.82}}));
  on.round(kDark, {-0.53, 0.96}, 0.03, 0.03);
}

void lion(Piece& p, PictureSheet& on) {
  const bool tiger = p.says("tiger");
  const Color fur = tiger ? Color{0.90, 0.56, 0.24} : Color{0.88, 0.68, 0.40}, mane{0.58, 0.34, 0.20}, pale = mixed(fur, kWhite, 0.65);
  on.fill(mixed(kGay[p.pick(5)], kCream, p.random(0.5, 0.75)));
  on.stand_at({0.5, 0.5}, on.larger(tiger ? 1.3 : 0.92));
  if (!tiger) {
    for (int i = 0; i < 12; ++i)
      on.round(i % 2 == 0 ? mane : mixed(mane, fur, 0.25), {0.56 * std::cos(kPi * i / 6), 0.56 * std::sin(kPi * i / 6)}, 0.26, 0.26);
  }
  for (const double s : {-1.0, 1.0}) {
    on.round(fur, {0.38 * s, 0.44}, 0.16, 0.16);
    on.round(mixed(fur, kDark, 0.4), {0.38 * s, 0.44}, 0.08, 0.08);
  }
  on.round(fur, {0, 0}, 0.52, 0.52);
  for (const double s : {-1.0, 1.0}) {
    on.round(pale, {0.13 * s, -0.24}, 0.17, 0.15);
    on.round(kWhite, {0.2 * s, 0.1}, 0.09, 0.075);
    on.round(kDark, {0.2 * s, 0.1}, 0.045, 0.055);
    for (const double z : {-0.12, 0.02, 0.16}) {
      if (tiger) on.figure(kDark, {{0.51 * s, z}, {0.48 * s, z + 0.08}, {0.3 * s, z - 0.02}});
    }
  }
  if (tiger) on.figure(kDark, {{-0.04, 0.5}, {0.04, 0.5}, {0, 0.26}});
  on.figure(mixed(fur, kDark, 0.15), {{-0.07, 0.16}, {0.07, 0.16}, {0.1, -0.1}, {-0.1, -0.1}});
  on.figure(kDark, smooth({{-0.12, -0.08}, {0.12, -0.08}, {0, -0.2}}, 4));
  on.stroke(kDark, {{-0.17, -0.26}, {0, -0.33}, {0.17, -0.26}}, 0.025);
}

// A stag's head.
void deer(Piece& p, PictureSheet& on) {
  const Color hide{0.60, 0.42, 0.28}, horn{0.40, 0.30, 0.22};
  on.fill(mixed(Color{0.40, 0.52, 0.44}, kCream, p.random(0.4, 0.8)));
  on.stand_at({0.5, 0.36}, on.larger(0.9));
  for (const double s : {-1.0, 1.0}) {
    on.stroke(horn, {{0.1 * s, 0.4}, {0.36 * s, 0.66}, {0.42 * s, 0.92}, {0.3 * s, 1.16}}, 0.075, 0.03);
    on.stroke(horn, {{0.34 * s, 0.64}, {0.56 * s, 0.76}, {0.62 * s, 0.96}}, 0.055, 0.02);
    on.stroke(horn, {{0.4 * s, 0.88}, {0.6 * s, 1.06}, {0.6 * s, 1.22}}, 0.05, 0.02);
    on.stroke(horn, {{0.22 * s, 0.52}, {0.2 * s, 0.78}}, 0.05, 0.02);
  }
  on.figure(mixed(hide, kDark, 0.15), smooth({{-0.5, -1.3}, {0.5, -1.3}, {0.26, -0.2}, {0.18, 0.1}, {-0.18, 0.1}, {-0.26, -0.2}}, 4));
  on.figure(mixed(hide, kCream, 0.6), smooth({{-0.2, -1.3}, {0.2, -1.3}, {0.12, -0.3}, {-0.12, -0.3}}, 4));
  for (const double s : {-1.0, 1.0})
    on.figure(hide, smooth({{0.16 * s, 0.34}, {0.38 * s, 0.46}, {0.58 * s, 0.4}, {0.4 * s, 0.28}, {0.2 * s, 0.24}}, 4));
  on.figure(hide, smooth({{-0.2, 0.38},
                          {0, 0.46},
                          {0.2, 0.38},
                          {0.21, 0.14},
                          {0.12, -0.14},
                          {0.09, -0.34},
                          {0, -0.4},
                          {-0.09, -0.34},
                          {-0.12, -0.14},
                          {-0.21, 0.14}}));
  for (const double s : {-1.0, 1.0}) on.round(kDark, {0.145 * s, 0.16}, 0.035, 0.045);
  on.round(kDark, {0, -0.31}, 0.075, 0.055);
}

}  // namespace

void add_wild_animals(Drawings& to) { to.insert({{"dinosaur", dinosaur}, {"elephant", elephant}, {"lion", lion}, {"deer", deer}}); }

}  // namespace layoutbox::kit::pictures
