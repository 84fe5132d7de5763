// The garden's and the yard's: watering cans, barrows, mowers, wood in stacks, slides.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// A wheel that rolls along y, its middle at `at`.
void wheel(Piece& p, Vec at, double radius, double wide) {
  p.add(p.named("black_plastic"), rod({at.x - wide / 2, at.y, at.z}, {at.x + wide / 2, at.y, at.z}, radius, 24));
  p.add(p.named("steel"), rod({at.x - wide * 0.55, at.y, at.z}, {at.x + wide * 0.55, at.y, at.z}, radius * 0.5, 16));
}

// Its spout to −x, its handle over the top and down the back.
void watering_can(Piece& p) {
  const int tin = p.main_accent("painted_metal");
  const double r = p.d / 2, tall = p.h * 0.62, x = p.w / 2 - r - p.w * 0.1;
  p.add(tin,
        lathe({{0, 0},
               {r * 0.94, 0},
               {r, p.h * 0.02},
               {r * 0.9, tall * 0.9},
               {r * 0.86, tall},
               {r * 0.8, tall},
               {r * 0.8, tall * 0.9},
               {0, tall * 0.86}},
              30),
        moved(x, 0, 0));
  // The lid over the back half.
  std::vector<Vec2> half;
  for (int i = 0; i <= 12; ++i)
    half.push_back({x + r * 0.85 * std::cos(-kPi / 2 + kPi * i / 12), r * 0.85 * std::sin(-kPi / 2 + kPi * i / 12)});
  p.add(tin, prism(half, tall * 0.96, tall * 1.01, true));
  const Vec foot{x - r * 0.8, 0, p.h * 0.12}, mouth{-p.w / 2 + p.w * 0.1, 0, p.h * 0.8};
  p.add(tin, leg(foot, mouth, r * 0.2, r * 0.12, 12));
  p.add(p.named("brass"), cone({0, 0, 0}, r * 0.13, r * 0.36, p.w * 0.09, 18), aimed(mouth, mouth - foot));
  p.add(tin, tube({{x - r * 0.75, 0, tall * 0.85}, foot + (mouth - foot) * 0.72}, r * 0.05, 6));
  p.add(tin, tube(curve({{x - r * 0.6, 0, tall},
                         {x - r * 0.3, 0, p.h * 0.93},
                         {x + r * 0.4, 0, p.h * 0.98},
                         {p.w / 2 - r * 0.12, 0, p.h * 0.75},
                         {p.w / 2 - r * 0.2, 0, p.h * 0.4},
                         {x + r * 0.9, 0, p.h * 0.22}},
                        5),
                  r * 0.085, 8));
  p.fit();
}

// Wheel to the front, handles to the back.
void wheelbarrow(Piece& p) {
  const int tub = p.main_accent("painted_metal"), bar = p.frame("black_metal"), grip = p.named("black_plastic");
  const double x = p.w / 2, y = p.d / 2, wheel_r = std::min(0.19, p.h * 0.3);
  const auto ring = [&](double front, double back, double half, double z) {
    return ring_at(rounded_rectangle({-half, front}, {half, back}, half * 0.3), z);
  };
  const double low = p.h * 0.42, back = y * 0.36, front = -y * 0.78;
  p.add(tub, loft(std::vector<std::vector<Vec>>{ring(front * 0.45, back * 0.7, x * 0.5, low), ring(front, back, x * 0.96, p.h * 0.97),
                                                ring(front - 0.012, back + 0.012, x, p.h * 0.985), ring(front, back, x * 0.97, p.h),
                                                ring(front * 0.45 + 0.01, back * 0.7 - 0.01, x * 0.47, low + 0.012)}));
  wheel(p, {0, -y + wheel_r, wheel_r}, wheel_r, std::min(0.09, p.w * 0.15));
  for (const double s : {-1.0, 1.0}) {
    const Vec axle{s * p.w * 0.1, -y + wheel_r, wheel_r}, bend{s * x * 0.55, back * 0.5, low - 0.01}, end{s * x * 0.85, y, p.h * 0.72};
    p.add(bar, tube(curve({axle, {s * x * 0.4, front * 0.4, low - 0.012}, bend, end}, 5), 0.016, 8));
    p.add(grip, rod(end - unit(end - bend) * std::min(0.14, p.d * 0.1), end, 0.021, 10));
    p.add(bar, tube(curve({{s * x * 0.5, back * 0.2, low},
                           {s * x * 0.62, back * 0.9, 0.014},
                           {s * x * 0.62, back * 1.3, 0.014},
                           {s * x * 0.6, back * 1.2, low}},
                          3),
                    0.013, 8));
  }
  p.fit();
}

