// Pixels are an index: the upper five bits say how much of `second`, the lower three how dark. The picture is the same for all surfaces
// of one procedure, so it is computed and compressed once; the colours are the PNG's palette.
#include "layoutbox/export/pattern.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <mutex>
#include <vector>

namespace layoutbox {
namespace {

constexpr int kMixes = 32, kShades = 8;

std::uint32_t hash(int x, int y, std::uint32_t seed) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 374761393u + static_cast<std::uint32_t>(y) * 668265263u + seed * 2246822519u;
  h = (h ^ h >> 13u) * 1274126177u;
  return h ^ h >> 16u;
}

double random(int x, int y, std::uint32_t seed) { return hash(x, y, seed) / 4294967296.0; }

int wrapped(int value, int period) { return ((value % period) + period) % period; }

// Smooth noise in [0, 1] on a lattice of nx × ny cells that repeats over the unit square.
double lattice_noise(double u, double v, int nx, int ny, std::uint32_t seed) {
  const double x = u * nx, y = v * ny;
  const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y));
  const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
  const double fx = smooth(x - ix), fy = smooth(y - iy);
  const auto at = [&](int dx, int dy) { return random(wrapped(ix + dx, nx), wrapped(iy + dy, ny), seed); };
  return std::lerp(std::lerp(at(0, 0), at(1, 0), fx), std::lerp(at(0, 1), at(1, 1), fx), fy);
}

// Noise of several octaves, in [0, 1], mean 0.5.
double clouds(double u, double v, int nx, int ny, int octaves, std::uint32_t seed) {
  double sum = 0, weight = 1, total = 0;
  for (int i = 0; i < octaves; ++i, weight *= 0.55) {
    sum += weight * lattice_noise(u, v, nx << i, ny << i, seed + static_cast<std::uint32_t>(i));
    total += weight;
  }
  return sum / total;
}

double step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// What a pattern is at a point of the unit square: how much of `second`, and how dark (0–1 each).
struct Tone {
  double mix = 0, dark = 0;
};

Tone grain(double u, double v, int along, int across, double strength) {
  return {strength * step(0.42, 0.75, clouds(u, v, along, across, 3, 7)), 0};
}

Tone wood(double u, double v) { return grain(u, v, 2, 16, 0.7); }

// Boards in rows: the joint is 1, else grain and the board's own shade.
Tone boards(double u, double v, int rows, int columns, double stagger, double joint_u, double joint_v) {
  const double y = v * rows;
  const int row = static_cast<int>(y);
  const double x = u * columns + std::fmod(row * stagger, 1.0);
  const int column = wrapped(static_cast<int>(std::floor(x)), columns);
  const double fx = x - std::floor(x), fy = y - row;
  if (std::min(fx, 1 - fx) < joint_u || std::min(fy, 1 - fy) < joint_v) return {0.9, 0};
  Tone tone = grain(u, v, 3, rows * 5, 0.45);
  tone.mix += 0.3 * random(column, row, 3);
  tone.dark = 0.5 * random(column, row, 5);
  return tone;
}

Tone planks(double u, double v) { return boards(u, v, 8, 1, 0.37, 0.002, 0.02); }

// Herringbone of blocks 5 by 1 cells; one repeat is 10 by 10 cells.
Tone parquet(double u, double v) {
  const double x = u * 10, y = v * 10;
  const int i = static_cast<int>(x), j = static_cast<int>(y), k = wrapped(i - j, 10);
  const bool lies = k < 5;
  const double across = lies ? y - j : x - i, along = lies ? k + (x - i) : (9 - k) + (y - j);
  const int block_x = lies ? wrapped(i - k, 10) : i, block_y = lies ? j : wrapped(j - (9 - k), 10);
  if (std::min({across, 1 - across, along, 5 - along}) < 0.03) return {0.9, 0};
  Tone tone = lies ? grain(u, v, 4, 50, 0.45) : grain(v, u, 4, 50, 0.45);
  tone.mix += 0.3 * random(block_x, block_y, lies ? 3 : 4);
  tone.dark = 0.5 * random(block_x, block_y, lies ? 5 : 6);
  return tone;
}

