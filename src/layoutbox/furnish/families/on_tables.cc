// What lies and stands on tables: plates, pizzas, fruit, pens, papers, trophies.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

void xylophone(Piece& p) {
  const Color bars[] = {{0.82, 0.26, 0.24}, {0.92, 0.52, 0.22}, {0.95, 0.78, 0.28}, {0.40, 0.66, 0.36},
                        {0.26, 0.58, 0.62}, {0.26, 0.44, 0.76}, {0.50, 0.36, 0.66}, {0.82, 0.40, 0.60}};
  const int wood = p.frame("oak");
  const double x = p.w / 2, y = p.d / 2, top = p.open_above() != nullptr ? p.open_above()->box.min.z : p.h, bar = std::min(0.02, top * 0.3);
  p.legs(wood, top - bar, 0.04, 0.02);
  for (const double s : {-0.5, 0.5})
    p.add(wood, box(sides(-x, x, s * y - 0.012, s * y + 0.012, std::max(0.0, top - bar - 0.04), top - bar), 0.003));
  for (int i = 0; i < 8; ++i) {
    const double x0 = -x + p.w * i / 8, half = y * (1 - 0.06 * i);
    p.add(p.tinted("lacquer", bars[i]), box(sides(x0 + p.w * 0.012, x0 + p.w / 8 - p.w * 0.012, -half, half, top - bar, top), 0.004));
  }
}

void plate_stack(Piece& p) {
  const int clay = p.main("ceramic");
  const int n = std::clamp(static_cast<int>(p.h / 0.02), 2, 10);
  const double step = p.h / (n + 1.2), r = p.w / 2;
  for (int i = 0; i < n; ++i)
    p.add(clay,
          lathe({{0, 0}, {r * 0.55, 0}, {r * 0.65, step * 0.5}, {r, step * 1.9}, {r, step * 2.2}, {r * 0.62, step * 0.95}, {0, step * 0.7}},
                32),
          moved(0, 0, i * step));
  p.fit();
}

void pizza(Piece& p) {
  p.add(p.tinted("plaster", {0.80, 0.56, 0.30}), lathe({{0, 0}, {0.47, 0}, {0.5, 0.5}, {0.47, 1}, {0.42, 0.7}, {0, 0.6}}, 32));
  p.add(p.tinted("plaster", {0.93, 0.74, 0.36}), lathe({{0, 0.59}, {0.43, 0.59}, {0.41, 0.82}, {0, 0.82}}, 30));
  for (int i = 0; i < 9; ++i) {
    const double a = 2.4 * i, r = 0.11 * std::sqrt(i + 0.4);
    p.add(p.tinted("plaster", {0.70, 0.20, 0.14}), cylinder({r * std::cos(a), r * std::sin(a), 0.8}, 0.055, 0.12, 14));
  }
  for (int i = 0; i < 5; ++i)
    p.add(p.named("leaf"), leaf({0.3 * std::cos(i * 1.9), 0.3 * std::sin(i * 1.9), 0.82},
                                {0.22 * std::cos(i * 1.9 + 0.3), 0.22 * std::sin(i * 1.9 + 0.3), 0.95}, 0.05, 0.05));
  p.fit();
}

void melon(Piece& p) {
  const int rind = p.color_asked() ? p.main("plastic") : p.tinted("plastic", {0.24, 0.44, 0.22}),
            pale = p.tinted("plastic", {0.45, 0.62, 0.34});
  p.add(rind, ellipsoid({0, 0, p.h / 2}, {p.w / 2, p.d / 2, p.h / 2}, 28, 16));
  for (int i = 0; i < 8; ++i) {
    std::vector<Vec> path;
    const double a = kPi * i / 4;
    for (int k = 1; k < 10; ++k) {
      const double t = -kPi / 2 + kPi * k / 10;
      path.push_back({p.w / 2 * std::cos(t) * std::cos(a) * 0.995, p.d / 2 * std::cos(t) * std::sin(a) * 0.995,
                      p.h / 2 + p.h / 2 * std::sin(t) * 0.995});
    }
    p.add(pale, tube(path, std::min(p.w, p.h) * 0.018, 5));
  }
  p.fit();
}

