// Bathroom: toilets, bathtubs, showers.
#include <algorithm>
#include <array>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

void toilet(Piece& p) {
  const int white = p.main("ceramic");
  const FreeSpace* open = p.open_above();
  const double seat = open != nullptr ? open->box.min.z : std::min(0.42, p.h * 0.55),
               tank = std::max(0.08, open != nullptr ? p.d / 2 - open->box.max.y : p.d * 0.27);
  const double front = -p.d / 2, back = p.d / 2 - tank, rx = p.w * 0.46, cy = (front + back) / 2 + 0.02, ry = (back - front) / 2 + 0.02;
  // Foot, bowl, seat and lid as ovals; the tank behind.
  p.add(white, lathe({{0, 0}, {0.62, 0}, {0.55, 0.25}, {0.62, 0.55}, {0.98, 0.88}, {1, 0.95}, {1, 1}, {0, 1}}, 32),
        Pose{{rx * 0.92, 0, 0}, {0, ry * 0.94, 0}, {0, 0, seat - 0.045}, {0, cy, 0}});
  p.add(white, box(sides(-rx * 0.55, rx * 0.55, cy, p.d / 2 - 0.01, 0.0, seat - 0.1), 0.02));
  p.add(p.named("plastic"), lathe({{0, 0}, {0.97, 0}, {1, 0.2}, {1, 0.6}, {0.96, 1}, {0, 1}}, 36),
        Pose{{rx, 0, 0}, {0, ry, 0}, {0, 0, 0.045}, {0, cy - 0.02 + (front - (cy - 0.02 - ry)), seat - 0.045}});
  p.add(white, rounded_box(sides(-p.w / 2, p.w / 2, back, p.d / 2, seat - 0.1, p.h - 0.03), 0.025, 3));
  p.add(white, rounded_box(sides(-p.w / 2, p.w / 2, back, p.d / 2, p.h - 0.035, p.h - 0.003), 0.01, 2));
  p.add(p.named("chrome"), cylinder({0, p.d / 2 - tank / 2, p.h - 0.006}, 0.02, 0.006, 16));
}

// Brass feet below the tub's corners: an ankle that stands out, a ball under it.
void claw_feet(Piece& p, double height) {
  const int brass = p.named("brass");
  const double x = p.w / 2 - std::min(0.22, p.w * 0.15), y = p.d / 2 - std::min(0.14, p.d * 0.2), r = std::min(0.035, height * 0.3);
  for (const auto& [sx, sy] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
    p.add(
        brass,
        lathe({{0, 0}, {r * 0.7, 0}, {r, r * 0.6}, {r * 0.9, r * 1.4}, {r * 0.5, height * 0.6}, {r * 1.3, height * 1.3}, {0, height * 1.3}},
              16),
        moved(sx * x, sy * y, 0));
  }
}

