#include "layoutbox/base/plain_text.h"

#include <algorithm>

namespace layoutbox {
namespace {

// Bytes of the UTF-8 character that begins so.
std::size_t length_of_sign(char first) {
  const auto byte = static_cast<unsigned char>(first);
  if (byte < 0xC0) return 1;
  if (byte < 0xE0) return 2;
  return byte < 0xF0 ? 3 : 4;
}

bool is_unseen(std::string_view sign) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(sign[i])); };
  switch (sign.size()) {
    case 1: return byte(0) < 0x20 || byte(0) == 0x7F;
    case 2: return (byte(0) == 0xC2 && byte(1) < 0xA0) || (byte(0) == 0xD8 && byte(1) == 0x9C);  // U+0080–9F, U+061C
    case 3: {
      const unsigned code = (byte(0) & 0x0Fu) << 12 | (byte(1) & 0x3Fu) << 6 | (byte(2) & 0x3Fu);
      return (code >= 0x200B && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) || (code >= 0x2060 && code <= 0x206F) ||
             code == 0xFEFF;
    }
    default: return byte(0) == 0xF3 && byte(1) == 0xA0;  // tags, U+E0000 and on
  }
}

}  // namespace

std::string plain_text(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view sign = text.substr(i, length_of_sign(text[i]));
    i += sign.size();
    plain += is_unseen(sign) ? std::string_view(" ") : sign;
  }
  return plain;
}

}  // namespace layoutbox
