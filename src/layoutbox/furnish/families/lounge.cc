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
    p.add(cloth, lathe({{0, foot}, {r - e, foot}, {r, foot + e}, {r, p.h - e}, {r - e * 0.3, p.h - e * 0.25}, {r - e, p.h}, {0, p.h}}, 36), scaled(1, p.d / p.w, 1));
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
    p.add(wood, beam({s * a * 0.15, 0, 0.03}, {s * (a - 0.04), 0, p.h - 0.03}, {0.06, 0.06}, 0.008), turn);
    p.add(wood, box(sides(s * a * 0.45 - 0.03, s * a * 0.45 + 0.03, -b, b, 0, 0.05), 0.008), turn);
    p.add(p.named("linen"), rod({s * (a - 0.05), 0, p.h - 0.04}, {s * a * 0.72, 0, p.h * 0.62}, 0.008, 6), turn);
    p.add(wood, rod({s * a * 0.72, -b * 0.85, p.h * 0.62}, {s * a * 0.72, b * 0.85, p.h * 0.62}, 0.015, 8), turn);
  }
  p.add(wood, box(sides(-a * 0.5, a * 0.5, -0.03, 0.03, 0.03, 0.08), 0.008), turn);
  std::vector<Vec2> profile;
  const int n = 14;
  const auto level = [&](double t) { return p.h * (0.36 + 0.26 * t * t); };
  for (int i = 0; i <= n; ++i) profile.push_back({a * 0.72 * (2.0 * i / n - 1), level(2.0 * i / n - 1)});
  for (int i = n; i >= 0; --i) profile.push_back({a * 0.72 * (2.0 * i / n - 1), level(2.0 * i / n - 1) + 0.02});
  p.add(cloth, prism(profile, -b * 0.85, b * 0.85, true), turn * Pose{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}});
  p.fit();
}

void swing(Piece& p) {
  const int wood = p.frame("oak"), rope = p.named("linen"), seat = p.main("oak");
  for (const double s : {-1.0, 1.0}) {
    for (const double t : {-1.0, 1.0}) p.add(wood, beam({s * (p.w / 2 - 0.04), t * (p.d / 2 - 0.04), 0}, {s * (p.w / 2 - 0.04), 0, p.h - 0.04}, {0.06, 0.06}, 0.006));
    p.add(rope, rod({s * p.w * 0.22, 0, p.h * 0.25}, {s * p.w * 0.22, 0, p.h - 0.06}, 0.008, 6));
  }
  p.add(wood, box(sides(-p.w / 2, p.w / 2, -0.04, 0.04, p.h - 0.08, p.h), 0.008));
  p.add(seat, box(sides(-p.w * 0.25, p.w * 0.25, -p.d * 0.14, p.d * 0.14, p.h * 0.22, p.h * 0.25), 0.006));
  p.fit();
}

void pet_bed(Piece& p) {
  const int cloth = p.main_accent("wool"), pad = p.named("fur");
  const double r = p.w / 2, t = std::min({p.h / 2, r * 0.3, 0.09}), k = p.d / p.w;
  std::vector<Vec2> roll;
  for (int i = 0; i <= 12; ++i) {
    const double a = 2 * kPi * (i % 12) / 12;
    roll.push_back({r - t + t * std::cos(a), p.h / 2 + p.h / 2 * std::sin(a)});
  }
  p.add(cloth, lathe(roll, 32), scaled(1, k, 1));
  const double level = p.open_above() != nullptr ? std::min(p.open_above()->box.min.z, p.h * 0.6) : p.h * 0.4;
  p.add(pad, lathe({{0, 0}, {r - t, 0}, {r - t, level * 0.8}, {r - t * 1.5, level}, {0, level}}, 28), scaled(1, k, 1));
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
  p.add(p.named("black_plastic"), lathe({{0, 0}, {p.h * 0.075, 0}, {p.h * 0.075, 0.004}, {0, 0.004}}, 20), aimed({-p.w * 0.23, -p.d * 0.3 + 0.002, p.h * 0.31}, {0, -1, 0}));
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
