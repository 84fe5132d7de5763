// Seats: chairs, stools, benches, office chairs.
#include <algorithm>
#include <cmath>
#include <utility>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

bool upholstered(const Piece& p) {
  return p.word("seat", "") == "cushion" || p.says("upholstered") || p.says("leather") || p.says("velvet") || p.says("fabric") ||
         p.says("padded") || (p.is_style("mid-century") && !p.says("wooden"));
}

enum class Back { kSlats, kPanel, kSpindles, kUprights };

// What a chair's back is like: as the catalogue says, else by style and chance.
Back back_of(const Piece& p) {
  const std::string said = p.word("back", "");
  if (said == "panel" || p.count("slats", 3) == 0) return Back::kPanel;
  if (said == "spindles") return Back::kSpindles;
  if (!said.empty()) return Back::kSlats;
  if (p.is_style("modern") || p.is_style("scandinavian")) return Back::kPanel;
  if (p.is_style("traditional") || p.is_style("victorian")) return Back::kSpindles;
  constexpr Back kWays[] = {Back::kSlats, Back::kPanel, Back::kUprights, Back::kSpindles};
  return p.is_style("rustic") ? Back::kSlats : kWays[p.variant(4)];
}

void chair(Piece& p) {
  if (is_wicker(p)) return wicker_chair(p);
  const Back style = back_of(p);
  const Seat s = seat_of(p, 0.46, 0, 0.06);
  const double back = std::max(0.02, p.d / 2 - s.back), post = std::min({0.035, back, p.w / 6});
  const bool soft = upholstered(p);
  const int wood = soft ? p.frame("oak") : p.painted_frame("oak");
  const int colored = soft ? p.main_accent("linen") : p.main("oak");
  const double seat = std::min(soft ? 0.06 : 0.035, s.level * 0.4);
  // Front legs and posts that go up into the back.
  for (const double x : {-1.0, 1.0}) {
    const double cx = x * (p.w / 2 - post / 2);
    p.add(wood, taper({cx * 0.97, -p.d / 2 + post * 0.6, 0}, {post * 0.32, post * 0.32}, {cx, -p.d / 2 + post / 2, s.level - seat},
                      {post / 2, post / 2}));
    p.add(wood, box(sides(cx - post / 2, cx + post / 2, p.d / 2 - post, p.d / 2, 0, p.h), 0.004));
    p.add(wood, box(sides(cx - 0.009, cx + 0.009, -p.d / 2 + post, p.d / 2 - post, s.level * 0.45, s.level * 0.45 + 0.025), 0.003));
  }
  p.add(wood, box(sides(-p.w / 2 + post, p.w / 2 - post, -p.d / 2 + 0.01, -p.d / 2 + 0.03, s.level - seat - 0.05, s.level - seat), 0.003));
  p.add(colored, soft ? cushion(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2 - post, s.level - seat, s.level), 0.025, true, 4)
                      : rounded_box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2 - post, s.level - seat, s.level), 0.015, 2));
  const double inner = p.w / 2 - post, low = s.level + (p.h - s.level) * 0.25, thick = std::min(0.03, back),
               y0 = p.d / 2 - post / 2 - thick / 2;
  if (soft) {
    p.add(colored,
          rounded_box(sides(-inner, inner, std::max(s.back, p.d / 2 - 0.06), p.d / 2 - 0.004, low * 0.6 + s.level * 0.4, p.h), 0.02, 3));
  } else if (style == Back::kPanel) {
    p.add(colored, rounded_box(sides(-inner, inner, y0, y0 + thick, low, p.h), 0.012, 2));
  } else if (style == Back::kUprights) {
    p.add(colored, box(sides(-inner, inner, y0, y0 + thick, p.h - 0.07, p.h - 0.005), 0.006));
    p.add(wood, box(sides(-inner, inner, y0, y0 + thick, low - 0.03, low), 0.004));
    for (const double x : {-0.5, 0.0, 0.5}) {
      const double half = inner * 0.14;
      p.add(wood, box(sides(x * inner - half, x * inner + half, y0 + thick * 0.25, y0 + thick * 0.75, low, p.h - 0.07), 0.003));
    }
  } else if (style == Back::kSpindles) {
    for (int i = 0; i < 6; ++i)
      p.add(wood, rod({-inner * 0.85 + inner * 1.7 * i / 5, p.d / 2 - post / 2, s.level},
                      {-inner * 0.85 + inner * 1.7 * i / 5, p.d / 2 - post / 2, p.h - 0.05}, 0.007, 8));
    p.add(colored, box(sides(-inner, inner, y0, y0 + thick, p.h - 0.07, p.h - 0.005), 0.006));
  } else {
    const int n = p.count("slats", 3);
    const double pitch = (p.h - low) / n;
    for (int i = 0; i < n; ++i)
      p.add(colored,
            box(sides(-inner, inner, y0 + thick * 0.2, y0 + thick * 0.8, p.h - 0.008 - pitch * i - pitch * 0.6, p.h - 0.008 - pitch * i),
                0.005));
  }
  if (p.count("arms", 0) > 0) {
    for (const double x : {-1.0, 1.0}) {
      const double x0 = x > 0 ? p.w / 2 - post : -p.w / 2, z = std::min(p.h - 0.05, s.level + 0.2);
      if (!p.is_free(sides(x0, x0 + post, -p.d / 2 + 0.04, p.d / 2, s.level, z))) continue;
      p.add(wood, box(sides(x0, x0 + post, -p.d / 2 + 0.05, p.d / 2 - post, z - 0.025, z), 0.008));
      p.add(wood, box(sides(x0 + post * 0.2, x0 + post * 0.8, -p.d / 2 + 0.07, -p.d / 2 + 0.1, s.level, z - 0.025), 0.004));
    }
  }
}

