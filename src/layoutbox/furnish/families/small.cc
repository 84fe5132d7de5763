// Small things in rooms: books, boxes, baskets, bins, suitcases, statues, globes.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

constexpr Color kCovers[] = {{0.66, 0.24, 0.22}, {0.24, 0.40, 0.58}, {0.28, 0.48, 0.38},
                             {0.84, 0.66, 0.32}, {0.36, 0.30, 0.42}, {0.80, 0.76, 0.68}};

// A closed book in that box: covers, and pages that stand back on three sides. `standing` turns its spine to the front.
void one_book(Piece& p, int cover, const Box& b) {
  const Vec s = b.size();
  const int pages = p.named("paper");
  const double board = std::min({0.003, s.x * 0.15, s.z * 0.15});
  if (s.x < s.z) {  // upright: spine towards −y
    p.add(cover, box(sides(b.min.x, b.min.x + board, b.min.y, b.max.y, b.min.z, b.max.z), 0.001));
    p.add(cover, box(sides(b.max.x - board, b.max.x, b.min.y, b.max.y, b.min.z, b.max.z), 0.001));
    p.add(cover, box(sides(b.min.x + board, b.max.x - board, b.min.y, b.min.y + board, b.min.z, b.max.z), 0));
    p.add(pages,
          box(sides(b.min.x + board, b.max.x - board, b.min.y + board, b.max.y - s.y * 0.03, b.min.z + s.z * 0.015, b.max.z - s.z * 0.015),
              0));
    return;
  }
  p.add(cover, box(sides(b.min.x, b.max.x, b.min.y, b.max.y, b.min.z, b.min.z + board), 0.001));
  p.add(cover, box(sides(b.min.x, b.max.x, b.min.y, b.max.y, b.max.z - board, b.max.z), 0.001));
  p.add(cover, box(sides(b.min.x, b.min.x + board, b.min.y, b.max.y, b.min.z + board, b.max.z - board), 0));
  p.add(
      pages,
      box(sides(b.min.x + board, b.max.x - s.x * 0.03, b.min.y + s.y * 0.015, b.max.y - s.y * 0.015, b.min.z + board, b.max.z - board), 0));
}

int cover_of(Piece& p) { return p.color_asked() ? p.main("paper") : p.tinted("paper", kCovers[p.pick(6)]); }

void book(Piece& p) { one_book(p, cover_of(p), p.body()); }

void book_stack(Piece& p) {
  const int n = std::clamp(static_cast<int>(std::lround(p.h / 0.035)), 2, 12);
  for (int i = 0; i < n; ++i) {
    // The lowest is as large as the stack; those above it are smaller and lie a little aside.
    const double in_x = i == 0 ? 0 : p.random(0, p.w * 0.14), in_y = i == 0 ? 0 : p.random(0, p.d * 0.14),
                 x = i == 0 ? 0 : p.random(-0.5, 0.5) * in_x, y = i == 0 ? 0 : p.random(-0.5, 0.5) * in_y;
    one_book(p, i == 0 ? cover_of(p) : p.tinted("paper", kCovers[p.pick(6)]),
             sides(-p.w / 2 + in_x / 2 + x, p.w / 2 - in_x / 2 + x, -p.d / 2 + in_y / 2 + y, p.d / 2 - in_y / 2 + y, p.h * i / n,
                   p.h * (i + 1) / n));
  }
}

void magazine(Piece& p) {
  p.add(cover_of(p), box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, p.h * 0.9), std::min(0.001, p.h * 0.2)));
  p.add(p.named("paper"), box(sides(-p.w * 0.42, p.w * 0.42, p.d * 0.2, p.d * 0.42, p.h * 0.88, p.h), 0));
  p.add(p.tinted("paper", kCovers[p.pick(6)]), box(sides(-p.w * 0.42, p.w * 0.42, -p.d * 0.42, p.d * 0.12, p.h * 0.88, p.h), 0));
}

