// What stands on tables: vessels, cutlery, food, candles.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

void vase(Piece& p) {
  const double r = p.w / 2, h = p.h;
  const FreeSpace* in = p.open_above();
  const double neck = std::clamp(in != nullptr ? std::hypot(in->box.max.x, in->box.max.y) * 1.03 + r * 0.08 : 0, r * 0.42, r * 0.9);
  vessel(p, p.main_accent("ceramic"),
         {{r * 0.55, 0},
          {r * 0.9, h * 0.22},
          {r, h * 0.42},
          {std::max(neck, r * 0.82), h * 0.68},
          {neck, h * 0.88},
          {std::max(neck, r * 0.5), h}},
         r * 0.08, h * 0.05);
}

void fruit(Piece& p);

// With fruit in it where it is a fruit bowl, and nothing else is in it.
void bowl(Piece& p) {
  if (p.says("fruit") && p.spaces.empty() && p.w > 0.13) return fruit(p);
  const double r = p.w / 2, h = p.h;
  vessel(p, p.main("ceramic"), {{r * 0.45, 0}, {r * 0.48, h * 0.08}, {r * 0.8, h * 0.4}, {r * 0.95, h * 0.75}, {r, h}},
         std::min(0.006, r * 0.06), h * 0.1);
}

void plate(Piece& p) {
  const double r = p.w / 2, h = p.h;
  p.add(p.main("ceramic"),
        lathe({{0, 0}, {r * 0.55, 0}, {r * 0.65, h * 0.25}, {r, h * 0.8}, {r, h}, {r * 0.64, h * 0.5}, {r * 0.55, h * 0.3}, {0, h * 0.3}},
              36),
        scaled(1, p.d / p.w, 1));
}

// The handle sticks out to the right, so the cup itself is as wide as it is deep.
void cup(Piece& p) {
  const int clay = p.main_accent("ceramic");
  const double r = std::min(p.w, p.d) / 2, h = p.h, cx = -p.w / 2 + r, room = p.w - 2 * r;
  const std::vector<Vec2> profile{{0, 0},        {r * 0.75, 0},       {r, h * 0.2},        {r, h},
                                  {r * 0.92, h}, {r * 0.92, h * 0.2}, {r * 0.7, h * 0.08}, {0, h * 0.08}};
  p.add(clay, lathe(profile, 26), moved(cx, 0, 0) * scaled(1, p.d / (2 * r), 1));
  p.add(p.named("walnut"), lathe({{0, h * 0.6}, {r * 0.915, h * 0.6}, {r * 0.915, h * 0.8}, {0, h * 0.8}}, 22),
        moved(cx, 0, 0) * scaled(1, p.d / (2 * r), 1));
  if (room > 0.008) {
    const double t = std::min(0.006, room * 0.2);
    p.add(clay,
          tube(curve({{cx + r * 0.97, 0, h * 0.78}, {p.w / 2 - t, 0, h * 0.7}, {p.w / 2 - t, 0, h * 0.4}, {cx + r * 0.97, 0, h * 0.28}}, 4),
               t, 8));
    p.fit();
  }
}

void bottle(Piece& p) {
  const double r = p.w / 2, h = p.h, k = p.d / p.w;
  p.add(p.color_asked() ? p.main("frosted_glass") : p.tinted("frosted_glass", {0.16, 0.34, 0.22}),
        lathe({{0, 0}, {r, 0}, {r, h * 0.55}, {r * 0.7, h * 0.68}, {r * 0.36, h * 0.76}, {r * 0.36, h * 0.93}, {0, h * 0.93}}, 22),
        scaled(1, k, 1));
  p.add(p.named("walnut"), lathe({{0, h * 0.92}, {r * 0.38, h * 0.92}, {r * 0.38, h}, {0, h}}, 16), scaled(1, k, 1));
  p.add(p.named("paper"), lathe({{r * 0.99, h * 0.16}, {r, h * 0.16}, {r, h * 0.44}, {r * 0.99, h * 0.44}, {r * 0.99, h * 0.16}}, 22),
        scaled(1, k, 1));
}

