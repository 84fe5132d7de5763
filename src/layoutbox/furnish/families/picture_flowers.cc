// Flowers, leaves and fruit.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/picture_sheet.h"

namespace layoutbox::kit::pictures {
namespace {

constexpr Color kStem{0.36, 0.48, 0.32},
    kPetals[] = {{0.84, 0.42, 0.44}, {0.90, 0.66, 0.68}, {0.92, 0.74, 0.36}, {0.62, 0.52, 0.74}, {0.94, 0.90, 0.86}};

// A leaf from its root to its tip.
std::vector<Vec2> leaf_shape(Vec2 root, Vec2 tip, double wide) {
  const Vec2 along{tip.x - root.x, tip.y - root.y};
  const auto at = [&](double t, double off) { return Vec2{root.x + along.x * t - along.y * off, root.y + along.y * t + along.x * off}; };
  return {root, at(0.2, wide * 0.32),   at(0.45, wide * 0.5),  at(0.75, wide * 0.32),
          tip,  at(0.75, -wide * 0.32), at(0.45, -wide * 0.5), at(0.2, -wide * 0.32)};
}

void blossom(PictureSheet& on, Vec2 at, double r, const Color& color, int petals, double turn) {
  for (int i = 0; i < petals; ++i) {
    const double a = turn + 2 * kPi * i / petals;
    on.round(i % 2 == 0 ? color : mixed(color, kWhite, 0.18), {at.x + 0.58 * r * std::cos(a), at.y + 0.58 * r * std::sin(a)}, 0.44 * r,
             0.44 * r);
  }
  on.round({0.93, 0.78, 0.38}, at, 0.3 * r, 0.3 * r);
}

// A bunch in a vase.
void bunch(Piece& p, PictureSheet& on) {
  const Color wall = mixed(kPetals[p.pick(5)], kCream, 0.75), vase = mixed(kGay[p.pick(5)], kWhite, 0.35);
  on.fill(wall);
  on.bar(mixed(wall, {0.50, 0.38, 0.30}, 0.4), 0, 1, 0, 0.2);
  on.stand_at({0.5, 0.16}, on.larger(0.92));
  constexpr Vec2 kHeads[] = {{-0.5, 0.92}, {0.5, 0.98}, {-0.24, 1.24}, {0.24, 1.3}, {0.0, 0.98}, {-0.62, 1.22}, {0.6, 1.34}};
  for (const Vec2 head : kHeads) on.stroke(kStem, {{head.x * 0.12, 0.5}, {head.x * 0.5, 0.75}, head}, 0.025);
  for (const double s : {-1.0, 1.0}) {
    on.figure(kStem, leaf_shape({0.1 * s, 0.58}, {0.58 * s, 0.7}, 0.4));
    on.figure(mixed(kStem, kCream, 0.25), leaf_shape({0.08 * s, 0.6}, {0.36 * s, 0.94}, 0.36));
  }
  const int first = p.turn(5);
  int i = 0;
  for (const Vec2 head : kHeads) {
    ++i;
    blossom(on, head, p.random(0.15, 0.21), kPetals[(first + i % 3) % 5], 5 + i % 2, p.random(0, 1));
  }
  on.figure(vase, smooth({{-0.16, 0},
                          {0.16, 0},
                          {0.27, 0.22},
                          {0.17, 0.46},
                          {0.14, 0.54},
                          {0.2, 0.62},
                          {-0.2, 0.62},
                          {-0.14, 0.54},
                          {-0.17, 0.46},
                          {-0.27, 0.22}},
                         4));
  on.round(mixed(vase, kWhite, 0.4), {-0.12, 0.26}, 0.04, 0.1);
}

// Large flowers among leaves, up to the edges.
void blooms(Piece& p, PictureSheet& on) {
  const int first = p.turn(4);
  const Color ground = p.pick(2) == 0 ? Color{0.16, 0.22, 0.22} : mixed(kPetals[first], kCream, 0.8);
  on.fill(ground);
  constexpr Vec2 kPlaces[] = {{0.3, 0.66}, {0.7, 0.4}, {0.74, 0.78}, {0.26, 0.26}};
  int i = 0;
  for (const Vec2 place : kPlaces) {
    on.stand_at(place, 1);
    for (int k = 0; k < 5; ++k) {
      const double a = i + 2 * kPi * k / 5;
      on.figure(mixed(kStem, kCream, 0.1 * k), leaf_shape({0, 0}, {0.42 * std::cos(a), 0.42 * std::sin(a)}, 0.4));
    }
    ++i;
  }
  for (const Vec2 place : kPlaces) {
    on.stand_at(place, 1);
    blossom(on, {0, 0}, p.random(0.24, 0.34), kPetals[(first + ++i) % 5], 6, p.random(0, 1));
  }
}

void flowers(Piece& p, PictureSheet& on) { return p.turn(3) < 2 ? bunch(p, on) : blooms(p, on); }

// A plant by itself, as in old books, with its name below.
void botanical(Piece& p, PictureSheet& on) {
  const int kind = p.turn(3);
  const Color leaf = mixed(kStem, kind == 1 ? Color{0.30, 0.50, 0.46} : Color{0.56, 0.60, 0.34}, p.random(0.2, 0.7));
  on.fill(kCream);
  on.stand_at({0.5, 0.17}, on.larger(0.95));
  on.stroke(mixed(leaf, kDark, 0.3), {{0, -0.05}, {0.03, 0.6}, {-0.02, 1.34}}, 0.035, 0.015);
  for (int i = 0; i < 6; ++i) {
    const double z = 0.12 + 0.2 * i, far = 0.52 - 0.055 * i;
    for (const double s : {-1.0, 1.0}) {
      const double up = kind == 2 ? 0.02 : 0.2;
      on.figure(s > 0 ? leaf : mixed(leaf, kCream, 0.2), leaf_shape({0.02, z + (s > 0 ? 0.05 : 0)}, {far * s, z + up},
                                                                    kind == 0   ? 0.5
                                                                    : kind == 1 ? 0.26
                                                                                : 0.38));
    }
  }
  if (kind == 1) blossom(on, {-0.02, 1.36}, 0.16, kPetals[p.pick(4)], 6, 0.2);
  if (kind != 1) on.figure(leaf, leaf_shape({-0.02, 1.25}, {-0.03, 1.6}, 0.4));
  on.bar({0.55, 0.50, 0.42}, 0.36, 0.64, 0.075, 0.083);
  on.bar({0.55, 0.50, 0.42}, 0.42, 0.58, 0.055, 0.061);
}

void fruit(Piece& p, PictureSheet& on) {
  const Color wall{0.34, 0.29, 0.26}, bowl = mixed(kGay[p.pick(5)], kWhite, 0.4);
  constexpr Color kFruit[] = {{0.76, 0.26, 0.22}, {0.92, 0.58, 0.22}, {0.70, 0.72, 0.30}, {0.86, 0.74, 0.34}};
  on.fill(wall);
  on.bar({0.62, 0.44, 0.30}, 0, 1, 0, 0.32);
  on.stand_at({0.47, 0.22}, on.larger(1.15));
  const int first = p.turn(4);
  constexpr Vec2 kPile[] = {{-0.3, 0.42}, {0.3, 0.42}, {-0.14, 0.6}, {0.16, 0.6}, {0.0, 0.44}};
  int i = 0;
  for (const Vec2 at : kPile) {
    const Color color = kFruit[(first + i++) % 4];
    on.round(color, at, 0.17, 0.16);
    on.round(mixed(color, kWhite, 0.35), {at.x - 0.06, at.y + 0.06}, 0.04, 0.03);
  }
  on.figure(bowl, smooth({{-0.52, 0.42}, {-0.36, 0.12}, {-0.18, 0.0}, {0.18, 0.0}, {0.36, 0.12}, {0.52, 0.42}, {0, 0.36}}, 4));
  on.figure(kFruit[2], smooth({{0.6, 0.0}, {0.82, 0.0}, {0.86, 0.14}, {0.76, 0.3}, {0.71, 0.4}, {0.66, 0.3}, {0.56, 0.14}}, 4));
  on.stroke(kDark, {{0.71, 0.38}, {0.75, 0.48}}, 0.025);
  on.round(kFruit[0], {-0.68, 0.08}, 0.15, 0.14);
}

// Rings of petals round a middle.
void mandala(Piece& p, PictureSheet& on) {
  const int first = p.turn(5);
  on.fill(mixed(kGay[first], kNight, 0.6));
  on.stand_at({0.5, 0.5}, 0.95);
  constexpr struct {
    double from, to, wide;
    int many;
  } kRings[] = {{0.62, 0.98, 0.62, 16}, {0.4, 0.8, 0.6, 12}, {0.2, 0.56, 0.66, 8}};
  int ring = 0;
  for (const auto& r : kRings) {
    ++ring;
    for (const double within : {0.0, 0.06}) {
      const Color color = within > 0 ? mixed(kGay[(first + ring) % 5], kCream, 0.3) : kCream;
      for (int i = 0; i < r.many; ++i) {
        const double a = 2 * kPi * (i + ring / 2.0) / r.many, from = r.from + within, to = r.to - within;
        on.figure(color, leaf_shape({from * std::cos(a), from * std::sin(a)}, {to * std::cos(a), to * std::sin(a)}, r.wide));
      }
    }
  }
  on.round(kCream, {0, 0}, 0.24, 0.24);
  on.round(kGay[(first + 1) % 5], {0, 0}, 0.18, 0.18);
  on.round(kCream, {0, 0}, 0.07, 0.07);
}

}  // namespace

void add_flowers(Drawings& to) { to.insert({{"flowers", flowers}, {"botanical", botanical}, {"fruit", fruit}, {"mandala", mandala}}); }

}  // namespace layoutbox::kit::pictures