void vegetable(Piece& p) {
  const int carrot = p.tinted("plastic", {0.90, 0.48, 0.16}), green = p.named("leaf");
  for (int i = 0; i < 3; ++i) {
    const double y = -0.22 + 0.22 * i, x = 0.04 * (i % 2);
    p.add(carrot, cone({0, 0, 0}, 0.02, 0.085, 0.62, 14), moved(-0.4 + x, y, 0.09) * turned_y(90));
    for (int k = 0; k < 4; ++k) p.add(green, leaf({0.21 + x, y, 0.09}, {0.48 + x, y + 0.1 * (k - 1.5), 0.13 + 0.05 * (k % 2)}, 0.07, 0.05));
  }
  p.fit();
}

void pen(Piece& p) {
  const int body = p.main_accent("plastic"), dark = p.named("black_plastic"), metal = p.named("chrome");
  // Lies along its longer side.
  const Pose lie = (p.w >= p.d ? Pose{} : turned_z(90)) * turned_y(90);
  p.add(body, cylinder({0, 0, -0.4}, 0.05, 0.66, 14), lie);
  p.add(dark, cylinder({0, 0, 0.26}, 0.052, 0.2, 14), lie);
  p.add(metal, cone({0, 0, -0.5}, 0.012, 0.05, 0.1, 14), lie);
  p.add(metal, box(sides(-0.065, -0.045, -0.01, 0.01, 0.28, 0.44), 0.002), lie);
  p.fit();
}

void trophy(Piece& p) {
  const int gold = p.main("brass"), base = p.named("ebony");
  p.add(base, box(sides(-0.22, 0.22, -0.22, 0.22, 0, 0.16), 0.02));
  p.add(gold, lathe({{0, 0.16},
                     {0.16, 0.16},
                     {0.05, 0.24},
                     {0.045, 0.4},
                     {0.18, 0.52},
                     {0.28, 0.72},
                     {0.3, 1.0},
                     {0.27, 1.0},
                     {0.25, 0.74},
                     {0, 0.56}},
                    26));
  for (const double s : {-1.0, 1.0})
    p.add(gold, tube(curve({{s * 0.28, 0, 0.92}, {s * 0.46, 0, 0.9}, {s * 0.42, 0, 0.68}, {s * 0.2, 0, 0.58}}, 4), 0.025, 8));
  p.fit();
}

// A sheet or a few of them, with lines of writing.
void papers(Piece& p) {
  const int white = p.named("paper"), ink = p.named("grey_plastic");
  const double x = p.w / 2, y = p.d / 2;
  p.add(white, box(sides(-x, x, -y, y, 0, p.h * 0.6), 0));
  p.add(white, box(sides(-x * 0.96, x * 0.96, -y * 0.96, y * 0.96, p.h * 0.6, p.h * 0.9), 0), turned_z(2));
  for (int i = 0; i < 6; ++i)
    p.add(ink, box(sides(-x * 0.7, x * (i % 3 == 2 ? 0.2 : 0.7), y * (0.7 - 0.22 * i) - y * 0.03, y * (0.7 - 0.22 * i) + y * 0.03,
                         p.h * 0.88, p.h),
                   0));
  p.fit();
}

// A roll on a spindle or of paper.
void paper_roll(Piece& p) {
  p.add(p.named("paper"), lathe({{0.2, 0}, {0.5, 0}, {0.5, 1}, {0.2, 1}, {0.2, 0}}, 30));
  p.add(p.named("cardboard"), lathe({{0.18, 0}, {0.21, 0}, {0.21, 1}, {0.18, 1}, {0.18, 0}}, 20));
  p.fit();
}

}  // namespace

void add_things_on_tables(Families& to) {
  to["xylophone"] = xylophone;
  to["plate_stack"] = plate_stack;
  to["pizza"] = pizza;
  to["melon"] = melon;
  to["vegetable"] = vegetable;
  to["pen"] = pen;
  to["trophy"] = trophy;
  to["papers"] = papers;
  to["paper_roll"] = paper_roll;
}

}  // namespace layoutbox::kit