void glass(Piece& p) {
  const double r = p.w / 2, h = p.h;
  const int clear = p.main("glass");
  if (p.says("wine") || p.says("champagne")) {
    p.add(clear,
          lathe({{0, 0},
                 {r * 0.8, 0},
                 {r * 0.75, h * 0.02},
                 {r * 0.08, h * 0.06},
                 {r * 0.07, h * 0.45},
                 {r * 0.6, h * 0.55},
                 {r, h * 0.72},
                 {r * 0.85, h},
                 {r * 0.8, h},
                 {r * 0.93, h * 0.72},
                 {0, h * 0.52}},
                24),
          scaled(1, p.d / p.w, 1));
    return;
  }
  vessel(p, clear, {{r * 0.8, 0}, {r, h}}, r * 0.07, h * 0.08);
  p.add(p.named("water"), lathe({{0, h * 0.09}, {r * 0.75, h * 0.09}, {r * 0.85, h * 0.6}, {0, h * 0.6}}, 22), scaled(1, p.d / p.w, 1));
}

void cutlery(Piece& p) {
  const int steel = p.main("steel");
  const double t = p.h;
  // Fork, knife and spoon lie side by side, handles to the front.
  const double pitch = p.w / 3;
  for (int i = 0; i < 3; ++i) {
    const double x = -p.w / 2 + pitch * (i + 0.5), half = std::min(0.006, pitch * 0.25);
    p.add(steel, box(sides(x - half, x + half, -p.d / 2, p.d * 0.12, 0, t), 0.001));
    if (i == 0) {
      p.add(steel, box(sides(x - pitch * 0.4, x + pitch * 0.4, p.d * 0.12, p.d * 0.26, 0, t), 0.001));
      for (int k = 0; k < 3; ++k)
        p.add(steel, box(sides(x + pitch * (-0.4 + 0.31 * k), x + pitch * (-0.4 + 0.31 * k + 0.18), p.d * 0.26, p.d / 2, 0, t), 0.0005));
    } else if (i == 1) {
      p.add(steel, prism({{x - half, p.d * 0.12}, {x + pitch * 0.35, p.d * 0.14}, {x + pitch * 0.3, p.d * 0.42}, {x - half, p.d / 2}}, 0,
                         t * 0.7));
    } else {
      p.add(steel, ellipsoid({x, p.d * 0.3, t * 0.5}, {pitch * 0.42, p.d * 0.2, t * 0.5}, 16, 6));
    }
  }
  p.fit();
}

void pot(Piece& p) {
  const int steel = p.main("steel"), dark = p.named("black_plastic");
  const double grip = std::min(0.045, p.w * 0.12), r = std::min(p.w / 2 - grip, p.d / 2), body = p.h * 0.78;
  p.add(steel, lathe({{0, 0}, {r * 0.96, 0}, {r, body * 0.06}, {r, body}, {0, body}}, 30));
  p.add(steel,
        lathe({{0, body}, {r * 1.02, body}, {r * 0.98, body + p.h * 0.05}, {r * 0.5, body + p.h * 0.1}, {0, body + p.h * 0.11}}, 30));
  p.add(dark, lathe({{0, body + p.h * 0.1}, {r * 0.08, body + p.h * 0.1}, {r * 0.16, p.h * 0.96}, {r * 0.14, p.h}, {0, p.h}}, 16));
  for (const double s : {-1.0, 1.0})
    p.add(dark, tube(curve({{s * r * 0.96, -r * 0.3, body * 0.82},
                            {s * (r + grip * 0.8), -r * 0.2, body * 0.85},
                            {s * (r + grip * 0.8), r * 0.2, body * 0.85},
                            {s * r * 0.96, r * 0.3, body * 0.82}},
                           3),
                     grip * 0.18, 6));
  p.fit();
}

void pan(Piece& p) {
  const int iron = p.main("black_metal");
  const double r = std::min(p.d, p.w) / 2, cx = p.w > p.d ? -p.w / 2 + r : 0, cy = p.w > p.d ? 0 : p.d / 2 - r, deep = p.h * 0.7;
  p.add(iron, lathe({{0, 0}, {r * 0.82, 0}, {r, deep}, {r * 0.97, deep}, {r * 0.8, deep * 0.15}, {0, deep * 0.15}}, 32), moved(cx, cy, 0));
  const Vec way = p.w > p.d ? Vec{1, 0, 0} : Vec{0, -1, 0}, from = Vec{cx, cy, deep * 0.8} + way * (r * 0.95);
  const double length_out = std::abs(p.w - p.d) + r * 0.05;
  p.add(p.named("walnut"), beam(from, from + way * length_out + Vec{0, 0, p.h * 0.2}, {0.025, 0.014}, 0.004));
  p.fit();
}

