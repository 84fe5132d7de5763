// Devices: what plugs in and is not a screen.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

void mouse(Piece& p) {
  std::vector<Vec2> arch{{0, 0}, {0.94, 0}, {1, 0.1}};
  for (int i = 1; i <= 8; ++i) {
    const double a = kPi / 2 * i / 8;
    arch.push_back({std::cos(a) * (i == 8 ? 0 : 1), 0.16 + 0.84 * std::sin(a)});
  }
  p.add(p.main("black_plastic"), lathe(arch, 32), scaled(p.w / 2, p.d / 2, p.h * 0.97));
  // Its wheel stands a little out of the back, near the front.
  const double r = p.h * 0.3, z = p.h * 0.97 * (0.16 + 0.84 * 0.79) - r * 0.35;
  p.add(p.named("grey_plastic"), rod({-p.w * 0.05, -p.d * 0.3, z}, {p.w * 0.05, -p.d * 0.3, z}, r * 0.7, 16));
  p.fit();
}

void phone(Piece& p) {
  p.add(p.main("black_plastic"),
        rounded_box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, p.h * 0.95), std::min({p.w * 0.12, p.h * 0.45}), 3));
  p.add(p.named("screen"), box(sides(-p.w * 0.46, p.w * 0.46, -p.d * 0.47, p.d * 0.47, p.h * 0.9, p.h), 0));
}

void printer(Piece& p) {
  const int body = p.main("grey_plastic"), dark = p.named("black_plastic"), paper = p.named("paper");
  const double low = p.h * 0.78;
  p.add(body, box(sides(-p.w / 2, p.w / 2, -p.d * 0.3, p.d / 2, 0, low), 0.012));
  p.add(dark, box(sides(-p.w * 0.4, p.w * 0.4, -p.d * 0.305, -p.d * 0.2, p.h * 0.2, p.h * 0.42), 0.002));
  p.add(body, box(sides(-p.w * 0.36, p.w * 0.36, -p.d / 2, -p.d * 0.25, p.h * 0.14, p.h * 0.2), 0.004));
  p.add(paper, box(sides(-p.w * 0.28, p.w * 0.28, -p.d * 0.45, -p.d * 0.25, p.h * 0.2, p.h * 0.22), 0));
  p.add(dark, box(sides(-p.w * 0.46, p.w * 0.46, -p.d * 0.25, p.d * 0.3, low, low + p.h * 0.06), 0.008));
  p.add(p.named("lit_screen"), box(sides(p.w * 0.2, p.w * 0.42, -p.d * 0.305, -p.d * 0.28, p.h * 0.55, p.h * 0.7), 0.001));
  p.add(paper, box(sides(-p.w * 0.28, p.w * 0.28, p.d * 0.32, p.d * 0.34, low - 0.01, p.h), 0));
}

void projector(Piece& p) {
  const int body = p.main("plastic");
  const double drop = p.mount() == Mount::kCeiling ? p.h * 0.55 : 0, tall = p.h - drop;
  p.add(body, rounded_box(sides(-p.w / 2, p.w / 2, -p.d / 2 + p.d * 0.06, p.d / 2, p.mount() == Mount::kCeiling ? 0 : p.h * 0.08, tall),
                          tall * 0.18, 3));
  if (drop > 0) {
    p.add(p.named("black_metal"), cylinder({0, 0, tall - 0.004}, std::min(0.02, p.w * 0.1), drop - 0.01, 12));
    p.add(p.named("black_metal"), cylinder({0, 0, p.h - 0.015}, std::min(0.06, p.w * 0.25), 0.015, 20));
  } else {
    for (const double x : {-0.38, 0.38})
      p.add(p.named("black_plastic"), box(sides(x * p.w - 0.01, x * p.w + 0.01, -p.d * 0.3, p.d * 0.3, 0, p.h * 0.12), 0));
  }
  const double r = std::min(p.w * 0.16, tall * 0.34);
  dial(p, p.named("black_plastic"), {p.w * 0.18, -p.d / 2 + p.d * 0.07, tall * 0.52}, r, p.d * 0.06, 24);
  dial(p, p.named("lit_screen"), {p.w * 0.18, -p.d / 2 + p.d * 0.012, tall * 0.52}, r * 0.7, p.d * 0.012, 24);
}

void console_device(Piece& p) {
  const int body = p.main("black_plastic");
  p.add(body, rounded_box(p.body(), std::min({p.w, p.d, p.h}) * 0.15, 2));
  p.add(p.named("lit_screen"), box(sides(p.w * 0.3, p.w * 0.4, -p.d / 2 - 0.0003, -p.d / 2 + 0.002, p.h * 0.45, p.h * 0.6), 0));
}

