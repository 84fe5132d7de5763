// The page: walls, openings, furniture, dimension lines, title. Symbols and labels have files of their own.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "layoutbox/base/words.h"
#include "layoutbox/export/cairo_canvas.h"
#include "layoutbox/export/export.h"
#include "layoutbox/export/plan_labels.h"
#include "layoutbox/export/plan_symbols.h"
#include "layoutbox/export/svg.h"

namespace layoutbox {
namespace {

// A4 across, in millimetres.
constexpr double kPageWidth = 297, kPageHeight = 210, kMargin = 10, kTitleHeight = 20, kSideColumn = 42, kDimension = 9;
constexpr std::array kScales{5, 10, 20, 25, 30, 40, 50, 60, 75, 100, 125, 150, 200, 250, 500, 1000, 2000, 5000};

struct PlanVector {
  double x = 0, y = 0;
};

PlanVector operator+(PlanVector a, PlanVector b) { return {a.x + b.x, a.y + b.y}; }
PlanVector operator*(double s, PlanVector a) { return {s * a.x, s * a.y}; }
PlanVector vector_of(const Point& p) { return {double(p.x), double(p.y)}; }

// A wall with its direction and its outward normal, in the plan's millimetres.
struct WallFrame {
  PlanVector start, along, out;
  double length = 0, thickness = 0;
  PlanVector at(double s, double t) const { return start + s * along + t * out; }
};

WallFrame frame_of(const Wall& wall) {
  const PlanVector a = vector_of(wall.start), b = vector_of(wall.end);
  const double length = std::max(1.0, std::hypot(b.x - a.x, b.y - a.y));
  const PlanVector along{(b.x - a.x) / length, (b.y - a.y) / length};
  return {a, along, {along.y, -along.x}, length, double(wall.thickness)};
}

std::string title_of(const Layout& layout) {
  std::string title = !layout.name.empty() ? layout.name : !layout.room.type.empty() ? layout.room.type : std::string("room");
  std::replace(title.begin(), title.end(), '_', ' ');
  if (title[0] >= 'a' && title[0] <= 'z') title[0] = static_cast<char>(title[0] - 'a' + 'A');
  return title;
}

class FloorPlan {
 public:
  FloorPlan(const Layout& layout, const FloorPlanOptions& options, Canvas& canvas) : layout_(layout), options_(options), page_(canvas) {
    for (const Wall& wall : layout.room.walls) walls_.push_back(frame_of(wall));
    choose_scale();
  }

  void draw() {
    draw_walls();
    draw_furniture();
    for (const Opening& opening : layout_.room.openings) draw_opening(opening);  // swings lie over rugs
    draw_dimensions();
    draw_labels(page_, scale_, layout_, options_, area_);
    draw_title();
    draw_north();
  }

 private:
  PaperPoint paper(PlanVector p) const { return scale_.at(p.x, p.y); }

  // The largest usual scale at which the room with its dimension lines fits between the columns of labels.
  void choose_scale() {
    double x0 = 0, y0 = 0, x1 = 1000, y1 = 1000;
    if (!layout_.room.polygon.empty()) x0 = x1 = layout_.room.polygon[0].x, y0 = y1 = layout_.room.polygon[0].y;
    for (const Point& p : layout_.room.polygon) {
      x0 = std::min(x0, double(p.x)), x1 = std::max(x1, double(p.x));
      y0 = std::min(y0, double(p.y)), y1 = std::max(y1, double(p.y));
    }
    double wall = 0;
    for (const WallFrame& frame : walls_) wall = std::max(wall, frame.thickness);
    const double width = kPageWidth - 2 * (kMargin + kSideColumn + kDimension),
                 height = kPageHeight - 2 * kMargin - kTitleHeight - 2 * kDimension - 4;
    ratio_ = kScales.back();
    for (const int ratio : kScales) {
      if ((x1 - x0 + 2 * wall) / ratio <= width && (y1 - y0 + 2 * wall) / ratio <= height) {
        ratio_ = ratio;
        break;
      }
    }
    scale_.factor = 1.0 / ratio_;
    const double middle_y = kMargin + kDimension + 2 + height / 2;
    scale_.left = kPageWidth / 2 - (x0 + x1) / 2 * scale_.factor;
    scale_.bottom = middle_y + (y0 + y1) / 2 * scale_.factor;
    const double reach = (x1 - x0 + 2 * wall) / 2 * scale_.factor + kDimension;
    area_ = {kMargin,
             kPageWidth - kMargin,
             kPageWidth / 2 - reach,
             kPageWidth / 2 + reach,
             kMargin + 16,
             kPageHeight - kMargin - kTitleHeight - 2};
  }