bool three_legs(const Piece& p) { return p.says("three-legged") || p.says("three legged") || p.says("tripod") || p.says("milking"); }

void stool(Piece& p) {
  const bool round = p.word("top", p.w / p.d > 1.25 || p.d / p.w > 1.25 ? "rect" : "round") == "round";
  const FreeSpace* open = p.open_above();
  const double top = open != nullptr ? open->box.min.z : p.h, thick = std::min(0.05, top * 0.2);
  const int wood = p.frame("oak"),
            seat = p.says("upholstered") || p.says("leather") || p.says("velvet") ? p.main_accent("linen") : p.main("oak");
  slab(p, seat, sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, top - thick, top), round ? "round" : "rect", 0.015);
  const double rx = p.w * (round ? 0.34 : 0.46), ry = p.d * (round ? 0.34 : 0.46), in = 0.72;
  std::vector<Vec> ring;
  using Corner = std::pair<double, double>;
  const std::vector<Corner> feet =
      three_legs(p) ? std::vector<Corner>{{-1, 0.8}, {0, -1}, {1, 0.8}} : std::vector<Corner>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (const auto& [x, y] : feet) {
    const double leg = std::min(0.016, p.w / 14);
    p.add(wood, kit::leg({x * (rx - leg), y * (ry - leg), 0}, {x * rx * in, y * ry * in, top - thick}, leg * 0.8, leg));
    const double t = top > 0.55 ? 0.35 : 0.4;
    ring.push_back({x * ((rx - leg) * (1 - t) + rx * in * t), y * ((ry - leg) * (1 - t) + ry * in * t), t * (top - thick)});
  }
  for (std::size_t i = 0; i < ring.size(); ++i) p.add(wood, rod(ring[i], ring[(i + 1) % ring.size()], std::min(0.01, p.w / 20), 8));
  // A low back, where the piece is higher than its seat.
  if (p.h - top > 0.03) {
    const double y = open != nullptr ? std::max(open->box.max.y, p.d / 2 - 0.04) : p.d / 2 - 0.03;
    for (const double x : {-0.6, 0.6}) p.add(wood, box(sides(x * p.w / 2 - 0.01, x * p.w / 2 + 0.01, y, p.d / 2, top - thick, p.h), 0.003));
    p.add(seat, rounded_box(sides(-p.w / 2 + 0.01, p.w / 2 - 0.01, y, p.d / 2, p.h - std::min(0.12, (p.h - top) * 0.6), p.h), 0.012, 2));
  }
}