// Four walls of woven courses, every other one standing out, under a thick rim.
void woven_box(Piece& p, int weave) {
  const double wall = 0.022, thin = 0.006;
  Box in = sides(-p.w / 2 + wall, p.w / 2 - wall, -p.d / 2 + wall, p.d / 2 - wall, wall, p.h);
  if (const FreeSpace* s = p.open_above()) in = s->box;
  const auto course = [&](double out, double z0, double z1, double bevel) {
    const double x = p.w / 2 - out, y = p.d / 2 - out;
    p.add(weave, box(sides(-x, x, -y, in.min.y, z0, z1), bevel));
    p.add(weave, box(sides(-x, x, in.max.y, y, z0, z1), bevel));
    p.add(weave, box(sides(-x, in.min.x, in.min.y - thin, in.max.y + thin, z0, z1), bevel));
    p.add(weave, box(sides(in.max.x, x, in.min.y - thin, in.max.y + thin, z0, z1), bevel));
  };
  const double rim = std::min(0.03, p.h * 0.15), step = in.max.x > 0 ? std::min({thin, p.w / 2 - in.max.x, p.d / 2 - in.max.y}) : 0;
  p.add(weave, box(sides(-p.w / 2 + step, p.w / 2 - step, -p.d / 2 + step, p.d / 2 - step, 0, in.min.z), 0.003));
  const int courses = std::clamp(static_cast<int>((p.h - rim) / 0.03), 3, 9);
  for (int i = 0; i < courses; ++i)
    course(i % 2 == 0 ? step * 0.3 : step, (p.h - rim) * i / courses, (p.h - rim) * (i + 1) / courses, std::min(0.004, step * 0.6));
  course(0, p.h - rim, p.h, std::min(0.008, rim * 0.3));
  // The stakes that the courses are woven round, and a darker braid below the rim.
  const int dark = p.tinted("rattan", {0.45, 0.3, 0.16});
  const double half = std::min(0.006, step * 1.5), x = p.w / 2, y = p.d / 2;
  for (const double side : {-1.0, 1.0}) {
    p.add(dark,
          box(sides(-x, x, std::min(side * y, side * (y - step)), std::max(side * y, side * (y - step)), p.h - rim * 1.7, p.h - rim), 0));
    p.add(dark,
          box(sides(std::min(side * x, side * (x - step)), std::max(side * x, side * (x - step)), -y, y, p.h - rim * 1.7, p.h - rim), 0));
    for (const double at : {-0.78, -0.39, 0.0, 0.39, 0.78}) {
      p.add(dark, box(sides(at * x - half, at * x + half, side > 0 ? y - step : -y, side > 0 ? y : -y + step, 0.004, p.h - rim), 0));
      p.add(dark, box(sides(side > 0 ? x - step : -x, side > 0 ? x : -x + step, at * y - half, at * y + half, 0.004, p.h - rim), 0));
    }
  }
}

// A round padded rim, full of balls up to the space that is for a child.
void ball_pool(Piece& p) {
  static constexpr Color kBalls[] = {{0.86, 0.24, 0.22}, {0.95, 0.78, 0.20}, {0.22, 0.50, 0.80}, {0.36, 0.66, 0.36}, {0.88, 0.46, 0.66}};
  const FreeSpace* in = p.open_above();
  const double r = std::min(p.w, p.d) / 2, kx = p.w / 2 / r, ky = p.d / 2 / r, level = in != nullptr ? in->box.min.z : p.h * 0.6;
  const double wall = in != nullptr ? std::clamp(r - std::hypot(in->box.max.x / kx, in->box.max.y / ky) - 0.004, 0.02, 0.14) : 0.12;
  const Pose shape = scaled(kx, ky, 1);
  p.add(p.main_accent("linen"),
        lathe({{0, 0}, {r, 0}, {r, p.h - 0.03}, {r - wall * 0.5, p.h}, {r - wall, p.h - 0.03}, {r - wall, 0.06}, {0, 0.06}}, 32), shape);
  const double ball = std::max(0.055, (r - wall) / 11);
  const int rings = std::max(1, static_cast<int>((r - wall) / (2 * ball)));
  for (int k = 0; k < rings; ++k) {
    const double at = ball * (2 * k + 1), n = std::max(1.0, std::floor(kPi * at / ball * 0.9));
    for (int i = 0; i < static_cast<int>(n); ++i) {
      const double a = 2 * kPi * i / n + 0.4 * k;
      p.add(p.tinted("plastic", kBalls[p.pick(5)]),
            ellipsoid({at * std::cos(a) * kx, at * std::sin(a) * ky, level - ball - 0.002 - p.random(0, 0.02)}, {ball, ball, ball}, 8, 5));
    }
  }
}

