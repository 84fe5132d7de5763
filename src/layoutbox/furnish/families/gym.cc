// Gym equipment.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// Drawn as seen by its user, who looks up the y axis; the front of such machines is where that is.
auto adder(Piece& p) {
  return [&p](int surface, Mesh mesh, const Pose& pose = {}) { p.add(surface, std::move(mesh), turned_z(180) * pose); };
}

// One steps on at the back and looks to the front, where the console stands.
void treadmill(Piece& p) {
  const auto add = adder(p);
  const int dark = p.main("black_plastic"), metal = p.frame("steel"), belt = p.tinted("rubber_floor", {0.27, 0.28, 0.30});
  const double deck = std::min(0.18, p.h * 0.14);
  add(dark, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0.02, deck), 0.02));
  add(belt, box(sides(-p.w * 0.36, p.w * 0.36, -p.d / 2 + 0.02, p.d * 0.3, deck - 0.01, deck + 0.006), 0.004));
  add(dark, box(sides(-p.w * 0.42, p.w * 0.42, p.d * 0.3, p.d / 2 - 0.01, deck, deck + 0.1), 0.03));
  for (const double s : {-1.0, 1.0}) {
    add(metal, beam({s * (p.w / 2 - 0.04), p.d * 0.42, 0.02}, {s * (p.w / 2 - 0.04), p.d * 0.3, p.h * 0.82}, {0.05, 0.07}, 0.01));
    add(dark, rod({s * (p.w / 2 - 0.04), p.d * 0.32, p.h * 0.72}, {s * (p.w / 2 - 0.04), -p.d * 0.05, p.h * 0.68}, 0.022, 10));
    add(p.named("black_plastic"), box(sides(s * p.w * 0.4 - 0.03, s * p.w * 0.4 + 0.03, -p.d * 0.45, -p.d * 0.38, 0, 0.03), 0));
  }
  add(dark, rounded_box(sides(-p.w / 2 + 0.02, p.w / 2 - 0.02, p.d * 0.26, p.d * 0.36, p.h * 0.76, p.h * 0.84), 0.02, 2));
  const Pose tilt = moved(0, p.d * 0.3, p.h * 0.82) * turned_x(-25);
  add(dark, rounded_box(sides(-p.w * 0.3, p.w * 0.3, 0, 0.04, 0, p.h * 0.19), 0.015, 2), tilt);
  add(p.named("lit_screen"), box(sides(-p.w * 0.24, p.w * 0.24, -0.002, 0.004, p.h * 0.03, p.h * 0.16), 0), tilt);
  p.fit();
}

void exercise_bike(Piece& p) {
  const auto add = adder(p);
  const int dark = p.main("black_plastic"), metal = p.frame("steel");
  add(dark, rounded_box(sides(-0.24, 0.24, -0.5, -0.42, 0, 0.07), 0.02, 2));
  add(dark, rounded_box(sides(-0.24, 0.24, 0.42, 0.5, 0, 0.07), 0.02, 2));
  add(metal, beam({0, -0.46, 0.05}, {0, 0.46, 0.05}, {0.07, 0.06}, 0.01));
  add(p.named("grey_plastic"), rod({-0.05, 0.26, 0.36}, {0.05, 0.26, 0.36}, 0.27, 28));
  add(dark, rod({-0.058, 0.26, 0.36}, {0.058, 0.26, 0.36}, 0.2, 28));
  add(metal, beam({0, -0.05, 0.07}, {0, -0.22, 0.82}, {0.06, 0.06}, 0.01));
  add(metal, beam({0, 0.16, 0.3}, {0, 0.34, 1.05}, {0.06, 0.06}, 0.01));
  add(p.named("black_leather"), rounded_box(sides(-0.13, 0.13, -0.38, -0.1, 0.82, 0.9), 0.035, 3));
  add(dark, tube(curve({{-0.24, 0.12, 1.12}, {-0.22, 0.32, 1.06}, {0.22, 0.32, 1.06}, {0.24, 0.12, 1.12}}, 5), 0.02, 8));
  add(p.named("screen"), box(sides(-0.1, 0.1, 0.34, 0.37, 1.05, 1.22), 0.006));
  for (const double s : {-1.0, 1.0}) {
    add(metal, rod({s * 0.07, 0.05, 0.34}, {s * 0.09, 0.05, 0.34 - s * 0.16}, 0.012, 8));
    add(dark, box(sides(s * 0.14 - 0.05, s * 0.14 + 0.05, 0.0, 0.1, 0.33 - s * 0.16, 0.35 - s * 0.16), 0.005));
  }
  p.fit();
}

