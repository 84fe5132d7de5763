// Tables and desks.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// What carries a round top: one column on a foot where it stands free, else legs within the round.
void round_support(Piece& p, int surface, double top) {
  const double column = std::min(0.06, p.w * 0.1), foot = p.w * 0.22, ky = p.d / p.w;
  // Chairs are pushed in from all sides, so what many sit at stands on one foot.
  const int n = p.count("legs", 4) == 3 ? 3 : 4;
  const double t = std::min(0.022, p.w * 0.05);
  const auto angle = [&](int i) { return kPi * (n == 3 ? 0.5 + 2.0 * i / 3 : 0.25 + 0.5 * i); };
  const auto at = [&](int i, double k) { return Vec{std::cos(angle(i)) * (p.w / 2 - t) * k, std::sin(angle(i)) * (p.d / 2 - t) * k, 0}; };
  const auto stands = [&](double k) {
    for (int i = 0; i < n; ++i) {
      const Vec c = at(i, k);
      if (!p.is_free(sides(c.x - t, c.x + t, c.y - t, c.y + t, 0, top))) return false;
    }
    return true;
  };
  const double reach = stands(0.86) ? 0.86 : 0.98;
  if (p.count("legs", 4) <= 1 || std::min(p.w, p.d) > 0.75 || !stands(reach)) {
    p.add(surface,
          lathe({{0, 0},
                 {foot, 0},
                 {foot, 0.012},
                 {foot * 0.7, 0.03},
                 {column, 0.06},
                 {column * 0.7, top * 0.5},
                 {column * 0.8, top - 0.02},
                 {foot * 0.6, top},
                 {0, top}},
                28),
          scaled(1, ky, 1));
    return;
  }
  for (int i = 0; i < n; ++i) {
    const Vec c = at(i, reach);
    p.add(surface, cone({c.x, c.y, 0}, t * 0.7, t, top, 14));
  }
}

// A table with a bench at the front and one at the back, on crossed legs.
void picnic_table(Piece& p) {
  const int wood = p.main("pine");
  double seat = p.h * 0.62, inner = p.d / 2 - 0.33;
  for (const FreeSpace& s : p.spaces) {
    if (!s.carries) continue;
    seat = std::min(p.h, s.box.min.z);
    inner = std::min(std::abs(s.box.min.y), std::abs(s.box.max.y));
  }
  const double board = 0.045, gap = 0.008, top = inner - 0.01, bench = p.d / 2 - inner - 0.05;
  const auto planks = [&](double y0, double y1, double z, int n) {
    for (int i = 0; i < n; ++i)
      p.add(wood,
            box(sides(-p.w / 2, p.w / 2, y0 + (y1 - y0) * i / n + (i > 0 ? gap : 0), y0 + (y1 - y0) * (i + 1) / n, z - board, z), 0.005));
  };
  planks(-top, top, p.h, 5);
  planks(-p.d / 2, -p.d / 2 + bench, seat, 2);
  planks(p.d / 2 - bench, p.d / 2, seat, 2);
  for (const double s : {-1.0, 1.0}) {
    const double x = s * (p.w / 2 - 0.05);
    for (const double k : {-1.0, 1.0})
      p.add(wood, beam({x, k * (p.d / 2 - 0.08), 0.04}, {x, k * top * 0.4, p.h - board}, {0.045, 0.08}, 0.004));
    p.add(wood, box(sides(x - 0.022, x + 0.022, -p.d / 2 + 0.02, p.d / 2 - 0.02, seat - board - 0.08, seat - board), 0.004));
    p.add(wood, box(sides(x - 0.022, x + 0.022, -top, top, p.h - board - 0.06, p.h - board), 0.004));
    for (const double k : {-1.0, 1.0})
      p.add(wood, box(sides(x - 0.03, x + 0.03, k * (p.d / 2 - 0.08) - 0.05, k * (p.d / 2 - 0.08) + 0.05, 0, 0.06), 0.004));
  }
}

std::string top_of(const Piece& p) {
  return p.says("hexagonal")                         ? "hexagon"
         : p.says("octagonal")                       ? "octagon"
         : p.says("round") || p.says("circular")     ? "round"
         : p.says("oval")                            ? "oval"
         : p.says("rectangular") || p.says("square") ? "rect"
                                                     : p.word("top", "rect");
}

// As wide and deep as these halves say, a corner at either end.
std::vector<Vec2> regular_polygon(int corners, Vec2 half) {
  std::vector<Vec2> outline;
  const double highest = std::sin(2 * kPi * (corners / 4) / corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * i / corners;
    outline.push_back({half.x * std::cos(angle), half.y * std::sin(angle) / highest});
  }
  return outline;
}

