// Music, sport, dance and writing with the brush.
#include <cmath>

#include "layoutbox/furnish/families/picture_sheet.h"

namespace layoutbox::kit::pictures {
namespace {

void guitar(Piece& p, PictureSheet& on) {
  const Color wood = p.pick(2) == 0 ? Color{0.82, 0.56, 0.30} : Color{0.72, 0.24, 0.20}, dark{0.24, 0.16, 0.12};
  on.stand_at({0.5, 0.34}, 0.9);
  on.block(dark, -0.06, 0.06, 0.2, 1.08);
  on.figure(dark, {{-0.08, 1.06}, {0.08, 1.06}, {0.1, 1.3}, {-0.1, 1.3}});
  on.figure(mixed(wood, kDark, 0.45), smooth({{0, -0.56},
                                              {0.42, -0.4},
                                              {0.44, -0.06},
                                              {0.25, 0.12},
                                              {0.31, 0.36},
                                              {0.14, 0.51},
                                              {0, 0.49},
                                              {-0.14, 0.51},
                                              {-0.31, 0.36},
                                              {-0.25, 0.12},
                                              {-0.44, -0.06},
                                              {-0.42, -0.4}}));
  on.figure(wood, smooth({{0, -0.52},
                          {0.38, -0.37},
                          {0.4, -0.07},
                          {0.21, 0.12},
                          {0.27, 0.35},
                          {0.12, 0.47},
                          {0, 0.45},
                          {-0.12, 0.47},
                          {-0.27, 0.35},
                          {-0.21, 0.12},
                          {-0.4, -0.07},
                          {-0.38, -0.37}}));
  on.block(dark, -0.055, 0.055, 0.3, 0.6);
  on.round(dark, {0, 0.16}, 0.12, 0.12);
  on.block(dark, -0.16, 0.16, -0.27, -0.22);
  for (const double x : {-0.03, 0.0, 0.03}) on.block({0.92, 0.88, 0.78}, x - 0.004, x + 0.004, -0.24, 1.1);
}

void record(Piece& p, PictureSheet& on) {
  const Color label = kGay[p.pick(5)];
  on.stand_at({0.5, 0.56}, 0.84);
  on.round({0.09, 0.09, 0.10}, {0, 0}, 0.9, 0.9);
  for (const double r : {0.82, 0.7, 0.58, 0.46}) {
    on.round({0.22, 0.22, 0.24}, {0, 0}, r, r);
    on.round({0.11, 0.11, 0.12}, {0, 0}, r - 0.02, r - 0.02);
  }
  on.round(label, {0, 0}, 0.32, 0.32);
  on.round(kCream, {0, 0}, 0.05, 0.05);
}

void note(Piece& p, PictureSheet& on) {
  const Color ink = mixed(kGay[p.pick(5)], kDark, 0.75);
  on.stand_at({0.5, 0.46}, 0.9);
  on.round(mixed(kGay[p.pick(5)], kWhite, 0.5), {0.04, 0.24}, 0.86, 0.86);
  for (const double x : {-0.4, 0.3}) {
    on.round(ink, {x - 0.12, -0.26 + (x > 0 ? 0.1 : 0)}, 0.18, 0.13);
    on.block(ink, x, x + 0.06, x > 0 ? -0.16 : -0.26, x > 0 ? 0.8 : 0.68);
  }
  on.figure(ink, {{-0.4, 0.5}, {0.36, 0.62}, {0.36, 0.84}, {-0.4, 0.72}});
}

void music(Piece& p, PictureSheet& on) {
  constexpr const char* kTitles[] = {"LIVE TONIGHT", "ROCK", "JAZZ", "ON TOUR", "THE BAND", "BLUES"};
  const bool dark = p.pick(2) == 0;
  const Color ground = dark ? mixed(kGay[p.pick(5)], kNight, 0.75) : mixed(kGay[p.pick(5)], kCream, 0.35);
  on.fill(ground);
  const bool disc = p.says("record") || p.says("vinyl") || p.says("album");
  const int kind = disc ? 1 : p.says("guitar") ? 0 : p.turn(3);
  for (int i = 0; i < 9 && kind != 1; ++i) {  // rays of light
    const double a = kPi * (i + 0.2) / 9, b = kPi * (i + 0.7) / 9;
    on.paint(mixed(ground, kWhite, 0.1),
             {{0.5, 0.45}, {0.5 + 0.6 * std::cos(a), 0.45 + 0.6 * std::sin(a)}, {0.5 + 0.6 * std::cos(b), 0.45 + 0.6 * std::sin(b)}});
  }
  constexpr Drawing kShown[] = {guitar, record, note};
  kShown[kind](p, on);
  on.letters(dark ? kCream : kDark, kTitles[p.turn(6)], {0.5, 0.09}, 0.07);
}

// A ball before a pitch.
void football(Piece& p, PictureSheet& on) {
  const bool basket = p.says("basketball") || p.says("nba");
  const int first = p.turn(5);
  const Color green{0.32, 0.54, 0.34};
  on.fill(basket ? mixed(kGay[first], kDark, 0.6) : mixed(kGay[first], kNight, 0.55));
  for (int i = 0; i < 5; ++i)
    on.paint(mixed(kGay[first], kNight, 0.4), {{0.1 * i, 0.3}, {0.1 * i + 0.06, 0.3}, {0.24 * i + 0.2, 1}, {0.24 * i + 0.06, 1}});
  on.paint(basket ? Color{0.72, 0.50, 0.32} : green, {{0, 0}, {1, 0}, {1, 0.3}, {0, 0.3}});
  on.bar(kWhite, 0, 1, 0.28, 0.295);
  on.stand_at({0.5, 0.48}, 0.66);
  on.round(basket ? Color{0.86, 0.48, 0.20} : kWhite, {0, 0}, 0.86, 0.86);
  if (basket) {
    on.block(kDark, -0.02, 0.02, -0.85, 0.85);
    on.block(kDark, -0.85, 0.85, -0.02, 0.02);
    for (const double s : {-1.0, 1.0}) on.stroke(kDark, {{0.6 * s, 0.6}, {0.34 * s, 0}, {0.6 * s, -0.6}}, 0.04);
  } else {
    const auto at = [](double a, double r) { return Vec2{r * std::sin(a), r * std::cos(a)}; };
    std::vector<Vec2> middle;
    for (int i = 0; i < 5; ++i) {
      const double a = 2 * kPi * i / 5;
      middle.push_back(at(a, 0.28));
      on.stroke(kDark, {at(a, 0.26), at(a, 0.6)}, 0.035);
      on.figure(kDark, {at(a, 0.56), at(a + 0.26, 0.66), at(a + 0.2, 0.84), at(a, 0.86), at(a - 0.2, 0.84), at(a - 0.26, 0.66)});
      on.stroke(kDark, {at(a + 0.26, 0.66), at(a + 2 * kPi / 5 - 0.26, 0.66)}, 0.03);
    }
    on.figure(kDark, middle);
  }
  on.letters(kCream, basket ? "HOOPS" : p.pick(2) == 0 ? "GOAL" : "UNITED", {0.5, 0.12}, 0.08);
}

void dancer(Piece& p, PictureSheet& on) {
  const Color ground = mixed(Color{0.90, 0.66, 0.68}, kCream, p.random(0.3, 0.8)), skin{0.92, 0.77, 0.66},
              dress = mixed(kGay[p.pick(5)], kWhite, 0.45), hair{0.34, 0.23, 0.18};
  on.fill(ground);
  on.disc(mixed(ground, kWhite, 0.4), {0.5, 0.56}, 0.4);
  on.bar(mixed(ground, hair, 0.3), 0, 1, 0, 0.14);
  on.stand_at({0.48, 0.12}, p.pick(2) == 0 ? 0.9 : -0.9);
  on.stroke(skin, {{0.0, 0.75}, {0.02, 0.4}, {0, 0.02}}, 0.11, 0.04);
  on.stroke(skin, {{0.05, 0.72}, {0.4, 0.66}, {0.84, 0.74}}, 0.11, 0.04);
  on.stroke(skin, {{-0.08, 1.18}, {-0.34, 1.4}, {-0.12, 1.66}}, 0.06, 0.035);
  on.stroke(skin, {{0.08, 1.18}, {0.4, 1.16}, {0.66, 1.3}}, 0.06, 0.035);
  on.figure(dress, smooth({{-0.09, 0.9}, {0.09, 0.9}, {0.36, 0.84}, {0.56, 0.68}, {0.1, 0.66}, {-0.44, 0.6}, {-0.32, 0.82}}));
  on.figure(mixed(dress, kDark, 0.18), smooth({{-0.11, 1.2}, {0.11, 1.2}, {0.08, 0.86}, {-0.08, 0.86}}, 3));
  on.block(skin, -0.035, 0.035, 1.18, 1.32);
  on.round(hair, {0.04, 1.44}, 0.11, 0.12);
  on.round(skin, {-0.01, 1.41}, 0.09, 0.115);
  on.round(hair, {0.11, 1.55}, 0.06, 0.06);
}

// Signs of the brush in a column, and a red seal.
void calligraphy(Piece& p, PictureSheet& on) {
  const Color ink{0.10, 0.10, 0.12};
  on.fill({0.94, 0.91, 0.83});
  const bool tall = on.upright() > 1.25;
  const int many = tall ? 3 : 1;
  for (int i = 0; i < many; ++i) {
    on.stand_at({0.5, tall ? 0.8 - 0.27 * i : 0.54}, tall ? 0.5 : 0.72);
    const double lean = p.random(0.02, 0.1);
    on.stroke(ink, {{-0.7, 0.34}, {0, 0.36 + lean}, {0.74, 0.42 + lean}}, 0.17, 0.12);
    if (p.pick(3) > 0) on.stroke(ink, {{0.02, 0.82}, {0.0, 0.2}, {0.03, -0.75}}, 0.17, 0.08);
    on.stroke(ink, {{-0.08, 0.34}, {-0.26, -0.2}, {-0.78, -0.62}}, 0.17, 0.03);
    on.stroke(ink, {{0.1, 0.2}, {0.36, -0.26}, {0.84, -0.58}}, 0.08, 0.2);
    if (p.pick(2) == 0) on.stroke(ink, {{-0.36, -0.1}, {0.34, -0.06}}, 0.12, 0.09);
    if (p.pick(2) == 0) on.stroke(ink, {{-0.44, 0.72}, {-0.3, 0.56}}, 0.08, 0.15);
    if (p.pick(2) == 0) on.stroke(ink, {{0.4, 0.8}, {0.32, 0.58}}, 0.08, 0.14);
  }
  on.stand_at({tall ? 0.74 : 0.84, 0.12}, 0.3);
  on.block({0.76, 0.18, 0.14}, -0.28, 0.28, -0.28, 0.28);
  for (const double x : {-0.14, 0.08}) on.block({0.94, 0.82, 0.74}, x, x + 0.06, -0.2, 0.2);
  on.block({0.94, 0.82, 0.74}, -0.08, 0.08, 0.06, 0.12);
}

}  // namespace

void add_pastime_pictures(Drawings& to) {
  to.insert({{"music", music}, {"football", football}, {"dancer", dancer}, {"calligraphy", calligraphy}});
}

}  // namespace layoutbox::kit::pictures
