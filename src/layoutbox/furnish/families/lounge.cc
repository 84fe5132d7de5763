// Soft and swinging seats: bean bags, ottomans, recliners, hammocks, swings; beds for pets.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

void bean_bag(Piece& p) {
  const int cloth = p.main_accent("velvet");
  const FreeSpace* open = p.open_above();
  const double seat = open != nullptr ? open->box.min.z : p.h * 0.5;
  p.add(cloth, ellipsoid({0, 0, seat * 0.5}, {p.w / 2, p.d / 2, seat * 0.5}, 28, 14));
  const double y0 = open != nullptr ? open->box.max.y : 0, half = (p.d / 2 - y0) / 2;
  if (p.h > seat + 0.02) p.add(cloth, ellipsoid({0, y0 + half, p.h * 0.55}, {p.w * 0.36, half, p.h * 0.45}, 24, 12));
}

void ottoman(Piece& p) {
  const int cloth = p.main_accent("linen");
  const double foot = std::min(0.1, p.h * 0.25);
  const bool round = p.word("top", "rect") == "round" || p.says("round");
  if (round) {
    const double r = p.w / 2, e = std::min(0.04, (p.h - foot) * 0.3);
    for (int i = 0; i < 3; ++i) {
      const double a = kPi * (0.5 + 2.0 * i / 3);
      p.add(p.frame("oak"), cone({std::cos(a) * r * 0.7, std::sin(a) * r * 0.7 * p.d / p.w, 0}, 0.014, 0.02, foot + 0.01, 12));
    }
    p.add(cloth, lathe({{0, foot}, {r - e, foot}, {r, foot + e}, {r, p.h - e}, {r - e * 0.3, p.h - e * 0.25}, {r - e, p.h}, {0, p.h}}, 36),
          scaled(1, p.d / p.w, 1));
    return;
  }
  p.legs(p.frame("oak"), foot, 0.045, 0.04, true, 0.65);
  const double pad = (p.h - foot) * 0.45;
  p.add(cloth, rounded_box(sides(-p.w / 2 + 0.006, p.w / 2 - 0.006, -p.d / 2 + 0.006, p.d / 2 - 0.006, foot, p.h - pad), 0.02, 2));
  p.add(cloth, cushion(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, p.h - pad - 0.002, p.h), 0.035));
}

void recliner(Piece& p) { family_or_generic("armchair")(p); }

void hammock(Piece& p) {
  const int cloth = p.main_accent("cotton"), wood = p.frame("oak");
  const bool along = p.w >= p.d;
  const double a = (along ? p.w : p.d) / 2, b = (along ? p.d : p.w) / 2;
  const Pose turn = along ? Pose{} : turned_z(90);
  for (const double s : {-1.0, 1.0}) {
    p.add(wood, tube(curve({{s * a * 0.15, 0, 0.06}, {s * a * 0.72, 0, 0.12}, {s * (a - 0.04), 0, p.h - 0.01}}, 5), 0.035, 10), turn);
    p.add(wood, box(sides(s * a * 0.45 - 0.03, s * a * 0.45 + 0.03, -b, b, 0, 0.05), 0.008), turn);
    p.add(p.named("linen"), rod({s * (a - 0.05), 0, p.h - 0.04}, {s * a * 0.72, 0, p.h * 0.46}, 0.008, 6), turn);
    p.add(wood, rod({s * a * 0.72, -b * 0.85, p.h * 0.46}, {s * a * 0.72, b * 0.85, p.h * 0.46}, 0.015, 8), turn);
  }
  p.add(wood, box(sides(-a * 0.5, a * 0.5, -0.03, 0.03, 0.03, 0.08), 0.008), turn);
  std::vector<Vec2> profile;
  const int n = 14;
  const auto level = [&](double t) { return p.h * (0.3 + 0.15 * t * t); };
  for (int i = 0; i <= n; ++i) profile.push_back({a * 0.72 * (2.0 * i / n - 1), level(2.0 * i / n - 1)});
  for (int i = n; i >= 0; --i) profile.push_back({a * 0.72 * (2.0 * i / n - 1), level(2.0 * i / n - 1) + 0.02});
  p.add(cloth, prism(profile, -b * 0.85, b * 0.85, true), turn * Pose{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}});
  p.fit();
}

