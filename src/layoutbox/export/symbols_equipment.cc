// Symbols of bath and kitchen, of devices, and of what stands in gyms, shops and music rooms.
#include "layoutbox/export/plan_symbol_list.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "layoutbox/base/units.h"

namespace layoutbox {

void draw_toilet(Pen& pen, const PlacedObject&) {
  const double w = pen.w(), d = pen.d();
  pen.style.fill = "#e7f1f6";
  pen.cushion(-w / 2, w / 2, d / 2 - 0.28 * d, d / 2, 30);
  pen.ellipse(0, -0.14 * d, 0.46 * w, 0.36 * d);
  pen.ellipse(0, -0.14 * d, 0.32 * w, 0.26 * d);
}

void draw_basin(Pen& pen, const PlacedObject&) {
  const double w = pen.w(), d = pen.d();
  pen.style.fill = "#e7f1f6";
  pen.outline();
  pen.style.fill = "#fff";
  pen.ellipse(0, -0.05 * d, 0.38 * w, 0.34 * d);
  pen.ellipse(0, 0.38 * d, 15, 15);
}

void draw_tub(Pen& pen, const PlacedObject&) {
  const double w = pen.w(), d = pen.d(), rim = 0.1 * std::min(w, d);
  pen.style.fill = "#e7f1f6";
  pen.outline();
  pen.style.fill = "#fff";
  pen.cushion(-w / 2 + rim, w / 2 - rim, -d / 2 + rim, d / 2 - rim, 0.35 * std::min(w, d));
  if (w >= d) {
    pen.ellipse(w / 2 - 3 * rim, 0, 25, 25);
  } else {
    pen.ellipse(0, d / 2 - 3 * rim, 25, 25);
  }
}

// The floor falls towards the drain; its lines leave the middle free.
void draw_shower(Pen& pen, const PlacedObject&) {
  const double w = pen.w() / 2, d = pen.d() / 2;
  pen.style.fill = "#e7f1f6";
  pen.outline();
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) pen.line(x * w, y * d, 0.6 * x * w, 0.6 * y * d);
  }
  pen.ellipse(0, 0.7 * d, 45, 45);
}

void draw_stove(Pen& pen, const PlacedObject&) {
  const double w = pen.w(), d = pen.d(), r = 0.17 * std::min(w, d);
  pen.style.fill = "#ececec";
  pen.outline();
  for (const double x : {-0.24, 0.24}) {
    for (const double y : {-0.2, 0.24}) pen.ellipse(x * w, y * d, r, r);
  }
}

void draw_kitchen_sink(Pen& pen, const PlacedObject&) {
  const double w = pen.w(), d = pen.d();
  pen.style.fill = "#eadfd0";
  pen.outline();
  pen.style.fill = "#fff";
  pen.cushion(-0.4 * w, 0.4 * w, -0.32 * d, 0.28 * d, 60);
  pen.ellipse(0, 0.38 * d, 15, 15);
}

// A door in front; what the machine is about in the corner: cold, a drum, or nothing.
void draw_appliance(Pen& pen, const PlacedObject&) {
  const double w = pen.w() / 2, d = pen.d() / 2, r = 0.2 * std::min(w, d), x = w - 1.5 * r, y = d - 1.5 * r;
  pen.style.fill = "#ececec";
  pen.outline();
  pen.style.width = 0.12;
  pen.line(-w, -0.85 * d, w, -0.85 * d);
  const std::string_view family = pen.family();
  if (family == "dishwasher") return;
  if (family == "washing_machine") return pen.ellipse(x, y, r, r);
  for (int i = 0; i < 3; ++i) {
    const double c = r * std::cos(i * kPi / 3), s = r * std::sin(i * kPi / 3);
    pen.line(x - c, y - s, x + c, y + s);
  }
}

void draw_screen(Pen& pen, const PlacedObject&) {
  pen.style.fill = "#c3c8cd";
  pen.outline();
  pen.line(-pen.w() / 2, -pen.d() / 2, pen.w() / 2, -pen.d() / 2);
}

