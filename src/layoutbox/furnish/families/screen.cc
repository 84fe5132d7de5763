// Screens and the devices that go with them.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// A flat panel in that box, its screen to −y.
void panel(Piece& p, const Box& b, int shell) {
  const double rim = std::min(0.012, b.size().z * 0.04), face = std::min(0.004, b.size().y * 0.2);
  p.add(shell, box({{b.min.x, b.min.y + face, b.min.z}, b.max}, 0.004));
  p.add(p.named("screen"),
        box(sides(b.min.x + rim, b.max.x - rim, b.min.y, b.min.y + face + 0.001, b.min.z + rim * 1.3, b.max.z - rim), 0.001));
}

void television(Piece& p) {
  const int shell = p.main("black_plastic");
  if (p.mount() == Mount::kWall || p.d < 0.08) {
    const double thick = std::min(p.d, 0.05);
    panel(p, sides(-p.w / 2, p.w / 2, -p.d / 2, -p.d / 2 + thick, 0, p.h), shell);
    if (p.d > thick) p.add(shell, box(sides(-p.w * 0.2, p.w * 0.2, -p.d / 2 + thick - 0.002, p.d / 2, p.h * 0.3, p.h * 0.7), 0.004));
    return;
  }
  const double foot = std::min(0.08, p.h * 0.15), thick = std::min(0.045, p.d * 0.3);
  panel(p, sides(-p.w / 2, p.w / 2, -thick / 2, thick / 2, foot, p.h), shell);
  p.add(shell, box(sides(-0.04, 0.04, -0.012, 0.02, 0.01, foot + 0.06), 0.004));
  p.add(shell, box(sides(-p.w * 0.22, p.w * 0.22, -p.d / 2, p.d / 2, 0, 0.014), 0.004));
}

void monitor(Piece& p) {
  const int shell = p.main("black_plastic");
  const double foot = p.h * 0.24, thick = std::min(0.035, p.d * 0.3);
  panel(p, sides(-p.w / 2, p.w / 2, -thick, 0, foot, p.h), shell);
  p.add(shell, box(sides(-0.025, 0.025, 0, 0.02, 0.01, p.h * 0.6), 0.004));
  p.add(shell, rounded_box(sides(-std::min(0.14, p.w * 0.35), std::min(0.14, p.w * 0.35), -p.d / 2, p.d / 2, 0, 0.016), 0.006, 2));
}

void laptop(Piece& p) {
  const int shell = p.main("steel"), dark = p.named("black_plastic");
  const double thick = std::min(0.016, p.h * 0.3), hinge = p.d / 2 - std::min(p.d * 0.25, p.h * 0.3);
  p.add(shell, rounded_box(sides(-p.w / 2, p.w / 2, -p.d / 2, hinge, 0, thick), 0.005, 2));
  p.add(dark, box(sides(-p.w * 0.43, p.w * 0.43, -p.d * 0.12, hinge - 0.02, thick, thick + 0.0015), 0));
  p.add(dark, box(sides(-p.w * 0.16, p.w * 0.16, -p.d / 2 + 0.015, -p.d * 0.18, thick, thick + 0.001), 0));
  if (p.h < 0.05) return;
  const Vec low{0, hinge - 0.004, thick}, high{0, p.d / 2 - 0.004, p.h - 0.002};
  const double tall = length(high - low);
  const Pose lid{{1, 0, 0}, unit(cross(unit(high - low), {1, 0, 0})), unit(high - low), low};
  p.add(shell, box(sides(-p.w / 2 + 0.001, p.w / 2 - 0.001, -0.003, 0.004, 0, tall), 0.002), lid);
  p.add(p.named("lit_screen"), box(sides(-p.w / 2 + 0.012, p.w / 2 - 0.012, -0.0045, -0.002, 0.014, tall - 0.01), 0), lid);
}

void keyboard(Piece& p) {
  p.add(p.main("grey_plastic"), box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, p.h * 0.6), 0.003));
  const int keys = p.named("plastic"), rows = 5, columns = std::clamp(static_cast<int>(p.w / 0.026), 6, 18);
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double cw = (p.w - 0.016) / columns, ch = (p.d - 0.016) / rows, x = -p.w / 2 + 0.008 + cw * i, y = -p.d / 2 + 0.008 + ch * j;
      p.add(keys, box(sides(x + 0.001, x + cw - 0.001, y + 0.001, y + ch - 0.001, p.h * 0.6, p.h), 0));
    }
  }
}

void speaker(Piece& p) {
  const int body = p.main("black_plastic"), cone_surface = p.named("grey_plastic");
  p.add(body, box(sides(-p.w / 2, p.w / 2, -p.d / 2 + 0.008, p.d / 2, 0, p.h), 0.008));
  const double r = std::min(p.w * 0.38, p.h * 0.24);
  const auto driver = [&](double z, double radius) {
    p.add(cone_surface, lathe({{0, 0}, {radius, 0}, {radius, 0.008}, {radius * 0.85, 0.008}, {radius * 0.4, 0.002}, {0, 0.005}}, 24),
          aimed({0, -p.d / 2 + 0.008, z}, {0, -1, 0}));
  };
  driver(p.h * 0.3, r);
  driver(p.h * 0.76, r * 0.55);
}

}  // namespace

void add_screens(Families& to) {
  to["tv"] = television;
  to["monitor"] = monitor;
  to["laptop"] = laptop;
  to["keyboard"] = keyboard;
  to["speaker"] = speaker;
}

}  // namespace layoutbox::kit