// A bar along x with a head at each end, in that box; round heads where they are as deep as high.
void dumbbell_in(Piece& p, int head, int bar, Vec c, double half, double r) {
  p.add(bar, rod(c - Vec{half * 0.7, 0, 0}, c + Vec{half * 0.7, 0, 0}, r * 0.28, 10));
  for (const double s : {-1.0, 1.0}) p.add(head, rod(c + Vec{s * half * 0.45, 0, 0}, c + Vec{s * half, 0, 0}, r, 6));
}

void dumbbell(Piece& p) {
  dumbbell_in(p, p.main("black_metal"), p.named("chrome"), {0, 0, p.h / 2}, p.w / 2, std::min(p.d, p.h) / 2);
  p.fit();
}

void dumbbell_rack(Piece& p) {
  const int metal = p.frame("black_metal"), head = p.named("black_plastic"), bar = p.named("chrome");
  const int tiers = p.h > 0.75 ? 3 : 2;
  if (!p.spaces.empty()) {
    family_or_generic("rack")(p);
    if (!p.may_show_contents()) return;
    for (const FreeSpace& s : p.spaces) {
      const double r = std::min({0.06, s.box.size().z * 0.3, s.box.size().y * 0.3});
      if (!s.carries || s.held || r < 0.02 || s.box.max.z > p.h - 0.002) continue;
      const double reach = std::min(0.13, s.box.size().y * 0.45), y = (s.box.min.y + s.box.max.y) / 2, z = s.box.min.z + r;
      const int n = std::max(2, static_cast<int>(s.box.size().x / (2.4 * r)));
      for (int i = 0; i < n; ++i) {
        const double x = s.box.min.x + s.box.size().x * (i + 0.5) / n;
        p.add(bar, rod({x, y - reach * 0.7, z}, {x, y + reach * 0.7, z}, r * 0.28, 8));
        for (const double k : {-1.0, 1.0}) p.add(head, rod({x, y + k * reach * 0.45, z}, {x, y + k * reach, z}, r, 6));
      }
    }
    return;
  }
  for (const double s : {-1.0, 1.0}) {
    const double x0 = s > 0 ? p.w / 2 - 0.05 : -p.w / 2;
    p.add(metal, box(sides(x0, x0 + 0.05, -p.d / 2, p.d / 2, 0, 0.05), 0.006));
    p.add(metal, beam({x0 + 0.025, -p.d * 0.1, 0.03}, {x0 + 0.025, p.d / 2 - 0.04, p.h - 0.02}, {0.05, 0.06}, 0.006));
  }
  for (int t = 0; t < tiers; ++t) {
    const double z = p.h * (0.2 + 0.68 * t / std::max(1, tiers - 1)), y = -p.d * 0.22 + p.d * 0.45 * t / tiers,
                 r = std::min(0.06, p.h / tiers * 0.22);
    p.add(metal, box(sides(-p.w / 2 + 0.05, p.w / 2 - 0.05, y - 0.09, y + 0.09, z - 0.03, z), 0.005), Pose{});
    const int n = std::max(2, static_cast<int>((p.w - 0.14) / (2.4 * r)));
    for (int i = 0; i < n; ++i) {
      const double x = -p.w / 2 + 0.07 + (p.w - 0.14) * (i + 0.5) / n;
      const double reach = std::min(0.13, p.d * 0.24);
      p.add(bar, rod({x, y - reach * 0.7, z + r}, {x, y + reach * 0.7, z + r}, r * 0.28, 8));
      for (const double s : {-1.0, 1.0}) p.add(head, rod({x, y + s * reach * 0.45, z + r}, {x, y + s * reach, z + r}, r, 6));
    }
  }
  p.fit();
}

