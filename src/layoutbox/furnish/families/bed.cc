// Beds and what is made up like one.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// What the bed is made up with, as the text says, else in a colour of the room.
int duvet_of(Piece& p) { return p.part_look("bedding") != nullptr ? p.part("bedding", "cotton") : p.main_accent("cotton"); }

// A throw goes with the duvet, or is of the second colour that was said.
Color throw_color(const Piece& p) {
  const PartLook* look = p.part_look("bedding");
  return look != nullptr && look->colors.size() > 1 ? look->colors[1] : mixed(p.accent(), {0.93, 0.89, 0.80}, 0.55);
}

// Slept in: the duvet is thrown back to one side, in folds, and the pillows lie as they were left.
void slept_in(Piece& p, const Box& b, int pillows, int duvet, int white, double sheet) {
  const double w = b.size().x, length = b.size().y, drop = std::min(0.16, (sheet - b.min.z) * 0.8), thick = b.max.z - sheet;
  const double edge = b.max.y - length * 0.46;  // up to where it still lies
  p.add(duvet,
        rounded_box(sides(b.min.x, b.max.x, b.min.y + 0.01, edge, sheet - drop, sheet + thick * 0.55), std::min(0.04, thick * 0.5), 3));
  const double cx = (b.min.x + b.max.x) / 2;
  for (int i = 0; i < 4; ++i) {  // folds across it, the first of them showing the other side
    const double half = w * (0.45 - 0.05 * i), deep = 0.09 + 0.01 * (i % 2), y = edge - 0.01 - i * 0.13;
    Mesh fold = rounded_box({{-half, -deep, sheet - 0.02}, {half, deep, sheet + thick * (i % 2 == 0 ? 1.0 : 0.8)}}, thick * 0.45, 4);
    p.add(i == 0 ? white : duvet, posed(std::move(fold), moved(cx + w * 0.01 * i, y, 0) * turned_z(-5.0 - 4.0 * i)));
  }
  const double each = std::min(0.66, (w - 0.08) / std::max(1, pillows)), depth = std::min(0.42, length * 0.2);
  for (int i = 0; i < pillows; ++i) {
    const double x = cx + (i - (pillows - 1) / 2.0) * each, y = b.max.y - depth / 2 - (i % 2 == 0 ? 0.03 : 0.09);
    Mesh one = pillow(sides(-each / 2 + 0.03, each / 2 - 0.03, -depth / 2, depth / 2, sheet - 0.03, b.max.z), 10);
    p.add(white, posed(std::move(one), moved(x, y, 0) * turned_z(i % 2 == 0 ? 6.0 : -11.0)));
  }
}

// Mattress, duvet and pillows in a box whose top is the level on which things may lie.
void bedding(Piece& p, const Box& b, int pillows, int duvet, int white) {
  const double puff = std::min(0.09, b.size().z * 0.4), sheet = b.max.z - puff, margin = 0.012;
  p.add(white, rounded_box(sides(b.min.x + margin, b.max.x - margin, b.min.y + margin, b.max.y, b.min.z, sheet), 0.035, 3));
  if (p.says("unmade")) return slept_in(p, b, pillows, duvet, white, sheet);
  const double length = b.size().y, pillow_depth = std::clamp(length * 0.22, 0.2, 0.46),
               fold = b.max.y - pillow_depth - std::min(0.1, length * 0.06);
  const double drop = std::min(0.16, (sheet - b.min.z) * 0.8);
  // The duvet hangs over three sides; its top end is folded back and shows its white side.
  const double turned = std::min(0.3, length * 0.16);
  p.add(duvet,
        rounded_box(sides(b.min.x, b.max.x, b.min.y, fold - turned + 0.05, sheet - drop, b.max.z - 0.008), std::min(0.045, puff), 3));
  p.add(white, rounded_box(sides(b.min.x + 0.004, b.max.x - 0.004, fold - turned, fold + 0.02, sheet - drop * 0.7, b.max.z),
                           std::min(0.045, puff), 3));
  // A throw over the foot end.
  const PartLook* said = p.part_look("bedding");
  const bool two_colors = said != nullptr && said->colors.size() > 1;
  if (p.may_show_contents() && length > 1.5 && (two_colors || p.variant(3) != 0)) {
    const double y0 = b.min.y + length * 0.06, y1 = b.min.y + length * 0.24;
    p.add(p.tinted("wool", throw_color(p)),
          rounded_box(sides(b.min.x - 0.004, b.max.x + 0.004, y0, y1, sheet - drop * 0.8, b.max.z - 0.003), std::min(0.045, puff), 3));
  }
  const double room = b.size().x - 0.06, each = std::min(0.75, room / std::max(1, pillows));
  for (int i = 0; i < pillows; ++i) {
    const double x = (i - (pillows - 1) / 2.0) * std::max(each, std::min(room / pillows, 0.85));
    p.add(white, pillow(sides(x - each / 2 + 0.02, x + each / 2 - 0.02, fold + 0.04, b.max.y - 0.02, sheet - 0.03, b.max.z), 10));
  }
}

