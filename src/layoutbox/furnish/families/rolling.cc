// A pram and a rowing machine: frames of tube on wheels and rails.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// The child looks to the front; the handle is at the back.
void stroller(Piece& p) {
  const int cloth = p.main_accent("cotton"), bar = p.named("grey_plastic"), dark = p.named("black_plastic");
  const double x = p.w / 2, y = p.d / 2, big = std::min(0.15, p.h * 0.15), small = big * 0.7, half = x * 0.66;
  for (const double s : {-1.0, 1.0}) {
    const double wx = s * (x - 0.025);
    for (const auto& [wy, r] : {std::pair{y * 0.55, big}, {-y + small, small}}) {
      p.add(dark, rod({wx - 0.02, wy, r}, {wx + 0.02, wy, r}, r, 24));
      p.add(bar, rod({wx - 0.023, wy, r}, {wx + 0.023, wy, r}, r * 0.62, 18));
    }
    p.add(bar, tube(curve({{wx, -y + small, small},
                           {s * x * 0.8, -y * 0.2, p.h * 0.36},
                           {s * x * 0.8, y * 0.55, p.h * 0.72},
                           {s * x * 0.72, y - 0.02, p.h * 0.92}},
                          5),
                    0.012, 8));
    p.add(bar, rod({wx, y * 0.55, big}, {s * x * 0.8, -y * 0.05, p.h * 0.45}, 0.012, 8));
  }
  p.add(dark, rod({-x * 0.72, y - 0.02, p.h * 0.92}, {x * 0.72, y - 0.02, p.h * 0.92}, 0.018, 10));
  // Seat, back and foot rest as one bent shell; a hood over the back.
  const double seat = p.h * 0.42;
  p.add(cloth, box(sides(-half, half, -y * 0.35, y * 0.3, seat - 0.04, seat), 0.015));
  p.add(cloth, beam({0, y * 0.28, seat - 0.02}, {0, y * 0.62, p.h * 0.82}, {half * 2, 0.04}, 0.012));
  p.add(cloth, beam({0, -y * 0.33, seat - 0.02}, {0, -y * 0.55, seat - p.h * 0.19}, {half * 2, 0.03}, 0.01));
  p.add(dark, box(sides(-half, half, -y * 0.72, -y * 0.5, seat - p.h * 0.205, seat - p.h * 0.18), 0.006));
  for (const double s : {-1.0, 1.0})
    p.add(cloth,
          box(sides(s > 0 ? half : -half - 0.03, s > 0 ? half + 0.03 : -half, -y * 0.3, y * 0.35, seat - 0.03, seat + p.h * 0.12), 0.01));
  p.add(dark, tube(curve({{-half, -y * 0.28, seat + p.h * 0.1},
                          {-half * 0.6, -y * 0.42, seat + p.h * 0.13},
                          {half * 0.6, -y * 0.42, seat + p.h * 0.13},
                          {half, -y * 0.28, seat + p.h * 0.1}},
                         4),
                   0.014, 8));
  // The hood: a quarter of a drum round a line across.
  std::vector<Vec2> arc;
  const double r = p.h * 0.25, cy = y * 0.42, cz = p.h - r;
  for (int i = 0; i <= 10; ++i)
    arc.push_back({cy + r * std::cos(kPi * (0.08 + 0.9 * i / 10)), cz + r * std::sin(kPi * (0.08 + 0.9 * i / 10))});
  for (int i = 10; i >= 0; --i)
    arc.push_back({cy + r * 0.93 * std::cos(kPi * (0.08 + 0.9 * i / 10)), cz + r * 0.93 * std::sin(kPi * (0.08 + 0.9 * i / 10))});
  p.add(cloth, prism(arc, -half - 0.03, half + 0.03, true), Pose{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, 0}});
  p.add(p.named("linen"), rounded_box(sides(-half * 0.85, half * 0.85, -y * 0.3, y * 0.25, seat - 0.002, seat + 0.03), 0.014, 3));
  p.fit();
}

// Flywheel at the front, the seat on its rail behind it.
void rowing_machine(Piece& p) {
  const int frame = p.main("black_metal"), steel = p.named("steel"), dark = p.named("black_plastic");
  const double x = p.w / 2, y = p.d / 2, r = std::min({p.h * 0.36, p.d * 0.16, 0.3}), rail = std::min(0.36, p.h * 0.5), hub = -y + r;
  p.add(dark, rod({-0.07, hub, r * 1.15}, {0.07, hub, r * 1.15}, r, 34));
  p.add(steel, rod({-0.075, hub, r * 1.15}, {0.075, hub, r * 1.15}, r * 0.62, 30));
  p.add(dark, rod({-0.08, hub, r * 1.15}, {0.08, hub, r * 1.15}, r * 0.16, 16));
  p.add(steel, beam({0, hub + r * 0.6, rail}, {0, y - 0.03, rail * 0.92}, {0.07, 0.05}, 0.008));
  for (const auto& [wy, top] : {std::pair{hub, r * 0.7}, {y - 0.12, rail * 0.9}}) {
    p.add(frame, box(sides(-x, x, wy - 0.03, wy + 0.03, 0, 0.04), 0.01));
    p.add(frame, rod({0, wy, 0.03}, {0, wy, top}, 0.025, 12));
  }
  const double seat = y * 0.3;
  p.add(dark, rounded_box(sides(-0.15, 0.15, seat - 0.12, seat + 0.12, rail + 0.035, rail + 0.085), 0.024, 4));
  p.add(frame, box(sides(-0.06, 0.06, seat - 0.1, seat + 0.1, rail - 0.05, rail + 0.04), 0.008));
  for (const double s : {-1.0, 1.0})
    p.add(dark, beam({s * 0.13, hub + r * 1.05, rail - 0.08}, {s * 0.13, hub + r * 1.05 - 0.14, rail + 0.14}, {0.1, 0.02}, 0.006));
  p.add(frame, rod({0, hub, r * 1.9}, {0, hub + r * 0.35, p.h - 0.1}, 0.018, 10));
  p.add(dark, rounded_box(sides(-0.1, 0.1, hub + r * 0.3, hub + r * 0.3 + 0.035, p.h - 0.15, p.h), 0.012, 3));
  p.add(p.named("lit_screen"), box(sides(-0.075, 0.075, hub + r * 0.3 + 0.033, hub + r * 0.3 + 0.037, p.h - 0.13, p.h - 0.03), 0));
  p.add(p.named("oak"), rod({-x * 0.75, hub + r * 1.12, rail + 0.17}, {x * 0.75, hub + r * 1.12, rail + 0.17}, 0.016, 10));
  p.add(steel, rod({0, hub + r * 0.8, rail + 0.14}, {0, hub + r * 1.12, rail + 0.17}, 0.005, 6));
  p.fit();
}

}  // namespace

void add_rolling_things(Families& to) {
  to["stroller"] = stroller;
  to["rowing_machine"] = rowing_machine;
}

}  // namespace layoutbox::kit
