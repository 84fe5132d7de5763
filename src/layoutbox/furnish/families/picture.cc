// Pictures and posters, and what they show.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// The canvas of a picture: shapes in shares of its sides, each layer a hair before the one below, so that no faces coincide.
class PictureSheet {
 public:
  PictureSheet(Piece& p, double x0, double x1, double z0, double z1, double y) : p_(p), x0_(x0), z0_(z0), w_(x1 - x0), h_(z1 - z0), y_(y) {}

  void paint(const Color& color, const std::vector<Vec2>& outline, int layer) {
    std::vector<Vec2> placed;
    for (const Vec2 q : outline) placed.push_back({x0_ + w_ * std::clamp(q.x, 0.02, 0.98), z0_ + h_ * std::clamp(q.y, 0.02, 0.98)});
    const Pose upright{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, y_, 0}};
    p_.add(p_.tinted("paper", color), prism(placed, -0.0002, std::min(0.0006, p_.d * 0.06) * layer), upright);
  }
  void bar(const Color& color, double x0, double x1, double z0, double z1, int layer) {
    paint(color, {{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}}, layer);
  }
  // Round in the room, whatever the canvas measures; `r` in shares of its shorter side, `tall`: higher than wide.
  void disc(const Color& color, Vec2 at, double r, int layer, double tall = 1) {
    const double side = std::min(w_, h_);
    paint(color, ellipse(at, {r * side / w_, r * tall * side / h_}, 24), layer);
  }

 private:
  Piece& p_;
  double x0_, z0_, w_, h_, y_;
};

constexpr Color kDark{0.20, 0.20, 0.24}, kWhite{0.97, 0.96, 0.93};
constexpr Color kGay[] = {{0.36, 0.62, 0.80}, {0.95, 0.74, 0.36}, {0.88, 0.48, 0.42}, {0.48, 0.70, 0.52}, {0.66, 0.56, 0.78}};

// A bear's or a cat's face.
void animal_face(Piece& p, PictureSheet& on) {
  const Color fur = p.pick(2) == 0 ? Color{0.66, 0.48, 0.33} : Color{0.86, 0.62, 0.36}, inner{0.93, 0.80, 0.68};
  on.bar(mixed(kGay[p.pick(5)], kWhite, 0.55), 0, 1, 0, 1, 1);
  for (const double s : {-1.0, 1.0}) {
    on.disc(fur, {0.5 + 0.27 * s, 0.72}, 0.13, 2);
    on.disc(inner, {0.5 + 0.27 * s, 0.72}, 0.07, 3);
  }
  on.disc(fur, {0.5, 0.47}, 0.34, 4);
  on.disc(inner, {0.5, 0.36}, 0.16, 5, 0.8);
  for (const double s : {-1.0, 1.0}) on.disc(kDark, {0.5 + 0.13 * s, 0.55}, 0.035, 6, 1.3);
  on.disc(kDark, {0.5, 0.41}, 0.05, 7, 0.75);
}

// A rocket among stars.
void rocket(Piece& p, PictureSheet& on) {
  const Color red{0.86, 0.36, 0.32};
  on.bar({0.16, 0.22, 0.40}, 0, 1, 0, 1, 1);
  for (int i = 0; i < 9; ++i) on.disc({0.98, 0.92, 0.66}, {p.random(0.08, 0.92), p.random(0.1, 0.92)}, p.random(0.012, 0.03), 2);
  on.disc({0.93, 0.84, 0.58}, {0.82, 0.82}, 0.1, 3);
  on.paint(red, {{0.28, 0.22}, {0.72, 0.22}, {0.6, 0.5}, {0.4, 0.5}}, 4);
  on.paint({0.96, 0.70, 0.28}, {{0.42, 0.24}, {0.5, 0.06}, {0.58, 0.24}}, 5);
  on.paint(kWhite, {{0.4, 0.24}, {0.6, 0.24}, {0.64, 0.5}, {0.5, 0.88}, {0.36, 0.5}}, 6);
  on.paint(red, {{0.435, 0.69}, {0.565, 0.69}, {0.5, 0.88}}, 7);
  on.disc(kGay[0], {0.5, 0.52}, 0.08, 7);
}

// A whale that spouts.
void whale(Piece& p, PictureSheet& on) {
  const Color blue = mixed(kGay[0], {0.12, 0.24, 0.42}, 0.25);
  on.bar({0.90, 0.94, 0.95}, 0, 1, 0, 1, 1);
  on.bar(mixed(kGay[0], kWhite, 0.45), 0, 1, 0, 0.22, 2);
  on.paint(blue, {{0.2, 0.4}, {0.08, 0.62}, {0.2, 0.58}, {0.27, 0.66}, {0.32, 0.42}}, 3);
  on.disc(blue, {0.54, 0.36}, 0.3, 4, 0.68);
  on.disc(kWhite, {0.6, 0.25}, 0.17, 5, 0.5);
  on.disc(kDark, {0.72, 0.42}, 0.025, 6);
  for (const double x : {-0.06, 0.0, 0.06}) on.disc(kGay[0], {0.56 + x, 0.7 + p.random(0, 0.1)}, 0.03, 5, 1.8);
}