// Four legs under a frame of boards.
void apron_and_legs(Piece& p, int frame, double under, double level) {
  const double in = std::min(0.05, p.d * 0.08);
  if (level - under > 0.015) {
    const double x = p.w / 2 - in, y = p.d / 2 - in;
    for (const double s : {-1.0, 1.0}) {
      p.add(frame, box(sides(-x, x, s * y - 0.009, s * y + 0.009, under, level), 0.003));
      p.add(frame, box(sides(s * x - 0.009, s * x + 0.009, -y, y, under, level), 0.003));
    }
  }
  const bool slim = p.is_style("modern") || p.is_style("scandinavian") || p.is_style("mid-century") || p.says("modern");
  const int look = slim ? 1 : p.is_style("industrial") ? 3 : p.is_style("traditional") ? 2 : p.is_style("rustic") ? 0 : p.variant(3);
  const double tapered = look == 1 ? 0.6 : look == 2 ? 0.75 : 1;
  p.legs(look == 3 && p.own_part("legs") == nullptr ? p.named("black_metal") : frame, level,
         std::min(0.06, 0.025 + p.w * 0.025) * (look == 3 ? 0.7 : 1), in * 0.7, look == 2, tapered);
}

// A shelf below, where the catalogue has a space that stands on one.
void shelves_below(Piece& p, int wood) {
  for (const FreeSpace& s : p.spaces) {
    if (!s.carries || s.box.min.z < 0.05 || s.box.max.z > p.h - 0.005) continue;
    p.add(wood, box(sides(s.box.min.x, s.box.max.x, s.box.min.y, s.box.max.y, s.box.min.z - 0.02, s.box.min.z), 0.004));
  }
}

void drawers_below(Piece& p, int wood, double under, double level) {
  const int drawers = p.count("drawers", 0);
  if (drawers <= 0 || level - under <= 0.05) return;
  const double each = (p.w - 0.2) / drawers;
  for (int i = 0; i < drawers; ++i) {
    const double x0 = -p.w / 2 + 0.1 + each * i, y0 = -p.d / 2 + 0.022;
    fronts(p, wood, p.named("brass"), {x0 + 0.01, x0 + each - 0.01, under + 0.006, level - 0.004, y0, 1, 1, false, 0.02, 0.018});
  }
}

void table(Piece& p) {
  if (p.count("benches", 0) > 0) return picnic_table(p);
  const std::string top = top_of(p);
  const int wood = p.own_part_or("top", "oak", &Piece::main), frame = p.own_part_or("legs", "oak", &Piece::painted_frame);
  const double under = p.clear_below(p.h - std::min(0.09, p.h * 0.16)), board = std::min(0.035, (p.h - under) * 0.6 + 0.002);
  const double level = p.h - board;
  const int corners = top == "hexagon" ? 6 : top == "octagon" ? 8 : 0;
  if (corners > 0) {
    p.add(wood, prism(regular_polygon(corners, {p.w / 2, p.d / 2}), level, p.h));
  } else {
    slab(p, wood, sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, level, p.h), top, 0.006);
  }
  if (top == "round" || top == "oval" || corners > 0 || p.count("legs", 4) == 1) {
    round_support(p, frame, level);
  } else {
    apron_and_legs(p, frame, under, level);
  }
  shelves_below(p, wood);
  drawers_below(p, wood, under, level);
}

// What closes a desk at one side of its knee room: drawers where there is width, else a frame of two legs.
void desk_side(Piece& p, int wood, int front, int metal, double x0, double x1, double level) {
  if (x1 - x0 > 0.2) {
    p.add(wood, box(sides(x0, x1, -p.d / 2 + 0.04, p.d / 2 - 0.01, 0, level), 0.004));
    const int drawers = std::min(4, p.count("drawers", 3));
    fronts(p, front, metal, {x0 + 0.008, x1 - 0.008, 0.03, level - 0.008, -p.d / 2 + 0.022, std::max(1, drawers), 1, drawers == 0});
    return;
  }
  const double t = std::max(0.008, std::min(0.045, x1 - x0));
  const bool left = x0 < 0;
  const double a = left ? std::min(x0 + 0.012, x1 - t) : std::max(x1 - t - 0.012, x0), b = a + t;
  for (const double y : {-p.d / 2 + 0.012, p.d / 2 - 0.012 - t}) p.add(wood, box(sides(a, b, y, y + t, 0, level), 0.004));
  p.add(wood, box(sides(a + t * 0.15, b - t * 0.15, -p.d / 2 + 0.012 + t, p.d / 2 - 0.012 - t, level - 0.06, level), 0.003));
}

