#include "layoutbox/base/png_check.h"

#include <fmt/format.h>
#include <zlib.h>

#include <array>
#include <cstdint>
#include <string>

namespace layoutbox {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);

Failure broken(std::string_view why) { return fail(ErrorCode::kParse, fmt::format("the picture is not a whole PNG: {}", why)); }

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8u | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

const Bytef* as_bytes(std::string_view text) { return reinterpret_cast<const Bytef*>(text.data()); }

// The number of bytes that `packed` unpacks to, or -1 where it is damaged or cut off.
std::int64_t unpacked_size(std::string packed) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) return -1;
  stream.next_in = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_in = static_cast<uInt>(packed.size());
  std::array<Bytef, 1 << 16> buffer;
  std::int64_t size = 0;
  int status = Z_OK;
  while (status == Z_OK) {
    stream.next_out = buffer.data();
    stream.avail_out = static_cast<uInt>(buffer.size());
    status = inflate(&stream, Z_NO_FLUSH);
    size += static_cast<std::int64_t>(buffer.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  return status == Z_STREAM_END ? size : -1;
}

// Of all pixels: a line is a byte and its pixels.
std::int64_t bytes_of_lines(std::int64_t width, std::int64_t height, std::int64_t bits_per_pixel) {
  return width > 0 ? (1 + (width * bits_per_pixel + 7) / 8) * height : 0;
}

// The same of an interlaced picture, which comes in seven parts.
std::int64_t bytes_of_parts(std::int64_t width, std::int64_t height, std::int64_t bits_per_pixel) {
  struct Part {
    std::int64_t x, y, dx, dy;
  };
  constexpr Part kParts[] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  std::int64_t bytes = 0;
  for (const Part& part : kParts) {
    const std::int64_t w = (width - part.x + part.dx - 1) / part.dx, h = (height - part.y + part.dy - 1) / part.dy;
    if (w > 0 && h > 0) bytes += bytes_of_lines(w, h, bits_per_pixel);
  }
  return bytes;
}

}  // namespace

Result<PngSize> check_png(std::string_view bytes) {
  if (bytes.substr(0, kSignature.size()) != kSignature) return broken("it does not begin like one");
  PngSize size;
  std::int64_t bits_per_pixel = 0;
  bool interlaced = false;
  std::string packed;
  for (std::size_t at = kSignature.size();;) {
    if (at + 12 > bytes.size()) return broken("it is cut off");
    const std::size_t length = big_endian(bytes, at);
    if (length > bytes.size() - at - 12) return broken("it is cut off");
    const std::string_view kind_and_data = bytes.substr(at + 4, length + 4), kind = kind_and_data.substr(0, 4);
    if (crc32(0, as_bytes(kind_and_data), static_cast<uInt>(kind_and_data.size())) != big_endian(bytes, at + 8 + length)) {
      return broken("a checksum is wrong");
    }
    if (kind == "IHDR" && length == 13) {
      size = {static_cast<int>(big_endian(bytes, at + 8)), static_cast<int>(big_endian(bytes, at + 12))};
      constexpr std::array<int, 7> kChannels{1, 0, 3, 1, 2, 0, 4};  // by colour type
      const auto type = static_cast<std::size_t>(bytes[at + 17]);
      interlaced = bytes[at + 20] != 0;
      bits_per_pixel = type < kChannels.size() ? kChannels[type] * std::int64_t{bytes[at + 16]} : 0;
    } else if (kind == "IDAT") {
      packed += kind_and_data.substr(4);
    } else if (kind == "IEND") {
      break;
    }
    at += length + 12;
  }
  if (size.width <= 0 || size.height <= 0 || bits_per_pixel <= 0) return broken("it has no size");
  const auto whole = interlaced ? bytes_of_parts : bytes_of_lines;
  if (unpacked_size(std::move(packed)) != whole(size.width, size.height, bits_per_pixel)) return broken("pixels are missing");
  return size;
}

}  // namespace layoutbox
