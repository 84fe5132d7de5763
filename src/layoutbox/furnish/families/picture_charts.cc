// Charts: bodies, elements, letters, figures.
#include <array>
#include <string>
#include <string_view>

#include "layoutbox/furnish/families/picture_sheet.h"

namespace layoutbox::kit::pictures {
namespace {

constexpr Color kInk{0.55, 0.56, 0.58};

void heading(PictureSheet& on, const Color& ink, std::string_view text) {
  on.fill(kWhite);
  on.bar(ink, 0.06, 0.94, 0.87, 0.95);
  on.letters(kWhite, text, {0.5, 0.91}, 0.045, 0.8);
}

void lines(Piece& p, PictureSheet& on, double x, double most, double top, int many) {
  for (int i = 0; i < many; ++i) on.bar(kInk, x, x + p.random(most * 0.6, most), top - 0.055 * i, top - 0.055 * i + 0.014);
}

void body(PictureSheet& on, double x) {
  const Color skin{0.87, 0.66, 0.54}, flesh{0.76, 0.36, 0.32}, bone{0.95, 0.92, 0.84};
  on.stand_at({x, 0.05}, std::min(1.25, 0.95 * on.upright()));
  for (const double s : {-1.0, 1.0}) {
    on.figure(
        skin,
        smooth({{0.2 * s, 1.24}, {0.3 * s, 1.2}, {0.4 * s, 0.86}, {0.46 * s, 0.56}, {0.38 * s, 0.56}, {0.28 * s, 0.9}, {0.18 * s, 1.1}},
               3));
    on.figure(
        skin,
        smooth({{0.02 * s, 0.66}, {0.22 * s, 0.7}, {0.2 * s, 0.36}, {0.16 * s, 0.04}, {0.22 * s, -0.0}, {0.08 * s, -0.0}, {0.06 * s, 0.34}},
               3));
  }
  on.figure(skin,
            smooth({{-0.24, 1.24}, {0.24, 1.24}, {0.22, 0.96}, {0.19, 0.8}, {0.23, 0.62}, {-0.23, 0.62}, {-0.19, 0.8}, {-0.22, 0.96}}, 4));
  on.block(skin, -0.07, 0.07, 1.2, 1.38);
  on.round(skin, {0, 1.5}, 0.13, 0.17);
  for (const double z : {1.16, 1.08, 1.0}) on.stroke(bone, {{-0.18, z - 0.03}, {0, z}, {0.18, z - 0.03}}, 0.025);
  on.round({0.86, 0.56, 0.52}, {-0.1, 1.06}, 0.07, 0.13);
  on.round({0.86, 0.56, 0.52}, {0.1, 1.06}, 0.07, 0.13);
  on.round({0.70, 0.20, 0.22}, {0.03, 1.03}, 0.06, 0.07);
  on.figure({0.56, 0.30, 0.26}, smooth({{-0.16, 0.9}, {0.1, 0.93}, {0.04, 0.85}, {-0.12, 0.82}}, 3));
  on.round({0.90, 0.66, 0.50}, {0, 0.73}, 0.13, 0.09);
  for (const double s : {-1.0, 1.0}) on.stroke(flesh, {{0.12 * s, 0.58}, {0.13 * s, 0.4}, {0.12 * s, 0.16}}, 0.05, 0.03);
}

void anatomy(Piece& p, PictureSheet& on) {
  heading(on, mixed(kGay[p.pick(5)], kDark, 0.35), "THE BODY");
  body(on, 0.5);
  for (const double z : {0.78, 0.62, 0.54, 0.36, 0.2}) {
    on.bar(kInk, 0.07, 0.22, z, z + 0.012);
    on.bar(kInk, 0.07, 0.17, z - 0.03, z - 0.02);
    on.bar(kInk, 0.78, 0.93, z - 0.05, z - 0.038);
    on.bar(kInk, 0.78, 0.88, z - 0.08, z - 0.07);
  }
}

// Bars and lines of text, or a round of shares.
void figures(Piece& p, PictureSheet& on) {
  constexpr const char* kTitles[] = {"HEALTH", "FACTS", "LEARN", "SAFETY FIRST"};
  heading(on, mixed(kGay[p.pick(5)], kDark, 0.35), kTitles[p.turn(4)]);
  if (p.pick(2) == 0) {
    for (int i = 0; i < 4; ++i) on.bar(kGay[i], 0.1 + 0.12 * i, 0.19 + 0.12 * i, 0.16, 0.16 + p.random(0.15, 0.55));
  } else {
    const int first = p.pick(5);
    on.disc(kGay[first], {0.33, 0.52}, 0.22);
    on.dome(kGay[(first + 1) % 5], {0.33, 0.52}, 0.22);
    on.disc(kWhite, {0.33, 0.52}, 0.1);
  }
  lines(p, on, 0.62, 0.3, 0.76, 11);
}

void chart(Piece& p, PictureSheet& on) { return p.turn(2) == 0 ? anatomy(p, on) : figures(p, on); }

// Rows of the periodic table from the top: x where an element stands, its group by its letter.
void elements(Piece&, PictureSheet& on) {
  constexpr std::array<const char*, 9> kRows = {"a................g", "ab..........ddeefg", "ab..........cddefg",
                                                "abhhhhhhhhhhccdefg", "abhhhhhhhhhhcccdfg", "abhhhhhhhhhhccccfg",
                                                "abhhhhhhhhhhccccfg", "...iiiiiiiiiiiiii.", "...iiiiiiiiiiiiii."};
  constexpr Color kGroups[] = {{0.88, 0.46, 0.42}, {0.94, 0.68, 0.40}, {0.62, 0.76, 0.70}, {0.54, 0.72, 0.50}, {0.48, 0.70, 0.82},
                               {0.62, 0.60, 0.84}, {0.78, 0.58, 0.78}, {0.93, 0.84, 0.54}, {0.80, 0.76, 0.66}};
  heading(on, {0.22, 0.28, 0.40}, "ELEMENTS");
  for (std::size_t row = 0; row < kRows.size(); ++row) {
    for (std::size_t column = 0; column < 18; ++column) {
      if (kRows[row][column] == '.') continue;
      const double x = 0.06 + 0.0489 * static_cast<double>(column), z = 0.76 - 0.08 * static_cast<double>(row) - (row > 6 ? 0.03 : 0);
      on.bar(kGroups[kRows[row][column] - 'a'], x, x + 0.042, z, z + 0.068);
    }
  }
}

void alphabet(Piece& p, PictureSheet& on) {
  const int first = p.pick(5), columns = on.upright() > 1 ? 4 : 7, rows = (26 + columns - 1) / columns;
  on.fill(kCream);
  for (int i = 0; i < 26; ++i) {
    const double x = 0.06 + 0.88 * (i % columns) / columns, wide = 0.88 / columns, high = 0.9 / rows, z = 0.95 - high * (i / columns + 1);
    on.bar(mixed(kGay[(first + i) % 5], kWhite, 0.25), x + wide * 0.06, x + wide * 0.94, z + high * 0.06, z + high * 0.94);
    const char letter = static_cast<char>('A' + i);
    on.letters(i % 2 == 0 ? kWhite : kDark, std::string_view(&letter, 1), {x + wide / 2, z + high / 2}, high * 0.56, wide * 0.6);
  }
}

void numbers(Piece&, PictureSheet& on) {
  on.fill(kCream);
  for (int i = 0; i < 10; ++i) {
    const double z = 0.92 - 0.088 * (i + 1);
    for (int k = 0; k <= i; ++k) on.disc(kGay[i % 5], {0.1 + 0.088 * k, z + 0.04}, std::min(0.036, 0.036 * on.upright()));
  }
}

// Letters that become smaller row by row.
void eye_test(Piece&, PictureSheet& on) {
  constexpr const char* kRows[] = {"E", "FP", "TOZ", "LPED", "PECFD", "EDFCZP", "FELOPZD"};
  on.fill(kWhite);
  double z = 0.86, high = 0.16;
  for (const char* row : kRows) {
    on.letters(kDark, row, {0.5, z - high / 2 + 0.04}, high);
    z -= high + 0.028;
    high *= 0.76;
  }
}

}  // namespace

void add_charts(Drawings& to) {
  to.insert({{"chart", chart},
             {"figures", figures},
             {"anatomy", anatomy},
             {"elements", elements},
             {"alphabet", alphabet},
             {"numbers", numbers},
             {"eye_test", eye_test}});
}

}  // namespace layoutbox::kit::pictures
