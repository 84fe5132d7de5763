// The page: walls, openings, furniture, dimension lines, title. Symbols and labels have files of their own.
#include <algorithm>
#include <array>
#include <cmath>

#include "layoutbox/catalog/opening_look.h"
#include "layoutbox/export/cairo_canvas.h"
#include "layoutbox/export/export.h"
#include "layoutbox/export/plan_dimensions.h"
#include "layoutbox/export/plan_ink.h"
#include "layoutbox/export/plan_labels.h"
#include "layoutbox/export/plan_room.h"
#include "layoutbox/export/plan_sheet.h"
#include "layoutbox/export/plan_symbols.h"
#include "layoutbox/export/svg.h"

namespace layoutbox {
namespace {

constexpr double kSmallRatio = 50, kSmallMargin = 4;  // of a room alone
constexpr std::array kScales{5, 10, 20, 25, 30, 40, 50, 60, 75, 100, 125, 150, 200, 250, 500, 1000, 2000, 5000};

// The paper that a plan takes: width and height.
PaperPoint paper_for(const Layout& layout, const FloorPlanOptions& options) {
  if (options.sheet) return {kSheetWidth, kSheetHeight};
  const PlanRoom room(layout);
  return {(room.x1 - room.x0) / kSmallRatio + 2 * kSmallMargin, (room.y1 - room.y0) / kSmallRatio + 2 * kSmallMargin};
}

class FloorPlan {
 public:
  FloorPlan(const Layout& layout, const Catalog& catalog, const FloorPlanOptions& options, Canvas& canvas)
      : layout_(layout),
        catalog_(catalog),
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
      draw_sheet(page_, layout_, ratio_, options_.scale_bar);
      draw_labels(page_, ink_, scale_, layout_, options_,
                  {kSheetWidth - kSheetMargin - kSheetKeyWidth, kSheetMargin + 20, kSheetWidth - kSheetMargin, kSheetTitleTop - 3});
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

  // The largest usual scale at which the room with its dimension lines fits beside the key.
  void choose_scale() {
    const double width = kSheetWidth - 2 * kSheetMargin - kSheetKeyWidth - 2 * kDimensionReach,
                 height = kSheetTitleTop - kSheetMargin - 2 * kDimensionReach;
    ratio_ = kScales.back();
    for (const int ratio : kScales) {
      if ((room_.x1 - room_.x0) / ratio <= width && (room_.y1 - room_.y0) / ratio <= height) {
        ratio_ = ratio;
        break;
      }
    }
    put_in_the_middle(ratio_, {kSheetMargin + kDimensionReach + width / 2, kSheetMargin + kDimensionReach + height / 2});
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
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return plan_height(layout_.objects[a], catalog_) < plan_height(layout_.objects[b], catalog_);
    });
    for (const std::size_t number : order) {
      const PlacedObject& object = layout_.objects[number];
      ink_.set_owner(static_cast<int>(number));
      page_.open_group(object.id, object.name.empty() ? object.category : object.name);
      draw_symbol(page_, scale_, object, catalog_);
      page_.close_group();
    }
  }

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

  const Layout& layout_;
  const Catalog& catalog_;
  const FloorPlanOptions& options_;
  PaperPoint paper_;
  PlanInk ink_;
  BothCanvases page_;
  PlanRoom room_;
  PlanScale scale_;
  int ratio_ = 50;
};

}  // namespace

std::string write_floor_plan_svg(const Layout& layout, const Catalog& catalog, const FloorPlanOptions& options) {
  const PaperPoint paper = paper_for(layout, options);
  SvgWriter svg(paper.x, paper.y, options.sheet ? 2 : 1);
  FloorPlan(layout, catalog, options, svg).draw();
  return std::move(svg).finish();
}

namespace {

Result<std::string> write_by_cairo(PageFormat format, const Layout& layout, const Catalog& catalog, FloorPlanOptions options) {
  options.sheet = true;
  LAYOUTBOX_ASSIGN(const auto page, CairoCanvas::make(format, kSheetWidth, kSheetHeight, options.dots_per_inch, plan_title(layout)));
  FloorPlan(layout, catalog, options, *page).draw();
  return page->finish();
}

}  // namespace

Result<std::string> write_floor_plan_pdf(const Layout& layout, const Catalog& catalog, const FloorPlanOptions& options) {
  return write_by_cairo(PageFormat::kPdf, layout, catalog, options);
}

Result<std::string> write_floor_plan_png(const Layout& layout, const Catalog& catalog, const FloorPlanOptions& options) {
  return write_by_cairo(PageFormat::kPng, layout, catalog, options);
}

}  // namespace layoutbox