// A tub with round corners, its inside falling to the drain; the mixer lies on the rim at one end, as flat as the height leaves it.
void bathtub(Piece& p) {
  const int white = p.main("ceramic"), chrome = p.named("chrome");
  const FreeSpace* in = p.open_above();
  const Box b = in != nullptr ? in->box : sides(-p.w / 2 + 0.08, p.w / 2 - 0.08, -p.d / 2 + 0.08, p.d / 2 - 0.08, 0.1, p.h);
  const double h = p.h - 0.003, x = p.w / 2, y = p.d / 2, round = std::min({0.09, x * 0.4, y * 0.4}), lip = std::min(0.035, p.h * 0.1);
  const auto outside = [&](double by, double z) {
    return ring_at(rounded_rectangle({-x + by, -y + by}, {x - by, y - by}, std::max(0.01, round - by * 0.5), 5), z);
  };
  // The free room is a box: its corners stay sharp enough to hold it.
  const auto inside = [&](double by, double z, double r) {
    return ring_at(rounded_rectangle({b.min.x - by, b.min.y - by}, {b.max.x + by, b.max.y + by}, r, 5), z);
  };
  const double give = std::min({0.03, b.min.x + x - 0.02, b.min.y + y - 0.02});
  const double feet = std::min(p.number("feet", 0), std::max(0.0, b.min.z - 0.05));
  if (feet > 0) claw_feet(p, feet);
  p.add(white, loft(std::vector<std::vector<Vec>>{outside(0.05 + feet * 0.6, feet), outside(0.035 + feet * 0.3, feet + p.h * 0.06),
                                                  outside(0.012, p.h * 0.55), outside(0.008, h - lip), outside(0.001, h - lip * 0.9),
                                                  outside(0, h - lip * 0.4), outside(0.006, h), inside(give, h, give * 3.2),
                                                  inside(give * 0.6, h - lip * 0.6, give * 1.9),
                                                  inside(give * 0.2, b.min.z + 0.03, give * 0.6), inside(0.001, b.min.z, 0.002)}));
  p.add(chrome, lathe({{0, 0}, {0.03, 0}, {0.03, 0.0008}, {0, 0.0008}}, 16), moved(b.min.x + 0.2, 0, b.min.z));
  p.add(chrome, lathe({{0, 0}, {0.03, 0}, {0.03, 0.001}, {0, 0.001}}, 16), aimed({b.min.x - give * 0.4, 0, p.h - 0.14}, {1, 0, 0}));
  const double mid = (b.min.x - give - x) / 2, deep = b.min.x - give + x, r = std::min(0.022, deep * 0.36);
  for (const double s : {-0.1, 0.1}) p.add(chrome, lathe({{0, 0}, {r, 0}, {r * 0.9, 0.004}, {0, 0.004}}, 16), moved(mid, s, h - 0.001));
  p.add(chrome, box(sides(mid - r * 0.8, mid + deep * 0.5 - 0.001, -r * 0.8, r * 0.8, h - 0.001, p.h), 0.001));
}

// One walks or rolls in: a floor of small tiles with a drain, no door.
bool is_level(const Piece& p) {
  return std::ranges::any_of(
      std::array{"walk in", "level access", "roll in", "curbless", "barrier free", "wet room", "doorless", "step free"},
      [&](const char* words) { return p.says(words); });
}

// Instead of glass a curtain on the rail before the tray and along its side, drawn back half way.
void shower_curtain(Piece& p, double rim) {
  const int fabric = p.main_accent("cotton");
  const double z0 = rim + 0.03, z1 = p.h - 0.03, front = -p.d / 2 + 0.004;
  p.add(fabric, waves(sides(-p.w * 0.02, p.w / 2 - 0.03, front, front + 0.022, z0, z1), 6, 0.006));
  p.add(fabric, waves(sides(-p.w / 2 + 0.02, -p.w * 0.3, front, front + 0.022, z0, z1), 3, 0.006));
  Mesh side = waves(sides(-p.d * 0.46, p.d * 0.1, -0.011, 0.011, z0, z1), 6, 0.006);
  p.add(fabric, posed(std::move(side), moved(p.w / 2 - 0.016, 0, 0) * turned_z(90)));
}

