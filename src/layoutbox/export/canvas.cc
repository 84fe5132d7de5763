#include "layoutbox/export/canvas.h"

#include <algorithm>

namespace layoutbox {
namespace {

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
  double width = 0;
  for (const char c : words) {
    if ((static_cast<unsigned char>(c) & 0xc0u) == 0x80u) continue;  // within a character
    width += std::string_view("iljtfr.,:;'|! ").find(c) != std::string_view::npos ? 0.32
             : std::string_view("mwMW%@").find(c) != std::string_view::npos       ? 0.85
                                                                                  : 0.56;
  }
  return width * size;
}

}  // namespace layoutbox