void barbell_bench(Piece& p) {
  const int metal = p.frame("black_metal"), pad = p.main("black_leather"), chrome = p.named("chrome"), weight = p.named("black_plastic");
  const double seat = p.h * 0.42, up = p.d * 0.3;
  p.add(pad, rounded_box(sides(-0.14, 0.14, -p.d / 2, p.d * 0.28, seat - 0.07, seat), 0.025, 3));
  p.add(metal, box(sides(-0.03, 0.03, -p.d * 0.45, p.d * 0.35, seat - 0.12, seat - 0.07), 0.005));
  for (const double y : {-p.d * 0.38, up}) {
    p.add(metal, box(sides(-0.03, 0.03, y - 0.03, y + 0.03, 0.03, seat - 0.1), 0.005));
    p.add(metal, box(sides(-0.25, 0.25, y - 0.03, y + 0.03, 0, 0.04), 0.008));
  }
  const double x = std::min(0.3, p.w * 0.3), z = p.h - 0.22;
  for (const double s : {-1.0, 1.0}) {
    p.add(metal, box(sides(s * x - 0.03, s * x + 0.03, up - 0.03, up + 0.03, 0.02, z + 0.03), 0.005));
    p.add(metal, box(sides(s * x - 0.03, s * x + 0.03, up - 0.2, p.d / 2, 0, 0.05), 0.006));
    p.add(metal, box(sides(s * x - 0.03, s * x + 0.03, up - 0.08, up - 0.05, z, z + 0.1), 0.005));
    p.add(weight,
          rod({s * (p.w / 2 - 0.16), up - 0.05, z + 0.045}, {s * (p.w / 2 - 0.1), up - 0.05, z + 0.045}, std::min(0.2, z * 0.4), 28));
    p.add(weight,
          rod({s * (p.w / 2 - 0.1), up - 0.05, z + 0.045}, {s * (p.w / 2 - 0.06), up - 0.05, z + 0.045}, std::min(0.14, z * 0.3), 28));
  }
  p.add(metal, box(sides(-x, x, up - 0.02, up + 0.02, z * 0.35, z * 0.35 + 0.04), 0.005));
  p.add(chrome, rod({-p.w / 2, up - 0.05, z + 0.045}, {p.w / 2, up - 0.05, z + 0.045}, 0.014, 10));
  p.fit();
}

void yoga_mat(Piece& p) {
  const int mat = p.main_accent("plastic");
  if (p.h < 0.04) {
    p.add(mat, box(p.body(), 0.003));
    return;
  }
  // Rolled up along its longer side.
  const bool along = p.w >= p.d;
  const double r = std::min(along ? p.d : p.w, p.h) / 2, half = (along ? p.w : p.d) / 2;
  const Pose turn = along ? Pose{} : turned_z(90);
  p.add(mat, rod({-half, 0, r}, {half, 0, r}, r, 26), turn);
  for (const double s : {-1.0, 1.0})
    p.add(p.named("black_plastic"), torus({0, 0, 0}, r * 0.55, r * 0.05, 22, 5), turn * aimed({s * half * 0.999, 0, r}, {1, 0, 0}));
  p.fit();
}

