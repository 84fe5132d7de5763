#include "layoutbox/export/plan_symbols.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace layoutbox {
namespace {

// Draws in an object's own frame: millimetres, origin at the centre of the footprint, front to −y.
class Pen {
 public:
  Pen(Canvas& page, const PlanScale& scale, const PlacedObject& object) : page_(page), scale_(scale), object_(object) {
    const double turn = radians_from_degrees(object.rotation_deg);
    cos_ = std::cos(turn);
    sin_ = std::sin(turn);
  }

  double w() const { return object_.size.width; }
  double d() const { return object_.size.depth; }

  PaperPoint at(double x, double y) const {
    return scale_.at(object_.position[0] + cos_ * x - sin_ * y, object_.position[1] + sin_ * x + cos_ * y);
  }
  void box(double x0, double x1, double y0, double y1) { page_.polygon({at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)}, style); }
  // The same with round corners.
  void cushion(double x0, double x1, double y0, double y1, double radius) {
    radius = std::min({radius, (x1 - x0) / 2, (y1 - y0) / 2});
    std::vector<PaperPoint> points;
    const std::array<std::array<double, 3>, 4> corners{
        {{x1 - radius, y1 - radius, 0}, {x0 + radius, y1 - radius, 90}, {x0 + radius, y0 + radius, 180}, {x1 - radius, y0 + radius, 270}}};
    for (const auto& [x, y, start] : corners) {
      for (int i = 0; i <= 8; ++i) {
        const double angle = radians_from_degrees(start + 11.25 * i);
        points.push_back(at(x + radius * std::cos(angle), y + radius * std::sin(angle)));
      }
    }
    page_.polygon(points, style);
  }
  void ellipse(double x, double y, double rx, double ry) {
    std::vector<PaperPoint> points;
    for (int i = 0; i < 32; ++i) points.push_back(at(x + rx * std::cos(i * kPi / 16), y + ry * std::sin(i * kPi / 16)));
    page_.polygon(points, style);
  }
  void shape(const std::vector<PaperPoint>& corners) {
    std::vector<PaperPoint> points;
    for (const PaperPoint& p : corners) points.push_back(at(p.x, p.y));
    page_.polygon(points, style);
  }
  void line(double x0, double y0, double x1, double y1) { page_.line(at(x0, y0), at(x1, y1), style); }
  void outline() { box(-w() / 2, w() / 2, -d() / 2, d() / 2); }

  DrawStyle style;

 private:
  Canvas& page_;
  const PlanScale& scale_;
  const PlacedObject& object_;
  double cos_ = 1, sin_ = 0;
};

bool has(std::string_view text, std::initializer_list<std::string_view> words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) { return text.find(word) != std::string_view::npos; });
}

bool is_round(const PlacedObject& object) {
  const auto& words = object.attributes;
  return has(object.name, {"round", "circular", "oval"}) || std::find(words.begin(), words.end(), "round") != words.end() ||
         std::find(words.begin(), words.end(), "circular") != words.end() || std::find(words.begin(), words.end(), "oval") != words.end();
}

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

