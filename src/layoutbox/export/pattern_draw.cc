// Pixels are an index: the upper five bits say how much of `second`, the lower three how dark. The picture is the same for all surfaces
// of one procedure, so it is drawn and compressed once, when the program is built; the colours are the PNG's palette.
#include "layoutbox/export/pattern_draw.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace layoutbox {
namespace {

std::uint32_t hash(int x, int y, std::uint32_t seed) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 374761393u + static_cast<std::uint32_t>(y) * 668265263u + seed * 2246822519u;
  h = (h ^ h >> 13u) * 1274126177u;
  return h ^ h >> 16u;
}

double random(int x, int y, std::uint32_t seed) { return hash(x, y, seed) / 4294967296.0; }

int wrapped(int value, int period) { return ((value % period) + period) % period; }

// An image of smooth noise in [0, 1], mean 0.5: octaves of a lattice of nx × ny cells, repeating at the edges.
class Noise {
 public:
  Noise(int pixels, int nx, int ny, int octaves, std::uint32_t seed)
      : pixels_(pixels), values_(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels)) {
    float weight = 1, total = 0;
    for (int i = 0; i < octaves; ++i, weight *= 0.55f) {
      add_octave(nx << i, ny << i, seed + static_cast<std::uint32_t>(i), weight);
      total += weight;
    }
    for (float& value : values_) value = total > 0 ? value / total : 0;
  }

  double at(int x, int y) const { return double{values_[static_cast<std::size_t>(y * pixels_ + x)]}; }

 private:
  void add_octave(int nx, int ny, std::uint32_t seed, float weight) {
    const auto smooth = [](float t) { return t * t * (3 - 2 * t); };
    const auto cell = [&](int x, int count) { return static_cast<float>(x) * static_cast<float>(count) / static_cast<float>(pixels_); };
    std::vector<float> row(static_cast<std::size_t>(nx) + 1);
    std::size_t place = 0;
    for (int y = 0; y < pixels_; ++y) {
      const float v = cell(y, ny), fv = smooth(v - std::floor(v));
      const int iy = static_cast<int>(v);
      for (int i = 0; i <= nx; ++i) {
        const double below = random(i % nx, iy % ny, seed), above = random(i % nx, (iy + 1) % ny, seed);
        row[static_cast<std::size_t>(i)] = weight * std::lerp(static_cast<float>(below), static_cast<float>(above), fv);
      }
      for (int x = 0; x < pixels_; ++x) {
        const float u = cell(x, nx);
        const auto iu = static_cast<std::size_t>(u);
        const float fu = smooth(u - static_cast<float>(iu));
        values_[place++] += row[iu] + fu * (row[iu + 1] - row[iu]);
      }
    }
  }

  int pixels_;
  std::vector<float> values_;
};

double step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// What a pattern is at a point: how much of `second`, and how dark (0–1 each).
struct Tone {
  double mix = 0, dark = 0;
};

// A point of one repeat: u and v in [0, 1), and the pattern's two noises there.
struct PatternPlace {
  double u = 0, v = 0, fine = 0, coarse = 0;
  double fine_turned = 0;  // of the point with u and v exchanged
};

double grain(double noise) { return step(0.42, 0.75, noise); }

Tone wood(const PatternPlace& p) { return {0.7 * grain(p.fine), 0}; }

// A board or block with its own shade, and the joint round it.
Tone board(bool joint, double noise, int column, int row, std::uint32_t seed) {
  if (joint) return {0.9, 0};
  return {0.45 * grain(noise) + 0.3 * random(column, row, seed), 0.5 * random(column, row, seed + 2)};
}

Tone planks(const PatternPlace& p) {
  const double y = p.v * 8;
  const int row = static_cast<int>(y);
  const double x = p.u + std::fmod(row * 0.37, 1.0), fx = x - std::floor(x), fy = y - row;
  return board(std::min(fx, 1 - fx) < 0.002 || std::min(fy, 1 - fy) < 0.02, p.fine, 0, row, 3);
}

// Herringbone of blocks 5 by 1 cells; one repeat is 10 by 10 cells.
Tone parquet(const PatternPlace& p) {
  const double x = p.u * 10, y = p.v * 10;
  const int i = static_cast<int>(x), j = static_cast<int>(y), k = wrapped(i - j, 10);
  const bool lies = k < 5;
  const double across = lies ? y - j : x - i, along = lies ? k + (x - i) : (9 - k) + (y - j);
  const int block_x = lies ? wrapped(i - k, 10) : i, block_y = lies ? j : wrapped(j - (9 - k), 10);
  const bool joint = std::min({across, 1 - across, along, 5 - along}) < 0.03;
  return board(joint, lies ? p.fine : p.fine_turned, block_x, block_y, lies ? 3 : 4);
}

Tone tiles(const PatternPlace& p) {
  const double x = p.u * 2, y = p.v * 2, fx = x - std::floor(x), fy = y - std::floor(y);
  if (std::min({fx, 1 - fx, fy, 1 - fy}) < 1.0 / 90) return {1, 0};
  return {0.08 * random(static_cast<int>(x), static_cast<int>(y), 3), 0};
}