void punching_bag(Piece& p) {
  const int bag = p.main("black_leather"), chain = p.named("steel");
  const double r = std::min(p.w, p.d) / 2;
  if (p.mount() == Mount::kCeiling) {
    const double hang = p.h * 0.25;
    p.add(bag, lathe({{0, 0}, {r * 0.9, 0}, {r, 0.03}, {r, p.h - hang - 0.03}, {r * 0.9, p.h - hang}, {0, p.h - hang}}, 28));
    for (int i = 0; i < 4; ++i)
      p.add(chain,
            rod({std::cos(1.57 * i) * r * 0.85, std::sin(1.57 * i) * r * 0.85, p.h - hang - 0.01}, {0, 0, p.h - hang * 0.3}, 0.006, 6));
    p.add(chain, rod({0, 0, p.h - hang * 0.35}, {0, 0, p.h}, 0.012, 8));
  } else {
    p.add(p.named("black_plastic"), lathe({{0, 0}, {r, 0}, {r, p.h * 0.1}, {r * 0.6, p.h * 0.2}, {0, p.h * 0.2}}, 28));
    p.add(chain, cylinder({0, 0, p.h * 0.18}, r * 0.2, p.h * 0.2, 12));
    p.add(bag,
          lathe({{0, p.h * 0.32}, {r * 0.55, p.h * 0.32}, {r * 0.62, p.h * 0.36}, {r * 0.62, p.h * 0.96}, {r * 0.5, p.h}, {0, p.h}}, 28));
  }
  p.fit();
}

// A canvas on a skirted platform, a padded post in each corner (one red, one blue, two white), ropes from post to post and ties between
// them.
void boxing_ring(Piece& p) {
  const FreeSpace* open = p.open_above();
  const double floor = open != nullptr ? open->box.min.z : p.h * 0.3, edge = side_room(p, 0.15), x = p.w / 2, y = p.d / 2;
  const int white = p.named("cotton"), red = p.tinted("plastic", {0.78, 0.22, 0.2}), blue = p.tinted("plastic", {0.22, 0.36, 0.66});
  const int tie = p.named("plastic"), metal = p.frame("steel");
  p.add(p.tinted("cotton", {0.30, 0.36, 0.46}), box(sides(-x, x, -y, y, 0, floor - 0.02), 0.01));
  p.add(white, box(sides(-x + 0.02, x - 0.02, -y + 0.02, y - 0.02, floor - 0.03, floor), 0.004));
  const int ropes = p.count("ropes", 3);
  const double high = p.h - floor, low = 0.3 * high, rise = ropes > 1 ? 0.58 * high / (ropes - 1) : 0, middle = edge / 2;
  const auto level = [&](int i) { return floor + low + rise * i; };
  for (const double right : {-1.0, 1.0}) {
    for (const double back : {-1.0, 1.0}) {
      const Vec at{right * (x - middle), back * (y - middle), floor};
      const int pad = right * back < 0 ? white : right > 0 ? red : blue;
      p.add(metal, rod({at.x, at.y, floor}, {at.x, at.y, p.h}, 0.25 * edge, 12));
      p.add(pad, rounded_box(sides(at.x - middle, at.x + middle, at.y - middle, at.y + middle, floor + 0.2 * high, p.h - 0.02), 0.03, 2));
    }
    for (int i = 0; i < ropes; ++i) {
      const int rope = i % 3 == 0 ? red : i % 3 == 1 ? tie : blue;
      p.add(rope, rod({right * (x - middle), -y + edge, level(i)}, {right * (x - middle), y - edge, level(i)}, 0.02, 8));
      p.add(rope, rod({-x + edge, right * (y - middle), level(i)}, {x - edge, right * (y - middle), level(i)}, 0.02, 8));
    }
    for (const double third : {-1.0 / 3, 1.0 / 3}) {
      const auto strap = [&](double cx, double cy) {
        p.add(tie, box(sides(cx - 0.024, cx + 0.024, cy - 0.024, cy + 0.024, level(0) - 0.03, level(ropes - 1) + 0.03), 0.004));
      };
      strap(right * (x - middle), third * y);
      strap(third * x, right * (y - middle));
    }
  }
}

}  // namespace

void add_gym(Families& to) {
  to["boxing_ring"] = boxing_ring;
  to["treadmill"] = treadmill;
  to["exercise_bike"] = exercise_bike;
  to["dumbbell"] = dumbbell;
  to["dumbbell_rack"] = dumbbell_rack;
  to["barbell_bench"] = barbell_bench;
  to["yoga_mat"] = yoga_mat;
  to["punching_bag"] = punching_bag;
}

}  // namespace layoutbox::kit