void basket(Piece& p) {
  const int weave = p.main("rattan");
  const FreeSpace* in = p.open_above();
  const double half = in != nullptr ? std::hypot(in->box.max.x, in->box.max.y * p.w / p.d) : 0;
  const bool round = std::abs(p.w - p.d) < 0.25 * p.w && half < p.w / 2 - 0.006;
  const double floor = in != nullptr ? in->box.min.z : 0.02;
  if (p.word("kind", "") == "pool") return ball_pool(p);
  if (!round) return woven_box(p, weave);
  const double r = p.w / 2, wall = std::min(0.012, r * 0.1);
  // As straight as what it must leave free asks for.
  const double need =
      in != nullptr ? std::hypot(std::max(-in->box.min.x, in->box.max.x), std::max(-in->box.min.y, in->box.max.y) * p.w / p.d) + wall : 0;
  const double foot = std::clamp(need, r * 0.8, r);
  // Courses of withies: every other one stands out a little, where that leaves free what the inside asks for.
  std::vector<Vec2> outside{{foot, 0}, {(foot + r) / 2, p.h * 0.4}};
  const double groove = wall * 0.4;
  if (need < foot - groove) {
    outside.clear();
    const int courses = std::clamp(static_cast<int>(p.h / 0.04), 4, 9);
    for (int i = 0; i < courses; ++i) {
      const double out = foot + (r - foot) * i / courses;
      outside.push_back({out - groove, p.h * 0.94 * i / courses});
      outside.push_back({out, p.h * 0.94 * (i + 0.5) / courses});
    }
  }
  outside.insert(outside.end(), {{r - wall * 0.3, p.h * 0.93}, {r, p.h * 0.95}, {r, p.h}});
  vessel(p, weave, outside, wall, floor, 32);
}

void box_container(Piece& p) {
  const int card = p.main_accent("cardboard");
  if (const FreeSpace* in = p.open_above()) {
    // What has room between its inside and its top has a lid; it is off while something is inside.
    const bool lid = in->box.max.z < p.h - 0.006;
    open_box(p, card, sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, lid && !in->held ? in->box.max.z : p.h), 0.01, 0.003);
    if (lid && !in->held) p.add(card, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, in->box.max.z + 0.003, p.h), 0.006));
    if (p.h > 0.3 && p.w > 0.6) {
      for (const double x : {-0.3, 0.3})
        p.add(p.named("brass"), box(sides(x * p.w - 0.02, x * p.w + 0.02, -p.d / 2, -p.d / 2 + 0.004, p.h * 0.62, p.h * 0.8), 0.001));
    }
    return;
  }
  const double lid = std::min(0.06, p.h * 0.3);
  p.add(card, box(sides(-p.w / 2 + 0.004, p.w / 2 - 0.004, -p.d / 2 + 0.004, p.d / 2 - 0.004, 0, p.h - lid), 0.004));
  p.add(card, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, p.h - lid, p.h), 0.004));
}

void bin(Piece& p) {
  const int metal = p.main("steel"), dark = p.named("black_plastic");
  const double r = p.w / 2, k = p.d / p.w;
  if (p.open_above() != nullptr) {
    const Box in = p.open_above()->box;
    const double need = std::min(r * 0.99, std::hypot(in.max.x, in.max.y / k) + 0.004);
    vessel(p, metal, {{std::clamp(need, r * 0.78, r), 0}, {r, p.h}}, std::min(0.004, r * 0.04), in.min.z, 30);
    return;
  }
  p.add(dark, lathe({{0, 0}, {r * 0.98, 0}, {r, p.h * 0.04}, {0, p.h * 0.04}}, 30), scaled(1, k, 1));
  p.add(metal, lathe({{0, p.h * 0.03}, {r * 0.97, p.h * 0.03}, {r * 0.97, p.h * 0.84}, {0, p.h * 0.84}}, 30), scaled(1, k, 1));
  p.add(dark, lathe({{0, p.h * 0.83}, {r, p.h * 0.83}, {r, p.h * 0.88}, {r * 0.8, p.h * 0.96}, {r * 0.3, p.h}, {0, p.h}}, 30),
        scaled(1, k, 1));
}