Tone checker(const PatternPlace& p) { return {(p.u < 0.5) == (p.v < 0.5) ? 0.0 : 1.0, 0}; }

Tone bricks(const PatternPlace& p) {
  const double y = p.v * 6;
  const int row = static_cast<int>(y);
  const double x = p.u * 2 + 0.5 * (row % 2), fx = x - std::floor(x), fy = y - row;
  if (std::min(fx, 1 - fx) < 0.025 || std::min(fy, 1 - fy) < 0.075) return {1, 0};
  return {0, 0.7 * random(wrapped(static_cast<int>(std::floor(x)), 2), row, 3) + 0.3 * p.fine};
}

// Mats 1 by 1/2; one repeat is two of them.
Tone tatami(const PatternPlace& p) {
  const double y = p.v * 2;
  const int row = static_cast<int>(y);
  const double x = p.u + 0.5 * row, fx = x - std::floor(x), fy = y - row;
  if (std::min(fy, 1 - fy) < 0.05) return {1, 0};
  if (std::min(fx, 1 - fx) < 0.004) return {0.7, 0};
  return {0.12 * step(0.3, 0.7, p.fine), 0.15 * row};
}

// Slabs 1 by 0.6; one repeat is two rows of one.
Tone flags(const PatternPlace& p) {
  const double y = p.v * 2;
  const int row = static_cast<int>(y);
  const double x = p.u + 0.5 * row, fx = x - std::floor(x), fy = y - row;
  if (std::min(fx, 1 - fx) < 0.012 || std::min(fy, 1 - fy) < 0.02) return {1, 0};
  return {0.35 * p.fine, 0.5 * random(0, row, 3)};
}

// Blossoms of five petals, in every second row between those of the first.
Tone flowers(const PatternPlace& p) {
  const double y = p.v * 2;
  const int row = static_cast<int>(y);
  const double x = p.u * 2 + 0.5 * row, dx = x - std::floor(x) - 0.5, dy = y - row - 0.5;
  const double r = std::hypot(dx, dy), petals = 0.3 * (0.72 + 0.28 * std::cos(5 * std::atan2(dy, dx)));
  if (r < 0.06) return {0.2, 0.2};
  return {1 - step(petals - 0.03, petals, r), 0};
}

// Square tiles: a diamond in the middle of each, rings and discs about the corners where four meet.
Tone rosettes(const PatternPlace& p) {
  const double x = std::abs(p.u - 0.5), y = std::abs(p.v - 0.5), far = std::hypot(0.5 - x, 0.5 - y);
  return {(far < 0.36 && far >= 0.25) || far < 0.14 || x + y < 0.2 ? 1.0 : 0.0, 0};
}

// Round logs along u: pale where they bulge, dark where two meet.
Tone logs(const PatternPlace& p) {
  const double y = p.v * 4, bulge = std::sin(kPi * (y - std::floor(y)));
  return {std::max(1 - step(0.1, 0.6, bulge), 0.5 * grain(p.fine)), 0.6 * (1 - step(0.0, 0.25, bulge))};
}

Tone glazed(const PatternPlace& p) {
  const double x = p.u * 4, y = p.v * 4, fx = x - std::floor(x), fy = y - std::floor(y);
  if (std::min({fx, 1 - fx, fy, 1 - fy}) < 1.0 / 40) return {1, 0};
  return {0, 0.8 * random(static_cast<int>(x), static_cast<int>(y), 5)};
}

Tone marble(const PatternPlace& p) {
  const double vein = std::abs(std::sin(kPi * (2 * (p.u + p.v) + 3.0 * p.coarse)));
  return {std::max(0.8 * (1 - step(0.0, 0.16, vein)), 0.3 * step(0.45, 0.8, p.fine)), 0};
}

Tone terrazzo(const PatternPlace& p) {
  constexpr int kCells = 12;
  const double x = p.u * kCells, y = p.v * kCells;
  double nearest = 9;
  std::uint32_t chip = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int cx = static_cast<int>(x) + dx, cy = static_cast<int>(y) + dy, wx = wrapped(cx, kCells), wy = wrapped(cy, kCells);
      const double ax = cx + random(wx, wy, 1) - x, ay = cy + random(wx, wy, 2) - y,
                   distance = std::sqrt(ax * ax + ay * ay) / (0.6 + 0.8 * random(wx, wy, 4));
      if (distance < nearest) {
        nearest = distance;
        chip = hash(wx, wy, 3);
      }
    }
  }
  return nearest < 0.33 ? Tone{1, chip % 4 == 0 ? 1.0 : 0.0} : Tone{};
}

Tone concrete(const PatternPlace& p) { return {step(0.3, 0.7, p.fine), 0}; }
Tone plaster(const PatternPlace& p) { return {0.1 * step(0.3, 0.7, p.fine), 0}; }

