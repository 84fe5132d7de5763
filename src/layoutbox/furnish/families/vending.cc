// Machines of shops and arcades that one stands before: vending machines, arcade machines.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

constexpr Color kGoods[] = {{0.84, 0.30, 0.26}, {0.26, 0.50, 0.76}, {0.95, 0.76, 0.28}, {0.36, 0.64, 0.40}, {0.90, 0.55, 0.24}};

void vending_machine(Piece& p) {
  const int body = p.color_asked() ? p.main("painted_metal") : p.tinted("painted_metal", kGoods[p.pick(2)]), dark = p.named("screen");
  const double face = -p.d / 2 + 0.02;
  p.add(body, box(sides(-p.w / 2, p.w / 2, face, p.d / 2, 0, p.h), 0.012));
  const double x1 = p.w * 0.22, z0 = p.h * 0.3, z1 = p.h * 0.94, x0 = -p.w * 0.45;
  p.add(dark, box(sides(x0, x1, face - 0.004, face + 0.01, z0, z1), 0.004));
  for (int row = 0; row < 5; ++row) {
    const double z = z0 + (z1 - z0) * (row + 0.08) / 5;
    p.add(p.named("steel"), box(sides(x0 + 0.01, x1 - 0.01, face - 0.012, face, z - 0.008, z), 0));
    for (int i = 0; i < 6; ++i) {
      const double x = x0 + (x1 - x0) * (i + 0.5) / 6, r = (x1 - x0) / 6 * 0.33;
      p.add(p.tinted("plastic", kGoods[(row + i) % 5]),
            box(sides(x - r, x + r, face - 0.018, face - 0.003, z, z + (z1 - z0) / 5 * 0.62), 0.003));
    }
  }
  p.add(dark, box(sides(x0, x1, face - 0.006, face + 0.01, p.h * 0.1, p.h * 0.22), 0.004));
  p.add(p.named("lit_screen"), box(sides(p.w * 0.28, p.w * 0.44, face - 0.02, face + 0.01, p.h * 0.62, p.h * 0.74), 0.003));
  for (int i = 0; i < 9; ++i)
    p.add(p.named("grey_plastic"), box(sides(p.w * (0.29 + 0.055 * (i % 3)), p.w * (0.325 + 0.055 * (i % 3)), face - 0.008, face + 0.004,
                                             p.h * (0.56 - 0.03 * (i / 3)), p.h * (0.58 - 0.03 * (i / 3))),
                                       0.001));
}

void arcade_machine(Piece& p) {
  const int body = p.main_accent("lacquer"), dark = p.named("black_plastic");
  const double y = p.d / 2, t = std::min(0.03, p.w * 0.05);
  const std::vector<Vec2> side{{-y, p.h * 0.02},
                               {y, 0},
                               {y, p.h},
                               {-y * 0.2, p.h},
                               {-y * 0.35, p.h * 0.9},
                               {y * 0.1, p.h * 0.82},
                               {-y * 0.25, p.h * 0.56},
                               {-y, p.h * 0.52},
                               {-y * 0.98, p.h * 0.46},
                               {-y * 0.7, p.h * 0.42},
                               {-y * 0.7, p.h * 0.1}};
  const Pose across{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {}};
  for (const double s : {-1.0, 1.0}) p.add(dark, prism(side, s > 0 ? p.w / 2 - t : -p.w / 2, s > 0 ? p.w / 2 : -p.w / 2 + t), across);
  const std::vector<Vec2> core{{-y * 0.66, 0.01},       {y * 0.97, 0.01},        {y * 0.97, p.h * 0.99},
                               {-y * 0.16, p.h * 0.99}, {-y * 0.3, p.h * 0.9},   {y * 0.16, p.h * 0.82},
                               {-y * 0.2, p.h * 0.555}, {-y * 0.95, p.h * 0.51}, {-y * 0.66, p.h * 0.43}};
  p.add(body, prism(core, -p.w / 2 + t - 0.001, p.w / 2 - t + 0.001), across);
  const Vec low{0, -y * 0.2, p.h * 0.57}, high{0, y * 0.13, p.h * 0.81};
  const Vec up = unit(high - low), out = cross(up, {1, 0, 0});
  p.add(p.named("lit_screen"), box(sides(-p.w * 0.4, p.w * 0.4, -0.004, 0.008, 0, length(high - low)), 0.003),
        Pose{{1, 0, 0}, out, up, low});
  p.add(p.named("lit_screen"), box(sides(-p.w * 0.42, p.w * 0.42, -y * 0.29, -y * 0.2, p.h * 0.915, p.h * 0.975), 0.004));
  const double panel = p.h * 0.535;
  p.add(p.named("steel"), rod({-p.w * 0.2, -y * 0.6, panel - 0.02}, {-p.w * 0.2, -y * 0.6, panel + p.h * 0.035}, 0.006, 8));
  p.add(p.tinted("plastic", kGoods[0]), ellipsoid({-p.w * 0.2, -y * 0.6, panel + p.h * 0.04}, {0.02, 0.02, 0.02}, 12, 6));
  for (int i = 0; i < 4; ++i)
    p.add(p.tinted("plastic", kGoods[i]),
          cylinder({p.w * (0.05 + 0.09 * (i % 3)), -y * (0.66 - 0.12 * (i / 3) - 0.04 * (i % 3)), panel - 0.012}, 0.014, 0.022, 12));
}

}  // namespace

void add_vending(Families& to) {
  to["vending_machine"] = vending_machine;
  to["arcade_machine"] = arcade_machine;
}

}  // namespace layoutbox::kit
