// A small writer of SVG elements; lengths are millimetres on paper, y down the page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace layoutbox {

struct PaperPoint {
  double x = 0, y = 0;
};

// Fill, line and line width of a shape; "none" for none.
struct SvgStyle {
  std::string_view fill = "none", stroke = "#333";
  double width = 0.18;
  std::string_view dash;  // "1 0.8", or empty
};

enum class TextAnchor { kStart, kMiddle, kEnd };

class SvgWriter {
 public:
  SvgWriter(double width, double height);

  void polygon(const std::vector<PaperPoint>& points, const SvgStyle& style);
  void polyline(const std::vector<PaperPoint>& points, const SvgStyle& style);
  void line(PaperPoint a, PaperPoint b, const SvgStyle& style) { polyline({a, b}, style); }
  void circle(PaperPoint center, double radius, const SvgStyle& style);
  // A text on one line, turned by `degrees` (clockwise on the page) about its place.
  void text(PaperPoint at, double size, std::string_view words, TextAnchor anchor = TextAnchor::kMiddle, double degrees = 0,
            std::string_view color = "#222");
  // Raw markup between shapes: groups, titles.
  void open_group(std::string_view id, std::string_view title = {});
  void close_group();

  std::string finish() &&;

 private:
  std::string body_;
};

// Text safe within elements and attributes: markup escaped, bytes that XML does not allow replaced.
std::string escape_xml(std::string_view text);

// About how wide a text of that size is, in millimetres.
double text_width(std::string_view words, double size);

}  // namespace layoutbox
