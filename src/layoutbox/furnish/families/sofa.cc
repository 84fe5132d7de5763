// Sofas and armchairs, corner sofas, the cushions on them.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// Measures of a sofa that goes round a corner (or two): a part along the back, and a part to the front at each side of the free middle.
struct CornerSofa {
  double inner;  // where the part along the back begins
  double level, back, foot, pad, arm;
  int cloth, feet;
};

CornerSofa corner_sofa_of(Piece& p, const FreeSpace& middle) {
  CornerSofa c{middle.box.max.y, p.h * 0.5, p.d / 2 - 0.24, 0, 0, 0, p.main_accent("linen"), p.frame("walnut")};
  for (const FreeSpace& s : p.spaces) {
    if (s.carries) c.level = std::min(c.level, s.box.min.z), c.back = std::max(c.back, s.box.max.y);
  }
  c.foot = std::min(0.1, c.level * 0.25);
  c.pad = std::min(0.15, (c.level - c.foot) * 0.5);
  c.arm = std::min(p.h, c.level + 0.2);
  return c;
}

void corner_sofa_base(Piece& p, const CornerSofa& c, double x0, double x1, double y0, double y1) {
  p.add(c.cloth, rounded_box(sides(x0 + 0.005, x1 - 0.005, y0 + 0.005, y1 - 0.005, c.foot, c.level - c.pad), 0.02, 2));
  for (const double fx : {x0 + 0.06, x1 - 0.06}) {
    for (const double fy : {y0 + 0.06, y1 - 0.06}) p.add(c.feet, cone({fx, fy, 0}, 0.016, 0.024, c.foot + 0.01, 12));
  }
}

// One of its parts: cushions on a space that one sits in, those behind the back, and what is left at the sides and at the end as arm or
// back.
void corner_sofa_part(Piece& p, const CornerSofa& c, const Box& b) {
  const double x = p.w / 2, y = p.d / 2;
  const bool to_front = b.max.y < c.inner + 0.01;
  const int n = std::max(1, static_cast<int>(std::lround((b.max.x - b.min.x) / 0.75)));
  cushions(p, c.cloth, sides(b.min.x, b.max.x, to_front ? b.min.y : c.inner, b.max.y, c.level - c.pad, c.level), n, 0.045);
  for (int k = 0; k < n && !to_front; ++k) {
    const double each = (b.max.x - b.min.x) / n, x0 = b.min.x + each * k + 0.004;
    p.add(c.cloth, rounded_box(sides(x0, x0 + each - 0.008, c.back, c.back + 0.12, c.level + 0.003, p.h - 0.04), 0.06, 3));
  }
  for (const double k : {-1.0, 1.0}) {
    const double edge = k > 0 ? b.max.x : b.min.x, width = x - std::abs(edge);
    if (edge * k < 0 || width > 0.35 || width < 0.03) continue;
    const double top = width > 0.2 ? p.h : c.arm;
    p.add(c.cloth, rounded_box(sides(k > 0 ? x - width : -x, k > 0 ? x : -x + width, to_front ? -y : c.inner,
                                     to_front ? c.inner + 0.02 : y - 0.01, c.foot + 0.01, top),
                               0.045, 3));
  }
  if (to_front && b.min.y > -y + 0.03) p.add(c.cloth, rounded_box(sides(b.min.x, b.max.x, -y, b.min.y, c.foot + 0.01, c.arm), 0.045, 3));
}

void corner_sofa(Piece& p, const FreeSpace& middle) {
  const CornerSofa c = corner_sofa_of(p, middle);
  const double x = p.w / 2, y = p.d / 2;
  corner_sofa_base(p, c, -x, x, c.inner, y);
  p.add(c.cloth, rounded_box(sides(-x, x, c.back + 0.1, y, c.foot + 0.01, p.h), 0.04, 3));
  for (const auto& [far_edge, near_edge] : {std::pair{-x, middle.box.min.x}, {x, middle.box.max.x}}) {
    if (std::abs(far_edge - near_edge) > 0.1)
      corner_sofa_base(p, c, std::min(far_edge, near_edge), std::max(far_edge, near_edge), -y, c.inner + 0.01);
  }
  for (const FreeSpace& s : p.spaces) {
    if (s.carries) corner_sofa_part(p, c, s.box);
  }
}