struct BedLevels {
  double top, under, head, foot, side;  // level of the bedding, of the room below, y of head and foot boards, half width
};

BedLevels levels(const Piece& p) {
  BedLevels l{std::min(0.55, p.h * 0.75), 0, p.d / 2 - 0.05, -p.d / 2, p.w / 2};
  if (const FreeSpace* s = p.open_above()) l = {s->box.min.z, 0, s->box.max.y, s->box.min.y, std::max(-s->box.min.x, s->box.max.x)};
  l.under = p.clear_below(0);
  return l;
}

bool is_upholstered(const Piece& p) {
  const PartLook* head = p.own_part("headboard");
  const bool soft_head = head != nullptr && head->material != nullptr && head->material->soft();
  return soft_head || p.says("upholstered") || p.says("velvet") || p.says("tufted");
}

// What a bed is made of and where its parts end.
struct Bed {
  BedLevels levels;
  int wood, white, head_surface, duvet;
  double under, head, rail;
};

Bed bed_of(Piece& p) {
  Bed b{levels(p), p.painted_frame("oak"), p.named("cotton"), 0, 0, 0, 0, 0};
  b.head_surface =
      p.own_part_or("headboard", is_upholstered(p) ? "linen" : "walnut", is_upholstered(p) ? &Piece::main_accent : &Piece::painted_frame);
  b.duvet = duvet_of(p);
  b.under = b.levels.under > 0 ? b.levels.under : std::min(0.14, b.levels.top * 0.3);
  b.head = std::max(0.02, p.d / 2 - b.levels.head);
  b.rail = std::min(0.12, std::max(0.02, (b.levels.top - b.under) * 0.35));
  return b;
}

// Four posts with bars between their tops.
void canopy_bed(Piece& p, const Bed& b) {
  const double post = side_room(p, 0.06);
  for (const double x : {-1.0, 1.0}) {
    const double cx = x * (p.w / 2 - post / 2);
    for (const double y : {-1.0, 1.0})
      p.add(b.wood,
            box(sides(cx - post / 2, cx + post / 2, y * (p.d / 2 - post / 2) - post / 2, y * (p.d / 2 - post / 2) + post / 2, 0, p.h),
                0.006));
    p.add(b.wood, box(sides(cx - post / 2, cx + post / 2, -p.d / 2, p.d / 2, p.h - std::min(0.05, post), p.h), 0.005));
    p.add(b.wood, box(sides(-p.w / 2, p.w / 2, x * (p.d / 2 - post / 2) - post / 2, x * (p.d / 2 - post / 2) + post / 2,
                            p.h - std::min(0.05, post), p.h),
                      0.005));
  }
  p.add(b.wood, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, b.under, b.under + b.rail), 0.006));
  p.add(b.wood, box(sides(-p.w / 2, p.w / 2, p.d / 2 - std::min(b.head, 0.04), p.d / 2, b.under, b.levels.top + 0.45), 0.006));
  bedding(p, sides(-p.w / 2 + 0.01, p.w / 2 - 0.01, -p.d / 2 + 0.01, p.d / 2 - post, b.under + b.rail - 0.002, b.levels.top), 2, b.duvet,
          b.white);
}

// Boards between two posts.
void head_of_boards(Piece& p, const Bed& b, double thick) {
  for (const double x : {-1.0, 1.0})
    p.add(b.head_surface,
          box(sides(x > 0 ? p.w / 2 - 0.06 : -p.w / 2, x > 0 ? p.w / 2 : -p.w / 2 + 0.06, p.d / 2 - thick, p.d / 2, 0, p.h), 0.008));
  const double low = b.under * 0.5 + 0.1, pitch = (p.h - 0.02 - low) / 4;
  for (int i = 0; i < 4; ++i)
    p.add(b.head_surface, box(sides(-p.w / 2 + 0.055, p.w / 2 - 0.055, p.d / 2 - thick * 0.8, p.d / 2 - thick * 0.2, low + pitch * i,
                                    low + pitch * (i + 0.82)),
                              0.005));
}

