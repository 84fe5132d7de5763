// Cribs.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

void crib(Piece& p) {
  const int wood = p.main("lacquer"), white = p.named("cotton"), blanket = p.tinted("cotton", p.accent());
  const FreeSpace* open = p.open_above();
  const double top = open != nullptr ? open->box.min.z : p.h * 0.5, under = std::max({0.0, p.clear_below(0), top - 0.2}), t = 0.03;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const double cx = x * (p.w / 2 - t / 2), cy = y * (p.d / 2 - t / 2);
      p.add(wood, box(sides(cx - t / 2, cx + t / 2, cy - t / 2, cy + t / 2, 0, p.h), 0.005));
    }
  }
  const double floor = std::min(under + 0.06, top - 0.025);
  p.add(wood, box(sides(-p.w / 2 + 0.004, p.w / 2 - 0.004, -p.d / 2 + 0.004, p.d / 2 - 0.004, under, floor), 0.004));
  p.add(white, rounded_box(sides(-p.w / 2 + t, p.w / 2 - t, -p.d / 2 + t, p.d / 2 - t, floor, top - (top > 0.2 ? 0.02 : 0)), 0.02, 2));
  // A fitted sheet with a band of colour; a baby sleeps without pillow and quilt.
  if (top > 0.2)
    p.add(blanket, rounded_box(sides(-p.w / 2 + t, p.w / 2 - t, -p.d / 2 + t, -p.d / 2 + t + p.d * 0.16, top - 0.03, top), 0.012, 2));
  const auto rails = [&](bool along_x, double at) {
    const double half = (along_x ? p.w : p.d) / 2 - t;
    const auto bar = [&](double a0, double a1, double z0, double z1, double thick) {
      p.add(wood, along_x ? box(sides(a0, a1, at - thick / 2, at + thick / 2, z0, z1), 0.003)
                          : box(sides(at - thick / 2, at + thick / 2, a0, a1, z0, z1), 0.003));
    };
    bar(-half, half, p.h - 0.04, p.h, 0.024);
    const int n = std::max(2, static_cast<int>(2 * half / 0.085));
    for (int i = 1; i < n; ++i) {
      const double a = -half + 2 * half * i / n;
      bar(a - 0.006, a + 0.006, floor, p.h - 0.04, 0.012);
    }
  };
  for (const double s : {-1.0, 1.0}) {
    rails(true, s * (p.d / 2 - t / 2));
    rails(false, s * (p.w / 2 - t / 2));
  }
}

}  // namespace

void add_cribs(Families& to) { to["crib"] = crib; }

}  // namespace layoutbox::kit