// A balloon over hills.
void balloon(Piece& p, PictureSheet& on) {
  const int first = p.pick(5);
  on.bar({0.86, 0.93, 0.96}, 0, 1, 0, 1, 1);
  on.disc(kGay[3], {0.2, 0.02}, 0.4, 2, 0.5);
  on.disc(mixed(kGay[3], kWhite, 0.3), {0.8, 0.0}, 0.5, 3, 0.5);
  on.paint(kDark, {{0.44, 0.27}, {0.56, 0.27}, {0.555, 0.18}, {0.445, 0.18}}, 4);
  on.paint(kGay[first], {{0.3, 0.55}, {0.7, 0.55}, {0.55, 0.3}, {0.45, 0.3}}, 5);
  on.disc(kGay[first], {0.5, 0.64}, 0.26, 6);
  on.disc(kGay[(first + 1) % 5], {0.5, 0.64}, 0.11, 7, 2.35);
}

void for_a_child(Piece& p, PictureSheet& on) {
  switch (p.pick(4)) {
    case 0: return animal_face(p, on);
    case 1: return rocket(p, on);
    case 2: return whale(p, on);
    default: return balloon(p, on);
  }
}

// A heading, a figure or bars, and lines of text.
void chart(Piece& p, PictureSheet& on) {
  const Color ink = mixed(kGay[p.pick(5)], kDark, 0.35);
  on.bar(kWhite, 0, 1, 0, 1, 1);
  on.bar(ink, 0.08, 0.92, 0.86, 0.94, 2);
  if (p.pick(2) == 0) {  // a body
    const Color skin{0.87, 0.66, 0.54};
    on.disc(skin, {0.36, 0.72}, 0.08, 2, 1.2);
    on.paint(skin,
             {{0.26, 0.62}, {0.46, 0.62}, {0.43, 0.38}, {0.43, 0.1}, {0.37, 0.1}, {0.36, 0.36}, {0.35, 0.1}, {0.29, 0.1}, {0.29, 0.38}}, 2);
    on.paint(skin, {{0.2, 0.36}, {0.26, 0.62}, {0.3, 0.6}, {0.24, 0.35}}, 3);
    on.paint(skin, {{0.52, 0.36}, {0.46, 0.62}, {0.42, 0.6}, {0.48, 0.35}}, 3);
    on.disc({0.78, 0.30, 0.28}, {0.38, 0.55}, 0.035, 4);
  } else {
    for (int i = 0; i < 4; ++i) on.bar(kGay[i], 0.1 + 0.12 * i, 0.19 + 0.12 * i, 0.16, 0.16 + p.random(0.15, 0.55), 2);
  }
  for (int i = 0; i < 7; ++i) on.bar({0.55, 0.56, 0.58}, 0.6, 0.6 + p.random(0.2, 0.3), 0.72 - 0.08 * i, 0.74 - 0.08 * i, 2);
}

// Simple compositions: hills and a sun, blocks of colour, arches.
void composition(Piece& p, PictureSheet& on, bool abstract) {
  const Color accent = p.color_asked() ? Color{0.45, 0.5, 0.55} : p.accent();
  const Color deep = mixed(accent, {0.1, 0.12, 0.16}, 0.5), warm = p.second_accent(), pale{0.90, 0.84, 0.74};
  const int kind = abstract ? 1 : p.pick(3);
  if (kind == 0) {
    on.bar(mixed(accent, {0.9, 0.93, 0.96}, 0.75), 0, 1, 0.3, 1, 1);
    on.disc(warm, {p.random(0.3, 0.7), 0.72}, 0.1, 2);
    for (int k = 0; k < 3; ++k) {
      std::vector<Vec2> hill{{0, 0}, {1, 0}};
      const double phase = p.random(0, 6), level = 0.5 - 0.15 * k;
      for (int i = 12; i >= 0; --i) hill.push_back({i / 12.0, level + 0.07 * std::sin(phase + i * 0.6)});
      on.paint(mixed(accent, deep, k / 2.0), hill, 3 + k);
    }
  } else if (kind == 1) {
    const double a = p.random(0.35, 0.6), b = p.random(0.4, 0.65);
    on.bar(accent, 0.06, a, 0.06, b, 1);
    on.bar(warm, a + 0.03, 0.94, 0.06, b - 0.12, 1);
    on.bar(deep, a - 0.1, 0.94, b + 0.03, 0.94, 1);
    on.bar(pale, 0.06, a - 0.13, b + 0.03, 0.94, 1);
  } else {
    for (int k = 0; k < 3; ++k) {
      const double r = 0.42 - 0.12 * k;
      std::vector<Vec2> arch{{0.5 - r, 0.08}, {0.5 + r, 0.08}};
      for (int i = 0; i <= 14; ++i) arch.push_back({0.5 + r * std::cos(kPi * i / 14), 0.45 + r * std::sin(kPi * i / 14)});
      on.paint(k == 0 ? accent : k == 1 ? pale : warm, arch, 1 + k);
    }
  }
}

void picture(Piece& p) {
  const std::string said = p.word("kind", "");
  // Posters and canvases have no frame.
  const bool bare = said == "poster" || said == "canvas";
  const double t = bare ? 0 : std::min({0.025, p.w * 0.2, p.h * 0.2}), y = -p.d / 2 + std::min(bare ? 0.003 : 0.006, p.d * 0.45);
  if (!bare) picture_frame(p, p.frame("walnut"), t);
  const double x0 = -p.w / 2 + t, x1 = p.w / 2 - t, z0 = t, z1 = p.h - t;
  p.add(p.main("paper"), box(sides(x0, x1, y, p.d / 2 - 0.001, z0, z1), 0));
  PictureSheet on(p, x0, x1, z0, z1, y);
  if (p.says("chart") || p.pictures() == "chart") return chart(p, on);
  if (p.pictures() == "child") return for_a_child(p, on);
  composition(p, on, said == "abstract");
}

}  // namespace

void add_pictures(Families& to) { to["picture"] = picture; }

}  // namespace layoutbox::kit
