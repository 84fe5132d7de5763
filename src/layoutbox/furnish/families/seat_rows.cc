// Seats of other builds: woven ones, and rows on a beam.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// Single seats on a beam, as in waiting rooms.
void beam_seats(Piece& p) {
  const int shell = p.main("black_leather"), metal = p.frame("steel");
  const FreeSpace* open = p.open_above();
  const double top = open != nullptr ? open->box.min.z : p.h * 0.52, back = open != nullptr ? open->box.max.y : p.d / 2 - 0.12;
  const int n = std::max(2, static_cast<int>(p.w / 0.54));
  const double each = p.w / n;
  p.add(metal, box(sides(-p.w / 2, p.w / 2, -0.03, 0.03, top * 0.55, top * 0.55 + 0.05), 0.006));
  for (const double x : {-1.0, 1.0}) {
    const double c = x * (p.w / 2 - each * 0.5);
    p.add(metal, box(sides(c - 0.02, c + 0.02, -p.d / 2 + 0.03, p.d / 2 - 0.03, 0, 0.03), 0.006));
    p.add(metal, box(sides(c - 0.02, c + 0.02, -0.025, 0.025, 0.02, top * 0.56), 0.004));
  }
  for (int i = 0; i < n; ++i) {
    const double x0 = -p.w / 2 + each * i + 0.02, x1 = x0 + each - 0.04, mid = (x0 + x1) / 2;
    p.add(shell, rounded_box(sides(x0, x1, -p.d / 2, back, top - 0.07, top), 0.025, 3));
    p.add(shell, rounded_box(sides(x0, x1, back, std::min(p.d / 2, back + 0.07), top - 0.03, p.h), 0.025, 3));
    p.add(metal, box(sides(mid - 0.02, mid + 0.02, -0.02, p.d / 2 - 0.01, top * 0.55 + 0.04, top - 0.06), 0.004));
    p.add(metal, box(sides(mid - 0.02, mid + 0.02, p.d / 2 - 0.03, p.d / 2, top - 0.12, top + 0.1), 0.004));
  }
}

}  // namespace

bool is_wicker(const Piece& p) { return p.says("wicker") || p.says("rattan") || p.says("cane") || p.says("woven"); }

// Woven down to the floor, with a rounded back and a cushion.
void wicker_chair(Piece& p) {
  const FreeSpace* open = p.open_above();
  const struct {
    double level, back;
  } s{open != nullptr ? open->box.min.z : std::min(0.46, p.h * 0.6), open != nullptr ? open->box.max.y : p.d / 2 - 0.06};
  const int weave = p.main("rattan"), cloth = p.tinted("linen", {0.90, 0.86, 0.76});
  const double back = std::max(0.03, p.d / 2 - s.back), pad = std::min(0.06, s.level * 0.2), x = p.w / 2, low = s.level - pad;
  p.add(weave, taper({0, 0, 0}, {x * 0.86, p.d / 2 * 0.86}, {0, 0, low}, {x, p.d / 2}));
  for (int i = 1; i < 6; ++i) {
    const double z = low * i / 6, k = 0.86 + 0.14 * i / 6;
    p.add(weave, tube({{-x * k, -p.d / 2 * k, z}, {x * k, -p.d / 2 * k, z}, {x * k, p.d / 2 * k, z}, {-x * k, p.d / 2 * k, z}},
                      0.006 * (1 - k) / 0.14 + 0.001, 5, true));
  }
  p.add(cloth, cushion(sides(-x + 0.02, x - 0.02, -p.d / 2 + 0.02, s.back - 0.005, low - 0.002, s.level), 0.025, true, 4));
  // The back: an arch with ribs before it.
  std::vector<Vec2> arch{{-x, low}, {x, low}};
  for (int i = 0; i <= 12; ++i) {
    const double a = kPi * i / 12.0;
    arch.push_back({x * std::cos(a), s.level + (p.h - s.level) * (0.45 + 0.55 * std::sin(a))});
  }
  const Pose upright{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}};
  p.add(weave, prism(arch, -p.d / 2, -p.d / 2 + back * 0.55), upright);
  const int ribs = 9;
  for (int i = 1; i < ribs; ++i) {
    const double u = -1 + 2.0 * i / ribs, top = s.level + (p.h - s.level) * (0.43 + 0.53 * std::sqrt(1 - u * u));
    p.add(weave, rod({u * x, p.d / 2 - back * 0.6, s.level}, {u * x, p.d / 2 - back * 0.6, top}, std::min(0.012, back * 0.35), 6));
  }
}

void add_seat_rows(Families& to) { to["beam_seats"] = beam_seats; }

}  // namespace layoutbox::kit
