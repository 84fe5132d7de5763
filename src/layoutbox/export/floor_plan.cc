// The page: walls, openings, furniture, dimension lines, title. Symbols and labels have files of their own.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/opening_look.h"
#include "layoutbox/export/cairo_canvas.h"
#include "layoutbox/export/export.h"
#include "layoutbox/export/plan_dimensions.h"
#include "layoutbox/export/plan_ink.h"
#include "layoutbox/export/plan_labels.h"
#include "layoutbox/export/plan_room.h"
#include "layoutbox/export/plan_symbols.h"
#include "layoutbox/export/svg.h"

namespace layoutbox {
namespace {

// A4 across, in millimetres.
constexpr double kPageWidth = 297, kPageHeight = 210, kMargin = 10, kTitleHeight = 20, kKeyWidth = 46;
constexpr double kSmallRatio = 50, kSmallMargin = 4;  // of a room alone
constexpr std::array kScales{5, 10, 20, 25, 30, 40, 50, 60, 75, 100, 125, 150, 200, 250, 500, 1000, 2000, 5000};

std::string title_of(const Layout& layout) {
  std::string title = !layout.name.empty() ? layout.name : !layout.room.type.empty() ? layout.room.type : std::string("room");
  std::replace(title.begin(), title.end(), '_', ' ');
  if (title[0] >= 'a' && title[0] <= 'z') title[0] = static_cast<char>(title[0] - 'a' + 'A');
  return title;
}

// The paper that a plan takes: width and height.
PaperPoint paper_for(const Layout& layout, const FloorPlanOptions& options) {
  if (options.sheet) return {kPageWidth, kPageHeight};
  const PlanRoom room(layout);
  return {(room.x1 - room.x0) / kSmallRatio + 2 * kSmallMargin, (room.y1 - room.y0) / kSmallRatio + 2 * kSmallMargin};
}

class FloorPlan {
 public:
  FloorPlan(const Layout& layout, const FloorPlanOptions& options, Canvas& canvas)
      : layout_(layout),
        options_(options),
        paper_(paper_for(layout, options)),
        ink_(paper_.x, paper_.y),
        page_(canvas, ink_),
        room_(layout) {
    if (options.sheet) {
      choose_scale();
    } else {
      put_in_the_middle(kSmallRatio, {paper_.x / 2, paper_.y / 2});
    }
  }

  void draw() {
    draw_walls();
    draw_furniture();
    for (const Opening& opening : layout_.room.openings) draw_opening(opening);  // swings lie over rugs
    if (options_.sheet) {
      draw_dimensions(page_, scale_, layout_, room_);
      draw_title();
      draw_north();
      draw_labels(page_, ink_, scale_, layout_, options_,
                  {kPageWidth - kMargin - kKeyWidth, kMargin + 20, kPageWidth - kMargin, title_top() - 3});
    }
    for (const PlanMark& mark : options_.marks) draw_mark(mark);
  }

 private:
  PaperPoint paper(PlanVector p) const { return scale_.at(p.x, p.y); }

  std::vector<PaperPoint> paper(const std::vector<PlanVector>& points) const {
    std::vector<PaperPoint> out;
    out.reserve(points.size());
    for (const PlanVector& p : points) out.push_back(paper(p));
    return out;
  }

  static double title_top() { return kPageHeight - kMargin - kTitleHeight; }

  // The largest usual scale at which the room with its dimension lines fits beside the key.
  void choose_scale() {
    const double width = kPageWidth - 2 * kMargin - kKeyWidth - 2 * kDimensionReach, height = title_top() - kMargin - 2 * kDimensionReach;
    ratio_ = kScales.back();
    for (const int ratio : kScales) {
      if ((room_.x1 - room_.x0) / ratio <= width && (room_.y1 - room_.y0) / ratio <= height) {
        ratio_ = ratio;
        break;
      }
    }
    put_in_the_middle(ratio_, {kMargin + kDimensionReach + width / 2, kMargin + kDimensionReach + height / 2});
  }