// A cushion at each end of a wide sofa that nothing else lies on.
void scatter_cushions(Piece& p, const Seat& s, int seats) {
  const FreeSpace* open = p.open_above();
  const double size = std::min({0.42, (p.h - s.level) * 1.05, (s.back + p.d / 2) * 0.6});
  if (!p.may_show_contents() || seats < 2 || open == nullptr || open->held || size < 0.2) return;
  const Color base = p.accent();
  const int colors[] = {p.tinted("linen", mixed(base, {0.95, 0.92, 0.86}, 0.6)), p.tinted("wool", mixed(base, {0.80, 0.56, 0.30}, 0.6))};
  const double lean = 68, depth = size * 0.34;
  for (const int i : {0, 1}) {
    const double x = i == 0 ? s.left + size * 0.56 : s.right - size * 0.56;
    if (p.variant(5) == 0 && i == 1) continue;
    const Pose pose = moved(x, s.back - depth * 0.95, s.level + size * 0.47) * turned_z(i == 0 ? 8 : -10) * turned_x(lean);
    Mesh mesh = posed(pillow({{-size / 2, -size / 2, -depth / 2}, {size / 2, size / 2, depth / 2}}, 8), pose);
    const Box b = bounds(mesh);
    const double up = s.level + 0.002 - b.min.z;
    mesh = posed(std::move(mesh), moved(0, 0, std::max(0.0, up)));
    const Box in = bounds(mesh);
    if (in.max.z < p.h && in.max.y < s.back + 0.01 && in.min.y > -p.d / 2) p.add(colors[i], mesh);
  }
}

// Sofas and armchairs are the same thing of another width.
void sofa(Piece& p) {
  for (const FreeSpace& s : p.spaces) {
    if (!s.carries && s.box.min.z < 0.01 && s.box.max.z > p.h - 0.01) return corner_sofa(p, s);
  }
  const Seat s = seat_of(p, 0.43, std::min(0.18, p.w * 0.14), 0.22);
  const bool wicker = is_wicker(p);  // the cushions are of cloth all the same
  const int cloth = wicker ? p.tinted("linen", {0.90, 0.86, 0.76}) : p.main_accent("linen"), feet = p.frame("walnut"),
            body = wicker ? p.main("rattan") : cloth;
  const double foot = std::max(p.clear_below(0), std::min(0.12, s.level * 0.25)),
               arm_top = std::min(p.h, s.level + std::min(0.22, (p.h - s.level) * 0.6));
  const double back = std::max(0.04, p.d / 2 - s.back), left = s.left + p.w / 2, right = p.w / 2 - s.right;
  const int look = p.is_style("modern") || p.is_style("minimalist") ? 1 : p.is_style("traditional") ? 2 : p.variant(3);
  p.legs(look == 1 ? p.frame("black_metal") : feet, foot, look == 1 ? 0.035 : 0.05, look == 2 ? 0.02 : 0.04, look != 1,
         look == 2 ? 1 : 0.65);
  const double pad = std::min(0.15, (s.level - foot) * 0.5);
  p.add(body, rounded_box(sides(-p.w / 2 + 0.01, p.w / 2 - 0.01, -p.d / 2 + 0.012, p.d / 2 - 0.01, foot, s.level - pad), 0.02, 2));
  for (const double x : {-1.0, 1.0}) {
    const double width = x < 0 ? left : right;
    if (width < 0.02) continue;
    const double x0 = x < 0 ? -p.w / 2 : p.w / 2 - width;
    p.add(body, rounded_box(sides(x0, x0 + width, -p.d / 2, p.d / 2 - 0.005, foot + 0.01, arm_top),
                            std::min(look == 1   ? 0.02
                                     : look == 2 ? 0.09
                                                 : 0.05,
                                     width * 0.45),
                            look == 2 ? 4 : 3));
  }
  const bool split = back > 0.13;
  const double shell = split ? 0.1 : back;
  p.add(body, rounded_box(sides(-p.w / 2 + (left > 0.02 ? 0.02 : 0), p.w / 2 - (right > 0.02 ? 0.02 : 0), p.d / 2 - shell, p.d / 2,
                                foot + 0.01, p.h),
                          std::min(0.04, shell * 0.45), 3));
  const int seats = std::max(1, p.count("seats", std::max(1, static_cast<int>(std::lround((s.right - s.left) / 0.7)))));
  cushions(p, cloth, sides(s.left, s.right, -p.d / 2, s.back + (split ? 0.02 : 0), s.level - pad, s.level), seats, 0.045);
  if (split) {
    for (int i = 0; i < seats; ++i) {
      const double each = (s.right - s.left) / seats, x0 = s.left + each * i + 0.004;
      p.add(cloth, rounded_box(sides(x0, x0 + each - 0.008, s.back, p.d / 2 - shell + 0.02, s.level + 0.003, p.h - 0.04),
                               std::min(0.06, (back - shell) * 0.5 + 0.01), 3));
    }
  }
  scatter_cushions(p, s, seats);
}

}  // namespace

void add_sofas(Families& to) {
  to["armchair"] = sofa;
  to["sofa"] = sofa;
}

}  // namespace layoutbox::kit