void suitcase(Piece& p) {
  const int shell = p.main_accent("plastic"), dark = p.named("black_plastic"), chrome = p.named("chrome");
  const double wheel = std::min(0.05, p.h * 0.08), grip = std::min(0.1, p.h * 0.13);
  p.add(shell, rounded_box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, wheel, p.h - grip), std::min({p.w, p.d}) * 0.16, 4));
  for (int i = -2; i <= 2; ++i)
    p.add(shell,
          box(sides(p.w * 0.16 * i - 0.006, p.w * 0.16 * i + 0.006, -p.d / 2, p.d / 2, wheel + p.h * 0.1, p.h - grip - p.h * 0.1), 0.003));
  for (const double x : {-0.36, 0.36}) {
    for (const double y : {-0.3, 0.3})
      p.add(dark, ellipsoid({x * p.w, y * p.d, wheel * 0.55}, {wheel * 0.4, wheel * 0.55, wheel * 0.55}, 10, 6));
    p.add(chrome, rod({x * p.w * 0.5, p.d * 0.25, p.h - grip - 0.02}, {x * p.w * 0.5, p.d * 0.25, p.h - 0.02}, 0.006, 8));
  }
  p.add(dark, rounded_box(sides(-p.w * 0.22, p.w * 0.22, p.d * 0.25 - 0.014, p.d * 0.25 + 0.014, p.h - 0.028, p.h), 0.01, 2));
}

// A ring on a plinth, leaning, with a ball in it.
void abstract_statue(Piece& p) {
  const int stone = p.main("stone");
  const double h = p.h, r = std::min(p.w, p.d) / 2, ring = std::min(r * 0.9, h * 0.34), thick = ring * 0.24;
  p.add(p.named("walnut"), box(sides(-r, r, -r * 0.7, r * 0.7, 0, h * 0.12), 0.004));
  p.add(p.named("black_metal"), cylinder({0, 0, h * 0.12}, std::max(0.003, r * 0.06), h * 0.16, 10));
  p.add(stone, torus({0, 0, 0}, ring, thick, 32, 12),
        moved(0, 0, h * 0.24 + ring + thick) * turned_z(18) * turned_x(90) * scaled(1, 1, 1.2));
  p.add(p.named("brass"), ellipsoid({0, 0, h * 0.24 + thick * 2 + ring * 0.3}, {ring * 0.34, ring * 0.34, ring * 0.34}, 18, 10));
  p.fit();
}

void statue(Piece& p) {
  if (p.word("kind", "") == "abstract") return abstract_statue(p);
  const int stone = p.main("stone");
  const double h = p.h, r = std::min(p.w, p.d) / 2;
  p.add(stone, box(sides(-r, r, -r, r, 0, h * 0.1), 0.006));
  p.add(stone, lathe({{0, h * 0.1},
                      {r * 0.7, h * 0.1},
                      {r * 0.55, h * 0.14},
                      {r * 0.42, h * 0.35},
                      {r * 0.5, h * 0.48},
                      {r * 0.36, h * 0.6},
                      {r * 0.6, h * 0.74},
                      {r * 0.5, h * 0.79},
                      {r * 0.16, h * 0.82},
                      {r * 0.15, h * 0.86},
                      {0, h * 0.86}},
                     22));
  p.add(stone, ellipsoid({0, 0, h * 0.925}, {r * 0.27, r * 0.3, h * 0.075}, 18, 10));
  for (const double s : {-1.0, 1.0})
    p.add(stone, tube(curve({{s * r * 0.56, 0, h * 0.73}, {s * r * 0.8, -r * 0.1, h * 0.58}, {s * r * 0.35, -r * 0.5, h * 0.52}}, 5),
                      r * 0.13, 8));
  p.fit();
}