Tone tiles(double u, double v) {
  const double x = u * 2, y = v * 2, fx = x - std::floor(x), fy = y - std::floor(y);
  if (std::min({fx, 1 - fx, fy, 1 - fy}) < 1.0 / 160) return {1, 0};
  return {0.08 * random(static_cast<int>(x), static_cast<int>(y), 3), 0};
}

Tone checker(double u, double v) { return {(u < 0.5) == (v < 0.5) ? 0.0 : 1.0, 0}; }

Tone bricks(double u, double v) {
  const double y = v * 6;
  const int row = static_cast<int>(y);
  const double x = u * 2 + 0.5 * (row % 2), fx = x - std::floor(x), fy = y - row;
  if (std::min(fx, 1 - fx) < 0.025 || std::min(fy, 1 - fy) < 0.075) return {1, 0};
  return {0, 0.7 * random(wrapped(static_cast<int>(std::floor(x)), 2), row, 3) + 0.3 * clouds(u, v, 24, 24, 2, 9)};
}

Tone marble(double u, double v) {
  const double bend = clouds(u, v, 4, 4, 5, 11);
  const double vein = std::abs(std::sin(kPi * (2 * (u + v) + 3.0 * bend)));
  return {std::max(0.8 * (1 - step(0.0, 0.16, vein)), 0.3 * step(0.45, 0.8, clouds(u, v, 5, 5, 4, 13))), 0};
}

Tone terrazzo(double u, double v) {
  constexpr int kCells = 12;
  const double x = u * kCells, y = v * kCells;
  double nearest = 9;
  std::uint32_t chip = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int cx = static_cast<int>(x) + dx, cy = static_cast<int>(y) + dy, wx = wrapped(cx, kCells), wy = wrapped(cy, kCells);
      const double distance = std::hypot(cx + random(wx, wy, 1) - x, cy + random(wx, wy, 2) - y) / (0.6 + 0.8 * random(wx, wy, 4));
      if (distance < nearest) {
        nearest = distance;
        chip = hash(wx, wy, 3);
      }
    }
  }
  return nearest < 0.33 ? Tone{1, chip % 4 == 0 ? 1.0 : 0.0} : Tone{};
}

Tone concrete(double u, double v) { return {step(0.3, 0.7, clouds(u, v, 3, 3, 6, 17)), 0}; }
Tone plaster(double u, double v) { return {0.1 * concrete(u, v).mix, 0}; }

Tone fabric(double u, double v) {
  const double x = std::sin(2 * kPi * 32 * u), y = std::sin(2 * kPi * 32 * v);
  return {0.35 * (0.5 + 0.5 * x * y) + 0.4 * step(0.3, 0.7, clouds(u, v, 16, 16, 3, 19)), 0};
}

Tone carpet(double u, double v) { return {step(0.25, 0.75, clouds(u, v, 48, 48, 2, 23)), 0.3 * clouds(u, v, 6, 6, 2, 29)}; }
Tone leather(double u, double v) { return {0.7 * step(0.45, 0.75, clouds(u, v, 32, 32, 3, 31)), 0.3 * clouds(u, v, 4, 4, 2, 37)}; }

Tone wicker(double u, double v) {
  const double x = u * 8, y = v * 8, fx = x - std::floor(x), fy = y - std::floor(y);
  const bool over = (static_cast<int>(x) + static_cast<int>(y)) % 2 == 0;
  const double across = over ? fy : fx;
  return {1 - step(0.0, 0.25, std::min(across, 1 - across)), over ? 0.0 : 0.3};
}

Tone stripes(double u, double) { return {u < 0.5 ? 0.0 : 1.0, 0}; }
Tone brushed(double u, double v) { return {0.6 * clouds(u, v, 3, 96, 2, 41), 0}; }

struct Pattern {
  Tone (*tone)(double u, double v);
  int pixels;        // edge of one repeat
  PatternSize size;  // of one repeat, in units of the surface's scale
};