void draw_piano(Pen& pen, const PlacedObject& object) {
  if (pen.w() < 700) return draw_flat(pen, object);  // a computer's keyboard
  const double w = pen.w(), d = pen.d();
  pen.style.fill = "#d6d2cd";
  if (pen.family() == "grand_piano") {
    // The straight side at the bass, left of the keys; the bent side from the treble to the tail.
    std::vector<PaperPoint> outline{{w / 2, -d / 2}, {w / 2, -0.1 * d}};
    for (int i = 0; i <= 12; ++i) {
      const double share = i / 12.0, bend = 0.5 - 0.5 * std::cos(share * kPi);
      outline.push_back({w / 2 - bend * 0.38 * w, -0.1 * d + share * 0.45 * d});
    }
    for (int i = 0; i <= 8; ++i) {
      const double angle = i * kPi / 16;
      outline.push_back(
          {-w / 2 + 0.25 * w + 0.37 * w * std::cos(angle) - 0.12 * w * (1 - std::cos(angle)), 0.35 * d + 0.15 * d * std::sin(angle)});
    }
    outline.push_back({-w / 2, 0.5 * d});
    outline.push_back({-w / 2, -d / 2});
    pen.shape(outline);
  } else {
    pen.outline();
  }
  pen.style.fill = "#fff";
  pen.box(-0.45 * w, 0.45 * w, -d / 2, -d / 2 + std::min(180.0, 0.3 * d));
}

void draw_flat(Pen& pen, const PlacedObject&) {
  pen.style.fill = "#e3e3e3";
  pen.outline();
}

// Folds.
void draw_curtain(Pen& pen, const PlacedObject&) {
  const double w = pen.w(), d = pen.d();
  const int folds = std::max(4, static_cast<int>(w / 60));
  pen.style.width = 0.12;
  for (int i = 0; i < folds; ++i) {
    const double a = -w / 2 + i * w / folds, b = a + w / folds, way = i % 2 == 0 ? 1 : -1;
    pen.line(a, -0.4 * d * way, b, 0.4 * d * way);
  }
}

void draw_box(Pen& pen, const PlacedObject& object) {
  pen.style.fill = "#f0eee9";
  if (is_called_round(object)) return pen.ellipse(0, 0, pen.w() / 2, pen.d() / 2);
  pen.outline();
}

void draw_treadmill(Pen& pen, const PlacedObject&) {
  const double w = pen.w(), d = pen.d();
  pen.style.fill = "#d9d9d9";
  pen.cushion(-w / 2, w / 2, -d / 2, d / 2, 60);
  pen.style.fill = "#f2f2f2";
  pen.box(-0.36 * w, 0.36 * w, -0.3 * d, 0.46 * d);
  pen.line(-0.42 * w, -0.36 * d, 0.42 * w, -0.36 * d);  // the console, at the front
}

// Saddle, handlebars, and the wheel between two feet; its rider looks to the back (1) or the front (-1) of the symbol.
void draw_cycle(Pen& pen, double ahead) {
  const double w = pen.w(), d = ahead * pen.d();
  const auto across = [&](double half, double from, double to) { pen.box(-half * w, half * w, std::min(from, to), std::max(from, to)); };
  pen.style.fill = "#d9d9d9";
  for (const double y : {-0.46, 0.4}) across(0.42, y * d, (y + 0.06) * d);
  across(0.06, -0.4 * d, 0.4 * d);
  pen.cushion(-0.1 * w, 0.1 * w, std::min(0.0, 0.4 * d), std::max(0.0, 0.4 * d), 40);
  pen.ellipse(0, -0.15 * d, 0.2 * w, 0.1 * pen.d());
  across(0.5, 0.14 * d, 0.18 * d);
}

void draw_bike(Pen& pen, const PlacedObject&) { draw_cycle(pen, 1); }
void draw_exercise_bike(Pen& pen, const PlacedObject&) { draw_cycle(pen, -1); }

void draw_barbell(Pen& pen, const PlacedObject&) {
  const double w = pen.w(), d = pen.d();
  pen.style.fill = "#d9d9d9";
  pen.cushion(-0.25 * w, 0.25 * w, -d / 2, d / 2, 50);
  pen.box(-w / 2, w / 2, 0.3 * d - 15, 0.3 * d + 15);
  for (const double x : {-0.46, 0.4}) pen.box(x * w, (x + 0.06) * w, 0.18 * d, 0.42 * d);
}

