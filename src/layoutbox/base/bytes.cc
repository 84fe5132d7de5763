#include "layoutbox/base/bytes.h"

#include <fmt/format.h>

#include <cstdint>

namespace layoutbox {

std::string base64(std::string_view bytes, std::size_t line) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t per_line = line / 4;
  std::string text;
  text.reserve(bytes.size() * 4 / 3 + bytes.size() / 90 + 8);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8u | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63u] : '=';
    }
    if (per_line != 0 && (i / 3 + 1) % per_line == 0) text += '\n';
  }
  if (per_line != 0 && !text.empty() && text.back() != '\n') text += '\n';
  return text;
}

std::string content_key(std::string_view text) {
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return fmt::format("{:016x}", hash);
}

}  // namespace layoutbox
