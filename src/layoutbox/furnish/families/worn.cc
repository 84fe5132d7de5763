// Things that people wear: shoes and skates, hats and helmets, clothes on a hanger.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// An egg-shaped ring round (x, y), its narrow end (the heel) to +y.
std::vector<Vec> foot_ring(double x, double y, Vec2 half, double z) {
  std::vector<Vec> ring;
  for (int i = 0; i < 24; ++i) {
    const double a = 2 * kPi * i / 24, c = std::cos(a), s = std::sin(a);
    const double wide = half.x * (s < 0 ? 1 : 1 - 0.16 * s);
    ring.push_back({x + wide * std::copysign(std::pow(std::abs(c), 0.8), c), y + half.y * std::copysign(std::pow(std::abs(s), 0.9), s), z});
  }
  return ring;
}

// One shoe round x, from `low` (its sole's underside) to `high`, toe to the front; its opening is `ankle` of its length long.
void shoe(Piece& p, int upper, int sole, double x, double half, double low, double high) {
  const double y = p.d / 2, thick = std::min(0.022, (high - low) * 0.2), instep = std::min(high, low + p.d * 0.26), heel = y * 0.52;
  const Vec2 ankle{half * 0.72, y * 0.46}, inside{half * 0.6, y * 0.4};
  p.add(sole, prism(
                  [&] {
                    std::vector<Vec2> outline;
                    for (const Vec& v : foot_ring(x, 0, {half, y}, 0)) outline.push_back({v.x, v.y});
                    return outline;
                  }(),
                  low, low + thick, true));
  std::vector<std::vector<Vec>> rings{
      foot_ring(x, 0, {half * 0.96, y * 0.98}, low + thick - 0.001), foot_ring(x, 0, {half * 0.98, y * 0.96}, low + (instep - low) * 0.38),
      foot_ring(x, y * 0.2, {half * 0.86, y * 0.74}, low + (instep - low) * 0.68), foot_ring(x, heel, ankle, instep)};
  if (high > instep + 0.01) rings.push_back(foot_ring(x, heel, ankle, high));
  rings.push_back(foot_ring(x, heel, inside, high));
  rings.push_back(foot_ring(x, heel, inside, high - std::min(0.05, (high - low) * 0.4)));
  p.add(upper, loft(rings));
  const int lace = p.named("paper");
  for (int i = 0; i < 4; ++i) {  // laces over the instep
    const double t = i / 3.0, ly = -y * 0.38 + y * 0.42 * t, lz = low + (instep - low) * (0.62 + 0.3 * t);
    p.add(lace,
          tube(curve({{x - half * 0.5, ly, lz - 0.004}, {x, ly - 0.004, lz + 0.008}, {x + half * 0.5, ly, lz - 0.004}}, 3), 0.003, 5));
  }
}

// A pair of shoes; with `kind` skates: boots on a plate with wheels.
void shoes(Piece& p) {
  const bool skates = p.word("kind", "") == "skates";
  const int upper = p.main_accent("leather"), sole = p.named(skates ? "black_plastic" : "grey_plastic");
  const double half = p.w * 0.23, low = skates ? std::min(0.075, p.h * 0.3) : 0;
  for (const double s : {-1.0, 1.0}) {
    const double x = s * (p.w / 2 - half);
    shoe(p, upper, sole, x, half, low, p.h);
    if (!skates) continue;
    const double r = low * 0.42, tread = std::min(0.018, half * 0.3);
    for (const double y : {-0.3, 0.3}) {
      p.add(p.named("steel"), box(sides(x - half * 0.3, x + half * 0.3, y * p.d - 0.015, y * p.d + 0.015, r, low + 0.002), 0.003));
      for (const double k : {-1.0, 1.0})
        p.add(p.tinted("plastic", {0.90, 0.50, 0.30}),
              rod({x + k * (half * 0.85 - tread), y * p.d, r}, {x + k * half * 0.95, y * p.d, r}, r, 18));
    }
    p.add(p.tinted("plastic", {0.90, 0.50, 0.30}), cylinder({x, -p.d * 0.46, low * 0.35}, r * 0.5, low * 0.65, 14));
  }
  p.fit();
}

