#include "layoutbox/export/plan_ink.h"

#include <algorithm>
#include <cmath>

#include "layoutbox/base/units.h"

namespace layoutbox {

PlanInk::PlanInk(double width, double height)
    : width_(static_cast<int>(width / kCell)),
      height_(static_cast<int>(height / kCell)),
      cells_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

void PlanInk::line_cells(PaperPoint a, PaperPoint b, const std::function<void(std::size_t)>& visit) const {
  const int steps = std::clamp(static_cast<int>(std::ceil(std::hypot(b.x - a.x, b.y - a.y) / kCell * 1.5)), 1, 10'000);
  std::size_t last = cells_.size();
  for (int i = 0; i <= steps; ++i) {
    const double share = double(i) / steps;
    const int x = cell(a.x + share * (b.x - a.x)), y = cell(a.y + share * (b.y - a.y));
    if (x < 0 || y < 0 || x >= width_ || y >= height_) continue;
    const std::size_t here = index(x, y);
    if (here != last) visit(here);
    last = here;
  }
}

void PlanInk::fill_cells(const std::vector<PaperPoint>& points, const std::function<void(std::span<Cell>)>& change) {
  if (points.size() < 3) return;
  const auto [low, high] = std::minmax_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.y < b.y; });
  std::vector<double> crossings;
  for (int row = std::max(0, cell(low->y)); row <= std::min(height_ - 1, cell(high->y)); ++row) {
    const double y = (row + 0.5) * kCell;
    crossings.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const PaperPoint &a = points[i], &b = points[(i + 1) % points.size()];
      if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const int first = std::max(0, static_cast<int>(std::ceil(crossings[k] / kCell - 0.5)));
      const int last = std::min(width_ - 1, static_cast<int>(std::floor(crossings[k + 1] / kCell - 0.5)));
      if (first <= last) change(std::span(cells_).subspan(index(first, row), static_cast<std::size_t>(last - first) + 1));
    }
  }
}

void PlanInk::polygon(const std::vector<PaperPoint>& points, const DrawStyle& style) {
  if (style.fill != "none") {
    fill_cells(points, [&](std::span<Cell> row) { std::ranges::fill(row, Cell{static_cast<std::int16_t>(owner_), false}); });
  }
  if (style.stroke == "none" || points.empty()) return;
  polyline(points, style);
  polyline({points.back(), points.front()}, style);
}

void PlanInk::polyline(const std::vector<PaperPoint>& points, const DrawStyle& style) {
  if (style.stroke == "none") return;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    line_cells(points[i], points[i + 1], [&](std::size_t here) { cells_[here].ink = true; });
  }
}

void PlanInk::circle(PaperPoint center, double radius, const DrawStyle& style) {
  std::vector<PaperPoint> points;
  for (int i = 0; i < 24; ++i) points.push_back({center.x + radius * std::cos(i * kPi / 12), center.y + radius * std::sin(i * kPi / 12)});
  polygon(points, style);
}

void PlanInk::text(PaperPoint at, double size, std::string_view words, TextAnchor anchor, double degrees, std::string_view) {
  const double width = text_width(words, size), turn = radians_from_degrees(degrees), c = std::cos(turn), s = std::sin(turn);
  const double from = anchor == TextAnchor::kStart ? 0 : anchor == TextAnchor::kMiddle ? -width / 2 : -width;
  const auto point = [&](double x, double y) { return PaperPoint{at.x + c * x - s * y, at.y + s * x + c * y}; };
  const std::vector<PaperPoint> box{point(from, -0.8 * size), point(from + width, -0.8 * size), point(from + width, 0.25 * size),
                                    point(from, 0.25 * size)};
  fill_cells(box, [](std::span<Cell> row) {
    for (Cell& one : row) one.ink = true;
  });
}

void PlanInk::hand_over(const std::vector<PaperPoint>& points, int owner, const std::function<bool(int)>& whose) {
  fill_cells(points, [&](std::span<Cell> row) {
    for (Cell& c : row) {
      if (whose(c.owner)) c.owner = static_cast<std::int16_t>(owner);
    }
  });
}

}  // namespace layoutbox