void shower(Piece& p) {
  const bool level = is_level(p);
  const int tray = p.named(level ? "small_tiles" : "ceramic"), chrome = p.named("chrome"), glass = p.named("glass");
  const FreeSpace* in = nullptr;
  for (const FreeSpace& s : p.spaces) in = in == nullptr || s.box.max.z > in->box.max.z ? &s : in;
  const double rim = level ? 0.015 : in != nullptr ? std::max(0.02, in->box.min.z) : std::min(0.08, p.h * 0.05), t = 0.01;
  p.add(tray, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, rim), 0.01));
  p.add(chrome, lathe({{0, 0}, {0.04, 0}, {0.04, 0.0008}, {0, 0.0008}}, 16), moved(0, 0, rim));
  const bool cloth = p.says("curtain") || p.says("curtained");
  if (cloth) shower_curtain(p, rim);
  const auto pane = [&](double x0, double x1, double y0, double y1) { p.add(glass, box(sides(x0, x1, y0, y1, rim, p.h - 0.02), 0)); };
  if (!level && !cloth) pane(-p.w / 2 + 0.004, p.w / 2 - 0.004, -p.d / 2 + 0.004, -p.d / 2 + 0.004 + t);
  if (!cloth) pane(p.w / 2 - 0.004 - t, p.w / 2 - 0.004, -p.d / 2 + 0.02, p.d / 2 - 0.004);
  for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}}) {
    if (cloth || (level && x < 0)) continue;
    p.add(chrome, box(sides(x * p.w / 2 - (x > 0 ? 0.018 : 0), x * p.w / 2 + (x > 0 ? 0 : 0.018), y * p.d / 2 - (y > 0 ? 0.018 : 0),
                            y * p.d / 2 + (y > 0 ? 0 : 0.018), rim - 0.002, p.h),
                      0.002));
  }
  if (!level) p.add(chrome, box(sides(-p.w / 2, p.w / 2, -p.d / 2, -p.d / 2 + 0.018, p.h - 0.022, p.h), 0.002));
  p.add(chrome, box(sides(p.w / 2 - 0.018, p.w / 2, -p.d / 2, p.d / 2, p.h - 0.022, p.h), 0.002));
  if (in != nullptr && in->box.max.z < p.h - 0.03) {
    // A booth: roof and a closed back instead of a shower.
    const int shell = p.named("black_metal");
    p.add(shell, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, p.h - 0.06, p.h), 0.008));
    p.add(shell, box(sides(-p.w / 2, p.w / 2, p.d / 2 - 0.04, p.d / 2, rim, p.h - 0.05), 0.004));
    p.add(shell, box(sides(-p.w / 2, -p.w / 2 + 0.04, -p.d / 2 + 0.02, p.d / 2, rim, p.h - 0.05), 0.004));
    return;
  }
  if (!level && !cloth) handle(p, chrome, Handle::kVertical, {-p.w * 0.3, -p.d / 2 + 0.004, p.h * 0.5}, 0.3, 0.004);
  // On the wall behind: a mixer, a rail with a hand shower and its hose; a head above where there is room for it.
  const double y = p.d / 2 - 0.012, deep = in != nullptr ? p.d / 2 - in->box.max.y : 0.06, out = p.d / 2 - deep * 0.92, cx = -0.02;
  p.add(chrome, rod({cx, y, p.h * 0.5}, {cx, y, p.h - 0.06}, 0.009, 8));
  p.add(chrome, box(sides(cx - 0.13, cx + 0.13, out + 0.008, p.d / 2 - 0.004, p.h * 0.48, p.h * 0.5), 0.006));
  for (const double s : {-0.12, 0.12})
    p.add(chrome, rod({cx + s, out, p.h * 0.49}, {cx + s, p.d / 2 - 0.004, p.h * 0.49}, std::min(0.022, deep * 0.4), 14));
  p.add(chrome,
        tube(curve({{cx, y, p.h * 0.48}, {cx + 0.1, y, p.h * 0.36}, {cx + 0.14, y, p.h * 0.55}, {cx + 0.02, y, p.h * 0.8}}, 5), 0.006, 6));
  p.add(chrome, lathe({{0, 0}, {0.055, 0}, {0.06, deep * 0.16}, {0.03, deep * 0.34}, {0, deep * 0.34}}, 24),
        aimed({cx, out + deep * 0.36, p.h * 0.86}, {0, -1, 0}));
  p.add(chrome, rod({cx, out + deep * 0.3, p.h * 0.85}, {cx + 0.01, y - 0.004, p.h * 0.76}, 0.011, 8));
  const Box head = sides(-0.12, 0.12, y - 0.38, y - 0.14, p.h - 0.075, p.h - 0.05);
  if (p.is_free(head)) {
    p.add(chrome, rod({0, y, p.h - 0.055}, {0, y - 0.25, p.h - 0.055}, 0.009, 8));
    p.add(chrome, lathe({{0, 0}, {0.12, 0}, {0.12, 0.008}, {0.02, 0.016}, {0, 0.016}}, 24), moved(0, y - 0.25, p.h - 0.072));
  }
}

}  // namespace

void add_bath(Families& to) {
  to["toilet"] = toilet;
  to["bathtub"] = bathtub;
  to["shower"] = shower;
}

}  // namespace layoutbox::kit