  void draw_walls() {
    // Each wall as a strip along its outer face, prolonged at corners that turn outwards so that they close.
    std::vector<PaperPoint> floor;
    for (const Point& p : layout_.room.polygon) floor.push_back(paper(vector_of(p)));
    std::vector<PaperPoint> outer;
    const std::size_t count = walls_.size();
    for (std::size_t i = 0; i < count; ++i) outer.push_back(paper(outer_corner(walls_[(i + count - 1) % count], walls_[i])));
    page_.polygon(outer, {"#4a4a4a", "#222", 0.3, {}});
    page_.polygon(floor, {"#fdfcf9", "#222", 0.3, {}});
  }

  // Where the outer faces of two walls that follow one another meet.
  static PlanVector outer_corner(const WallFrame& before, const WallFrame& wall) {
    const double cross = before.out.x * wall.out.y - before.out.y * wall.out.x;
    if (std::abs(cross) < 1e-3) return wall.at(0, wall.thickness);
    const double t = before.thickness, u = wall.thickness;
    return wall.start + PlanVector{(t * wall.out.y - u * before.out.y) / cross, (u * before.out.x - t * wall.out.x) / cross};
  }

  void draw_opening(const Opening& opening) {
    const auto wall =
        std::find_if(layout_.room.walls.begin(), layout_.room.walls.end(), [&](const Wall& w) { return w.id == opening.wall; });
    if (wall == layout_.room.walls.end()) return;
    const WallFrame& frame = walls_[static_cast<std::size_t>(wall - layout_.room.walls.begin())];
    const double s = opening.offset.value_or(0), e = s + opening.width, t = frame.thickness;
    const auto strip = [&](double from, double to, const DrawStyle& style) {
      page_.polygon({paper(frame.at(s, from)), paper(frame.at(e, from)), paper(frame.at(e, to)), paper(frame.at(s, to))}, style);
    };
    page_.open_group(opening.id, opening.id);
    strip(0, t, {"#fff", "#222", 0.25, {}});
    switch (opening.type) {
      case OpeningType::kWindow: strip(0.38 * t, 0.62 * t, {"#dbeaf4", "#222", 0.15, {}}); break;
      case OpeningType::kOpen: strip(0, t, {"#fff", "#888", 0.15, "1.2 0.8"}); break;
      case OpeningType::kDoor: draw_door(opening, frame, s, e); break;
    }
    page_.close_group();
  }

  // Seen from within looking at the wall, the wall's end is at the left.
  void draw_door(const Opening& opening, const WallFrame& frame, double s, double e) {
    const double width = e - s;
    if (opening.swing == Swing::kSliding) {
      page_.line(paper(frame.at(s, -30)), paper(frame.at(e - 0.05 * width, -30)), {"none", "#222", 0.5, {}});
      return;
    }
    if (opening.swing == Swing::kNone) return;
    const bool left = opening.swing == Swing::kInLeft || opening.swing == Swing::kOutLeft;
    const bool in = opening.swing == Swing::kInLeft || opening.swing == Swing::kInRight;
    const double hinge = left ? e : s, side = left ? -1 : 1, depth = in ? 0 : frame.thickness, way = in ? -1 : 1;
    std::vector<PaperPoint> arc;
    for (int i = 0; i <= 18; ++i) {
      const double angle = i * kPi / 36;
      arc.push_back(paper(frame.at(hinge + side * width * std::cos(angle), depth + way * width * std::sin(angle))));
    }
    page_.polyline(arc, {"none", "#777", 0.15, "1 0.7"});
    page_.line(paper(frame.at(hinge, depth)), paper(frame.at(hinge, depth + way * width)), {"none", "#222", 0.5, {}});
  }

