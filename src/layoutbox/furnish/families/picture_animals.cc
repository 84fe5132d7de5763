// Animals of house and garden.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/picture_sheet.h"

namespace layoutbox::kit::pictures {
namespace {

constexpr Color kCoats[] = {{0.62, 0.42, 0.28}, {0.30, 0.26, 0.26}, {0.82, 0.60, 0.36}, {0.60, 0.58, 0.56}, {0.92, 0.88, 0.82}};

Color ground_of(Piece& p) { return mixed(kGay[p.pick(5)], kCream, p.random(0.5, 0.75)); }

void horse(Piece& p, PictureSheet& on) {
  const Color coat = kCoats[p.turn(4)], mane = mixed(coat, kDark, 0.6), shade = mixed(coat, kDark, 0.2);
  on.fill(ground_of(p));
  on.disc(mixed(kCream, kWhite, 0.3), {0.5, 0.55}, 0.4);
  on.stand_at({0.5, 0.46}, p.pick(2) == 0 ? 0.95 : -0.95);
  on.figure(mane, smooth({{0.1, 0.72}, {0.4, 0.62}, {0.62, 0.2}, {0.74, -0.4}, {0.74, -0.9}, {0.36, -0.9}, {0.26, 0.0}}));
  on.figure(coat, smooth({{0.2, 0.66},
                          {0.06, 0.66},
                          {-0.1, 0.5},
                          {-0.34, 0.1},
                          {-0.56, -0.12},
                          {-0.6, -0.28},
                          {-0.48, -0.38},
                          {-0.32, -0.34},
                          {-0.08, -0.14},
                          {0.04, -0.2},
                          {0.0, -0.5},
                          {-0.16, -0.92},
                          {0.6, -0.92},
                          {0.56, -0.3},
                          {0.46, 0.3}}));
  on.figure(coat, {{0.02, 0.6}, {0.0, 0.88}, {0.14, 0.64}});
  on.figure(shade, {{0.12, 0.62}, {0.16, 0.9}, {0.25, 0.62}});
  on.figure(mane, smooth({{0.1, 0.74}, {0.0, 0.62}, {-0.12, 0.36}, {0.0, 0.46}, {0.1, 0.56}, {0.2, 0.66}}));
  on.round(kDark, {-0.1, 0.32}, 0.035, 0.04);
  on.round(mixed(coat, kDark, 0.7), {-0.52, -0.2}, 0.025, 0.035);
  on.stroke(mixed(coat, kDark, 0.5), {{-0.52, -0.32}, {-0.42, -0.28}}, 0.018);
  if (coat.r < 0.5) on.figure(kWhite, smooth({{-0.12, 0.44}, {-0.21, 0.3}, {-0.44, -0.02}, {-0.36, -0.08}, {-0.18, 0.14}}));
}

// A cat that sits, seen from before.
void cat(Piece& p, PictureSheet& on) {
  const Color fur = kCoats[p.turn(5)], pale = mixed(fur, kWhite, 0.55),
              eye = p.pick(2) == 0 ? Color{0.62, 0.72, 0.30} : Color{0.86, 0.66, 0.24};
  on.fill(ground_of(p));
  on.bar(mixed(kGay[p.pick(5)], kDark, 0.35), 0, 1, 0, 0.17);
  on.stand_at({0.5, 0.12}, (p.pick(2) == 0 ? 1 : -1) * on.larger(0.95));
  on.stroke(mixed(fur, kDark, 0.15), {{0.3, 0.1}, {0.62, 0.08}, {0.72, 0.36}, {0.6, 0.56}}, 0.12, 0.06);
  on.figure(fur, smooth({{-0.36, 0.02}, {0.36, 0.02}, {0.42, 0.3}, {0.28, 0.7}, {0.16, 0.95}, {-0.16, 0.95}, {-0.28, 0.7}, {-0.42, 0.3}}));
  on.round(pale, {0, 0.6}, 0.15, 0.25);
  for (const double s : {-1.0, 1.0}) {
    on.round(pale, {0.14 * s, 0.06}, 0.12, 0.07);
    on.figure(fur, {{0.1 * s, 1.3}, {0.3 * s, 1.58}, {0.33 * s, 1.18}});
    on.figure({0.86, 0.60, 0.58}, {{0.17 * s, 1.32}, {0.27 * s, 1.48}, {0.29 * s, 1.24}});
  }
  on.round(fur, {0, 1.13}, 0.34, 0.28);
  on.round(pale, {0, 1.02}, 0.15, 0.11);
  for (const double s : {-1.0, 1.0}) {
    on.round(eye, {0.14 * s, 1.17}, 0.065, 0.06);
    on.round(kDark, {0.14 * s, 1.17}, 0.025, 0.055);
    for (const double up : {-0.02, 0.05}) on.stroke(kWhite, {{0.12 * s, 1.03}, {0.44 * s, 1.02 + up * 1.4}}, 0.012);
  }
  on.figure({0.80, 0.48, 0.46}, {{-0.04, 1.08}, {0, 1.03}, {0.04, 1.08}});
}

// A dog's head.
void dog(Piece& p, PictureSheet& on) {
  const Color fur = kCoats[p.turn(5)], ear = mixed(fur, kDark, 0.35), pale = mixed(fur, kWhite, 0.6);
  on.fill(ground_of(p));
  on.stand_at({0.5, 0.5}, on.larger(0.9));
  on.figure(fur, smooth({{-0.6, -1.6}, {0.6, -1.6}, {0.36, -0.4}, {0.2, -0.1}, {-0.2, -0.1}, {-0.36, -0.4}}, 4));
  on.block(kGay[p.pick(3)], -0.35, 0.35, -0.52, -0.42);
  on.round({0.90, 0.74, 0.34}, {0, -0.56}, 0.07, 0.07);
  on.figure(fur,
            smooth({{-0.4, 0.3}, {-0.24, 0.62}, {0.24, 0.62}, {0.4, 0.3}, {0.34, -0.1}, {0.18, -0.36}, {-0.18, -0.36}, {-0.34, -0.1}}));
  on.figure(pale,
            smooth({{-0.06, 0.6}, {0.06, 0.6}, {0.08, 0.2}, {0.22, -0.08}, {0.16, -0.34}, {-0.16, -0.34}, {-0.22, -0.08}, {-0.08, 0.2}}));
  for (const double s : {-1.0, 1.0}) {
    on.figure(ear, smooth({{0.24 * s, 0.6}, {0.44 * s, 0.52}, {0.6 * s, 0.1}, {0.54 * s, -0.24}, {0.4 * s, -0.1}, {0.34 * s, 0.28}}));
    on.round(kDark, {0.19 * s, 0.2}, 0.055, 0.06);
    on.round(kWhite, {0.2 * s, 0.22}, 0.016, 0.016);
  }
  on.round(kDark, {0, -0.04}, 0.1, 0.07);
  on.stroke(kDark, {{-0.14, -0.15}, {0, -0.21}, {0.14, -0.15}}, 0.022);
}

// A bird on a twig.
void bird(Piece& p, PictureSheet& on) {
  constexpr Color kBirds[] = {{0.32, 0.50, 0.66}, {0.78, 0.38, 0.30}, {0.90, 0.72, 0.32}, {0.36, 0.56, 0.48}};
  const Color back = kBirds[p.turn(4)], belly = mixed(back, kCream, 0.7), twig{0.42, 0.32, 0.26};
  on.fill(mixed(kCream, kGay[p.pick(5)], 0.18));
  on.stand_at({0.5, 0.42}, p.pick(2) == 0 ? 0.95 : -0.95);
  on.stroke(twig, {{-1.1, -0.62}, {-0.3, -0.42}, {0.4, -0.46}, {1.0, -0.2}}, 0.07, 0.03);
  on.stroke(twig, {{0.3, -0.46}, {0.6, -0.7}}, 0.035, 0.015);
  for (const Vec2 q : {Vec2{-0.72, -0.36}, Vec2{0.72, -0.14}, Vec2{0.62, -0.74}, Vec2{0.94, -0.34}, Vec2{-0.5, -0.62}})
    on.round(mixed({0.46, 0.58, 0.38}, kCream, 0.2), q, 0.13, 0.07);
  for (const double x : {-0.04, 0.08}) on.stroke(kDark, {{x, -0.2}, {x + 0.02, -0.42}}, 0.02);
  on.figure(mixed(back, kDark, 0.25), smooth({{0.3, -0.08}, {0.74, -0.44}, {0.82, -0.36}, {0.5, 0.06}}, 3));
  on.figure(belly, smooth({{-0.4, 0.3},
                           {-0.34, 0.56},
                           {-0.12, 0.6},
                           {0.06, 0.42},
                           {0.4, 0.12},
                           {0.44, -0.1},
                           {0.2, -0.26},
                           {-0.14, -0.22},
                           {-0.36, 0.04}}));
  on.figure(back, smooth({{-0.42, 0.4}, {-0.3, 0.6}, {-0.1, 0.62}, {0.08, 0.44}, {0.46, 0.08}, {0.48, -0.1}, {0.1, 0.14}, {-0.14, 0.36}}));
  on.figure(mixed(back, kDark, 0.3), smooth({{-0.1, 0.24}, {0.2, 0.22}, {0.56, -0.16}, {0.2, -0.1}, {-0.06, 0.02}}));
  on.figure({0.90, 0.62, 0.24}, {{-0.4, 0.47}, {-0.6, 0.4}, {-0.4, 0.37}});
  on.round(kDark, {-0.26, 0.46}, 0.035, 0.035);
}

void fish(Piece& p, PictureSheet& on) {
  const Color water{0.34, 0.58, 0.66};
  on.fill(water);
  on.bar(mixed(water, kWhite, 0.25), 0, 1, 0.62, 1);
  on.paint({0.86, 0.78, 0.58}, rolling(0.12, 0.03, 1, p.random(0, 6)));
  for (const double x : {0.12, 0.2, 0.86}) {
    on.stand_at({x, 0.06}, 0.9);
    on.stroke({0.28, 0.50, 0.40}, {{0, 0}, {0.08, 0.25}, {-0.05, 0.5}, {0.05, 0.78}}, 0.08, 0.02);
  }
  const int first = p.turn(5);
  int i = 0;
  for (const Vec2 at : {Vec2{0.42, 0.64}, Vec2{0.68, 0.4}, Vec2{0.34, 0.32}}) {
    const Color color = kGay[(first + 1 + i) % 5];
    on.stand_at(at, (p.pick(2) == 0 ? 1 : -1) * (0.62 - 0.12 * i++));
    on.figure(mixed(color, kDark, 0.2), smooth({{0.36, 0}, {0.74, 0.3}, {0.64, 0}, {0.74, -0.3}}, 4));
    on.figure(mixed(color, kDark, 0.2), smooth({{-0.14, 0.24}, {0.1, 0.44}, {0.24, 0.2}}, 3));
    on.figure(color, smooth({{-0.56, 0}, {-0.2, 0.28}, {0.24, 0.2}, {0.46, 0}, {0.24, -0.2}, {-0.2, -0.28}}));
    for (const double x : {-0.18, 0.1}) on.block(kWhite, x, x + 0.07, -0.2, 0.2);
    on.round(kWhite, {-0.36, 0.06}, 0.06, 0.06);
    on.round(kDark, {-0.37, 0.06}, 0.03, 0.03);
  }
  for (int k = 0; k < 6; ++k) on.disc(mixed(water, kWhite, 0.55), {0.14 + p.random(0, 0.1), 0.4 + 0.08 * k}, p.random(0.008, 0.018));
}

void butterfly(Piece& p, PictureSheet& on) {
  const int first = p.turn(5);
  on.fill(mixed(kGay[(first + 2) % 5], kCream, 0.75));
  on.stand_at({0.5, 0.5}, 0.92);
  for (const double s : {-1.0, 1.0}) {
    on.figure(kDark, smooth({{0.02 * s, 0.02}, {0.14 * s, -0.6}, {0.5 * s, -0.66}, {0.62 * s, -0.26}}));
    on.figure(kDark, smooth({{0.02 * s, 0.06}, {0.3 * s, 0.66}, {0.84 * s, 0.74}, {0.84 * s, 0.2}, {0.5 * s, -0.14}}));
    on.figure(kGay[(first + 1) % 5], smooth({{0.08 * s, -0.04}, {0.18 * s, -0.52}, {0.46 * s, -0.58}, {0.54 * s, -0.26}}));
    on.figure(kGay[first], smooth({{0.08 * s, 0.08}, {0.33 * s, 0.58}, {0.76 * s, 0.65}, {0.76 * s, 0.24}, {0.48 * s, -0.06}}));
    on.round(kCream, {0.6 * s, 0.46}, 0.09, 0.09);
    on.round(kCream, {0.36 * s, -0.38}, 0.07, 0.07);
    on.stroke(kDark, {{0.01 * s, 0.3}, {0.1 * s, 0.52}, {0.2 * s, 0.62}}, 0.02);
  }
  on.round(kDark, {0, 0}, 0.055, 0.36);
}

}  // namespace

void add_animals(Drawings& to) {
  to.insert({{"horse", horse}, {"cat", cat}, {"dog", dog}, {"bird", bird}, {"fish", fish}, {"butterfly", butterfly}});
}

}  // namespace layoutbox::kit::pictures
