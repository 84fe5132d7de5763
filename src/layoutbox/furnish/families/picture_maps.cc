// Maps: of the world, of a town, of hidden treasure.
#include <vector>

#include "layoutbox/furnish/families/picture_sheet.h"

namespace layoutbox::kit::pictures {
namespace {

using Coast = std::vector<Vec2>;  // degrees east and north

const std::vector<Coast>& world() {
  static const std::vector<Coast> lands = {
      {{-166, 66}, {-128, 70}, {-95, 72},  {-82, 67},  {-94, 59},  {-82, 53},  {-78, 60},  {-65, 58},  {-56, 52},
       {-66, 45},  {-75, 38},  {-81, 30},  {-81, 25},  {-90, 30},  {-97, 26},  {-96, 19},  {-88, 21},  {-84, 11},
       {-78, 8},   {-92, 14},  {-106, 21}, {-114, 30}, {-124, 40}, {-125, 49}, {-136, 58}, {-152, 59}, {-164, 55}},
      {{-78, 8},
       {-62, 10},
       {-50, 1},
       {-35, -6},
       {-39, -17},
       {-48, -26},
       {-58, -36},
       {-65, -45},
       {-69, -54},
       {-75, -48},
       {-71, -30},
       {-71, -18},
       {-81, -6}},
      {{-17, 21},
       {-6, 35},
       {10, 37},
       {20, 31},
       {33, 31},
       {43, 12},
       {51, 11},
       {40, -4},
       {40, -16},
       {33, -26},
       {26, -34},
       {18, -34},
       {12, -16},
       {9, 4},
       {-8, 5},
       {-17, 13}},
      {{-9, 43},  {-1, 46},  {3, 51},   {9, 55},   {6, 60},   {14, 67},  {28, 71},  {44, 67},  {70, 72},  {104, 77}, {140, 73}, {178, 69},
       {164, 60}, {156, 52}, {150, 59}, {136, 54}, {140, 46}, {128, 40}, {127, 35}, {121, 38}, {121, 29}, {109, 20}, {106, 10}, {102, 13},
       {103, 2},  {98, 10},  {94, 17},  {87, 21},  {80, 14},  {77, 8},   {72, 20},  {60, 25},  {52, 28},  {59, 22},  {44, 13},  {35, 29},
       {36, 36},  {27, 37},  {22, 37},  {18, 41},  {16, 39},  {9, 44},   {3, 43},   {-2, 37},  {-9, 37}},
      {{114, -22}, {123, -16}, {136, -12}, {142, -11}, {146, -19}, {153, -27}, {149, -38}, {138, -35}, {129, -32}, {116, -35}},
      {{-55, 60}, {-42, 60}, {-20, 72}, {-24, 82}, {-52, 82}, {-66, 77}},
      {{-5, 50}, {1, 52}, {-3, 59}, {-6, 56}},
      {{131, 32}, {141, 36}, {142, 44}, {136, 37}},
      {{44, -24}, {50, -16}, {47, -25}},
      {{96, 5}, {106, -4}, {102, -4}},
      {{109, 1}, {117, 6}, {116, -3}, {110, -2}},
      {{132, -2}, {147, -7}, {138, -8}},
      {{167, -46}, {174, -40}, {178, -38}, {173, -44}},
      {{-175, -76}, {-60, -73}, {0, -71}, {90, -67}, {175, -72}, {178, -82}, {-178, -82}}};
  return lands;
}

void world_map(Piece& p, PictureSheet& on) {
  const bool old = p.says("old") || p.says("vintage") || p.says("antique");
  const Color water = old ? Color{0.90, 0.82, 0.64} : Color{0.66, 0.80, 0.88};
  const double high = std::min(0.9, 0.92 / (on.upright() * 1.9)), foot = (1 - high) / 2;
  on.fill(old ? Color{0.80, 0.68, 0.46} : kWhite);
  on.bar(water, 0.04, 0.96, foot, foot + high);
  for (double x = 0.14; x < 0.9; x += 0.12) on.bar(mixed(water, kDark, 0.12), x, x + 0.002, foot, foot + high);
  for (double z = 0.2; z < 0.9; z += 0.2) on.bar(mixed(water, kDark, 0.12), 0.04, 0.96, foot + high * z, foot + high * z + 0.003);
  int i = 0;
  for (const Coast& coast : world()) {
    Coast land;
    for (const Vec2 q : coast) land.push_back({0.5 + 0.45 * q.x / 180, foot + high * (0.46 + 0.96 * q.y / 180)});
    on.paint(old ? mixed({0.60, 0.44, 0.26}, kCream, 0.08 * (i % 4)) : mixed(kGay[i % 5], kWhite, 0.12), land);
    ++i;
  }
}

// Streets across each other, a river, parks.
void town_map(Piece& p, PictureSheet& on) {
  const Color paper = p.pick(2) == 0 ? kCream : Color{0.20, 0.25, 0.33}, street = mixed(kWhite, paper, 0.15);
  on.fill(mixed(paper, kDark, 0.12));
  for (int i = 0; i < 4; ++i) {
    const double x = p.random(0.05, 0.8), z = p.random(0.05, 0.8);
    on.bar(mixed({0.56, 0.70, 0.50}, paper, 0.3), x, x + 0.14, z, z + 0.11);
  }
  const double bend = p.random(0.3, 0.7);
  on.paint({0.56, 0.72, 0.82}, smooth({{0, bend - 0.05},
                                       {0.35, bend + 0.08},
                                       {0.7, bend - 0.12},
                                       {1, bend + 0.06},
                                       {1, bend + 0.14},
                                       {0.7, bend - 0.03},
                                       {0.35, bend + 0.17},
                                       {0, bend + 0.05}},
                                      4));
  for (int i = 0; i < 9; ++i) {
    const double a = p.random(0.02, 0.98), lean = p.random(-0.08, 0.08), half = i % 4 == 0 ? 0.009 : 0.004;
    on.paint(street, {{0, a - half}, {1, a + lean - half}, {1, a + lean + half}, {0, a + half}});
    on.paint(street, {{a - half, 0}, {a + half, 0}, {a + lean + half, 1}, {a + lean - half, 1}});
  }
}

void treasure_map(Piece& p, PictureSheet& on) {
  const Color paper{0.88, 0.78, 0.56}, ink{0.44, 0.30, 0.18}, red{0.74, 0.20, 0.16};
  on.fill(paper);
  on.stand_at({0.5, 0.5}, p.pick(2) == 0 ? 0.92 : -0.92);
  on.figure(
      ink,
      smooth(
          {{-0.76, -0.2}, {-0.6, 0.34}, {-0.2, 0.46}, {0.1, 0.72}, {0.56, 0.52}, {0.78, 0.0}, {0.5, -0.44}, {0.06, -0.4}, {-0.3, -0.7}}));
  on.figure({0.76, 0.70, 0.44}, smooth({{-0.72, -0.2},
                                        {-0.57, 0.3},
                                        {-0.18, 0.42},
                                        {0.1, 0.67},
                                        {0.53, 0.48},
                                        {0.73, 0.0},
                                        {0.48, -0.4},
                                        {0.06, -0.35},
                                        {-0.29, -0.64}}));
  for (const double x : {0.2, 0.36, 0.52}) on.figure(ink, {{x - 0.09, 0.24}, {x + 0.09, 0.24}, {x, 0.42}});
  for (const double x : {-0.46, -0.34}) on.round({0.42, 0.52, 0.30}, {x, 0.16}, 0.08, 0.1);
  for (const Vec2 q : {Vec2{-0.4, -0.3}, Vec2{-0.26, -0.2}, Vec2{-0.12, -0.12}, Vec2{0.04, -0.1}, Vec2{0.2, -0.1}})
    on.round(red, q, 0.028, 0.028);
  on.stroke(red, {{0.34, -0.2}, {0.52, -0.02}}, 0.06);
  on.stroke(red, {{0.34, -0.02}, {0.52, -0.2}}, 0.06);
}

}  // namespace

void add_maps(Drawings& to) { to.insert({{"world_map", world_map}, {"town_map", town_map}, {"treasure_map", treasure_map}}); }

}  // namespace layoutbox::kit::pictures