void candle(Piece& p) {
  const double r = p.w / 2, wick = std::min(0.03, p.h * 0.18), body = p.h - wick;
  p.add(p.main("wax"), lathe({{0, 0}, {r, 0}, {r, body * 0.98}, {r * 0.85, body}, {0, body * 0.97}}, 22), scaled(1, p.d / p.w, 1));
  p.add(p.named("black_plastic"), cylinder({0, 0, body * 0.96}, std::min(0.0015, r * 0.1), wick * 0.35, 6));
  p.add(p.named("ember"), lathe({{0, 0}, {wick * 0.16, wick * 0.25}, {wick * 0.12, wick * 0.5}, {0, wick * 0.85}}, 10),
        moved(0, 0, body + wick * 0.15));
  p.light({0, 0, p.h + 0.01}, 1.5, 0.01);
}

void tray(Piece& p) {
  const int wood = p.main("oak");
  open_box(p, wood, p.body(), std::min(0.012, p.h * 0.3), 0.003);
}

void jar(Piece& p) {
  const double r = p.w / 2, h = p.h, k = p.d / p.w;
  if (const FreeSpace* in = p.open_above()) {
    // A pot open above, as straight as what it holds asks for.
    const double wall = std::max(0.002, r * 0.05), need = std::hypot(in->box.max.x, in->box.max.y / k) * 1.015 + wall;
    vessel(p, p.main("terracotta"),
           {{std::clamp(need, r * 0.8, r * 0.99), 0}, {std::clamp(need + r * 0.01, r * 0.9, r * 0.995), h * 0.8}, {r, h * 0.82}, {r, h}},
           wall, in->box.min.z);
    return;
  }
  p.add(p.main("glass"), lathe({{0, 0}, {r, 0}, {r, h * 0.72}, {r * 0.8, h * 0.82}, {0, h * 0.82}}, 26), scaled(1, k, 1));
  p.add(p.tinted("paper", {0.78, 0.58, 0.34}), lathe({{0, h * 0.03}, {r * 0.9, h * 0.03}, {r * 0.9, h * 0.55}, {0, h * 0.58}}, 22),
        scaled(1, k, 1));
  p.add(p.named("walnut"), lathe({{0, h * 0.81}, {r * 0.82, h * 0.81}, {r * 0.82, h}, {0, h}}, 24), scaled(1, k, 1));
}

// The colours of what is said to be in it, else of all sorts.
std::vector<Color> colors_of_fruit(const Piece& p) {
  struct Sort {
    std::string_view one, several;
    Color color;
  };
  static constexpr Sort kSorts[] = {{"apple", "apples", {0.76, 0.22, 0.18}},   {"orange", "oranges", {0.90, 0.55, 0.18}},
                                    {"pear", "pears", {0.62, 0.72, 0.26}},     {"lemon", "lemons", {0.94, 0.84, 0.25}},
                                    {"lime", "limes", {0.45, 0.66, 0.20}},     {"peach", "peaches", {0.93, 0.66, 0.45}},
                                    {"plum", "plums", {0.38, 0.16, 0.32}},     {"clementine", "clementines", {0.92, 0.50, 0.14}},
                                    {"tomato", "tomatoes", {0.80, 0.18, 0.14}}};
  constexpr std::size_t kUsual = 4;
  std::vector<Color> said, usual;
  for (const Sort& sort : kSorts) {
    if (p.says(sort.one) || p.says(sort.several)) said.push_back(sort.color);
    if (usual.size() < kUsual) usual.push_back(sort.color);
  }
  return said.empty() ? usual : said;
}

void fruit(Piece& p) {
  const std::vector<Color> colors = colors_of_fruit(p);
  const auto apple = [&](Vec at, double r, const Color& color) {
    p.add(p.tinted("wax", color),
          lathe({{0, 0.12},
                 {0.3, 0.02},
                 {0.52, 0.08},
                 {0.74, 0.3},
                 {0.9, 0.62},
                 {0.99, 1.0},
                 {0.98, 1.3},
                 {0.88, 1.58},
                 {0.68, 1.78},
                 {0.42, 1.86},
                 {0.2, 1.78},
                 {0, 1.62}},
                20),
          moved(at) * scaled(r, r, r));
    p.add(p.named("walnut"), rod(at + Vec{0, 0, r * 1.6}, at + Vec{r * 0.15, 0, r * 2.1}, r * 0.06, 5));
  };
  if (p.w > 0.13) {
    const double r = p.w / 2;
    vessel(p, p.named("ceramic"), {{r * 0.4, 0}, {r * 0.75, p.h * 0.25}, {r, p.h * 0.55}}, r * 0.05, p.h * 0.06);
    for (int i = 0; i < 7; ++i) {
      const double a = 2 * kPi * i / 6, out = i == 6 ? 0 : r * 0.48;
      apple({std::cos(a) * out, std::sin(a) * out, p.h * (i == 6 ? 0.5 : 0.22)}, std::min(r * 0.28, p.h * 0.22),
            colors[static_cast<std::size_t>(i) % colors.size()]);
    }
  } else {
    apple({0, 0, 0}, p.w / 2, colors[static_cast<std::size_t>(p.pick(static_cast<int>(colors.size())))]);
  }
  p.fit();
}