void globe(Piece& p) {
  const int brass = p.named("brass"), wood = p.frame("walnut"), sea = p.tinted("paper", {0.36, 0.55, 0.70}),
            land = p.tinted("paper", {0.72, 0.66, 0.42});
  const double r = std::min({p.w / 2 * 0.92, p.d / 2, p.h * 0.36}), z = p.h - r * 1.08;
  p.add(wood, lathe({{0, 0}, {r * 0.75, 0}, {r * 0.7, p.h * 0.04}, {r * 0.12, p.h * 0.08}, {r * 0.1, z - r}, {0, z - r}}, 26));
  p.add(brass, torus({0, 0, 0}, r * 1.05, r * 0.03, 30, 6), moved(0, 0, z) * turned_y(20) * turned_x(90));
  p.add(sea, ellipsoid({0, 0, z}, {r * 0.97, r * 0.97, r * 0.97}, 28, 16));
  for (int i = 0; i < 7; ++i) {
    const double a = 0.9 * i + 0.3, b = std::sin(2.1 * i) * 0.8;
    const Vec n{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
    p.add(land, ellipsoid({0, 0, 0}, {r * 0.3, r * 0.22, r * 0.06}, 12, 4), aimed(Vec{0, 0, z} + n * (r * 0.935), n));
  }
  p.fit();
}

void aquarium(Piece& p) {
  const double base = p.h > 0.7 ? p.h * 0.5 : std::min(0.03, p.h * 0.1);
  const int dark = p.frame("black_plastic");
  p.add(dark, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, base), 0.005));
  const double lid = p.h - std::min(0.03, p.h * 0.08), in = 0.008, rim = std::min(0.02, p.d * 0.1);
  // A rim and a lamp across it; open else, so that the fish are seen from above.
  for (const double s : {-1.0, 1.0}) {
    p.add(dark, box(sides(s > 0 ? p.w / 2 - rim : -p.w / 2, s > 0 ? p.w / 2 : rim - p.w / 2, -p.d / 2, p.d / 2, lid, p.h), 0.003));
    p.add(dark,
          box(sides(-p.w / 2 + rim, p.w / 2 - rim, s > 0 ? p.d / 2 - rim : -p.d / 2, s > 0 ? p.d / 2 : rim - p.d / 2, lid, p.h), 0.003));
  }
  p.add(p.named("glass"), box(sides(-p.w / 2 + 0.003, -p.w / 2 + in - 0.001, -p.d / 2 + in, p.d / 2 - in, base, lid), 0));
  p.add(p.named("glass"), box(sides(p.w / 2 - in + 0.001, p.w / 2 - 0.003, -p.d / 2 + in, p.d / 2 - in, base, lid), 0));
  p.add(p.tinted("plastic", {0.16, 0.36, 0.52}), box(sides(-p.w / 2 + in, p.w / 2 - in, p.d / 2 - in, p.d / 2 - 0.002, base, lid), 0));
  p.add(p.tinted("soil", {0.76, 0.66, 0.48}),
        box(sides(-p.w / 2 + in, p.w / 2 - in, -p.d / 2 + in, p.d / 2 - in, base, base + (lid - base) * 0.12), 0));
  p.add(p.named("water"),
        box(sides(-p.w / 2 + in, p.w / 2 - in, -p.d / 2 + in, p.d / 2 - in, base + (lid - base) * 0.12, lid - (lid - base) * 0.12), 0));
  p.add(p.named("glass"), box(sides(-p.w / 2 + 0.003, p.w / 2 - 0.003, -p.d / 2 + 0.003, -p.d / 2 + in - 0.001, base, lid), 0));
  for (int i = 0; i < 6; ++i) {
    const double x = p.w * (-0.36 + 0.14 * i) + p.random(-0.03, 0.03) * p.w, l = std::min(p.w, p.h) * 0.1, y = p.random(-0.28, 0.28) * p.d;
    // Every other one at the surface, where it is seen from above.
    const double z = base + (lid - base) * (i % 2 == 0 ? 0.88 : p.random(0.45, 0.8)) - l * 0.2;
    const int fish = p.tinted("wax", {0.96, 0.38 + 0.1 * i, 0.14});
    p.add(fish, ellipsoid({x, y, z}, {l, l * 0.4, l * 0.5}, 12, 6));
    p.add(fish, prism({{x + l * 0.8, y}, {x + l * 1.4, y - l * 0.35}, {x + l * 1.4, y + l * 0.35}}, z - l * 0.2, z + l * 0.2));
  }
  for (int i = 0; i < 5; ++i) {
    const double x = p.w * (-0.4 + 0.2 * i);
    p.add(p.named("leaf"), leaf({x, p.d * 0.1, base + (lid - base) * 0.1},
                                {x + p.w * 0.02, p.d * 0.15, base + (lid - base) * p.random(0.5, 0.85)}, p.w * 0.03, 0.01, 3));
  }
}

}  // namespace

void add_small_things(Families& to) {
  to["book"] = book;
  to["book_stack"] = book_stack;
  to["magazine"] = magazine;
  to["basket"] = basket;
  to["box_container"] = box_container;
  to["box"] = box_container;
  to["bin"] = bin;
  to["suitcase"] = suitcase;
  to["statue"] = statue;
  to["globe"] = globe;
  to["aquarium"] = aquarium;
}

}  // namespace layoutbox::kit
