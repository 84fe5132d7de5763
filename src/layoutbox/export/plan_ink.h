// What lies where on a floor plan's page, as far as labels must know it: whose each spot is, and where lines run. A canvas of small cells
// that is drawn on together with the real one.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "layoutbox/export/canvas.h"

namespace layoutbox {

struct PaperBox {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  double width() const { return x1 - x0; }
  double height() const { return y1 - y0; }
  PaperPoint center() const { return {(x0 + x1) / 2, (y0 + y1) / 2}; }
};

class PlanInk final : public Canvas {
 public:
  // Owners below the objects, which count from 0.
  static constexpr int kPaper = -4, kWall = -3, kSwing = -2, kFloor = -1;

  PlanInk(double width, double height);

  // Whose is what is drawn from now on.
  void set_owner(int owner) { owner_ = owner; }

  // A filled shape is its owner's and hides the lines below; lines and texts are ink.
  void polygon(const std::vector<PaperPoint>& points, const DrawStyle& style) override;
  void polyline(const std::vector<PaperPoint>& points, const DrawStyle& style) override;
  void circle(PaperPoint center, double radius, const DrawStyle& style) override;
  void text(PaperPoint at, double size, std::string_view words, TextAnchor anchor, double degrees, std::string_view color) override;
  void open_group(std::string_view, std::string_view) override {}
  void close_group() override {}

  // Gives the cells of a shape to `owner` where `whose` says so of the one that has them.
  void hand_over(const std::vector<PaperPoint>& points, int owner, const std::function<bool(int)>& whose);

  // Is the box on the page, without ink, and each spot of it of an owner that is allowed?
  template <class Allowed>
  bool is_clear(const PaperBox& box, const Allowed& allowed) const {
    const int x0 = cell(box.x0), x1 = cell(box.x1), y0 = cell(box.y0), y1 = cell(box.y1);
    if (x0 < 0 || y0 < 0 || x1 >= width_ || y1 >= height_) return false;
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const Cell& c = cells_[index(x, y)];
        if (c.ink || !allowed(c.owner)) return false;
      }
    }
    return true;
  }

  // Walks along a line: visit(owner, ink) of each cell.
  template <class Visit>
  void along(PaperPoint a, PaperPoint b, const Visit& visit) const {
    line_cells(a, b, [&](std::size_t i) { visit(int{cells_[i].owner}, cells_[i].ink); });
  }

 private:
  struct Cell {
    std::int16_t owner = kPaper;
    bool ink = false;
  };
  static constexpr double kCell = 0.3;  // mm
  static int cell(double mm) { return static_cast<int>(mm / kCell + 1000) - 1000; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  void line_cells(PaperPoint a, PaperPoint b, const std::function<void(std::size_t)>& visit) const;
  void fill_cells(const std::vector<PaperPoint>& points, const std::function<void(std::span<Cell>)>& change);  // row by row

  int width_, height_, owner_ = kPaper;
  std::vector<Cell> cells_;
};

// Draws on two canvases at once.
class BothCanvases final : public Canvas {
 public:
  using Canvas::text;
  BothCanvases(Canvas& first, Canvas& second) : first_(first), second_(second) {}
  void polygon(const std::vector<PaperPoint>& points, const DrawStyle& style) override {
    first_.polygon(points, style);
    second_.polygon(points, style);
  }
  void polyline(const std::vector<PaperPoint>& points, const DrawStyle& style) override {
    first_.polyline(points, style);
    second_.polyline(points, style);
  }
  void circle(PaperPoint center, double radius, const DrawStyle& style) override {
    first_.circle(center, radius, style);
    second_.circle(center, radius, style);
  }
  void text(PaperPoint at, double size, std::string_view words, TextAnchor anchor, double degrees, std::string_view color) override {
    first_.text(at, size, words, anchor, degrees, color);
    second_.text(at, size, words, anchor, degrees, color);
  }
  void open_group(std::string_view id, std::string_view title) override {
    first_.open_group(id, title);
    second_.open_group(id, title);
  }
  void close_group() override {
    first_.close_group();
    second_.close_group();
  }

 private:
  Canvas &first_, &second_;
};

}  // namespace layoutbox