  void draw_furniture() {
    std::vector<const PlacedObject*> order;
    for (const PlacedObject& object : layout_.objects) order.push_back(&object);
    std::stable_sort(order.begin(), order.end(), [&](auto* a, auto* b) { return plan_height(*a) < plan_height(*b); });
    for (const PlacedObject* object : order) {
      page_.open_group(object->id, object->name.empty() ? object->category : object->name);
      draw_symbol(page_, scale_, *object);
      page_.close_group();
    }
  }

  // The length of every wall outside it; of walls with openings also the lengths between.
  void draw_dimensions() {
    const bool rectangle = walls_.size() == 4;
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      const WallFrame& frame = walls_[i];
      std::vector<double> stops{0, frame.length};
      for (const Opening& opening : layout_.room.openings) {
        if (opening.wall != layout_.room.walls[i].id) continue;
        stops.push_back(opening.offset.value_or(0));
        stops.push_back(opening.offset.value_or(0) + opening.width);
      }
      // A rectangle's right and back walls repeat its left and front ones.
      const bool repeated = rectangle && (i == 1 || i == 2);
      if (stops.size() > 2) {
        std::sort(stops.begin(), stops.end());
        draw_chain(frame, stops, 3.0);
      }
      if (!repeated) draw_chain(frame, {0, frame.length}, stops.size() > 2 ? 7.0 : 4.0);
    }
  }

  void draw_chain(const WallFrame& frame, const std::vector<double>& stops, double off) {
    const double t = frame.thickness + off / scale_.factor, tick = 0.9 / scale_.factor;
    const DrawStyle thin{"none", "#888", 0.12, {}}, bold{"none", "#555", 0.3, {}};
    page_.line(paper(frame.at(stops.front(), t)), paper(frame.at(stops.back(), t)), thin);
    for (const double s : stops) {
      page_.line(paper(frame.at(s, frame.thickness + 0.8 / scale_.factor)), paper(frame.at(s, t + tick)), thin);
      page_.line(paper(frame.at(s - tick / 1.5, t - tick / 1.5)), paper(frame.at(s + tick / 1.5, t + tick / 1.5)), bold);
    }
    // Text along the wall, never upside down.
    double degrees = -std::atan2(frame.along.y, frame.along.x) * 180 / kPi;
    if (degrees > 89.5) degrees -= 180;
    if (degrees < -90.5) degrees += 180;
    const double size = off > 3.5 ? 2.4 : 1.9;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      const std::string text = fmt::format("{:.2f}", (stops[i + 1] - stops[i]) / 1000);
      if (text_width(text, size) > (stops[i + 1] - stops[i]) * scale_.factor) continue;
      const PaperPoint middle = paper(frame.at((stops[i] + stops[i + 1]) / 2, t));
      const double turn = radians_from_degrees(degrees);
      page_.text({middle.x + 0.6 * std::sin(turn), middle.y - 0.6 * std::cos(turn)}, size, text, TextAnchor::kMiddle, degrees, "#444");
    }
  }

  void draw_title() {
    const double top = kPageHeight - kMargin - kTitleHeight;
    page_.line({kMargin, top}, {kPageWidth - kMargin, top}, {"none", "#222", 0.3, {}});
    page_.text({kMargin, top + 6.5}, 5, title_of(layout_), TextAnchor::kStart);
    page_.text({kMargin, top + 11}, 2.6,
               fmt::format("{:.1f} m² · ceiling {:.2f} m · {} · scale 1 : {} on A4 · lengths in metres, furniture in centimetres",
                           area_m2(), m_from_mm(layout_.room.height), counted(layout_.objects.size(), "object"), ratio_),
               TextAnchor::kStart, 0, "#555");
    draw_prompt(top + 15);
    if (options_.scale_bar) draw_scale_bar({kPageWidth - kMargin, top + 8});
  }

