// What hangs in children's rooms.
#include "layoutbox/furnish/families/picture_sheet.h"

namespace layoutbox::kit::pictures {
namespace {

// A bear's face.
void bear(Piece& p, PictureSheet& on) {
  const Color fur = p.turn(2) == 0 ? Color{0.66, 0.48, 0.33} : Color{0.86, 0.62, 0.36}, inner{0.93, 0.80, 0.68};
  on.fill(mixed(kGay[p.pick(5)], kWhite, 0.55));
  for (const double s : {-1.0, 1.0}) {
    on.disc(fur, {0.5 + 0.27 * s, 0.72}, 0.13);
    on.disc(inner, {0.5 + 0.27 * s, 0.72}, 0.07);
  }
  on.disc(fur, {0.5, 0.47}, 0.34);
  on.disc(inner, {0.5, 0.36}, 0.16, 0.8);
  for (const double s : {-1.0, 1.0}) on.disc(kDark, {0.5 + 0.13 * s, 0.55}, 0.035, 1.3);
  on.disc(kDark, {0.5, 0.41}, 0.05, 0.75);
}

// A rocket among stars.
void rocket(Piece& p, PictureSheet& on) {
  const Color red{0.86, 0.36, 0.32};
  on.fill({0.16, 0.22, 0.40});
  for (int i = 0; i < 9; ++i) on.disc({0.98, 0.92, 0.66}, {p.random(0.08, 0.92), p.random(0.1, 0.92)}, p.random(0.012, 0.03));
  on.disc({0.93, 0.84, 0.58}, {0.82, 0.82}, 0.1);
  on.stand_at({0.5, 0.5}, p.random(0.85, 1));
  on.figure(red, {{-0.44, -0.56}, {0.44, -0.56}, {0.2, 0.0}, {-0.2, 0.0}});
  on.figure({0.96, 0.70, 0.28}, {{-0.16, -0.5}, {0, -0.88}, {0.16, -0.5}});
  on.figure(kWhite, {{-0.2, -0.52}, {0.2, -0.52}, {0.28, 0}, {0.2, 0.4}, {0, 0.78}, {-0.2, 0.4}, {-0.28, 0}});
  on.figure(red, {{-0.2, 0.4}, {0.2, 0.4}, {0, 0.78}});
  on.round(kGay[0], {0, 0.08}, 0.14, 0.14);
}

// A whale that spouts.
void whale(Piece& p, PictureSheet& on) {
  const Color blue = mixed(kGay[0], {0.12, 0.24, 0.42}, 0.25);
  on.fill({0.90, 0.94, 0.95});
  on.paint(mixed(kGay[0], kWhite, 0.45), rolling(0.24, 0.015, 2, p.random(0, 6)));
  on.stand_at({0.5, 0.5}, p.pick(2) == 0 ? 0.95 : -0.95);
  on.figure(blue, smooth({{-0.5, -0.2}, {-0.86, 0.3}, {-0.6, 0.2}, {-0.42, 0.38}, {-0.32, -0.16}}, 3));
  on.round(blue, {0.08, -0.28}, 0.6, 0.4);
  on.round(kWhite, {0.22, -0.48}, 0.34, 0.18);
  on.round(kDark, {0.42, -0.16}, 0.05, 0.05);
  for (const double x : {-0.12, 0.0, 0.12}) on.round(kGay[0], {0.12 + x, 0.36 + p.random(0, 0.2)}, 0.06, 0.11);
}

// A balloon over hills.
void balloon(Piece& p, PictureSheet& on) {
  const int first = p.turn(5);
  on.fill({0.86, 0.93, 0.96});
  on.paint(kGay[3], rolling(0.14, 0.05, 0.9, p.random(0, 6)));
  on.paint(mixed(kGay[3], kWhite, 0.3), rolling(0.07, 0.04, 0.8, p.random(0, 6)));
  on.stand_at({p.random(0.42, 0.58), 0.5}, 1);
  on.figure(kDark, {{-0.12, -0.46}, {0.12, -0.46}, {0.11, -0.64}, {-0.11, -0.64}});
  on.figure(kGay[first], {{-0.4, 0.1}, {0.4, 0.1}, {0.1, -0.4}, {-0.1, -0.4}});
  on.round(kGay[first], {0, 0.28}, 0.52, 0.52);
  on.round(kGay[(first + 1) % 5], {0, 0.28}, 0.22, 0.52);
}

void rainbow(Piece& p, PictureSheet& on) {
  constexpr Color kBows[] = {{0.88, 0.48, 0.44}, {0.94, 0.68, 0.42}, {0.95, 0.84, 0.52},
                             {0.56, 0.72, 0.56}, {0.46, 0.64, 0.78}, {0.66, 0.56, 0.76}};
  const Color sky = mixed(kGay[p.turn(5)], kWhite, 0.78);
  on.fill(sky);
  double r = 0.42;
  for (const Color& bow : kBows) {
    on.dome(bow, {0.5, 0.3}, r);
    r -= 0.045;
  }
  on.dome(sky, {0.5, 0.3}, r);
  on.stand_at({0.5, 0.3}, 1);
  for (const double x : {-0.7, 0.7}) {
    for (const Vec2 q : {Vec2{-0.16, 0}, Vec2{0.16, 0}, Vec2{0, 0.08}, Vec2{0, -0.06}}) on.round(kWhite, {x + q.x, q.y}, 0.16, 0.12);
  }
}

void unicorn(Piece& p, PictureSheet& on) {
  const int first = p.turn(5);
  on.fill(mixed(kGay[first], kWhite, 0.6));
  for (int i = 0; i < 8; ++i) on.disc({0.99, 0.95, 0.80}, {p.random(0.06, 0.94), p.random(0.08, 0.92)}, p.random(0.01, 0.022));
  on.stand_at({0.5, 0.42}, p.pick(2) == 0 ? 0.92 : -0.92);
  const Vec2 mane[] = {{0.3, 0.62}, {0.48, 0.38}, {0.56, 0.08}, {0.58, -0.24}, {0.56, -0.56}};
  int i = 0;
  for (const Vec2 q : mane) on.round(kGay[(first + ++i) % 5], q, 0.22, 0.24);
  on.figure(kWhite, smooth({{0.2, 0.66},
                            {0.02, 0.66},
                            {-0.14, 0.46},
                            {-0.36, 0.1},
                            {-0.54, -0.12},
                            {-0.5, -0.34},
                            {-0.3, -0.36},
                            {-0.06, -0.2},
                            {0.04, -0.5},
                            {-0.1, -0.9},
                            {0.54, -0.9},
                            {0.5, -0.2},
                            {0.42, 0.34}}));
  on.figure({0.95, 0.78, 0.42}, {{-0.02, 0.66}, {-0.2, 1.12}, {0.1, 0.68}});
  on.figure(kWhite, {{0.1, 0.62}, {0.16, 0.92}, {0.27, 0.6}});
  for (const Vec2 q : {Vec2{0.0, 0.56}, Vec2{0.14, 0.7}}) on.round(kGay[(first + 2) % 5], q, 0.1, 0.12);
  on.stroke(kDark, {{-0.16, 0.3}, {-0.1, 0.26}, {-0.04, 0.3}}, 0.025);
  on.round({0.95, 0.70, 0.72}, {-0.12, 0.06}, 0.08, 0.06);
}

void for_a_child(Piece& p, PictureSheet& on) {
  constexpr Drawing kAll[] = {bear, rocket, whale, balloon, rainbow};
  kAll[p.turn(5)](p, on);
}

// Any of those that children know.
void animals(Piece& p, PictureSheet& on) {
  constexpr const char* kNames[] = {"bear", "whale", "elephant", "lion", "cat", "bird"};
  drawings().at(kNames[p.turn(6)])(p, on);
}

}  // namespace

void add_children_pictures(Drawings& to) {
  to.insert({{"child", for_a_child},
             {"animals", animals},
             {"bear", bear},
             {"rocket", rocket},
             {"whale", whale},
             {"balloon", balloon},
             {"rainbow", rainbow},
             {"unicorn", unicorn}});
}

}  // namespace layoutbox::kit::pictures