void draw_sofa(Pen& pen, const PlacedObject& object) {
  for (const Space& space : object.spaces) {
    if (space.name == "corner") return draw_corner_sofa(pen, object, space);
  }
  const double w = pen.w(), d = pen.d(), arm = std::min(180.0, w * 0.14), back = std::min(220.0, d * 0.28);
  pen.style.fill = "#d9e4d6";
  pen.cushion(-w / 2, w / 2, -d / 2, d / 2, 70);
  const int seats = std::clamp(static_cast<int>(std::lround((w - 2 * arm) / 650)), 1, has(object.category, {"armchair"}) ? 1 : 5);
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

void draw_table(Pen& pen, const PlacedObject& object) {
  pen.style.fill = "#f3e3c8";
  if (is_round(object)) {
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

// Cupboards: the usual cross of tall storage; wardrobes: hangers on a rail.
void draw_storage(Pen& pen, const PlacedObject& object) {
  const double w = pen.w(), d = pen.d();
  pen.style.fill = "#eadfd0";
  pen.outline();
  pen.style.width = 0.12;
  if (has(object.category, {"wardrobe", "closet"})) {
    pen.line(-w / 2 + 30, 0, w / 2 - 30, 0);
    const int hangers = std::max(2, static_cast<int>(w / 130));
    for (int i = 0; i < hangers; ++i) {
      const double x = -w / 2 + (i + 0.5) * w / hangers;
      pen.line(x - 12, -0.36 * d, x + 12, 0.36 * d);
    }
  } else if (has(object.category, {"shelf", "bookcase", "rack"})) {
    const int parts = std::max(2, static_cast<int>(w / 60));
    for (int i = 1; i < parts; ++i) pen.line(-w / 2 + i * w / parts, -d / 2 + 0.15 * d, -w / 2 + i * w / parts, d / 2 - 0.25 * d);
    pen.line(-w / 2, d / 2 - 0.25 * d, w / 2, d / 2 - 0.25 * d);
  } else {
    pen.line(-w / 2, -d / 2 + 0.1 * d, w / 2, -d / 2 + 0.1 * d);
    if (w > 700) pen.line(0, -d / 2, 0, -d / 2 + 0.1 * d);
  }
}

void draw_plant(Pen& pen, const PlacedObject&) {
  const double r = std::min(pen.w(), pen.d()) / 2;
  pen.style.fill = "#cfe6c4";
  pen.style.stroke = "#4d7a41";
  pen.ellipse(0, 0, pen.w() / 2, pen.d() / 2);
  pen.style.width = 0.12;
  for (int i = 0; i < 8; ++i) pen.line(0, 0, 0.85 * r * std::cos(i * kPi / 4), 0.85 * r * std::sin(i * kPi / 4));
  pen.ellipse(0, 0, 0.3 * r, 0.3 * r);
}

void draw_lamp(Pen& pen, const PlacedObject&) {
  const double rx = pen.w() / 2, ry = pen.d() / 2;
  pen.style.fill = "#fff4c9";
  pen.ellipse(0, 0, rx, ry);
  pen.line(-rx, 0, rx, 0);
  pen.line(0, -ry, 0, ry);
}

void draw_rug(Pen& pen, const PlacedObject& object) {
  const double w = pen.w(), d = pen.d();
  pen.style.fill = "#f5ece6";
  pen.style.stroke = "#b99c8a";
  if (is_round(object)) return pen.ellipse(0, 0, w / 2, d / 2);
  pen.outline();
  pen.style.width = 0.08;
  const double step = 90;
  for (double s = -w / 2 - d / 2 + step; s < w / 2 + d / 2; s += step) {  // lines x + y = s within the box
    const double x0 = std::max(-w / 2, s - d / 2), x1 = std::min(w / 2, s + d / 2);
    pen.line(x0, s - x0, x1, s - x1);
  }
}

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

void draw_shower(Pen& pen, const PlacedObject&) {
  const double w = pen.w() / 2, d = pen.d() / 2;
  pen.style.fill = "#e7f1f6";
  pen.outline();
  pen.line(-w, -d, w, d);
  pen.line(-w, d, w, -d);
  pen.ellipse(0, 0, 45, 45);
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

void draw_appliance(Pen& pen, const PlacedObject& object) {
  const double w = pen.w() / 2, d = pen.d() / 2;
  pen.style.fill = "#ececec";
  pen.outline();
  if (has(object.category, {"washing", "dryer", "washer"}) && !has(object.category, {"dish"})) return pen.ellipse(0, 0, 0.6 * w, 0.6 * w);
  pen.line(-w, -d, w, d);
  pen.line(-w, d, w, -d);
}

void draw_screen(Pen& pen, const PlacedObject&) {
  pen.style.fill = "#c3c8cd";
  pen.outline();
  pen.line(-pen.w() / 2, -pen.d() / 2, pen.w() / 2, -pen.d() / 2);
}

void draw_piano(Pen& pen, const PlacedObject& object) {
  const double w = pen.w(), d = pen.d();
  pen.style.fill = "#d6d2cd";
  if (has(object.category, {"grand"})) {
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

void draw_box(Pen& pen, const PlacedObject& object) {
  pen.style.fill = "#f0eee9";
  if (is_round(object)) return pen.ellipse(0, 0, pen.w() / 2, pen.d() / 2);
  pen.outline();
}

struct SymbolRow {
  std::initializer_list<std::string_view> words;  // of the category; the first row that has one of them draws
  void (*draw)(Pen&, const PlacedObject&);
};

const SymbolRow kSymbols[] = {
    {{"bedside", "nightstand"}, draw_storage},
    {{"tub"}, draw_tub},
    {{"bed", "crib", "cot", "mattress"}, draw_bed},
    {{"rug", "carpet", "mat"}, draw_rug},
    {{"sofa", "couch", "armchair", "loveseat", "settee", "recliner"}, draw_sofa},
    {{"stool", "pouf", "ottoman", "bean_bag", "beanbag"}, draw_round_seat},
    {{"chair", "bench"}, draw_chair},
    {{"lamp", "light", "pendant", "chandelier", "sconce"}, draw_lamp},
    {{"desk"}, draw_desk},
    {{"tv_stand", "tv_console", "tv_unit", "sideboard", "dresser", "console"}, draw_storage},
    {{"kitchen_sink"}, draw_kitchen_sink},
    {{"table"}, draw_table},
    {{"toilet", "bidet"}, draw_toilet},
    {{"sink", "basin", "vanity"}, draw_basin},
    {{"shower"}, draw_shower},
    {{"stove", "cooker", "hob", "oven", "range"}, draw_stove},
    {{"fridge", "refrigerator", "freezer", "washing", "washer", "dryer", "dishwasher"}, draw_appliance},
    {{"plant", "tree", "flower"}, draw_plant},
    {{"tv", "monitor", "screen", "television"}, draw_screen},
    {{"piano", "keyboard"}, draw_piano},
    {{"wardrobe", "closet", "shelf", "bookcase", "rack", "cabinet", "cupboard", "drawer", "chest", "locker", "counter", "island"},
     draw_storage},
    {{"mirror", "picture", "painting", "clock", "poster", "whiteboard", "curtain"}, draw_flat},
};

}  // namespace

double plan_height(const PlacedObject& object) {
  if (object.mount == Mount::kCeiling) return 1e6;
  const bool seat = has(object.category, {"chair", "stool", "bench"}) && !has(object.category, {"armchair", "recliner"});
  return object.position[2] + (seat ? std::min<double>(object.size.height, 460) : object.size.height);
}

void draw_symbol(Canvas& page, const PlanScale& scale, const PlacedObject& object) {
  Pen pen(page, scale, object);
  if (object.mount == Mount::kCeiling) {
    pen.style.dash = "0.8 0.6";
    pen.style.fill = "none";
    const bool round = std::abs(pen.w() - pen.d()) < 0.1 * pen.w();
    round ? pen.ellipse(0, 0, pen.w() / 2, pen.d() / 2) : pen.outline();
    pen.line(-0.2 * pen.w(), 0, 0.2 * pen.w(), 0);
    return pen.line(0, -0.2 * pen.d(), 0, 0.2 * pen.d());
  }
  for (const SymbolRow& row : kSymbols) {
    if (has(object.category, row.words)) return row.draw(pen, object);
  }
  draw_box(pen, object);
}

}  // namespace layoutbox