  void put_in_the_middle(double ratio, PaperPoint middle) {
    scale_.factor = 1.0 / ratio;
    scale_.left = middle.x - (room_.x0 + room_.x1) / 2 * scale_.factor;
    scale_.bottom = middle.y + (room_.y0 + room_.y1) / 2 * scale_.factor;
  }

  void draw_walls() {
    // Each wall as a strip along its outer face, prolonged at corners that turn outwards so that they close.
    std::vector<PaperPoint> floor;
    for (const Point& p : layout_.room.polygon) floor.push_back(scale_.at(p.x, p.y));
    std::vector<PaperPoint> outer;
    const auto& walls = room_.walls;
    for (std::size_t i = 0; i < walls.size(); ++i)
      outer.push_back(paper(outer_corner(walls[(i + walls.size() - 1) % walls.size()], walls[i])));
    ink_.set_owner(PlanInk::kWall);
    page_.polygon(outer, {"#4a4a4a", "#222", 0.3, {}});
    ink_.set_owner(PlanInk::kFloor);
    page_.polygon(floor, {"#fdfcf9", "#222", 0.3, {}});
  }

  // Where the outer faces of two walls that follow one another meet.
  static PlanVector outer_corner(const PlanWall& before, const PlanWall& wall) {
    const double cross = before.out.x * wall.out.y - before.out.y * wall.out.x;
    if (std::abs(cross) < 1e-3) return wall.at(0, wall.thickness);
    const double t = before.thickness, u = wall.thickness;
    return wall.start + PlanVector{(t * wall.out.y - u * before.out.y) / cross, (u * before.out.x - t * wall.out.x) / cross};
  }

  void draw_opening(const Opening& opening) {
    const int number = wall_of(opening, layout_);
    if (number < 0) return;
    const PlanWall& wall = room_.walls[static_cast<std::size_t>(number)];
    const double s = opening.offset.value_or(0), e = s + opening.width, t = wall.thickness;
    const auto strip = [&](double from, double to, const DrawStyle& style) {
      page_.polygon(paper({wall.at(s, from), wall.at(e, from), wall.at(e, to), wall.at(s, to)}), style);
    };
    ink_.set_owner(PlanInk::kWall);
    page_.open_group(opening.id, opening.id);
    strip(0, t, {"#fff", "#222", 0.25, {}});
    switch (opening.type) {
      case OpeningType::kWindow:
        if (look_of(opening).bay) {
          const double out = std::min(500.0, opening.width / 4.0);
          page_.polyline(paper({wall.at(s, t), wall.at(s + out, t + out), wall.at(e - out, t + out), wall.at(e, t)}),
                         {"none", "#222", 0.5, {}});
          break;
        }
        strip(0.38 * t, 0.62 * t, {"#dbeaf4", "#222", 0.15, {}});
        break;
      case OpeningType::kOpen: strip(0, t, {"#fff", "#888", 0.15, "1.2 0.8"}); break;
      case OpeningType::kDoor: draw_door(opening, wall, s, e); break;
    }
    page_.close_group();
  }

  void draw_door(const Opening& opening, const PlanWall& wall, double s, double e) {
    if (opening.swing == Swing::kSliding) draw_sliding(opening, wall, s, e);
    for (const std::vector<PlanVector>& sweep : door_sweeps(wall, opening)) {
      std::vector<PaperPoint> arc = paper(sweep);
      const auto is_floor = [&](int owner) {
        return owner == PlanInk::kFloor || (owner >= 0 && layout_.objects[static_cast<std::size_t>(owner)].size.height <= 30);
      };
      ink_.hand_over(arc, PlanInk::kSwing, is_floor);
      const PaperPoint hinge = arc.front();
      arc.erase(arc.begin());
      page_.polyline(arc, {"none", "#777", 0.15, "1 0.7"});
      page_.line(hinge, arc.back(), {"none", "#222", 0.5, {}});
    }
  }