Tone fabric(const PatternPlace& p) {
  const double weave = 0.5 + 0.5 * std::sin(2 * kPi * 32 * p.u) * std::sin(2 * kPi * 32 * p.v);
  return {0.35 * weave + 0.4 * step(0.3, 0.7, p.fine), 0};
}

Tone carpet(const PatternPlace& p) { return {step(0.25, 0.75, p.fine), 0.3 * p.coarse}; }
Tone leather(const PatternPlace& p) { return {0.7 * step(0.45, 0.75, p.fine), 0.3 * p.coarse}; }

Tone wicker(const PatternPlace& p) {
  const double x = p.u * 8, y = p.v * 8, fx = x - std::floor(x), fy = y - std::floor(y);
  const bool over = (static_cast<int>(x) + static_cast<int>(y)) % 2 == 0;
  const double across = over ? fy : fx;
  return {1 - step(0.0, 0.25, std::min(across, 1 - across)), over ? 0.0 : 0.3};
}

Tone stripes(const PatternPlace& p) { return {p.u < 0.5 ? 0.0 : 1.0, 0}; }
Tone brushed(const PatternPlace& p) { return {0.6 * p.fine, 0}; }

// Cells along u and v, and octaves; none where octaves is 0.
struct NoiseSpec {
  int nx = 1, ny = 1, octaves = 0;
};

struct Pattern {
  Tone (*tone)(const PatternPlace&);
  int pixels;        // edge of one repeat
  PatternSize size;  // of one repeat, in units of the surface's scale
  NoiseSpec fine = {}, coarse = {};
};

const std::map<std::string, Pattern>& patterns() {
  static const std::map<std::string, Pattern> all{
      {"wood", {wood, 128, {160, 16}, {2, 16, 3}}},
      {"planks", {planks, 256, {1, 1}, {3, 40, 3}}},
      {"parquet", {parquet, 256, {2, 2, true}, {4, 50, 2}}},
      {"tiles", {tiles, 256, {2, 2}}},
      {"checker", {checker, 32, {2, 2}}},
      {"bricks", {bricks, 128, {2, 2}, {24, 24, 2}}},
      {"tatami", {tatami, 256, {1, 1}, {2, 100, 2}}},
      {"flags", {flags, 128, {1, 1.2}, {6, 6, 3}}},
      {"flowers", {flowers, 128, {2, 2}}},
      {"rosettes", {rosettes, 64, {1, 1}}},
      {"logs", {logs, 128, {4, 4}, {4, 32, 3}}},
      {"glazed", {glazed, 128, {4, 4}}},
      {"marble", {marble, 256, {4, 4}, {5, 5, 4}, {4, 4, 5}}},
      {"terrazzo", {terrazzo, 128, {12, 12}}},
      {"concrete", {concrete, 128, {3, 3}, {3, 3, 5}}},
      {"plaster", {plaster, 64, {3, 3}, {3, 3, 4}}},
      {"fabric", {fabric, 128, {64, 64}, {16, 16, 3}}},
      {"carpet", {carpet, 128, {48, 48}, {48, 48, 2}, {6, 6, 2}}},
      {"leather", {leather, 128, {32, 32}, {32, 32, 2}, {4, 4, 2}}},
      {"wicker", {wicker, 128, {8, 8}}},
      {"stripes", {stripes, 32, {2, 2}}},
      {"brushed", {brushed, 128, {200, 96}, {3, 96, 1}}},
  };
  return all;
}

std::string packed(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 9);
  out.resize(size);
  return out;
}

std::string draw(const Pattern& pattern) {
  const int n = pattern.pixels;
  const Noise fine(n, pattern.fine.nx, pattern.fine.ny, pattern.fine.octaves, 7);
  const Noise coarse(n, pattern.coarse.nx, pattern.coarse.ny, pattern.coarse.octaves, 11);
  std::string lines;
  lines.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n + 1));
  for (int y = 0; y < n; ++y) {
    lines += '\0';
    for (int x = 0; x < n; ++x) {
      const Tone tone = pattern.tone({(x + 0.5) / n, (y + 0.5) / n, fine.at(x, y), coarse.at(x, y), fine.at(y, x)});
      const int mix = std::clamp(static_cast<int>(tone.mix * (kPatternMixes - 1) + 0.5), 0, kPatternMixes - 1);
      const int dark = std::clamp(static_cast<int>(tone.dark * (kPatternShades - 1) + 0.5), 0, kPatternShades - 1);
      lines += static_cast<char>(mix * kPatternShades + dark);
    }
  }
  return packed(lines);
}

}  // namespace

std::vector<std::string> pattern_names() {
  std::vector<std::string> names;
  for (const auto& [name, pattern] : patterns()) names.push_back(name);
  return names;
}

int pattern_pixels(const std::string& texture) { return patterns().at(texture).pixels; }

PatternSize pattern_size(const std::string& texture) { return patterns().at(texture).size; }

std::string draw_pattern(const std::string& texture) { return draw(patterns().at(texture)); }

}  // namespace layoutbox
