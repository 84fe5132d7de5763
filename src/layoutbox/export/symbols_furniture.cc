// Symbols of what rooms are furnished with: beds, seats, tables, storage, lamps, plants, rugs.
#include "layoutbox/export/plan_symbol_list.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "layoutbox/base/units.h"

namespace layoutbox {

void draw_bed(Pen& pen, const PlacedObject&) {
  const double w = pen.w(), d = pen.d(), edge = std::min(40.0, w / 10);
  pen.style.fill = "#eef1f6";
  pen.outline();
  pen.style.fill = "#c9d6ea";
  pen.box(-w / 2 + edge, w / 2 - edge, -d / 2 + edge, d / 2 - 0.3 * d);
  pen.line(-w / 2 + edge, d / 2 - 0.38 * d, w / 2 - edge, d / 2 - 0.38 * d);
  pen.style.fill = "#fff";
  const int pillows = w > 1150 ? 2 : 1;
  const double width = (w - 2 * edge) / pillows;
  for (int i = 0; i < pillows; ++i) {
    const double x = -w / 2 + edge + i * width;
    pen.cushion(x + 0.09 * width, x + 0.91 * width, d / 2 - 0.25 * d, d / 2 - 0.07 * d, 60);
  }
}

namespace {

// An L: its box without the free corner, a cushion for each place to sit.
void draw_corner_sofa(Pen& pen, const PlacedObject& object, const Space& corner) {
  const double w = pen.w() / 2, d = pen.d() / 2;
  pen.style.fill = "#d9e4d6";
  if (corner.min[0] <= -w + 1) {
    pen.shape({{-w, d}, {w, d}, {w, -d}, {corner.max[0], -d}, {corner.max[0], corner.max[1]}, {-w, corner.max[1]}});
  } else {
    pen.shape({{-w, d}, {w, d}, {w, corner.max[1]}, {corner.min[0], corner.max[1]}, {corner.min[0], -d}, {-w, -d}});
  }
  pen.style.fill = "#ebf2e8";
  for (const Space& space : object.spaces) {
    if (!space.carries) continue;
    const int seats = std::clamp(static_cast<int>(std::lround((space.max[0] - space.min[0]) / 700)), 1, 6);
    const double seat = (space.max[0] - space.min[0]) / seats;
    for (int i = 0; i < seats; ++i) {
      pen.cushion(space.min[0] + i * seat, space.min[0] + (i + 1) * seat, space.min[1], space.max[1], 60);
    }
  }
}

}  // namespace

void draw_sofa(Pen& pen, const PlacedObject& object) {
  for (const Space& space : object.spaces) {
    if (space.name == "corner") return draw_corner_sofa(pen, object, space);
  }
  const double w = pen.w(), d = pen.d(), arm = std::min(180.0, w * 0.14), back = std::min(220.0, d * 0.28);
  pen.style.fill = "#d9e4d6";
  pen.cushion(-w / 2, w / 2, -d / 2, d / 2, 70);
  const int seats = std::clamp(static_cast<int>(std::lround((w - 2 * arm) / 650)), 1, 5);
  const double seat = (w - 2 * arm) / seats;
  pen.style.fill = "#ebf2e8";
  for (int i = 0; i < seats; ++i) pen.cushion(-w / 2 + arm + i * seat, -w / 2 + arm + (i + 1) * seat, -d / 2, d / 2 - back, 60);
}

void draw_chair(Pen& pen, const PlacedObject&) {
  const double w = pen.w(), d = pen.d();
  pen.style.fill = "#f4e6d3";
  pen.cushion(-w / 2, w / 2, -d / 2, d / 2 - 0.08 * d, 0.2 * w);
  pen.style.fill = "#d8bf9c";
  pen.cushion(-w / 2, w / 2, d / 2 - 0.16 * d, d / 2, 40);
}

void draw_round_seat(Pen& pen, const PlacedObject&) {
  pen.style.fill = "#f4e6d3";
  pen.ellipse(0, 0, pen.w() / 2, pen.d() / 2);
}

void draw_bench(Pen& pen, const PlacedObject&) {
  pen.style.fill = "#f4e6d3";
  pen.cushion(-pen.w() / 2, pen.w() / 2, -pen.d() / 2, pen.d() / 2, 50);
}

void draw_table(Pen& pen, const PlacedObject& object) {
  pen.style.fill = "#f3e3c8";
  if (is_called_round(object)) {
    pen.ellipse(0, 0, pen.w() / 2, pen.d() / 2);
  } else {
    pen.outline();
  }
}

void draw_desk(Pen& pen, const PlacedObject& object) {
  draw_table(pen, object);
  const double w = pen.w(), d = pen.d();
  pen.style.width = 0.12;
  pen.line(w / 2 - 0.3 * w, -d / 2, w / 2 - 0.3 * w, -d / 2 + 0.12 * d);
  pen.line(w / 2 - 0.3 * w, -d / 2 + 0.12 * d, w / 2, -d / 2 + 0.12 * d);
}

// The clothes on a rail, at one end of it: the other one is for the name.
void draw_wardrobe(Pen& pen, const PlacedObject&) {
  const double w = pen.w(), d = pen.d(), first = 0.06 * w, step = 0.055 * w;
  pen.style.fill = "#eadfd0";
  pen.outline();
  pen.style.width = 0.12;
  pen.line(-w / 2, 0, -w / 2 + first + 7 * step, 0);
  for (int i = 0; i < 7; ++i) {
    const double x = -w / 2 + first + (i + 0.3) * step;
    pen.line(x - 0.01 * w, -0.36 * d, x + 0.01 * w, 0.36 * d);
  }
}

// Books stand along the back.
void draw_shelf(Pen& pen, const PlacedObject&) {
  const double w = pen.w(), d = pen.d(), edge = d / 2 - 0.38 * d;
  pen.style.fill = "#eadfd0";
  pen.outline();
  pen.style.width = 0.12;
  pen.line(-w / 2, edge, w / 2, edge);
  const int parts = std::max(2, static_cast<int>(w / 60));
  for (int i = 1; i < parts; ++i) pen.line(-w / 2 + i * w / parts, edge, -w / 2 + i * w / parts, d / 2 - 0.06 * d);
}

// The doors show in front.
void draw_storage(Pen& pen, const PlacedObject&) {
  const double w = pen.w(), d = pen.d();
  pen.style.fill = "#eadfd0";
  pen.outline();
  pen.style.width = 0.12;
  pen.line(-w / 2, -d / 2 + 0.1 * d, w / 2, -d / 2 + 0.1 * d);
  if (w > 700) pen.line(0, -d / 2, 0, -d / 2 + 0.1 * d);
}

void draw_plant(Pen& pen, const PlacedObject&) {
  const double rx = pen.w() / 2, ry = pen.d() / 2;
  pen.style.fill = "#cfe6c4";
  pen.style.stroke = "#4d7a41";
  std::vector<PaperPoint> leaves;
  for (int i = 0; i < 72; ++i) {
    const double angle = i * kPi / 36, reach = 0.93 + 0.07 * std::cos(9 * angle);
    leaves.push_back({rx * reach * std::cos(angle), ry * reach * std::sin(angle)});
  }
  pen.shape(leaves);
  pen.style.width = 0.12;
  for (int i = 0; i < 9; ++i) {
    const double c = std::cos(i * kPi / 4.5), s = std::sin(i * kPi / 4.5);
    pen.line(0.74 * rx * c, 0.74 * ry * s, 0.96 * rx * c, 0.96 * ry * s);
  }
}

void draw_lamp(Pen& pen, const PlacedObject&) {
  const double rx = pen.w() / 2, ry = pen.d() / 2;
  pen.style.fill = "#fff4c9";
  pen.ellipse(0, 0, rx, ry);
  pen.line(-rx, 0, rx, 0);
  pen.line(0, -ry, 0, ry);
}

// A border within, and fringes at the short ends.
void draw_rug(Pen& pen, const PlacedObject& object) {
  const double w = pen.w() / 2, d = pen.d() / 2, edge = std::min({70.0, w / 4, d / 4});
  pen.style.fill = "#f5ece6";
  pen.style.stroke = "#b99c8a";
  const bool round = is_called_round(object);
  round ? pen.oval() : pen.outline();
  pen.style.width = 0.1;
  if (round) return pen.ellipse(0, 0, w - edge, d - edge);
  pen.box(-w + edge, w - edge, -d + edge, d - edge);
  const bool wide = w >= d;
  const double along = wide ? d : w, end = wide ? w : d;
  for (double s = -along + 25; s < along; s += 50) {
    for (const double side : {-end, end - edge / 2}) wide ? pen.line(side, s, side + edge / 2, s) : pen.line(s, side, s, side + edge / 2);
  }
}

}  // namespace layoutbox