void computer_tower(Piece& p) {
  const int body = p.main("black_metal"), glow = p.named("lit_screen"), mesh = p.named("mesh");
  const double foot = std::min(0.02, p.h * 0.05), face = -p.d / 2 + 0.012;
  p.add(body, box(sides(-p.w / 2, p.w / 2, face, p.d / 2, foot, p.h), 0.006));
  p.add(mesh, box(sides(-p.w / 2 + 0.01, p.w / 2 - 0.01, -p.d / 2, face + 0.002, foot + 0.015, p.h - 0.015), 0.004));
  for (const double y : {-0.35, 0.35})
    p.add(p.named("black_plastic"), box(sides(-p.w * 0.45, p.w * 0.45, y * p.d - 0.015, y * p.d + 0.015, 0, foot + 0.002), 0));
  p.add(glow, box(sides(-0.003, 0.003, -p.d / 2 - 0.0003, face, p.h * 0.6, p.h * 0.9), 0));
}

void fireplace(Piece& p) {
  const int stone = p.main("stone"), inside = p.named("slate"), ember = p.named("ember"), wood = p.named("walnut");
  const double shelf = std::min(0.08, p.h * 0.08), deep = std::min(0.06, p.d * 0.2), side = p.w * 0.2, top = p.h * 0.68,
               hearth = std::min(0.1, p.h * 0.1);
  const int mantel = p.says("brick") ? p.named("oak") : stone;  // a board
  p.add(mantel, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, p.h - shelf, p.h), 0.012));
  for (const double s : {-1.0, 1.0})
    p.add(stone, box(sides(s > 0 ? p.w / 2 - side : -p.w / 2 + 0.02, s > 0 ? p.w / 2 - 0.02 : -p.w / 2 + side, -p.d / 2 + deep, p.d / 2, 0,
                           p.h - shelf),
                     0.01));
  p.add(stone, box(sides(-p.w / 2 + side, p.w / 2 - side, -p.d / 2 + deep + 0.01, p.d / 2, top, p.h - shelf), 0.006));
  p.add(stone, box(sides(-p.w / 2 + 0.01, p.w / 2 - 0.01, -p.d / 2, p.d / 2 - 0.01, 0, hearth), 0.008));
  p.add(inside, box(sides(-p.w / 2 + side, p.w / 2 - side, p.d / 2 - 0.03, p.d / 2, hearth, top), 0));
  const double r = std::min(0.05, p.h * 0.05), room = p.w / 2 - side;
  for (int i = 0; i < 3; ++i)
    p.add(wood, rod({-room * 0.6, p.d * (0.05 + 0.12 * (i - 1)), hearth + r + (i == 1 ? r * 1.5 : 0)},
                    {room * 0.6, p.d * (0.1 - 0.1 * (i - 1)), hearth + r + (i == 1 ? r * 1.5 : 0)}, r, 10));
  for (int i = 0; i < 5; ++i) {
    const double x = room * (-0.4 + 0.2 * i), tall = (top - hearth) * (0.35 + 0.2 * ((i * 3) % 4) / 3.0),
                 f = std::min(room * 0.14, p.d * 0.14);
    p.add(ember, lathe({{0, 0}, {f * 0.7, tall * 0.1}, {f, tall * 0.3}, {f * 0.5, tall * 0.65}, {0, tall}}, 10),
          moved(x, p.d * 0.08, hearth + r * 2));
  }
  p.light({0, -p.d * 0.1, hearth + (top - hearth) * 0.4}, 20, 0.12);
}