  // Two leaves on two tracks within the wall, one that is drawn up, or one before the wall.
  void draw_sliding(const Opening& opening, const PlanWall& wall, double s, double e) {
    const DrawStyle leaf{"none", "#222", 0.5, {}};
    const auto line = [&](double from, double to, double across) {
      page_.line(paper(wall.at(from, across)), paper(wall.at(to, across)), leaf);
    };
    const double t = wall.thickness, middle = (s + e) / 2, lap = 0.04 * (e - s);
    if (look_of(opening).leaf == Leaf::kSectional) {
      for (const double across : {0.4 * t, 0.6 * t}) line(s, e, across);
    } else if (has_two_leaves(opening)) {
      line(s, middle + lap, 0.65 * t);
      line(middle - lap, e, 0.35 * t);
    } else {
      line(s, e - lap, -30);
    }
  }

  void draw_furniture() {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < layout_.objects.size(); ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return plan_height(layout_.objects[a]) < plan_height(layout_.objects[b]); });
    for (const std::size_t number : order) {
      const PlacedObject& object = layout_.objects[number];
      ink_.set_owner(static_cast<int>(number));
      page_.open_group(object.id, object.name.empty() ? object.category : object.name);
      draw_symbol(page_, scale_, object);
      page_.close_group();
    }
  }

  void draw_title() {
    const double top = title_top();
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
      const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      doubled += double(a.x) * double(b.y) - double(a.y) * double(b.x);
    }
    return doubled / 2e6;
  }

  // The words the room was made from, in at most three lines; a mark parts what stands in lines of its own, as edits do.
  void draw_prompt(double y) {
    std::string rest;
    for (const char c : layout_.prompt) {
      if (c != '\n')
        rest += c;
      else if (!rest.empty())
        rest += " · ";
    }
    for (int line = 0; line < 3 && !rest.empty(); ++line, y += 3.2) {
      std::size_t end = rest.size();
      while (text_width(rest.substr(0, end), 2.2) > kPageWidth - 2 * kMargin) {
        const std::size_t space = rest.rfind(' ', end - 1);
        end = space == std::string::npos || space == 0 ? end / 2 : space;
      }
      const bool cut = line == 2 && end < rest.size();
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
  void draw_mark(const PlanMark& mark) {
    if (mark.corners.empty()) return;
    std::vector<PaperPoint> points;
    for (const auto& corner : mark.corners) points.push_back(paper(PlanVector{corner[0], corner[1]}));
    double left = points[0].x, right = left, top = points[0].y;
    for (const PaperPoint& point : points) left = std::min(left, point.x), right = std::max(right, point.x), top = std::min(top, point.y);
    page_.open_group("mark", mark.label);
    page_.polygon(points, {"none", "#d00000", 0.8, {}});
    page_.text({(left + right) / 2, top - 0.8}, 3.4, mark.label, TextAnchor::kMiddle, 0, "#d00000");
    page_.close_group();
  }

  void draw_north() {
    const PaperPoint c{kPageWidth - kMargin - 6, kMargin + 7};
    page_.circle(c, 4.5, {"none", "#444", 0.2, {}});
    page_.polygon({{c.x, c.y - 4.5}, {c.x + 1.8, c.y + 3.2}, {c.x, c.y + 1.8}, {c.x - 1.8, c.y + 3.2}}, {"#444", "none", 0, {}});
    page_.text({c.x, c.y - 5.2}, 2.8, "N", TextAnchor::kMiddle);
  }

  const Layout& layout_;
  const FloorPlanOptions& options_;
  PaperPoint paper_;
  PlanInk ink_;
  BothCanvases page_;
  PlanRoom room_;
  PlanScale scale_;
  int ratio_ = 50;
};

}  // namespace

std::string write_floor_plan_svg(const Layout& layout, const FloorPlanOptions& options) {
  const PaperPoint paper = paper_for(layout, options);
  SvgWriter svg(paper.x, paper.y, options.sheet ? 2 : 1);
  FloorPlan(layout, options, svg).draw();
  return std::move(svg).finish();
}

namespace {

Result<std::string> write_by_cairo(PageFormat format, const Layout& layout, FloorPlanOptions options) {
  options.sheet = true;
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