void lawn_mower(Piece& p) {
  const int deck = p.main_accent("painted_metal"), dark = p.named("black_plastic"), bar = p.named("steel");
  const double x = p.w / 2, y = p.d / 2, wheel_r = std::min(0.11, p.h * 0.13), back = y * 0.15, top = wheel_r * 2.1;
  p.add(deck, rounded_box(sides(-x * 0.86, x * 0.86, -y, back, wheel_r * 0.6, top), 0.05, 4));
  const double cy = (back - y) / 2;
  p.add(dark, rounded_box(sides(-x * 0.42, x * 0.42, cy - p.d * 0.12, cy + p.d * 0.12, top - 0.01, top + p.h * 0.11), 0.03, 3));
  p.add(dark, cylinder({0, cy, top + p.h * 0.1}, x * 0.36, p.h * 0.05, 24));
  p.add(bar, rod({x * 0.42, cy, top + 0.06}, {x * 0.62, cy, top + 0.06}, 0.03, 12));
  for (const double s : {-1.0, 1.0}) {
    for (const double wy : {-y + wheel_r * 1.15, back - wheel_r * 0.6}) wheel(p, {s * (x - 0.03), wy, wheel_r}, wheel_r, 0.055);
    p.add(
        bar,
        tube(curve({{s * x * 0.7, back - 0.06, top * 0.8}, {s * x * 0.72, y * 0.5, p.h * 0.55}, {s * x * 0.72, y - 0.02, p.h - 0.015}}, 4),
             0.013, 8));
  }
  p.add(dark, rod({-x * 0.72, y - 0.018, p.h - 0.018}, {x * 0.72, y - 0.018, p.h - 0.018}, 0.018, 10));
  p.add(dark,
        loft(std::vector<std::vector<Vec>>{ring_at(rounded_rectangle({-x * 0.55, back}, {x * 0.55, y * 0.62}, 0.04), wheel_r * 0.9),
                                           ring_at(rounded_rectangle({-x * 0.62, back}, {x * 0.62, y * 0.78}, 0.05), top + p.h * 0.12)}));
  p.fit();
}

// Logs or boards that lie along the longer side.
void wood_pile(Piece& p) {
  const bool along_x = p.w > p.d, logs = p.word("kind", "logs") == "logs";
  const Pose turn = along_x && !logs ? turned_z(90) : Pose{};
  const double wide = along_x && !logs ? p.d : p.w, deep = along_x && !logs ? p.w : p.d;
  const int pale = p.main("pine"), bark = p.named("walnut");
  if (!logs) {
    const int rows = std::max(2, static_cast<int>(p.h / 0.06)), n = std::max(2, static_cast<int>(wide / 0.15));
    for (int k = 0; k < rows; ++k) {
      const double z0 = p.h * k / rows, z1 = p.h * (k + 0.72) / rows, each = wide / n;
      for (int i = 0; i < n; ++i) {
        const double short_by = k == 0 || (i + k) % 3 == 0 ? 0 : p.random(0, 0.04) * deep, x = -wide / 2 + each * i;
        p.add(pale, box(sides(x, x + each * 0.95, -deep / 2 + short_by, deep / 2 - short_by * 0.5, z0, k + 1 == rows ? p.h : z1), 0.003),
              turn);
      }
      for (const double y : {-0.32, 0.0, 0.32})
        if (k + 1 < rows)
          p.add(pale, box(sides(-wide / 2, wide / 2, deep * y - 0.015, deep * y + 0.015, z1, p.h * (k + 1) / rows), 0), turn);
    }
    p.fit();
    return;
  }
  const int n = std::clamp(static_cast<int>(wide / 0.11), 3, 10);
  const double r = wide / n / 2;
  const int rows = std::max(2, static_cast<int>((p.h - 2 * r) / (r * 1.75)) + 1);
  for (int k = 0; k < rows; ++k) {
    for (int i = 0; i + k % 2 < n; ++i) {
      const double x = -wide / 2 + r * (2 * i + 1 + k % 2), z = r + r * 1.75 * k, mine = r * p.random(0.86, 0.99),
                   out = p.random(0.0, 0.03) * deep;
      p.add(bark, rod({x, -deep / 2 + out, z}, {x, deep / 2 - out * 0.5, z}, mine, 8));
      p.add(pale, rod({x, -deep / 2 + out - 0.004, z}, {x, deep / 2 - out * 0.5 + 0.004, z}, mine * 0.86, 8));
    }
  }
  p.fit();
}

