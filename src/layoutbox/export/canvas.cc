#include "layoutbox/export/canvas.h"

#include <algorithm>
#include <array>

#include "layoutbox/base/utf8.h"

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

// Neither XML nor Cairo allows these.
bool is_forbidden(char32_t sign) { return sign < 0x20 || sign == 0x7f || sign == 0xfffe || sign == 0xffff; }

}  // namespace

std::string printable(std::string_view text) { return with_blanks(text, is_forbidden); }

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