void hat(Piece& p) {
  const Pose oval = scaled(p.w / 2, p.d / 2, p.h);
  if (p.word("kind", "") == "helmet") {
    const int shell = p.main_accent("plastic"), dark = p.named("black_plastic");
    p.add(shell, lathe({{0, 0.06}, {0.94, 0.06}, {0.99, 0.3}, {0.93, 0.6}, {0.7, 0.87}, {0.35, 0.98}, {0, 1}}, 30), oval);
    p.add(dark, lathe({{0.9, 0}, {0.97, 0}, {1, 0.1}, {0.97, 0.14}, {0.9, 0.1}, {0.9, 0}}, 30), oval);
    for (const double x : {-0.42, -0.14, 0.14, 0.42}) {  // air slots along the top
      std::vector<Vec> slot;
      for (int i = 0; i <= 6; ++i) {
        const double y = -0.55 + 1.1 * i / 6;
        slot.push_back({x * p.w / 2, y * p.d / 2, p.h * (0.985 * std::sqrt(std::max(0.05, 1 - (x * x + y * y))))});
      }
      p.add(dark, tube(curve(slot, 2), std::min(p.w, p.d) * 0.026, 6));
    }
    p.fit();
    return;
  }
  p.add(p.main_accent("wool"),
        lathe({{0, 0}, {0.98, 0.02}, {1, 0.07}, {0.6, 0.1}, {0.57, 0.16}, {0.53, 0.86}, {0.44, 1}, {0.2, 0.95}, {0, 0.93}}, 32), oval);
  p.add(p.named("black_plastic"), lathe({{0.5, 0.13}, {0.6, 0.13}, {0.575, 0.32}, {0.5, 0.32}, {0.5, 0.13}}, 32), oval);
  p.fit();
}

// A dress or a coat that hangs on a hanger.
void garment(Piece& p) {
  const int cloth = p.main_accent("cotton"), hanger = p.named("oak");
  const double x = p.w / 2, k = p.d / p.w, top = p.h * 0.88;
  p.add(cloth, lathe({{0, 0},
                      {x * 0.82, 0},
                      {x * 0.62, top * 0.58},
                      {x * 0.66, top * 0.74},
                      {x * 0.72, top * 0.88},
                      {x * 0.66, top * 0.93},
                      {x * 0.22, top},
                      {x * 0.16, top * 0.97},
                      {0, top * 0.93}},
                     30, k));
  for (const double s : {-1.0, 1.0}) {
    p.add(cloth,
          tube(curve({{s * x * 0.6, 0, top * 0.9}, {s * x * 0.82, 0, top * 0.76}, {s * x * 0.88, 0, top * 0.52}}, 5), p.d * 0.38, 12));
    p.add(hanger, tube({{0, 0, top * 0.985}, {s * x * 0.6, 0, top * 0.94}}, 0.007, 7));
  }
  for (int i = 0; i < 5; ++i)  // buttons
    p.add(p.named("brass"), ellipsoid({0, -p.d / 2 * (0.8 + 0.03 * i), top * (0.86 - 0.1 * i)}, {0.009, 0.005, 0.009}, 8, 4));
  const double r = p.h * 0.025;
  p.add(
      p.named("chrome"),
      tube(curve({{0, 0, top * 0.97}, {0, 0, p.h - 2.6 * r}, {r, 0, p.h - 1.6 * r}, {0, 0, p.h - 0.003}, {-r, 0, p.h - r}}, 4), 0.003, 6));
  p.fit();
}

}  // namespace

void add_worn_things(Families& to) {
  to["shoes"] = shoes;
  to["hat"] = hat;
  to["garment"] = garment;
}

}  // namespace layoutbox::kit
