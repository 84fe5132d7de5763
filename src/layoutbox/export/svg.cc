#include "layoutbox/export/svg.h"

#include <fmt/format.h>

#include <algorithm>

namespace layoutbox {
namespace {

// Two digits are a hundredth of a millimetre on paper.
std::string number(double value) {
  std::string text = fmt::format("{:.2f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string attributes(const SvgStyle& style) {
  std::string text = fmt::format(R"( fill="{}" stroke="{}")", style.fill, style.stroke);
  if (style.stroke != "none") text += fmt::format(R"( stroke-width="{}")", number(style.width));
  if (!style.dash.empty()) text += fmt::format(R"( stroke-dasharray="{}")", style.dash);
  return text;
}

std::string list(const std::vector<PaperPoint>& points) {
  std::string text;
  for (const PaperPoint& p : points) text += (text.empty() ? "" : " ") + number(p.x) + "," + number(p.y);
  return text;
}

// The length of the UTF-8 sequence at the start of `text`, or 0 where it is not one that XML allows.
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t length = first >= 0xc2 && first < 0xe0 ? 2 : first >= 0xe0 && first < 0xf0 ? 3 : first >= 0xf0 && first < 0xf5 ? 4 : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0u) != 0x80u) return 0;
  }
  if ((first == 0xe0 && byte(1) < 0xa0) || (first == 0xed && byte(1) >= 0xa0)) return 0;  // overlong, surrogates
  if ((first == 0xf0 && byte(1) < 0x90) || (first == 0xf4 && byte(1) >= 0x90)) return 0;  // overlong, beyond Unicode
  if (first == 0xef && byte(1) == 0xbf && byte(2) >= 0xbe) return 0;                      // not characters
  return length;
}

}  // namespace

std::string escape_xml(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    switch (text[0]) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default:
        if (length > 0) {
          out += text.substr(0, length);
        } else {
          out += ' ';
        }
    }
    text.remove_prefix(std::max<std::size_t>(1, length));
  }
  return out;
}

double text_width(std::string_view words, double size) {
  double width = 0;
  for (const char c : words) {
    if ((static_cast<unsigned char>(c) & 0xc0u) == 0x80u) continue;  // within a character
    width += std::string_view("iljtfr.,:;'|! ").find(c) != std::string_view::npos ? 0.32
             : std::string_view("mwMW%@").find(c) != std::string_view::npos       ? 0.85
                                                                                  : 0.56;
  }
  return width * size;
}

SvgWriter::SvgWriter(double width, double height) {
  body_ = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
      number(width), number(height));
}

void SvgWriter::polygon(const std::vector<PaperPoint>& points, const SvgStyle& style) {
  body_ += fmt::format("<polygon points=\"{}\"{}/>\n", list(points), attributes(style));
}

void SvgWriter::polyline(const std::vector<PaperPoint>& points, const SvgStyle& style) {
  body_ += fmt::format("<polyline points=\"{}\"{}/>\n", list(points), attributes(style));
}

void SvgWriter::circle(PaperPoint center, double radius, const SvgStyle& style) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", number(center.x), number(center.y), number(radius), attributes(style));
}

void SvgWriter::text(PaperPoint at, double size, std::string_view words, TextAnchor anchor, double degrees, std::string_view color) {
  const std::string_view name = anchor == TextAnchor::kStart ? "start" : anchor == TextAnchor::kMiddle ? "middle" : "end";
  const std::string turn = degrees == 0 ? "" : fmt::format(" transform=\"rotate({} {} {})\"", number(degrees), number(at.x), number(at.y));
  body_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"{} "
      "paint-order=\"stroke\" stroke=\"#fff\" stroke-opacity=\"0.7\" stroke-width=\"0.6\">{}</text>\n",
      number(at.x), number(at.y), number(size), name, color, turn, escape_xml(words));
}

void SvgWriter::open_group(std::string_view id, std::string_view title) {
  body_ += fmt::format("<g data-id=\"{}\">", escape_xml(id));
  if (!title.empty()) body_ += fmt::format("<title>{}</title>", escape_xml(title));
  body_ += "\n";
}

void SvgWriter::close_group() { body_ += "</g>\n"; }

std::string SvgWriter::finish() && { return std::move(body_) + "</svg>\n"; }

}  // namespace layoutbox
