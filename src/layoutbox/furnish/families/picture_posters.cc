// Posters: films, games, cars, words.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "layoutbox/furnish/families/picture_sheet.h"

namespace layoutbox::kit::pictures {
namespace {

// The small print below a film's title.
void credits(PictureSheet& on, const Color& ink) {
  on.bar(ink, 0.18, 0.82, 0.07, 0.08);
  on.bar(ink, 0.26, 0.74, 0.05, 0.058);
}

// Somebody who stands before a great light.
void lone_figure(PictureSheet& on, const Color& dark) {
  on.stand_at({0.5, 0.27}, 0.62);
  on.round(dark, {0, 0.9}, 0.09, 0.11);
  on.figure(dark, smooth({{-0.08, 0.8},
                          {0.08, 0.8},
                          {0.2, 0.7},
                          {0.26, 0.2},
                          {0.18, 0.2},
                          {0.2, -0.1},
                          {-0.2, -0.1},
                          {-0.18, 0.2},
                          {-0.26, 0.2},
                          {-0.2, 0.7}},
                         3));
  for (const double s : {-1.0, 1.0}) on.figure(dark, {{0.02 * s, 0}, {0.16 * s, 0}, {0.14 * s, -0.42}, {0.05 * s, -0.42}});
}

void film(Piece& p, PictureSheet& on) {
  constexpr struct {
    Color sky, light;
  } kLights[] = {{{0.10, 0.13, 0.22}, {0.90, 0.46, 0.26}},
                 {{0.20, 0.08, 0.12}, {0.92, 0.72, 0.36}},
                 {{0.06, 0.18, 0.20}, {0.86, 0.88, 0.76}},
                 {{0.16, 0.10, 0.24}, {0.90, 0.42, 0.54}}};
  constexpr const char* kTitles[] = {"NIGHT TRAIN", "LAST LIGHT", "THE ISLAND", "RED MOON", "STORM", "NO RETURN"};
  const auto& l = kLights[p.turn(4)];
  on.fill(l.sky);
  on.bar(mixed(l.sky, l.light, 0.25), 0, 1, 0.16, 0.62);
  on.disc(l.light, {0.5, 0.62}, p.random(0.27, 0.34));
  const Color dark = mixed(l.sky, kDark, 0.2), far = mixed(l.sky, l.light, 0.35);
  if (p.pick(2) == 0) {
    on.paint(far, rolling(0.42, 0.05, 1.4, p.random(0, 6)));
  } else {
    for (int i = 0; i < 9; ++i) on.bar(far, 0.02 + 0.107 * i, 0.12 + 0.107 * i, 0.2, p.random(0.34, 0.56));
  }
  on.paint(dark, rolling(0.27, 0.015, 0.8, p.random(0, 6)));
  lone_figure(on, dark);
  on.bar(dark, 0, 1, 0, 0.24);
  on.letters(mixed(l.light, kWhite, 0.5), kTitles[p.turn(6)], {0.5, 0.155}, 0.07);
  credits(on, mixed(l.light, l.sky, 0.4));
}

struct Neon {
  Color ground, first, second;
};
constexpr Neon kNeons[] = {{{0.09, 0.07, 0.18}, {0.96, 0.26, 0.62}, {0.20, 0.82, 0.92}},
                           {{0.06, 0.10, 0.16}, {0.32, 0.92, 0.56}, {0.58, 0.36, 0.96}},
                           {{0.12, 0.06, 0.14}, {0.98, 0.60, 0.22}, {0.36, 0.56, 0.98}}};

void controller(PictureSheet& on, const Neon& n) {
  on.stand_at({0.5, 0.54}, 0.9);
  for (const double more : {0.06, 0.0}) {
    const double k = 1 + more;
    on.figure(more > 0 ? n.first : Color{0.15, 0.16, 0.24}, smooth({{-0.4 * k, 0.4 * k},
                                                                    {0.4 * k, 0.4 * k},
                                                                    {0.68 * k, 0.24 * k},
                                                                    {0.84 * k, -0.3 * k},
                                                                    {0.72 * k, -0.5 * k},
                                                                    {0.5 * k, -0.36 * k},
                                                                    {0.3 * k, -0.12 * k},
                                                                    {-0.3 * k, -0.12 * k},
                                                                    {-0.5 * k, -0.36 * k},
                                                                    {-0.72 * k, -0.5 * k},
                                                                    {-0.84 * k, -0.3 * k},
                                                                    {-0.68 * k, 0.24 * k}}));
  }
  on.block(n.second, -0.56, -0.32, 0.12, 0.2);
  on.block(n.second, -0.48, -0.4, 0.04, 0.28);
  on.round(n.first, {0.44, 0.27}, 0.05, 0.05);
  on.round(n.second, {0.44, 0.05}, 0.05, 0.05);
  on.round(kWhite, {0.33, 0.16}, 0.05, 0.05);
  on.round({0.98, 0.82, 0.30}, {0.55, 0.16}, 0.05, 0.05);
  for (const double s : {-1.0, 1.0}) on.round(mixed(n.first, n.ground, 0.5), {0.2 * s, -0.02}, 0.1, 0.1);
}

// A creature of points, as on old screens.
void invader(PictureSheet& on, const Neon& n) {
  constexpr const char* kRows[] = {"..#.....#..", "...#...#...", "..#######..", ".##.###.##.",
                                   "###########", "#.#######.#", "#.#.....#.#", "...##.##..."};
  on.stand_at({0.5, 0.55}, 1);
  for (int row = 0; row < 8; ++row) {
    for (int x = 0; x < 11; ++x) {
      if (kRows[row][x] == '#')
        on.block(row < 4 ? n.first : mixed(n.first, n.second, 0.4), -0.66 + 0.12 * x, -0.545 + 0.12 * x, 0.36 - 0.12 * row,
                 0.475 - 0.12 * row);
    }
  }
}

// The four signs of the buttons.
void button_signs(PictureSheet& on, const Neon& n) {
  const auto at = [&](double x, double z) { on.stand_at({0.5 + x, 0.56 + z}, 0.42); };
  const double up = 0.2 / std::max(1.0, on.upright());
  at(-0.21, up);
  on.figure(n.first, {{-0.5, -0.4}, {0.5, -0.4}, {0, 0.5}});
  on.figure(n.ground, {{-0.3, -0.28}, {0.3, -0.28}, {0, 0.27}});
  at(0.21, up);
  on.round(n.second, {0, 0}, 0.46, 0.46);
  on.round(n.ground, {0, 0}, 0.34, 0.34);
  at(-0.21, -up);
  on.block({0.98, 0.82, 0.30}, -0.42, 0.42, -0.42, 0.42);
  on.block(n.ground, -0.3, 0.3, -0.3, 0.3);
  at(0.21, -up);
  on.stroke(kWhite, {{-0.4, -0.4}, {0.4, 0.4}}, 0.13);
  on.stroke(kWhite, {{-0.4, 0.4}, {0.4, -0.4}}, 0.13);
}

void gaming(Piece& p, PictureSheet& on) {
  constexpr const char* kTitles[] = {"GAME ON", "LEVEL UP", "PLAYER ONE", "GAME OVER", "PRESS START", "NEW GAME"};
  const Neon& n = kNeons[p.pick(3)];
  on.fill(n.ground);
  on.paint(mixed(n.ground, n.first, 0.22), {{0, 0.5}, {1, 0.86}, {1, 1}, {0, 1}});
  on.paint(mixed(n.ground, n.second, 0.22), {{0, 0}, {1, 0}, {1, 0.34}, {0, 0.12}});
  constexpr void (*kShown[])(PictureSheet&, const Neon&) = {controller, invader, button_signs};
  kShown[p.turn(3)](on, n);
  on.letters(n.second, kTitles[p.turn(6)], {0.5, 0.14}, 0.085);
  on.bar(n.first, 0.2, 0.8, 0.06, 0.07);
}

void car(Piece& p, PictureSheet& on) {
  constexpr Color kPaints[] = {{0.80, 0.20, 0.18}, {0.92, 0.70, 0.22}, {0.20, 0.40, 0.62}, {0.20, 0.46, 0.38}, {0.88, 0.46, 0.20}};
  const int first = p.turn(5);
  const Color paint = kPaints[first], sky = mixed(kPaints[(first + 2) % 5], kCream, 0.72), dark{0.13, 0.13, 0.15};
  on.fill(sky);
  on.disc(mixed(sky, kWhite, 0.5), {0.5, 0.5}, 0.38);
  on.bar({0.36, 0.36, 0.40}, 0, 1, 0, 0.36);
  for (double x = 0.06; x < 0.9; x += 0.24) on.bar(kWhite, x, x + 0.12, 0.14, 0.155);
  on.stand_at({0.5, 0.32}, p.pick(2) == 0 ? 0.94 : -0.94);
  on.figure(dark, {{-0.84, 0.02}, {0.84, 0.02}, {0.76, 0.1}, {-0.76, 0.1}});
  on.figure(paint, smooth({{-0.92, 0.1},
                           {-0.94, 0.3},
                           {-0.84, 0.4},
                           {-0.5, 0.44},
                           {-0.22, 0.66},
                           {0.2, 0.68},
                           {0.52, 0.47},
                           {0.84, 0.42},
                           {0.95, 0.28},
                           {0.92, 0.1},
                           {0, 0.07}}));
  on.figure({0.66, 0.78, 0.84}, smooth({{-0.38, 0.45}, {-0.18, 0.6}, {-0.02, 0.61}, {-0.02, 0.45}}, 2));
  on.figure({0.66, 0.78, 0.84}, smooth({{0.04, 0.45}, {0.04, 0.61}, {0.18, 0.61}, {0.4, 0.46}}, 2));
  on.block(mixed(paint, kDark, 0.4), -0.86, 0.86, 0.19, 0.215);
  on.round({0.98, 0.92, 0.70}, {0.88, 0.3}, 0.05, 0.05);
  for (const double x : {-0.52, 0.54}) {
    on.round(dark, {x, 0.1}, 0.2, 0.2);
    on.round({0.76, 0.76, 0.78}, {x, 0.1}, 0.1, 0.1);
  }
}

// A few words in large letters.
void saying(Piece& p, PictureSheet& on) {
  constexpr const char* kSayings[][3] = {{"DREAM", "BIG", ""},    {"KEEP", "GOING", ""},       {"YOU", "CAN", "DO IT"},
                                         {"STAY", "CURIOUS", ""}, {"WORK", "HARD", "BE KIND"}, {"LOVE", "LIVES", "HERE"}};
  const auto& said = kSayings[p.turn(6)];
  const bool dark = p.pick(2) == 0;
  const Color ground = dark ? mixed(kGay[p.pick(5)], kDark, 0.7) : mixed(kGay[p.pick(5)], kCream, 0.8), ink = dark ? kCream : kDark;
  on.fill(ground);
  const int many = std::string_view(said[2]).empty() ? 2 : 3;
  for (int i = 0; i < many; ++i) on.letters(ink, said[i], {0.5, 0.5 + 0.2 * ((many - 1) / 2.0 - i)}, 0.14, 0.72);
  on.bar(kGay[p.pick(3)], 0.38, 0.62, 0.14, 0.155);
}

}  // namespace

void add_posters(Drawings& to) { to.insert({{"film", film}, {"gaming", gaming}, {"car", car}, {"saying", saying}}); }

}  // namespace layoutbox::kit::pictures