void fan(Piece& p) {
  const int body = p.main("plastic"), chrome = p.named("chrome");
  if (p.mount() == Mount::kCeiling) {
    const double hub = std::min(0.09, p.h * 0.3), z = std::min(0.08, p.h * 0.3), r = p.w / 2;
    p.add(chrome, cylinder({0, 0, z}, 0.014, p.h - z, 12));
    p.add(chrome, cone({0, 0, p.h - 0.04}, 0.03, 0.06, 0.04, 20));
    p.add(chrome, cylinder({0, 0, z * 0.3}, hub, z * 1.2, 24));
    const int blades = p.frame("oak");
    for (int i = 0; i < 4; ++i)
      p.add(blades, prism(rounded_rectangle({hub * 0.8, -r * 0.1}, {r, r * 0.1}, r * 0.05, 3), z * 0.5, z * 0.5 + 0.01),
            turned_z(90.0 * i));
    p.add(p.named("lampshade"), lathe({{0, 0}, {hub * 0.7, z * 0.15}, {hub * 0.8, z * 0.35}, {0, z * 0.35}}, 20));
    p.light({0, 0, -0.01}, 15, 0.06);
    p.fit();
    return;
  }
  const double r = std::min(p.w / 2, p.h * 0.35), z = p.h - r, front = -p.d / 2;
  p.add(body, lathe({{0, 0}, {r * 0.72, 0}, {r * 0.68, 0.02}, {0.03, 0.035}, {0, 0.035}}, 28));
  p.add(chrome, cylinder({0, p.d * 0.12, 0.02}, 0.013, z - 0.02, 12));
  p.add(body, ellipsoid({0, p.d * 0.12, z}, {r * 0.2, p.d * 0.25, r * 0.2}, 16, 8));
  for (int i = 0; i < 4; ++i) {
    const Pose turn = moved(0, front + p.d * 0.22, z) * Pose{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}} * turned_z(90.0 * i + 20);
    p.add(p.named("grey_plastic"), prism(ellipse({r * 0.48, r * 0.1}, {r * 0.4, r * 0.2}, 16), -0.002, 0.002), turn);
  }
  for (const double y : {front + 0.006, front + p.d * 0.36}) {
    p.add(chrome, torus({0, 0, 0}, r - 0.006, 0.006, 32, 6), aimed({0, y, z}, {0, -1, 0}));
    p.add(chrome, torus({0, 0, 0}, r * 0.55, 0.003, 24, 5), aimed({0, y, z}, {0, -1, 0}));
    for (int i = 0; i < 8; ++i) {
      const double a = kPi * i / 8;
      p.add(chrome, rod({std::cos(a) * (r - 0.006), y, z + std::sin(a) * (r - 0.006)},
                        {-std::cos(a) * (r - 0.006), y, z - std::sin(a) * (r - 0.006)}, 0.002, 4));
    }
  }
  p.fit();
}

void radiator(Piece& p) {
  const int white = p.main("painted_metal");
  const int n = std::max(3, static_cast<int>(p.w / 0.06));
  const double each = p.w / n, foot = p.mount() == Mount::kFloor ? std::min(0.08, p.h * 0.15) : 0;
  for (int i = 0; i < n; ++i)
    p.add(white, rounded_box(sides(-p.w / 2 + each * i + 0.004 * (i > 0), -p.w / 2 + each * (i + 1) - 0.004 * (i + 1 < n), -p.d / 2,
                                   p.d / 2, foot, p.h),
                             std::min(each, p.d) * 0.3, 2));
  for (const double z : {foot + (p.h - foot) * 0.12, p.h - (p.h - foot) * 0.12})
    p.add(white, rod({-p.w / 2 + 0.01, 0, z}, {p.w / 2 - 0.01, 0, z}, std::min(0.015, p.d * 0.3), 8));
  if (foot > 0) {
    for (const double x : {-0.4, 0.4})
      p.add(white, box(sides(x * p.w - 0.015, x * p.w + 0.015, -p.d * 0.4, p.d * 0.4, 0, foot + 0.02), 0.003));
  }
}

void heater(Piece& p) {
  if (p.w > p.h) return radiator(p);
  const int body = p.main("plastic"), glow = p.named("ember");
  p.add(body, rounded_box(sides(-p.w / 2, p.w / 2, -p.d / 2 + 0.01, p.d / 2, 0, p.h), std::min(p.w, p.d) * 0.15, 3));
  for (int i = 0; i < 5; ++i)
    p.add(glow,
          rod({-p.w * 0.34, -p.d / 2 + 0.008, p.h * (0.25 + 0.12 * i)}, {p.w * 0.34, -p.d / 2 + 0.008, p.h * (0.25 + 0.12 * i)}, 0.008, 8));
}

void air_conditioner(Piece& p) {
  const int white = p.main("plastic"), dark = p.named("grey_plastic");
  p.add(white, rounded_box(p.body(), std::min(p.d, p.h) * 0.22, 4));
  p.add(dark, box(sides(-p.w * 0.44, p.w * 0.44, -p.d / 2 + p.d * 0.02, -p.d * 0.2, p.h * 0.06, p.h * 0.14), 0.002));
  p.add(p.named("lit_screen"), box(sides(p.w * 0.32, p.w * 0.38, -p.d / 2 - 0.0003, -p.d / 2 + 0.004, p.h * 0.5, p.h * 0.56), 0));
}

}  // namespace

void add_devices(Families& to) {
  to["mouse"] = mouse;
  to["phone"] = phone;
  to["printer"] = printer;
  to["projector"] = projector;
  to["console_device"] = console_device;
  to["computer_tower"] = computer_tower;
  to["fireplace"] = fireplace;
  to["fan"] = fan;
  to["radiator"] = radiator;
  to["heater"] = heater;
  to["air_conditioner"] = air_conditioner;
}

}  // namespace layoutbox::kit