// A panel in a frame.
void head_of_a_panel(Piece& p, const Bed& b, double thick) {
  p.add(b.head_surface, box(sides(-p.w / 2, p.w / 2, p.d / 2 - thick * 0.6, p.d / 2, b.under * 0.5, p.h - 0.02), 0.004));
  p.add(b.head_surface, box(sides(-p.w / 2, p.w / 2, p.d / 2 - thick, p.d / 2, p.h - 0.07, p.h), 0.01));
  for (const double x : {-1.0, 1.0})
    p.add(b.head_surface, box(sides(x > 0 ? p.w / 2 - 0.07 : -p.w / 2, x > 0 ? p.w / 2 : -p.w / 2 + 0.07, p.d / 2 - thick, p.d / 2,
                                    b.under * 0.5, p.h - 0.06),
                              0.006));
}

// Cloth in upright panels.
void head_of_cloth(Piece& p, const Bed& b, double thick) {
  const int n = std::max(2, static_cast<int>(p.w / 0.32)), cloth = p.main_accent("linen");
  p.add(b.wood, box(sides(-p.w / 2, p.w / 2, p.d / 2 - thick * 0.4, p.d / 2, b.under * 0.5, p.h), 0.004));
  for (int i = 0; i < n; ++i)
    p.add(cloth, rounded_box(sides(-p.w / 2 + p.w * i / n + 0.002, -p.w / 2 + p.w * (i + 1) / n - 0.002, p.d / 2 - thick,
                                   p.d / 2 - thick * 0.3, b.levels.top - 0.1, p.h - 0.004),
                             thick * 0.3, 3));
}

bool is_metal(const Piece& p) {
  return p.says("metal") || p.says("iron") || p.says("wrought iron") || p.says("rusty") || p.says("rusted") || p.says("steel") ||
         p.says("brass");
}

// Bars between two posts under a bow.
void head_of_bars(Piece& p, const Bed& b, double y0, double top) {
  const int metal = p.frame("black_metal");
  const double r = std::min(0.02, b.head * 0.4), y = y0 > 0 ? y0 - r : y0 + r;
  for (const double s : {-1.0, 1.0}) {
    p.add(metal, rod({s * (p.w / 2 - r), y, 0}, {s * (p.w / 2 - r), y, top - r * 2}, r, 10));
    p.add(metal, ellipsoid({s * (p.w / 2 - r), y, top - r}, {r, r, r}, 10, 6));
  }
  for (const double z : {b.levels.top + 0.02, top - r * 3}) p.add(metal, rod({-p.w / 2 + r, y, z}, {p.w / 2 - r, y, z}, r * 0.8, 8));
  const int n = std::max(4, static_cast<int>(p.w / 0.16));
  for (int i = 1; i < n; ++i) {
    const double x = -p.w / 2 + p.w * i / n;
    p.add(metal, rod({x, y, b.levels.top + 0.02}, {x, y, top - r * 3}, r * 0.5, 6));
  }
}

// The board at the head, by the style of the bed where it is high enough to show one.
void head_board(Piece& p, const Bed& b) {
  const bool soft = is_upholstered(p);
  const int look = soft                                               ? 0
                   : p.is_style("modern") || p.is_style("minimalist") ? 0
                   : p.is_style("rustic")                             ? 1
                   : p.is_style("traditional")                        ? 2
                                                                      : p.variant(4);
  const double thick = std::min(b.head, 0.05), top = b.levels.top;
  const bool high = p.h > top + 0.2;
  if (high && !soft && is_metal(p)) return head_of_bars(p, b, p.d / 2, p.h);
  if (high && look == 1) return head_of_boards(p, b, thick);
  if (high && look == 2) return head_of_a_panel(p, b, thick);
  if (high && look == 3 && b.head > 0.03) return head_of_cloth(p, b, thick);
  if (p.h > top + 0.03) {
    p.add(b.head_surface, soft ? rounded_box(sides(-p.w / 2, p.w / 2, p.d / 2 - b.head, p.d / 2, b.under, p.h), b.head * 0.4, 3)
                               : box(sides(-p.w / 2, p.w / 2, p.d / 2 - std::min(b.head, 0.05), p.d / 2, b.under * 0.5, p.h), 0.008));
    return;
  }
  p.add(b.wood, box(sides(-p.w / 2, p.w / 2, p.d / 2 - std::min(b.head, 0.03), p.d / 2, b.under * 0.5, std::min(p.h, top)), 0.006));
}