  double area_m2() const {
    const auto& polygon = layout_.room.polygon;
    double doubled = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const PlanVector a = vector_of(polygon[i]), b = vector_of(polygon[(i + 1) % polygon.size()]);
      doubled += a.x * b.y - a.y * b.x;
    }
    return doubled / 2e6;
  }

  // The words the room was made from, in at most two lines.
  void draw_prompt(double y) {
    std::string rest = layout_.prompt;
    for (int line = 0; line < 2 && !rest.empty(); ++line, y += 3.2) {
      std::size_t end = rest.size();
      while (text_width(rest.substr(0, end), 2.2) > kPageWidth - 2 * kMargin) {
        const std::size_t space = rest.rfind(' ', end - 1);
        end = space == std::string::npos || space == 0 ? end / 2 : space;
      }
      const bool cut = line == 1 && end < rest.size();
      page_.text({kMargin, y}, 2.2, rest.substr(0, end) + (cut ? " …" : ""), TextAnchor::kStart, 0, "#777");
      rest.erase(0, std::min(rest.size(), end + 1));
    }
  }

  void draw_scale_bar(PaperPoint right) {
    // The longest round length of at most 60 mm on paper.
    double metres = 0.1;
    for (const double length : {0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
      if (length * 1000 * scale_.factor <= 60) metres = length;
    }
    const double width = metres * 1000 * scale_.factor, x = right.x - width - 6, step = width / 4;
    for (int i = 0; i < 4; ++i) {
      const double a = x + i * step;
      page_.polygon({{a, right.y - 1.2}, {a + step, right.y - 1.2}, {a + step, right.y}, {a, right.y}},
                    {i % 2 == 0 ? "#222" : "#fff", "#222", 0.15, {}});
    }
    page_.text({x, right.y - 2}, 2.2, "0", TextAnchor::kMiddle);
    page_.text({x + width / 2, right.y - 2}, 2.2, fmt::format("{:g}", metres / 2), TextAnchor::kMiddle);
    page_.text({x + width, right.y - 2}, 2.2, fmt::format("{:g} m", metres), TextAnchor::kMiddle);
  }

  // North is the back of the room: +y, up the page.
  void draw_north() {
    const PaperPoint c{kPageWidth - kMargin - 6, kMargin + 7};
    page_.circle(c, 4.5, {"none", "#444", 0.2, {}});
    page_.polygon({{c.x, c.y - 4.5}, {c.x + 1.8, c.y + 3.2}, {c.x, c.y + 1.8}, {c.x - 1.8, c.y + 3.2}}, {"#444", "none", 0, {}});
    page_.text({c.x, c.y - 5.2}, 2.8, "N", TextAnchor::kMiddle);
  }

  const Layout& layout_;
  const FloorPlanOptions& options_;
  Canvas& page_;
  PlanScale scale_;
  LabelArea area_;
  std::vector<WallFrame> walls_;
  int ratio_ = 50;
};

}  // namespace

std::string write_floor_plan_svg(const Layout& layout, const FloorPlanOptions& options) {
  SvgWriter svg(kPageWidth, kPageHeight);
  FloorPlan(layout, options, svg).draw();
  return std::move(svg).finish();
}

namespace {

Result<std::string> write_by_cairo(PageFormat format, const Layout& layout, const FloorPlanOptions& options) {
  LAYOUTBOX_ASSIGN(const auto page, CairoCanvas::make(format, kPageWidth, kPageHeight, options.dots_per_inch, title_of(layout)));
  FloorPlan(layout, options, *page).draw();
  return page->finish();
}

}  // namespace

Result<std::string> write_floor_plan_pdf(const Layout& layout, const FloorPlanOptions& options) {
  return write_by_cairo(PageFormat::kPdf, layout, options);
}

Result<std::string> write_floor_plan_png(const Layout& layout, const FloorPlanOptions& options) {
  return write_by_cairo(PageFormat::kPng, layout, options);
}

}  // namespace layoutbox
