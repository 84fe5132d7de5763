// Portraits: one, a couple, a family, forebears in oil, saints.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/picture_sheet.h"

namespace layoutbox::kit::pictures {
namespace {

enum class Hair { kLong, kBun, kShort, kBeard, kCurls };

struct Person {
  Color skin, hair, clothes;
  Hair cut;
};

constexpr Color kSkins[] = {{0.93, 0.78, 0.67}, {0.86, 0.67, 0.53}, {0.69, 0.49, 0.37}, {0.48, 0.33, 0.26}, {0.95, 0.82, 0.72}};
constexpr Color kHairs[] = {{0.22, 0.17, 0.15}, {0.42, 0.28, 0.19}, {0.74, 0.56, 0.34}, {0.56, 0.28, 0.17}, {0.70, 0.68, 0.66}};
constexpr Color kClothes[] = {{0.30, 0.40, 0.54}, {0.64, 0.34, 0.32}, {0.36, 0.48, 0.42}, {0.84, 0.74, 0.58}, {0.50, 0.40, 0.54}};

Person someone(Piece& p, Hair cut) {
  const int skin = p.pick(5);
  return {kSkins[skin], kHairs[skin == 3 ? 0 : p.pick(5)], kClothes[p.pick(5)], cut};
}

// Not grey as yet.
Person grown_up(Piece& p, Hair cut) {
  Person who = someone(p, cut);
  who.hair = kHairs[who.skin.r < 0.5 ? 0 : p.pick(4)];
  return who;
}

Hair womans(Piece& p) { return p.pick(3) == 0 ? Hair::kBun : Hair::kLong; }
Hair mans(Piece& p) { return p.pick(2) == 0 ? Hair::kBeard : Hair::kShort; }

// By what is said of who it is, else by chance.
Hair hair_said(Piece& p) {
  for (const char* word : {"woman", "girl", "lady", "queen", "mother", "grandmother", "wife", "daughter"}) {
    if (p.says(word)) return womans(p);
  }
  for (const char* word : {"man", "boy", "king", "father", "grandfather", "husband", "son", "general", "captain"}) {
    if (p.says(word)) return mans(p);
  }
  return static_cast<Hair>(p.pick(5));
}

void hair_behind(PictureSheet& on, const Person& who) {
  if (who.cut == Hair::kLong)
    on.figure(who.hair, smooth({{-0.3, 0.1}, {-0.38, 0.5}, {-0.26, 0.9}, {0, 1.01}, {0.26, 0.9}, {0.38, 0.5}, {0.3, 0.1}, {0, 0.16}}));
  if (who.cut == Hair::kBun) on.round(who.hair, {0, 1.02}, 0.13, 0.12);
  if (who.cut == Hair::kBun) on.round(who.hair, {0, 0.7}, 0.29, 0.29);
  if (who.cut == Hair::kCurls) {
    for (const Vec2 q : {Vec2{-0.26, 0.56}, Vec2{0.26, 0.56}, Vec2{-0.22, 0.82}, Vec2{0.22, 0.82}, Vec2{0, 0.92}})
      on.round(who.hair, q, 0.17, 0.17);
  }
}

void hair_before(PictureSheet& on, const Person& who) {
  if (who.cut == Hair::kBeard)
    on.figure(who.hair,
              smooth({{-0.235, 0.62}, {-0.22, 0.38}, {0, 0.24}, {0.22, 0.38}, {0.235, 0.62}, {0.14, 0.48}, {0, 0.5}, {-0.14, 0.48}}));
  if (who.cut == Hair::kShort || who.cut == Hair::kBeard)
    on.figure(who.hair, smooth({{-0.25, 0.66},
                                {-0.26, 0.86},
                                {-0.08, 1.0},
                                {0.18, 0.95},
                                {0.27, 0.8},
                                {0.25, 0.66},
                                {0.17, 0.8},
                                {-0.04, 0.83},
                                {-0.19, 0.79}}));
  else  // parted
    on.figure(who.hair,
              smooth({{-0.25, 0.6}, {-0.25, 0.84}, {0, 0.98}, {0.25, 0.84}, {0.25, 0.6}, {0.16, 0.76}, {0.04, 0.86}, {-0.12, 0.76}}));
}

void features(PictureSheet& on, const Person& who) {
  const Color line = mixed(who.skin, kDark, 0.75), shade = mixed(who.skin, {0.56, 0.30, 0.24}, 0.28);
  for (const double s : {-1.0, 1.0}) {
    on.round(line, {0.095 * s, 0.655}, 0.026, 0.03);
    on.stroke(mixed(who.hair, kDark, 0.3), {{0.05 * s, 0.715}, {0.1 * s, 0.735}, {0.15 * s, 0.715}}, 0.02);
  }
  on.stroke(shade, {{0.01, 0.66}, {0.03, 0.56}, {-0.02, 0.55}}, 0.02);
  on.stroke({0.70, 0.36, 0.34}, {{-0.075, 0.475}, {0, 0.46}, {0.075, 0.475}}, 0.026);
}

// Head and shoulders; the sheet stands at the middle of the chest.
void head_and_shoulders(PictureSheet& on, const Person& who) {
  const Color shade = mixed(who.skin, {0.46, 0.26, 0.20}, 0.25);
  hair_behind(on, who);
  on.figure(who.clothes,
            smooth({{-0.62, -0.9}, {0.62, -0.9}, {0.6, -0.1}, {0.4, 0.14}, {0.12, 0.24}, {-0.12, 0.24}, {-0.4, 0.14}, {-0.6, -0.1}}, 4));
  on.figure(shade, smooth({{-0.12, 0.44}, {-0.11, 0.22}, {0, 0.1}, {0.11, 0.22}, {0.12, 0.44}}, 4));
  on.figure(who.skin,
            smooth({{0, 0.33}, {0.15, 0.42}, {0.235, 0.62}, {0.21, 0.82}, {0, 0.93}, {-0.21, 0.82}, {-0.235, 0.62}, {-0.15, 0.42}}));
  features(on, who);
  hair_before(on, who);
}

// What hangs behind people: a plain ground, paler round the head.
void ground(PictureSheet& on, const Color& color) {
  on.fill(color);
  on.disc(mixed(color, kWhite, 0.16), {0.5, 0.58}, 0.46);
}

// Somebody at `x` who rises out of the lower edge; `sunk`: a child, of whom less is seen.
void stand(PictureSheet& on, const Person& who, double x, double size, double sunk = 0) {
  constexpr double kChest = 0.85;  // from the middle of the chest down to what the edge cuts
  const double half = std::min(1.0, 1 / on.upright()) / 2;
  on.stand_at({x, (kChest - sunk) * std::abs(size) * half}, size);
  head_and_shoulders(on, who);
}

// One person, who looks either way: on a wide canvas nearer, and less of the shoulders is seen.
void stand_alone(Piece& p, PictureSheet& on, const Person& who) {
  const bool wide = on.upright() < 1;
  stand(on, who, 0.5, (p.turn(2) == 0 ? 1 : -1) * on.larger(wide ? 1.3 : 1), wide ? 0.45 : 0.15);
}

void portrait(Piece& p, PictureSheet& on) {
  ground(on, mixed(kClothes[p.pick(5)], kCream, p.random(0.35, 0.7)));
  stand_alone(p, on, someone(p, hair_said(p)));
}

// How far from the middle two stand side by side, in shares of the width.
double beside(const PictureSheet& on, double size) { return 0.25 * size * std::min(1.0, on.upright()); }

void family(Piece& p, PictureSheet& on) {
  const bool two_children = p.pick(2) == 0;
  ground(on, mixed(kClothes[p.pick(5)], kCream, p.random(0.5, 0.75)));
  const Person mother = grown_up(p, womans(p));
  Person father = grown_up(p, mans(p)), child = mother, other = mother;
  father.skin = mother.skin;
  child.clothes = kClothes[p.pick(5)];
  child.cut = Hair::kShort;
  other.clothes = kClothes[p.pick(5)];
  other.cut = p.pick(2) == 0 ? Hair::kBun : Hair::kLong;
  const double size = on.larger(0.88), side = (p.pick(2) == 0 ? 1 : -1) * beside(on, size);
  stand(on, father, 0.5 + side, size);
  stand(on, mother, 0.5 - side, size * 0.94);
  if (!two_children) return stand(on, child, 0.5, size * 0.74, 0.28);
  stand(on, other, 0.5 - side * 0.9, size * 0.66, 0.36);
  stand(on, child, 0.5 + side * 0.9, size * 0.64, 0.4);
}

void couple(Piece& p, PictureSheet& on) {
  const bool wedding = p.says("wedding") || p.says("bride");
  ground(on, mixed(kClothes[p.pick(5)], kCream, p.random(0.5, 0.75)));
  Person bride = grown_up(p, womans(p)), groom = grown_up(p, mans(p));
  if (wedding) bride.clothes = kWhite, groom.clothes = kDark;
  const double size = std::min(1.0, on.larger(0.92)), reach = beside(on, size);
  stand(on, groom, 0.5 + reach, size);
  if (wedding) {  // a veil, behind her
    on.stand_at({0.5 - reach, 0.85 * 0.92 * size * std::min(1.0, 1 / on.upright()) / 2}, size * 0.92);
    on.figure({0.90, 0.90, 0.90}, smooth({{-0.5, -0.6}, {-0.4, 0.5}, {-0.2, 0.96}, {0.06, 1.03}, {0.3, 0.8}, {0.36, 0}, {0.3, -0.6}}, 4));
  }
  stand(on, bride, 0.5 - reach, size * 0.92);
}

// Dark and varnished, with a ruff, lace or a chain.
void forebear(Piece& p, PictureSheet& on) {
  const Color dark{0.13, 0.10, 0.08};
  on.fill(dark);
  on.disc({0.25, 0.19, 0.13}, {0.46, 0.6}, 0.44, 1.1);
  on.disc({0.31, 0.24, 0.16}, {0.44, 0.64}, 0.3, 1.1);
  Person who = someone(p, hair_said(p));
  who.skin = mixed(who.skin, {0.80, 0.62, 0.40}, 0.35);
  who.hair = mixed(who.hair, dark, 0.35);
  constexpr Color kGowns[] = {{0.30, 0.09, 0.10}, {0.12, 0.18, 0.16}, {0.11, 0.13, 0.22}, {0.10, 0.09, 0.09}};
  who.clothes = kGowns[p.pick(4)];
  stand_alone(p, on, who);
  const int worn = p.pick(3);
  const Color lace{0.84, 0.78, 0.66}, gold{0.74, 0.56, 0.26};
  if (worn == 0) on.figure(lace, smooth({{-0.3, 0.2}, {0, 0.06}, {0.3, 0.2}, {0.22, 0.33}, {0, 0.27}, {-0.22, 0.33}}));
  if (worn == 1) on.figure(lace, {{-0.12, 0.24}, {0.12, 0.24}, {0.16, 0.02}, {0.06, -0.12}, {-0.06, -0.12}, {-0.16, 0.02}});
  if (worn == 2) on.stroke(gold, {{-0.34, 0.14}, {-0.2, -0.12}, {0, -0.2}, {0.2, -0.12}, {0.34, 0.14}}, 0.035);
  if (worn == 2) on.round(gold, {0, -0.26}, 0.06, 0.06);
}

// A saint on gold.
void icon(Piece& p, PictureSheet& on) {
  const Color gold{0.85, 0.66, 0.28}, red{0.52, 0.16, 0.14}, blue{0.16, 0.26, 0.44};
  const bool veiled = p.says("mary") || p.says("madonna") || p.says("virgin") || (!p.says("jesus") && !p.says("christ") && p.turn(2) == 0);
  on.fill(red);
  on.bar(gold, 0.06, 0.94, 0.06, 0.94);
  on.stand_at({0.5, 0.32}, on.larger(0.92));
  on.round({0.62, 0.42, 0.14}, {0, 0.64}, 0.48, 0.48);
  on.round({0.95, 0.83, 0.48}, {0, 0.64}, 0.45, 0.45);
  Person saint{{0.84, 0.66, 0.48}, {0.28, 0.18, 0.12}, veiled ? red : blue, veiled ? Hair::kBun : Hair::kBeard};
  if (!veiled) on.figure(saint.hair, smooth({{-0.27, 0.16}, {-0.31, 0.6}, {-0.2, 0.92}, {0.2, 0.92}, {0.31, 0.6}, {0.27, 0.16}, {0, 0.2}}));
  if (veiled) on.figure(blue, smooth({{-0.54, -0.56}, {-0.44, 0.3}, {-0.3, 0.78}, {0, 1.0}, {0.3, 0.78}, {0.44, 0.3}, {0.54, -0.56}}));
  head_and_shoulders(on, saint);
  if (veiled) {
    for (const double s : {-1.0, 1.0})
      on.figure(blue, smooth({{0, 0.9},
                              {0.26 * s, 0.78},
                              {0.36 * s, 0.3},
                              {0.6 * s, -0.6},
                              {0.2 * s, -0.6},
                              {0.2 * s, 0.2},
                              {0.24 * s, 0.6},
                              {0.12 * s, 0.82}},
                             4));
  } else {
    on.figure(red, {{-0.6, -0.6}, {-0.1, -0.6}, {0.3, 0.18}, {0.14, 0.22}, {-0.34, 0.1}, {-0.54, -0.1}});
  }
  on.bar(red, 0.06, 0.94, 0.03, 0.06);
}

}  // namespace

void add_people(Drawings& to) {
  to.insert({{"portrait", portrait}, {"family", family}, {"couple", couple}, {"forebear", forebear}, {"icon", icon}});
}

}  // namespace layoutbox::kit::pictures