void bed(Piece& p) {
  const Bed b = bed_of(p);
  const BedLevels& l = b.levels;
  if (p.number("headboard", 1) <= 0 && p.h < 0.55 && p.open_above() == nullptr) {
    // A mattress on the floor, blown up or rolled out.
    bedding(p, sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, p.h), std::max(1, p.count("pillows", 1)), b.duvet, b.white);
    return;
  }
  if (p.number("canopy", 0) > 0) return canopy_bed(p, b);
  p.legs(b.wood, b.under, 0.07, 0.03, false, 0.8);
  p.add(b.wood, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2 - std::min(b.head, 0.03), b.under, b.under + b.rail), 0.008));
  head_board(p, b);
  const double edge = p.d / 2 - std::min(b.head, is_upholstered(p) ? b.head : 0.05);
  if (p.h < l.top + 0.03 && p.h > l.top) p.add(b.wood, box(sides(-0.05, 0.05, p.d / 2 - 0.02, p.d / 2, l.top - 0.02, p.h), 0.004));
  const int pillows = p.count("pillows", p.w > 1.15 ? 2 : 1);
  bedding(p, sides(-p.w / 2 + 0.015, p.w / 2 - 0.015, -p.d / 2 + 0.015, edge, b.under + b.rail - 0.002, l.top), std::max(1, pillows),
          b.duvet, b.white);
  // A foot board, where the bedding ends before the bed does.
  if (l.foot > -p.d / 2 + 0.02)
    p.add(b.wood, box(sides(-p.w / 2, p.w / 2, -p.d / 2, std::min(l.foot, -p.d / 2 + 0.04), b.under, std::min(p.h, l.top + 0.15)), 0.008));
}

// How thick corner posts may be: as wanted, less where a space reaches into the corner.
double corner_room(const Piece& p, double wanted) {
  constexpr double kStep = 0.005, kThinnest = 0.02;
  double post = wanted;
  while (post > kThinnest && !p.is_free(sides(p.w / 2 - post, p.w / 2, p.d / 2 - post, p.d / 2, 0, p.h))) post -= kStep;
  return post;
}

void bunk_bed(Piece& p) {
  const int wood = p.frame("oak"), white = p.named("cotton"), duvet = duvet_of(p);
  const double post = corner_room(p, std::min(0.07, p.w * 0.08));
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const double cx = x * (p.w / 2 - post / 2), cy = y * (p.d / 2 - post / 2);
      p.add(wood, box(sides(cx - post / 2, cx + post / 2, cy - post / 2, cy + post / 2, 0, p.h), 0.006));
    }
  }
  std::vector<double> tops;
  for (const FreeSpace& s : p.spaces) {
    if (s.carries && s.box.min.z > 0.2) tops.push_back(s.box.min.z);
  }
  std::sort(tops.begin(), tops.end());
  if (tops.empty()) tops = {0.45, p.h - 0.35};
  const double free_below = p.clear_below(0);
  for (const double top : tops) {
    const double below = std::max(top - 0.26, free_below < top ? free_below : 0);
    p.add(wood, box(sides(-p.w / 2 + 0.006, p.w / 2 - 0.006, -p.d / 2 + 0.006, p.d / 2 - 0.006, below, below + 0.1), 0.006));
    bedding(p, sides(-p.w / 2 + post, p.w / 2 - post, -p.d / 2 + post, p.d / 2 - post, below + 0.09, top), 1, duvet, white);
    for (const double y : {-1.0, 1.0}) {
      const double y0 = y > 0 ? p.d / 2 - 0.03 : -p.d / 2 + 0.004;
      p.add(wood, box(sides(-p.w / 2 + post, p.w / 2 - post, y0, y0 + 0.025, below + 0.1, std::min(p.h, top + 0.12)), 0.005));
    }
  }
  const double guard = std::min(p.h - 0.02, tops.back() + 0.22);
  for (const double x : {-1.0, 1.0}) {
    const double x0 = x > 0 ? p.w / 2 - 0.03 : -p.w / 2 + 0.006;
    if (!p.is_free(sides(x0, x0 + 0.024, -p.d / 2 + post, p.d / 2 - post, guard - 0.08, guard))) continue;
    p.add(wood, box(sides(x0, x0 + 0.024, -p.d / 2 + post, p.d / 2 - post, guard - 0.08, guard), 0.004));
  }
  // The ladder stands at the foot, between the posts.
  for (const double x : {-0.14, 0.14})
    p.add(wood, box(sides(x - 0.018, x + 0.018, -p.d / 2, -p.d / 2 + 0.03, 0, std::min(p.h, tops.back() + 0.2)), 0.004));
  for (double z = 0.25; z < tops.back() - 0.15; z += 0.27)
    p.add(wood, box(sides(-0.13, 0.13, -p.d / 2 + 0.003, -p.d / 2 + 0.027, z, z + 0.03), 0.004));
}

}  // namespace

void add_beds(Families& to) {
  to["bed"] = bed;
  to["bunk_bed"] = bunk_bed;
}

}  // namespace layoutbox::kit
