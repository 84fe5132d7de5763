// PNGs of the baked patterns: their pixels are the same for all surfaces, the palette has the colours.
#include "layoutbox/export/pattern.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "layoutbox/embedded/patterns.h"
#include "layoutbox/export/pattern_draw.h"

namespace layoutbox {
namespace {

// The compressed pixels of a pattern, or null where there is none of that name.
const std::string_view* baked(const std::string& texture) {
  for (const auto& [name, pixels] : embedded::patterns_files()) {
    if (name == texture) return &pixels;
  }
  return nullptr;
}

void append_u32(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xffu);
}

void append_chunk(std::string& png, std::string_view kind, std::string_view data) {
  append_u32(png, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = png.size();
  png += kind;
  png += data;
  append_u32(
      png, static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(png.data() + start), static_cast<uInt>(png.size() - start))));
}

std::string palette(const Surface& surface) {
  const std::array<double, 3> base{surface.base.r, surface.base.g, surface.base.b};
  const std::array<double, 3> second{surface.second.r, surface.second.g, surface.second.b};
  std::string colors;
  for (int mix = 0; mix < kPatternMixes; ++mix) {
    for (int dark = 0; dark < kPatternShades; ++dark) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double color = std::lerp(base[i], second[i], mix / (kPatternMixes - 1.0)) * (1 - 0.22 * dark / (kPatternShades - 1.0));
        colors += static_cast<char>(std::clamp(std::lround(color * 255), 0l, 255l));
      }
    }
  }
  return colors;
}

}  // namespace

bool has_pattern(const std::string& texture) { return baked(texture) != nullptr; }

std::string pattern_png(const Surface& surface) {
  const auto pixels = static_cast<std::uint32_t>(pattern_pixels(surface.texture));
  std::string png("\x89PNG\r\n\x1a\n", 8), header;
  append_u32(header, pixels);
  append_u32(header, pixels);
  header += std::string("\x08\x03\0\0\0", 5);  // 8 bits, palette
  append_chunk(png, "IHDR", header);
  append_chunk(png, "PLTE", palette(surface));
  append_chunk(png, "IDAT", *baked(surface.texture));
  append_chunk(png, "IEND", {});
  return png;
}

}  // namespace layoutbox