void draw_drums(Pen& pen, const PlacedObject&) {
  const double w = pen.w() / 2, d = pen.d() / 2, r = std::min(w, d);
  pen.style.fill = "#e6e2dc";
  pen.box(-0.3 * w, 0.3 * w, -0.8 * d, -0.1 * d);
  for (const PaperPoint& drum : {PaperPoint{-0.25, 0.05}, {0.25, 0.05}, {-0.55, 0.4}, {0.62, 0.3}}) {
    pen.ellipse(drum.x * w, drum.y * d, 0.24 * r, 0.24 * r);
  }
  pen.style.fill = "#f4e9c0";
  for (const double x : {-0.7, 0.7}) pen.ellipse(x * w, -0.4 * d, 0.29 * r, 0.29 * r);
  pen.style.fill = "#f4e6d3";
  pen.ellipse(0, 0.75 * d, 0.22 * r, 0.22 * r);
}

// Head and shoulders.
void draw_mannequin(Pen& pen, const PlacedObject&) {
  pen.style.fill = "#e8e4de";
  pen.oval();
  pen.ellipse(0, 0, 0.22 * pen.w(), 0.28 * pen.d());
}

void draw_laptop(Pen& pen, const PlacedObject& object) {
  draw_flat(pen, object);
  pen.line(-pen.w() / 2, 0.05 * pen.d(), pen.w() / 2, 0.05 * pen.d());
}

// A pane of glass around.
void draw_glass_case(Pen& pen, const PlacedObject&) {
  const double w = pen.w() / 2, d = pen.d() / 2;
  pen.style.fill = "#eaf1f4";
  pen.outline();
  pen.style.width = 0.12;
  pen.box(-w + 40, w - 40, -d + 40, d - 40);
}

// Small round things: a plate, a vase, a globe, a bin.
void draw_round_thing(Pen& pen, const PlacedObject&) {
  pen.style.fill = "#f0eee9";
  pen.oval();
}

void draw_pool_table(Pen& pen, const PlacedObject&) {
  const double w = pen.w() / 2, d = pen.d() / 2, r = 0.07 * std::min(w, d);
  pen.style.fill = "#d8bf9c";
  pen.outline();
  pen.style.fill = "#cfe6c4";
  pen.box(-w + 100, w - 100, -d + 100, d - 100);
  pen.style.fill = "#555";
  const bool wide = w > d;
  for (const double x : {-1.0, 0.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const double along = x * ((wide ? w : d) - 90), across = y * ((wide ? d : w) - 90);
      wide ? pen.ellipse(along, across, r, r) : pen.ellipse(across, along, r, r);
    }
  }
}

// A canvas with a post in each corner and a rope round it.
void draw_boxing_ring(Pen& pen, const PlacedObject&) {
  const double w = pen.w() / 2, d = pen.d() / 2, post = 0.06 * std::min(w, d);
  pen.style.fill = "#c9d2de";
  pen.outline();
  pen.style.fill = "#f4f1ea";
  pen.box(-w + post, w - post, -d + post, d - post);
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      pen.style.fill = x * y < 0 ? "#ffffff" : x > 0 ? "#d9665e" : "#6d8fc4";
      pen.ellipse(x * (w - post), y * (d - post), post, post);
    }
  }
}

void draw_net_table(Pen& pen, const PlacedObject&) {
  const double w = pen.w() / 2, d = pen.d() / 2;
  pen.style.fill = "#cfdfea";
  pen.outline();
  w > d ? pen.line(0, -d, 0, d) : pen.line(-w, 0, w, 0);
}

// A dashed line where the ceiling begins to come down, and short ones that fall towards the wall.
void draw_roof_slope(Pen& pen, const PlacedObject&) {
  constexpr double kApart = 700, kFall = 0.35;
  const double w = pen.w() / 2, d = pen.d() / 2;
  pen.style.fill = "none";
  pen.style.dash = "1.6 0.9";
  pen.line(-w, -d, w, -d);
  pen.style.dash = {};
  pen.style.width = 0.1;
  const int falls = std::max(1, static_cast<int>(2 * w / kApart));
  for (int i = 0; i < falls; ++i) {
    const double x = -w + 2 * w * (i + 0.5) / falls;
    pen.line(x, -d, x, -d + kFall * 2 * d);
  }
}

}  // namespace layoutbox