void bench(Piece& p) {
  const FreeSpace* open = p.open_above();
  const double top = open != nullptr ? open->box.min.z : p.h, back = open != nullptr ? p.d / 2 - open->box.max.y : 0;
  const double thick = std::min(0.05, top * 0.15);
  const int wood = p.frame("oak");
  const bool soft = upholstered(p);
  const int seat = soft ? p.main_accent("linen") : p.main("oak");
  const double pad = soft ? std::min(0.08, top * 0.2) : 0;
  if (soft) cushions(p, seat, sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2 - back * 0.5, top - pad, top), 1, 0.03);
  p.add(soft ? wood : seat,
        box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2 - (back > 0 ? back * 0.5 : 0), top - pad - thick, top - pad), 0.008));
  p.legs(wood, top - pad - thick, 0.05, 0.03);
  if (back > 0.005) {
    p.add(wood, box(sides(-p.w / 2 + 0.02, p.w / 2 - 0.02, p.d / 2 - std::min(back, 0.03), p.d / 2, top + (p.h - top) * 0.45, p.h), 0.008));
    for (const double x : {-1.0, 1.0})
      p.add(wood, box(sides(x * (p.w / 2 - 0.06) - 0.02, x * (p.w / 2 - 0.06) + 0.02, p.d / 2 - std::min(back, 0.03), p.d / 2 - 0.002,
                            top - pad - thick, p.h - 0.01),
                      0.004));
  }
}

void office_chair(Piece& p) {
  const Seat s = seat_of(p, 0.48, 0.06, 0.1);
  const int cloth = p.main("mesh"), dark = p.named("black_plastic"), metal = p.frame("steel");
  const double r = std::min(p.w, p.d) / 2;
  // Five-star base on castors, out to the box in every direction.
  for (int i = 0; i < 5; ++i) {
    const double a = kPi * (0.5 + 0.4 * i), x = std::cos(a) * (r - 0.03), y = std::sin(a) * (r - 0.03);
    p.add(dark, beam({0, 0, 0.11}, {x, y, 0.075}, {0.045, 0.03}, 0.006));
    p.add(dark, ellipsoid({x, y, 0.028}, {0.028, 0.028, 0.028}, 12, 6));
    p.add(metal, cylinder({x, y, 0.045}, 0.008, 0.035, 8));
  }
  p.add(metal, cylinder({0, 0, 0.09}, 0.028, s.level - 0.2, 14));
  p.add(dark, cylinder({0, 0, 0.085}, 0.05, 0.05, 16));
  p.add(dark, box(sides(-0.13, 0.13, -0.13, 0.13, s.level - 0.12, s.level - 0.08), 0.01));
  p.add(cloth, cushion(sides(s.left + 0.005, s.right - 0.005, -p.d / 2, s.back - 0.005, s.level - 0.08, s.level), 0.04, true, 8));
  const double back = std::max(0.03, p.d / 2 - s.back), low = s.level + std::min(0.12, (p.h - s.level) * 0.25);
  p.add(cloth, rounded_box(sides(s.left + 0.02, s.right - 0.02, s.back + back * 0.1, s.back + back * 0.75, low, p.h),
                           std::min(0.035, back * 0.3), 3));
  p.add(dark, box(sides(-0.035, 0.035, p.d / 2 - back * 0.25, p.d / 2, s.level - 0.1, low + (p.h - low) * 0.5), 0.006));
  p.add(dark, box(sides(-0.035, 0.035, 0.05, p.d / 2, s.level - 0.11, s.level - 0.082), 0.006));
  for (const double x : {-1.0, 1.0}) {
    const double width = std::max(0.025, std::min(0.07, x < 0 ? s.left + p.w / 2 : p.w / 2 - s.right)),
                 x0 = x < 0 ? -p.w / 2 : p.w / 2 - width;
    const double z = std::min(p.h * 0.675, s.level + 0.22);  // low enough to go under a desk
    p.add(dark, rounded_box(sides(x0, x0 + width, -p.d * 0.2, p.d * 0.2, z - 0.03, z), 0.012, 2));
    const double xc = x0 + width / 2;
    p.add(dark, box(sides(xc - 0.012, xc + 0.012, -0.03, 0.03, s.level - 0.1, z - 0.03), 0.004));
    p.add(dark, box(sides(std::min(0.0, xc), std::max(0.0, xc), -0.025, 0.025, s.level - 0.115, s.level - 0.085), 0.003));
  }
}

}  // namespace

void add_seats(Families& to) {
  to["chair"] = chair;
  to["stool"] = stool;
  to["bench"] = bench;
  to["office_chair"] = office_chair;
}

}  // namespace layoutbox::kit
