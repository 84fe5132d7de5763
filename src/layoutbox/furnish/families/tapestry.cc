// Cloths that hang on walls: woven figures, or what their words say, between a rod and a fringe.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/picture_sheet.h"

namespace layoutbox::kit::pictures {
namespace {

void diamond(PictureSheet& on, const Color& color, Vec2 at, double half, double high) {
  on.paint(color, {{at.x - half, at.y}, {at.x, at.y - high}, {at.x + half, at.y}, {at.x, at.y + high}});
}

// Bands and diamonds, one within the other.
void weave(Piece& p, PictureSheet& on) {
  const Color dark = mixed(p.second_accent(), {0.24, 0.18, 0.16}, 0.45), light = mixed(p.second_accent(), kCream, 0.5);
  for (const double z : {0.05, 0.93}) on.bar(dark, 0, 1, z, z + 0.02);
  for (const double z : {0.09, 0.89}) on.bar(light, 0, 1, z, z + 0.02);
  for (int i = 0; i < 8; ++i) {
    for (const double z : {0.15, 0.85}) diamond(on, i % 2 == 0 ? dark : light, {(i + 0.5) / 8, z}, 0.05, 0.025);
  }
  const double wide = p.random(0.34, 0.42);
  for (int k = 0; k < 4; ++k) diamond(on, k % 2 == 0 ? dark : light, {0.5, 0.5}, wide * (1 - 0.26 * k), 0.28 * (1 - 0.26 * k));
}

// Cords that meet in points below.
void macrame(PictureSheet& on) {
  const Color cord{0.80, 0.73, 0.60};
  for (int row = 0; row < 3; ++row) {
    const double top = 0.92 - 0.12 * row;
    for (int i = 0; i < 5 - row; ++i) {
      const double x = 0.5 + (i - (4 - row) / 2.0) * 0.18;
      on.paint(cord, {{x - 0.08, top}, {x - 0.06, top}, {x, top - 0.1}, {x + 0.06, top}, {x + 0.08, top}, {x, top - 0.14}});
    }
  }
  for (int i = 0; i < 14; ++i) on.bar(cord, 0.06 + 0.065 * i, 0.07 + 0.065 * i, 0.03, 0.4 + 0.1 * std::abs(i - 6.5) / 6.5);
}

void tapestry(Piece& p) {
  const double r = p.d / 2, fringe = std::min(0.06, p.h * 0.08), front = -p.d * 0.1, foot = fringe * 0.9, side = p.w / 2 - 0.003;
  const bool knotted = p.says("macrame");
  const int cloth = knotted && !p.color_asked() ? p.tinted("wool", {0.90, 0.85, 0.75}) : p.main_accent("wool");
  p.add(p.frame("oak"), rod({-p.w / 2, 0, p.h - r}, {p.w / 2, 0, p.h - r}, r, 12));
  p.add(cloth, box(sides(-side, side, front, p.d * 0.4, foot, p.h - r), 0.001));
  const int tassels = std::max(3, static_cast<int>(p.w / 0.03));
  for (int i = 0; i < tassels; ++i) {
    const double x = -side + 2 * side * (i + 0.5) / tassels;
    p.add(cloth, box(sides(x - 0.006, x + 0.006, front + p.d * 0.1, p.d * 0.35, 0, fringe), 0));
  }
  PictureSheet on(p, sides(-side, side, front, p.d * 0.4, foot, p.h - p.d), -p.d / 2);
  const std::string subject = subject_said(p);
  if (subject.empty() && knotted) return macrame(on);
  if (!subject.empty()) return drawings().at(subject)(p, on);
  // Arms hang in castles, woven figures elsewhere.
  p.is_style("medieval") ? drawings().at("arms")(p, on) : weave(p, on);
}

}  // namespace

void add_tapestry(Families& to) { to["tapestry"] = tapestry; }

}  // namespace layoutbox::kit::pictures