void bread(Piece& p) {
  if (p.category() == "soap") return p.add(p.main_accent("wax"), rounded_box(p.body(), std::min(p.d, p.h) * 0.4, 4));
  p.add(p.tinted("wax", {0.72, 0.47, 0.22}), rounded_box(p.body(), std::min(p.d, p.h) * 0.45, 5));
  for (int i = -1; i <= 1; ++i)
    p.add(p.tinted("wax", {0.88, 0.72, 0.48}), beam({p.w * (0.25 * i - 0.05), -p.d * 0.2, p.h * 0.985},
                                                    {p.w * (0.25 * i + 0.05), p.d * 0.2, p.h * 0.985}, {p.w * 0.03, p.h * 0.03}, 0.001));
}

void cake(Piece& p) {
  const double r = p.w / 2, h = p.h, k = p.d / p.w;
  p.add(p.named("ceramic"), lathe({{0, 0}, {r, 0}, {r, h * 0.06}, {0, h * 0.06}}, 32), scaled(1, k, 1));
  p.add(p.tinted("wax", {0.93, 0.80, 0.74}),
        lathe({{0, h * 0.06}, {r * 0.86, h * 0.06}, {r * 0.86, h * 0.8}, {r * 0.8, h * 0.86}, {0, h * 0.86}}, 32), scaled(1, k, 1));
  p.add(p.tinted("wax", {0.38, 0.22, 0.15}),
        lathe({{r * 0.85, h * 0.38}, {r * 0.87, h * 0.38}, {r * 0.87, h * 0.48}, {r * 0.85, h * 0.48}, {r * 0.85, h * 0.38}}, 32),
        scaled(1, k, 1));
  for (int i = 0; i < 8; ++i) {
    const double a = 2 * kPi * i / 8, b = std::min(r * 0.12, h * 0.08);
    p.add(p.tinted("wax", {0.76, 0.2, 0.2}), ellipsoid({std::cos(a) * r * 0.65, std::sin(a) * r * 0.65 * k, h - b}, {b, b, b}, 10, 6));
  }
}

void food_plate(Piece& p) {
  const double r = p.w / 2, h = p.h, k = p.d / p.w, rim = std::min(0.02, h * 0.4);
  p.add(p.named("ceramic"), lathe({{0, 0}, {r * 0.55, 0}, {r, rim * 0.8}, {r, rim}, {r * 0.6, rim * 0.4}, {0, rim * 0.4}}, 32),
        scaled(1, k, 1));
  p.add(p.tinted("wax", {0.80, 0.58, 0.30}),
        ellipsoid({-r * 0.15, 0, rim * 0.4 + (h - rim * 0.4) / 2}, {r * 0.38, r * 0.34 * k, (h - rim * 0.4) / 2}, 16, 8));
  p.add(p.tinted("wax", {0.36, 0.56, 0.25}),
        ellipsoid({r * 0.35, r * 0.15 * k, rim * 0.4 + h * 0.2}, {r * 0.2, r * 0.22 * k, h * 0.22}, 12, 6));
  p.add(p.tinted("wax", {0.78, 0.28, 0.2}),
        ellipsoid({r * 0.28, -r * 0.25 * k, rim * 0.4 + h * 0.18}, {r * 0.15, r * 0.15 * k, h * 0.2}, 12, 6));
}

}  // namespace

void add_tableware(Families& to) {
  to["vase"] = vase;
  to["bowl"] = bowl;
  to["plate"] = plate;
  to["cup"] = cup;
  to["bottle"] = bottle;
  to["glass"] = glass;
  to["cutlery"] = cutlery;
  to["pot"] = pot;
  to["pan"] = pan;
  to["candle"] = candle;
  to["tray"] = tray;
  to["jar"] = jar;
  to["fruit"] = fruit;
  to["bread"] = bread;
  to["cake"] = cake;
  to["food_plate"] = food_plate;
}

}  // namespace layoutbox::kit
