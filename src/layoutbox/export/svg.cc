#include "layoutbox/export/svg.h"

#include <fmt/format.h>

#include <algorithm>

namespace layoutbox {
namespace {

// Two digits are a hundredth of a millimetre on paper.
std::string number(double value, int digits = 2) {
  std::string text = fmt::format("{:.{}f}", value, digits);
  while (text.back() == '0' && text.find('.') != std::string::npos) text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string attributes(const DrawStyle& style) {
  std::string text = fmt::format(R"( fill="{}" stroke="{}")", style.fill, style.stroke);
  if (style.stroke != "none") text += fmt::format(R"( stroke-width="{}")", number(style.width));
  if (!style.dash.empty()) text += fmt::format(R"( stroke-dasharray="{}")", style.dash);
  return text;
}

std::string list(const std::vector<PaperPoint>& points, int digits) {
  std::string text;
  for (const PaperPoint& p : points) text += (text.empty() ? "" : " ") + number(p.x, digits) + "," + number(p.y, digits);
  return text;
}

}  // namespace

std::string escape_xml(std::string_view text) {
  std::string out;
  for (const char c : printable(text)) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  }
  return out;
}

SvgWriter::SvgWriter(double width, double height, int digits) : digits_(digits) {
  body_ = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
      number(width), number(height));
}

void SvgWriter::polygon(const std::vector<PaperPoint>& points, const DrawStyle& style) {
  body_ += fmt::format("<polygon points=\"{}\"{}/>\n", list(points, digits_), attributes(style));
}

void SvgWriter::polyline(const std::vector<PaperPoint>& points, const DrawStyle& style) {
  body_ += fmt::format("<polyline points=\"{}\"{}/>\n", list(points, digits_), attributes(style));
}

void SvgWriter::circle(PaperPoint center, double radius, const DrawStyle& style) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", number(center.x, digits_), number(center.y, digits_),
                       number(radius, digits_), attributes(style));
}

void SvgWriter::text(PaperPoint at, double size, std::string_view words, TextAnchor anchor, double degrees, std::string_view color) {
  const std::string_view name = anchor == TextAnchor::kStart ? "start" : anchor == TextAnchor::kMiddle ? "middle" : "end";
  const std::string turn = degrees == 0 ? "" : fmt::format(" transform=\"rotate({} {} {})\"", number(degrees), number(at.x), number(at.y));
  body_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" textLength=\"{}\" lengthAdjust=\"spacingAndGlyphs\" fill=\"{}\"{} "
      "paint-order=\"stroke\" stroke=\"#fff\" stroke-opacity=\"0.7\" stroke-width=\"0.6\">{}</text>\n",
      number(at.x), number(at.y), number(size), name, number(text_width(words, size)), color, turn, escape_xml(words));
}

void SvgWriter::open_group(std::string_view id, std::string_view title) {
  body_ += fmt::format("<g data-id=\"{}\">", escape_xml(id));
  if (!title.empty()) body_ += fmt::format("<title>{}</title>", escape_xml(title));
  body_ += "\n";
}

void SvgWriter::close_group() { body_ += "</g>\n"; }

std::string SvgWriter::finish() && { return std::move(body_) + "</svg>\n"; }

}  // namespace layoutbox