// An L: a part along the back and one along the right, round a free corner.
void corner_desk(Piece& p, const FreeSpace& corner) {
  const int wood = p.main("oak"), frame = p.painted_frame("oak");
  const double x = p.w / 2, y = p.d / 2, cx = corner.box.max.x, cy = corner.box.max.y, under = p.h - 0.07, board = 0.03, t = 0.045;
  p.add(wood, box(sides(-x, x, cy, y, p.h - board, p.h), 0.005));
  p.add(wood, box(sides(cx, x, -y, cy + 0.002, p.h - board, p.h), 0.005));
  p.add(frame, box(sides(-x + t, x - 0.002, y - t, y - 0.02, under, p.h - board), 0.003));
  p.add(frame, box(sides(x - t, x - 0.02, -y + t, y - t, under, p.h - board), 0.003));
  for (const Vec2 at : {Vec2{-x, y - t}, Vec2{-x, cy}, Vec2{x - t, y - t}, Vec2{x - t, -y}, Vec2{cx, -y}})
    p.add(frame, box(sides(at.x, at.x + t, at.y, at.y + t, 0, p.h - board), 0.004));
}

void desk(Piece& p) {
  for (const FreeSpace& s : p.spaces) {
    if (s.box.min.z < 0.01 && s.box.max.z > p.h - 0.01) return corner_desk(p, s);
  }
  if (p.count("hutch", 0) > 0) {
    const int body = p.main("oak");
    Carcass c{p.body(), body, body, p.named("brass")};
    c.drawers = std::max(1, p.count("drawers", 2));
    return carcass(p, c);
  }
  const int wood = p.main("oak"), frame = p.painted_frame("oak"), metal = p.named("steel");
  const int front = p.color_asked() ? wood : p.named("lacquer");
  double top_level = p.h, under = 0, left = -p.w / 2 + 0.06, right = p.w / 2 - 0.06, back = p.d / 2;
  for (const FreeSpace& s : p.spaces) {
    if (s.box.min.z < 0.01 && s.box.max.z > under) under = s.box.max.z, left = s.box.min.x, right = s.box.max.x, back = s.box.max.y;
    if (s.box.max.z > p.h - 0.011 && s.box.min.z > 0.3 * p.h) top_level = std::min(top_level, s.box.min.z);
  }
  if (under <= 0) under = top_level - 0.1;
  const double board = std::min(0.03, top_level - under);
  p.add(wood, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, top_level - board, top_level), 0.005));
  const double level = top_level - board;
  desk_side(p, frame, front, metal, -p.w / 2, left, level);
  desk_side(p, frame, front, metal, right, p.w / 2, level);
  if (back < p.d / 2 - 0.015)
    p.add(frame, box(sides(-p.w / 2 + 0.03, p.w / 2 - 0.03, back, std::min(p.d / 2 - 0.01, back + 0.018), level * 0.5, level), 0.003));
  if (level - under > 0.06) {
    p.add(frame, box(sides(left, right, -p.d / 2 + 0.045, std::min(back, p.d / 2 - 0.03), under, level), 0.003));
    fronts(p, front, metal,
           {left + 0.006, right - 0.006, under + 0.004, level - 0.004, -p.d / 2 + 0.025, 1,
            std::max(1, static_cast<int>((right - left) / 0.5)), false, 0.02, 0.02});
  } else if (level - under > 0.012) {
    p.add(frame, box(sides(left, right, p.d / 2 - 0.05, p.d / 2 - 0.03, under, level), 0.003));
  }
  // A hutch or gallery behind the top.
  if (p.h - top_level > 0.02) {
    double front_edge = p.d / 2 - 0.02;
    for (const FreeSpace& s : p.spaces) {
      if (s.box.min.z > top_level - 0.01) front_edge = std::min(p.d / 2 - 0.01, std::max(s.box.max.y, p.d / 2 - 0.3));
    }
    const bool mirror = p.word("kind", "") == "mirror";
    if (mirror) {
      p.add(p.named("mirror"),
            box(sides(-p.w / 2 + 0.05, p.w / 2 - 0.05, front_edge, front_edge + 0.012, top_level + 0.05, p.h - 0.05), 0.001));
      front_edge += 0.006;
    }
    carcass(p, {sides(-p.w / 2, p.w / 2, front_edge, p.d / 2, top_level, p.h), frame, front, metal, 0, 0, false, 0});
  }
}

}  // namespace

void add_tables(Families& to) {
  to["table"] = table;
  to["desk"] = desk;
}

}  // namespace layoutbox::kit
