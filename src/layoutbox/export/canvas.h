// What a floor plan is drawn on: a page in millimetres, y down. SVG, PDF and PNG are three of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace layoutbox {

struct PaperPoint {
  double x = 0, y = 0;
};

// Fill, line and line width of a shape; "none" for none. Colours are "#rgb" or "#rrggbb".
struct DrawStyle {
  std::string_view fill = "none", stroke = "#333";
  double width = 0.18;
  std::string_view dash;  // "1 0.8", or empty
};

enum class TextAnchor { kStart, kMiddle, kEnd };

class Canvas {
 public:
  Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  virtual ~Canvas() = default;

  virtual void polygon(const std::vector<PaperPoint>& points, const DrawStyle& style) = 0;
  virtual void polyline(const std::vector<PaperPoint>& points, const DrawStyle& style) = 0;
  virtual void circle(PaperPoint center, double radius, const DrawStyle& style) = 0;
  // A text on one line, turned by `degrees` (clockwise on the page) about its place, with a light edge that keeps it readable on lines.
  // Whatever font there is, it is as wide as text_width says.
  virtual void text(PaperPoint at, double size, std::string_view words, TextAnchor anchor, double degrees, std::string_view color) = 0;
  // What is drawn in between belongs to that object; only some canvases keep it.
  virtual void open_group(std::string_view id, std::string_view title) = 0;
  virtual void close_group() = 0;

  void line(PaperPoint a, PaperPoint b, const DrawStyle& style) { polyline({a, b}, style); }
  void text(PaperPoint at, double size, std::string_view words, TextAnchor anchor = TextAnchor::kMiddle) {
    text(at, size, words, anchor, 0, "#222");
  }
};

// The text with what is no printable UTF-8 as blanks.
std::string printable(std::string_view text);

// How wide a text of that size is drawn, in millimetres.
double text_width(std::string_view words, double size);

}  // namespace layoutbox