// A chute from the platform down to the front, steps up its back.
void slide(Piece& p) {
  const int chute = p.main_accent("plastic"), frame = p.tinted("plastic", {0.30, 0.52, 0.76});
  const double x = p.w / 2, y = p.d / 2, top = p.h * 0.78, t = std::min(0.03, p.w * 0.06), platform = y * 0.45;
  // The chute's line as seen from the side: level at the top, steep, and running out.
  const std::vector<Vec> line = curve(
      {{0, platform, top}, {0, platform * 0.55, top * 0.93}, {0, -y * 0.3, top * 0.36}, {0, -y * 0.75, p.h * 0.1}, {0, -y, p.h * 0.08}}, 6);
  const auto side = [&](double below, double above) {
    std::vector<Vec2> outline;
    for (const Vec& v : line) outline.push_back({v.y, std::max(0.0, v.z - below)});
    for (std::size_t i = line.size(); i-- > 0;) outline.push_back({line[i].y, line[i].z + above});
    std::reverse(outline.begin(), outline.end());
    return outline;
  };
  const Pose across{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, 0}};
  const double wall = std::min(0.1, p.h * 0.14);
  p.add(chute, prism(side(t, 0), -x + t, x - t, true), across);
  for (const double s : {-1.0, 1.0}) p.add(chute, prism(side(t, wall), s > 0 ? x - t : -x, s > 0 ? x : -x + t, true), across);
  p.add(frame, box(sides(-x, x, platform, y * 0.7, top - t, top), 0.006));
  const int n = std::max(2, static_cast<int>(top / 0.2));
  for (const double s : {-1.0, 1.0}) {
    const double px = s * (x - t * 0.7);
    p.add(frame, tube(curve({{px, y - t, t * 0.7},
                             {px, y * 0.68, top},
                             {px, y * 0.62, p.h - t * 0.7},
                             {px, platform, p.h - t * 0.7},
                             {px, platform * 0.8, top * 0.98}},
                            4),
                      t * 0.65, 8));
    p.add(frame, rod({px, platform, 0}, {px, platform, top}, t * 0.6, 8));
  }
  for (int i = 1; i <= n; ++i) {
    const double k = (i - 0.4) / n;
    p.add(frame,
          box(sides(-x + t, x - t, (y - t) * (1 - k) + y * 0.68 * k - 0.045, (y - t) * (1 - k) + y * 0.68 * k + 0.03, top * k - t, top * k),
              0.004));
  }
  p.fit();
}

}  // namespace

void add_garden_things(Families& to) {
  to["watering_can"] = watering_can;
  to["wheelbarrow"] = wheelbarrow;
  to["lawn_mower"] = lawn_mower;
  to["wood_pile"] = wood_pile;
  to["slide"] = slide;
}

}  // namespace layoutbox::kit
