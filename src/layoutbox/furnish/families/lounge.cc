// Soft and swinging seats: bean bags, ottomans, recliners, hammocks, swings; beds for pets.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// A slumped sack: wide below, a dent to sit in, gathered above. With a seat and a back of its own where the catalogue has them.
void bean_bag(Piece& p) {
  const int cloth = p.main_accent("velvet");
  if (const FreeSpace* open = p.open_above()) {
    const double seat = open->box.min.z, y0 = open->box.max.y, half = (p.d / 2 - y0) / 2;
    p.add(cloth, ellipsoid({0, 0, seat * 0.5}, {p.w / 2, p.d / 2, seat * 0.5}, 28, 14));
    if (p.h > seat + 0.02) p.add(cloth, ellipsoid({0, y0 + half, p.h * 0.55}, {p.w * 0.36, half, p.h * 0.45}, 24, 12));
    return;
  }
  static constexpr Vec2 kSide[] = {{0.72, 0},    {0.9, 0.05},  {1, 0.2},     {0.97, 0.36}, {0.84, 0.54},
                                   {0.64, 0.72}, {0.42, 0.86}, {0.22, 0.95}, {0.08, 1}};
  const int sides = 36;
  std::vector<std::vector<Vec>> rings;
  for (const Vec2& at : kSide) {
    std::vector<Vec> ring;
    for (int i = 0; i < sides; ++i) {
      // Six panels bulge between their seams; the front leans back above the seat.
      const double a = 2 * kPi * i / sides, bulge = 1 + 0.035 * std::abs(std::sin(3 * a)) * (at.y > 0.04 ? 1 : 0);
      const double front = std::max(0.0, -std::sin(a)), dent = at.y > 0.3 ? 0.34 * front * (at.y - 0.3) : 0;
      ring.push_back({std::cos(a) * at.x * bulge, std::sin(a) * (at.x * bulge - dent) + std::max(0.0, at.y - 0.3) * 0.42, at.y});
    }
    rings.push_back(ring);
  }
  p.add(cloth, loft(rings));
  p.add(cloth, ellipsoid({0, 0.3, 1.0}, {0.07, 0.07, 0.035}, 12, 6));
  p.fit();
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

// A chair to be treated in: a long pad that bends up at the knees' end, on a foot with a column; a head rest behind, arms at the sides.
// `basin`: a wash basin behind (hair) or before it (feet); dental ones have a lamp and a tray on arms.
void treatment_chair(Piece& p, const FreeSpace& seat) {
  const int pad = p.main_accent("leather"), metal = p.named("steel"), white = p.named("plastic");
  const double level = seat.box.min.z, half = std::min(-seat.box.min.x, seat.box.max.x), y0 = seat.box.min.y, y1 = seat.box.max.y,
               y = p.d / 2;
  const double thick = std::min(0.12, level * 0.25), wide = half - 0.005, room = p.w / 2 - half;
  const bool dental = p.word("kind", "") == "dental";
  const double cy = (y0 + y1) / 2 + 0.05;
  p.add(white, lathe({{0, 0}, {0.96, 0}, {1, 0.02}, {0.9, 0.045}, {0.3, 0.07}, {0, 0.07}}, 32),
        moved(0, cy, 0) * scaled(p.w * 0.4, std::min(p.w * 0.5, y - std::abs(cy)), 1));
  p.add(metal, cylinder({0, cy, 0.05}, std::min(0.11, half * 0.5), level - thick - 0.08, 22));
  p.add(white, rounded_box(sides(-wide * 0.7, wide * 0.7, y0 * 0.5, y1 - 0.02, level - thick - 0.06, level - thick + 0.01), 0.025, 3));
  // Seat and leg rest; what is left at the front lies lower.
  p.add(pad, rounded_box(sides(-wide, wide, y0 + p.d * 0.22, y1, level - thick, level - 0.001), thick * 0.4, 3));
  p.add(pad, rounded_box(sides(-wide * 0.86, wide * 0.86, y0, y0 + p.d * 0.225, level - thick * 1.1, level - thick * 0.1), thick * 0.4, 3));
  // The back leans over what lies behind the free room; a head rest above it.
  const double back = std::min(0.13, (y - y1) * 0.5), head = std::min(0.3, (p.h - level) * 0.4);
  const Vec low{0, y1 + back * 0.62, level - thick * 0.8}, high{0, y - back * 0.6, p.h - head * 0.55};
  const Vec lean = unit(high - low);
  p.add(pad, rounded_box(sides(-wide * 0.96, wide * 0.96, -back * 0.35, back * 0.35, 0, length(high - low)), back * 0.3, 4),
        Pose{{1, 0, 0}, unit(cross(lean, {1, 0, 0})), lean, low});
  p.add(pad, rounded_box(sides(-wide * 0.5, wide * 0.5, y - back * 1.25, y, p.h - head, p.h), back * 0.4, 4));
  for (const double s : {-1.0, 1.0}) {
    const double w0 = s * (half + room * 0.2), w1 = s * (p.w / 2), top = level + std::min(0.2, (p.h - level) * 0.4);
    p.add(pad, rounded_box(sides(std::min(w0, w1), std::max(w0, w1), cy - 0.22, std::min(y1, cy + 0.22), top - 0.05, top), 0.02, 3));
    p.add(metal, box(sides(std::min(w0, w1) + 0.01, std::max(w0, w1) - 0.01, cy - 0.03, cy + 0.03, level - thick, top - 0.03), 0.006));
    p.add(metal,
          box(sides(std::min(0.0, w0 + s * 0.02), std::max(0.0, w0 + s * 0.02), cy - 0.03, cy + 0.03, level - thick - 0.05, level - thick),
              0.004));
  }
  if (dental && y - y1 > 0.2) {  // lamp and tray on a pole behind the patient's left
    const Vec pole{half + room * 0.5, y - 0.06, 0};
    p.add(white, rod({pole.x, pole.y, 0}, {pole.x, pole.y, p.h - 0.05}, std::min(0.025, room * 0.3), 12));
    p.add(white, rod({pole.x, pole.y, p.h - 0.06}, {0.1, y1 + 0.14, p.h - 0.06}, 0.018, 10));
    p.add(white, rounded_box(sides(-0.13, 0.13, y1 + 0.02, std::min(y, y1 + 0.2), p.h - 0.08, p.h), 0.03, 3));
    p.add(p.named("bulb"), box(sides(-0.09, 0.09, y1 + 0.04, y1 + 0.16, p.h - 0.084, p.h - 0.07), 0.004));
    p.add(metal, box(sides(half + room * 0.05, p.w / 2, y0 + p.d * 0.3, y0 + p.d * 0.5, level + 0.1, level + 0.12), 0.004));
    p.add(metal, rod({half + room * 0.5, y0 + p.d * 0.4, level + 0.1}, {half + room * 0.5, cy, level - thick}, 0.012, 8));
  }
  if (p.number("basin", 0) > 0) {
    const bool feet = y0 > -y + 0.2;
    const double b0 = feet ? -y : y1 + back + 0.02, b1 = feet ? y0 - 0.03 : y,
                 top = feet ? level * 0.7 : level + std::min(0.3, (p.h - level) * 0.6);
    p.add(p.named("ceramic"), lathe({{0, 0}, {0.6, 0}, {1, 0.7}, {1, 1}, {0.9, 1}, {0.86, 0.75}, {0.5, 0.35}, {0, 0.35}}, 32),
          moved(0, (b0 + b1) / 2, top - 0.2) * scaled(half * 0.9, (b1 - b0) / 2, 0.2));
    p.add(white, box(sides(-half * 0.5, half * 0.5, b0 + (b1 - b0) * 0.25, b1 - (b1 - b0) * 0.25, 0, top - 0.18), 0.02));
  }
}

void recliner(Piece& p) {
  const FreeSpace* seat = p.open_above();
  if (seat != nullptr && (p.word("kind", "") == "dental" || p.number("basin", 0) > 0)) return treatment_chair(p, *seat);
  family_or_generic("armchair")(p);
}

// A cloth slung between the two ends of a bent stand, on many strings.
void hammock(Piece& p) {
  const int cloth = p.main_accent("cotton"), wood = p.frame("oak"), rope = p.named("linen");
  const Pose turn = p.w >= p.d ? Pose{} : turned_z(90);
  const auto add = [&](int s, const Mesh& m) { p.add(s, m, turn); };
  // Made 2 long and 0.72 wide; the stand is one bow with two feet across.
  const double end = 0.96, top = 0.8, half = 0.36;
  for (const double y : {-0.04, 0.04})
    add(wood, tube(curve({{-end, y, top}, {-0.8, y, 0.42}, {-0.4, y, 0.1}, {0, y, 0.055}, {0.4, y, 0.1}, {0.8, y, 0.42}, {end, y, top}}, 6),
                   0.032, 10));
  for (const double s : {-1.0, 1.0}) {
    add(wood, box(sides(s * 0.42 - 0.035, s * 0.42 + 0.035, -half, half, 0, 0.06), 0.012));
  }
  const auto low = [](double t) { return 0.3 + 0.24 * t * t; };  // the middle line, −1…1 along the cloth
  const auto wide = [&](double t) { return half * (0.98 - 0.22 * t * t); };
  const int n = 14, across = 10;
  std::vector<std::vector<Vec>> rings;
  for (int k = 0; k <= n; ++k) {
    const double t = 2.0 * k / n - 1, x = 0.66 * t;
    const auto at = [&](double c) { return Vec{x, c * wide(t), low(t) + 0.15 * c * c * (1 - 0.5 * t * t)}; };
    std::vector<Vec> ring;
    for (int i = 0; i <= across; ++i) ring.push_back(at(-1 + 2.0 * i / across));
    for (int i = across; i >= 0; --i) ring.push_back(at(-1 + 2.0 * i / across) + Vec{0, 0, 0.014});
    rings.push_back(ring);
  }
  add(cloth, loft(rings));
  for (const double s : {-1.0, 1.0}) {
    add(wood, tube(curve({{s * 0.665, -wide(1), low(1) + 0.09}, {s * 0.665, 0, low(1) + 0.01}, {s * 0.665, wide(1), low(1) + 0.09}}, 6),
                   0.014, 8));
    for (int i = 0; i <= 8; ++i) {
      const double c = -1 + 0.25 * i;
      add(rope, rod({s * 0.665, c * wide(1), low(1) + 0.015 + 0.075 * c * c}, {s * (end - 0.02), 0, top - 0.02}, 0.004, 5));
    }
  }
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
