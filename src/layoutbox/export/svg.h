// A small writer of SVG elements; lengths are millimetres on paper, y down the page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/export/canvas.h"

namespace layoutbox {

class SvgWriter final : public Canvas {
 public:
  // `digits`: of places after the point.
  SvgWriter(double width, double height, int digits = 2);

  void polygon(const std::vector<PaperPoint>& points, const DrawStyle& style) override;
  void polyline(const std::vector<PaperPoint>& points, const DrawStyle& style) override;
  void circle(PaperPoint center, double radius, const DrawStyle& style) override;
  void text(PaperPoint at, double size, std::string_view words, TextAnchor anchor, double degrees, std::string_view color) override;
  // <g data-id="…"> with a <title>.
  void open_group(std::string_view id, std::string_view title) override;
  void close_group() override;

  std::string finish() &&;

 private:
  int digits_;
  std::string body_;
};

// Text safe within elements and attributes: markup escaped, bytes that XML does not allow replaced.
std::string escape_xml(std::string_view text);

}  // namespace layoutbox
