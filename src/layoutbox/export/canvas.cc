#include "layoutbox/export/canvas.h"

#include <algorithm>
#include <array>

namespace layoutbox {
namespace {

// How far each character from the blank to ~ advances, in thousandths of the size: Adobe's metrics of Helvetica, which Arial and
// Liberation Sans share. Other letters of two bytes are about as wide as these, those of three (Chinese, …) are square.
constexpr std::array kHelvetica{278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
                                556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
                                611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
                                667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
                                222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
constexpr int kLatin = 560, kWide = 1000;

// The length of the UTF-8 sequence at the start of `text`, or 0 where it is not one that XML and Cairo allow.
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

std::string printable(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    if (length > 0) {
      out += text.substr(0, length);
    } else {
      out += ' ';
    }
    text.remove_prefix(std::max<std::size_t>(1, length));
  }
  return out;
}

double text_width(std::string_view words, double size) {
  int thousandths = 0;
  for (const char c : words) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xc0u) == 0x80u) continue;  // within a character
    thousandths += byte >= 0xe0 ? kWide : byte < 0x20 || byte >= 0x7f ? kLatin : kHelvetica.at(byte - 0x20U);
  }
  return thousandths * size / 1000;
}

}  // namespace layoutbox