// A seat on ropes from the ceiling, or a shell that hangs on one.
void swing(Piece& p) {
  const int rope = p.named("linen");
  const FreeSpace* seat = p.spaces.empty() ? nullptr : &p.spaces.front();
  const double level = seat != nullptr ? seat->box.min.z : p.h * 0.12;
  const double x = seat != nullptr ? (p.w / 2 + seat->box.max.x) / 2 : p.w * 0.45;
  if (level > 0.15) {
    const int shell = p.main("rattan");
    const double back = seat != nullptr ? seat->box.max.y : p.d * 0.3, top = seat != nullptr ? seat->box.max.z : p.h * 0.5;
    p.add(shell, rounded_box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, level - 0.06), std::min(0.12, level * 0.45), 4));
    p.add(p.named("cotton"), cushion(sides(-p.w * 0.4, p.w * 0.4, -p.d * 0.45, back, level - 0.07, level), 0.03));
    p.add(shell, rounded_box(sides(-p.w / 2 + 0.01, p.w / 2 - 0.01, back, p.d / 2 - 0.005, level * 0.4, top),
                             std::min(0.05, (p.d / 2 - back) * 0.4), 3));
    for (const double s : {-1.0, 1.0}) {
      p.add(shell,
            tube(curve({{s * x, -p.d * 0.3, level * 0.6}, {s * x, p.d * 0.1, top * 0.75}, {s * x, p.d / 2 - 0.03, top}}, 5), 0.018, 8));
      p.add(rope,
            tube({{s * x, p.d / 2 - 0.04, top * 0.97}, {s * x * 0.5, p.d * 0.25, top + (p.h - top) * 0.4}, {0, 0, p.h - 0.05}}, 0.008, 6));
    }
    p.add(p.named("black_metal"), cylinder({0, 0, p.h - 0.06}, 0.04, 0.06, 18));
    return;
  }
  const int board = p.main("oak");
  p.add(board, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, level), 0.008));
  for (const double s : {-1.0, 1.0}) {
    p.add(rope, rod({s * x, 0, level * 0.5}, {s * x, 0, p.h - 0.01}, std::min(0.012, (p.w / 2 - x) * 0.8), 8));
    p.add(p.named("black_metal"), cylinder({s * x, 0, p.h - 0.03}, std::min(0.03, (p.w / 2 - x) * 0.98), 0.03, 14));
  }
}

// Bolsters round a pad.
void pet_bed(Piece& p) {
  const int cloth = p.main_accent("wool"), pad = p.named("fur");
  const FreeSpace* in = p.open_above();
  const double t = in != nullptr ? p.w / 2 - in->box.max.x : p.w * 0.16, ty = in != nullptr ? p.d / 2 - in->box.max.y : p.d * 0.18;
  const double level = in != nullptr ? in->box.min.z : p.h * 0.45, x = p.w / 2, y = p.d / 2, r = std::min({t, ty, p.h}) * 0.45;
  for (const double s : {-1.0, 1.0}) {
    p.add(cloth, rounded_box(sides(s > 0 ? x - t : -x, s > 0 ? x : -x + t, -y, y, 0, p.h), r, 4));
    p.add(cloth, rounded_box(sides(-x + t * 0.5, x - t * 0.5, s > 0 ? y - ty : -y, s > 0 ? y : -y + ty, 0,
                                   s > 0 ? p.h : std::max(level, p.h * 0.75)),
                             r, 4));
  }
  p.add(pad, cushion(sides(-x + t * 0.8, x - t * 0.8, -y + ty * 0.8, y - ty * 0.8, 0.01, level), 0.03));
}

void cat_tree(Piece& p) {
  const int fur = p.main("wool"), post = p.named("linen");
  p.add(fur, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, 0.04), 0.01));
  const double r = std::min(0.045, p.w * 0.1);
  p.add(post, cylinder({-p.w * 0.22, p.d * 0.15, 0.04}, r, p.h - 0.08, 16));
  p.add(post, cylinder({p.w * 0.24, -p.d * 0.1, 0.04}, r, p.h * 0.55, 16));
  p.add(fur, box(sides(-p.w / 2, p.w * 0.1, -p.d * 0.2, p.d / 2, p.h - 0.04, p.h), 0.01));
  p.add(fur, box(sides(-p.w * 0.05, p.w / 2, -p.d / 2, p.d * 0.25, p.h * 0.55, p.h * 0.55 + 0.04), 0.01));
  p.add(fur, box(sides(-p.w / 2 + 0.02, p.w * 0.02, -p.d * 0.3, p.d / 2 - 0.02, p.h * 0.2, p.h * 0.42), 0.015));
  p.add(p.named("black_plastic"), lathe({{0, 0}, {p.h * 0.075, 0}, {p.h * 0.075, 0.004}, {0, 0.004}}, 20),
        aimed({-p.w * 0.23, -p.d * 0.3 + 0.002, p.h * 0.31}, {0, -1, 0}));
}

}  // namespace

void add_lounge(Families& to) {
  to["bean_bag"] = bean_bag;
  to["ottoman"] = ottoman;
  to["recliner"] = recliner;
  to["hammock"] = hammock;
  to["swing"] = swing;
  to["pet_bed"] = pet_bed;
  to["cat_tree"] = cat_tree;
}

}  // namespace layoutbox::kit