const std::map<std::string, Pattern>& patterns() {
  static const std::map<std::string, Pattern> all{
      {"wood", {wood, 256, {160, 16}}},       {"planks", {planks, 256, {1, 1}}},        {"parquet", {parquet, 256, {2, 2, true}}},
      {"tiles", {tiles, 256, {2, 2}}},        {"checker", {checker, 32, {2, 2}}},       {"bricks", {bricks, 256, {2, 2}}},
      {"marble", {marble, 256, {4, 4}}},      {"terrazzo", {terrazzo, 256, {12, 12}}},  {"concrete", {concrete, 128, {3, 3}}},
      {"plaster", {plaster, 128, {3, 3}}},    {"fabric", {fabric, 128, {64, 64}}},      {"carpet", {carpet, 128, {48, 48}}},
      {"leather", {leather, 128, {32, 32}}},  {"wicker", {wicker, 128, {8, 8}}},        {"stripes", {stripes, 32, {2, 2}}},
      {"brushed", {brushed, 128, {200, 96}}},
  };
  return all;
}

std::string packed(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 3);
  out.resize(size);
  return out;
}

std::string draw(const Pattern& pattern) {
  std::string lines;
  const int n = pattern.pixels;
  lines.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n + 1));
  for (int y = 0; y < n; ++y) {
    lines += '\0';
    for (int x = 0; x < n; ++x) {
      const Tone tone = pattern.tone((x + 0.5) / n, (y + 0.5) / n);
      // A little noise before rounding hides the steps between so few tones.
      const double dither = random(x, y, 99) - 0.5;
      const int mix = std::clamp(static_cast<int>(std::lround(tone.mix * (kMixes - 1) + 0.6 * dither)), 0, kMixes - 1);
      const int dark = std::clamp(static_cast<int>(std::lround(tone.dark * (kShades - 1))), 0, kShades - 1);
      lines += static_cast<char>(mix * kShades + dark);
    }
  }
  return packed(lines);
}

// The compressed pixels of a procedure, made at its first use.
const std::string& pixels_of(const std::string& texture) {
  static std::mutex mutex;
  static std::map<std::string, std::string> made;
  const std::lock_guard lock(mutex);
  std::string& pixels = made[texture];
  if (pixels.empty()) pixels = draw(patterns().at(texture));
  return pixels;
}

void append_u32(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xffu);
}

void append_chunk(std::string& png, std::string_view kind, std::string_view data) {
  append_u32(png, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = png.size();
  png += kind;
  png += data;
  append_u32(png, static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(png.data() + start), static_cast<uInt>(png.size() - start))));
}

std::string palette(const Surface& surface) {
  const std::array<double, 3> base{surface.base.r, surface.base.g, surface.base.b};
  const std::array<double, 3> second{surface.second.r, surface.second.g, surface.second.b};
  std::string colors;
  for (int mix = 0; mix < kMixes; ++mix) {
    for (int dark = 0; dark < kShades; ++dark) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double color = std::lerp(base[i], second[i], mix / (kMixes - 1.0)) * (1 - 0.22 * dark / (kShades - 1.0));
        colors += static_cast<char>(std::clamp(std::lround(color * 255), 0l, 255l));
      }
    }
  }
  return colors;
}

}  // namespace

bool has_pattern(const std::string& texture) { return patterns().contains(texture); }

PatternSize pattern_size(const std::string& texture) { return patterns().at(texture).size; }

std::string pattern_png(const Surface& surface) {
  const Pattern& pattern = patterns().at(surface.texture);
  std::string png("\x89PNG\r\n\x1a\n", 8), header;
  append_u32(header, static_cast<std::uint32_t>(pattern.pixels));
  append_u32(header, static_cast<std::uint32_t>(pattern.pixels));
  header += std::string("\x08\x03\0\0\0", 5);  // 8 bits, palette
  append_chunk(png, "IHDR", header);
  append_chunk(png, "PLTE", palette(surface));
  append_chunk(png, "IDAT", pixels_of(surface.texture));
  append_chunk(png, "IEND", {});
  return png;
}

}  // namespace layoutbox
