// What stands on the shelves of shops, workrooms and dispensaries.
#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// Rolls of cloth side by side, their ends to the front, and a folded pile between.
void fabric(Piece& p, const Box& room) {
  static constexpr Color kCloth[] = {{0.74, 0.22, 0.26}, {0.20, 0.36, 0.56}, {0.90, 0.74, 0.38}, {0.36, 0.52, 0.38},
                                     {0.86, 0.62, 0.66}, {0.46, 0.34, 0.54}, {0.90, 0.88, 0.82}};
  const Vec size = room.size();
  const double r = std::min(0.045, size.z * 0.24), y0 = room.min.y + 0.012, y1 = room.max.y - 0.01;
  const int n = std::clamp(static_cast<int>(size.x / (2.15 * r)), 1, 12), rows = size.z > 4.2 * r ? 2 : 1;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < n - row; ++i) {
      const double x = room.min.x + size.x * (i + 0.5 + row * 0.5) / n, z = room.min.z + r + row * r * 1.8;
      p.add(p.tinted("cotton", kCloth[p.pick(7)]), rod({x, y0, z}, {x, y1, z}, r, 10));
      p.add(p.named("cardboard"), rod({x, y0 - 0.003, z}, {x, y0 + 0.01, z}, r * 0.25, 8));
    }
  }
}

// Bottles with handles and caps, and packets of washing powder.
void detergents(Piece& p, const Box& room) {
  static constexpr Color kBottles[] = {{0.16, 0.42, 0.78}, {0.93, 0.92, 0.90}, {0.90, 0.42, 0.14}, {0.24, 0.62, 0.44}, {0.72, 0.32, 0.62}};
  const Vec size = room.size();
  const double deep = std::min(0.11, size.y - 0.03), tall = std::min(size.z * 0.9, 0.28);
  for (double x = room.min.x + 0.02; x < room.max.x - 0.16;) {
    const int paint = p.tinted("plastic", kBottles[p.pick(5)]), cap = p.tinted("plastic", kBottles[p.pick(5)]);
    const double wide = p.random(0.1, 0.15), h = tall * p.random(0.7, 1), y0 = room.min.y + 0.015, z = room.min.z;
    if (p.random() < 0.35) {
      p.add(paint, box(sides(x, x + wide * 1.2, y0, y0 + deep, z, z + h), 0.004));
      p.add(cap, box(sides(x + 0.02, x + wide * 1.2 - 0.02, y0 - 0.002, y0 + 0.004, z + h * 0.4, z + h * 0.75), 0));
      x += wide * 1.2 + 0.02;
      continue;
    }
    p.add(paint, rounded_box(sides(x, x + wide, y0, y0 + deep, z, z + h * 0.74), 0.02, 2));
    p.add(paint, taper({x + wide / 2, y0 + deep / 2, z + h * 0.72}, {wide * 0.42, deep * 0.4}, {x + wide / 2, y0 + deep / 2, z + h * 0.88},
                       {0.018, 0.018}));
    p.add(cap, cylinder({x + wide / 2, y0 + deep / 2, z + h * 0.86}, 0.022, h * 0.14, 10));
    x += wide + 0.02;
  }
}

// Spools of thread in rows.
void threads(Piece& p, const Box& room) {
  static constexpr Color kThread[] = {{0.80, 0.18, 0.20}, {0.16, 0.34, 0.62}, {0.94, 0.78, 0.24},
                                      {0.28, 0.54, 0.34}, {0.92, 0.90, 0.86}, {0.52, 0.26, 0.50}};
  const Vec size = room.size();
  const double r = 0.022, tall = std::min(0.07, size.z * 0.8);
  for (double x = room.min.x + 0.035; x < room.max.x - 0.03; x += std::max(0.06, size.x / 16)) {
    const Vec at{x, room.min.y + 0.03, room.min.z};
    p.add(p.tinted("cotton", kThread[p.pick(6)]), cylinder({at.x, at.y, at.z + 0.006}, r, tall - 0.012, 10));
    for (const double z : {0.0, tall - 0.006}) p.add(p.named("plastic"), cylinder({at.x, at.y, at.z + z}, r * 1.15, 0.006, 10));
  }
}

// Trays of buns, tarts and slices.
void pastries(Piece& p, const Box& room) {
  static constexpr Color kBaked[] = {{0.80, 0.56, 0.28}, {0.62, 0.38, 0.18}, {0.93, 0.80, 0.58},
                                     {0.90, 0.60, 0.66}, {0.36, 0.20, 0.12}, {0.95, 0.92, 0.84}};
  const Vec size = room.size();
  const int columns = std::clamp(static_cast<int>(size.x / 0.13), 1, 14), rows = std::clamp(static_cast<int>(size.y / 0.14), 1, 4);
  const double tall = std::min(0.075, size.z * 0.6);
  for (int c = 0; c < columns; ++c) {
    const int kind = (c / 3) % 3, paint = p.tinted("plaster", kBaked[(c / 3 * 2 + kind) % 6]),
              other = p.tinted("plaster", kBaked[(c / 3 + 3) % 6]);
    for (int r = 0; r < rows; ++r) {
      const double x = room.min.x + size.x * (c + 0.5) / columns, y = room.min.y + size.y * (r + 0.5) / rows, z = room.min.z;
      if (kind == 0) {
        p.add(paint, ellipsoid({x, y, z + tall * 0.42}, {0.05, 0.042, tall * 0.42}, 10, 6));
      } else if (kind == 1) {
        p.add(paint, cylinder({x, y, z}, 0.042, tall * 0.6, 12));
        p.add(other, ellipsoid({x, y, z + tall * 0.62}, {0.036, 0.036, tall * 0.3}, 10, 6));
      } else {
        p.add(paint, box(sides(x - 0.045, x + 0.045, y - 0.035, y + 0.035, z, z + tall * 0.8), 0.006));
        p.add(other, box(sides(x - 0.045, x + 0.045, y - 0.035, y + 0.035, z + tall * 0.8, z + tall), 0.004));
      }
    }
  }
}

// Joints, slices on trays and strings of sausages.
void meat(Piece& p, const Box& room) {
  static constexpr Color kMeat[] = {{0.68, 0.20, 0.20}, {0.80, 0.42, 0.40}, {0.52, 0.16, 0.16}, {0.86, 0.58, 0.52}};
  const Vec size = room.size();
  const int columns = std::clamp(static_cast<int>(size.x / 0.26), 1, 8), rows = std::clamp(static_cast<int>(size.y / 0.24), 1, 3);
  const double tall = std::min(0.1, size.z * 0.6);
  for (int c = 0; c < columns; ++c) {
    for (int r = 0; r < rows; ++r) {
      const double x = room.min.x + size.x * (c + 0.5) / columns, y = room.min.y + size.y * (r + 0.5) / rows, z = room.min.z;
      const double wide = std::min(0.115, size.x / columns * 0.45), deep = std::min(0.1, size.y / rows * 0.44);
      const int paint = p.tinted("plaster", kMeat[p.pick(4)]);
      p.add(p.named("plastic"), box(sides(x - wide, x + wide, y - deep, y + deep, z, z + 0.012), 0));
      if ((c + r) % 3 == 0) {
        p.add(paint, ellipsoid({x, y, z + 0.012 + tall * 0.4}, {wide * 0.8, deep * 0.7, tall * 0.42}, 12, 6));
      } else if ((c + r) % 3 == 1) {
        for (int i = 0; i < 4; ++i)
          p.add(paint, box(sides(x - wide * 0.85 + i * wide * 0.44, x - wide * 0.85 + i * wide * 0.44 + wide * 0.36, y - deep * 0.75,
                                 y + deep * 0.75, z + 0.012, z + 0.012 + tall * 0.32),
                           0.008));
      } else {
        for (int i = 0; i < 4; ++i) {
          const double at = y - deep * 0.7 + i * deep * 0.46;
          p.add(paint, rod({x - wide * 0.75, at, z + 0.03}, {x + wide * 0.75, at, z + 0.03}, 0.017, 8));
        }
      }
    }
  }
}

// Flasks, beakers and bottles of clear glass.
void glassware(Piece& p, const Box& room) {
  const Vec size = room.size();
  const int glass = p.named("glass"), tint = p.tinted("plastic", {0.36, 0.58, 0.74});
  const double r = std::min(0.045, size.y * 0.35), tall = std::min(size.z * 0.85, 0.2);
  int k = 0;
  for (double x = room.min.x + r + 0.02; x < room.max.x - r; x += std::max(0.12, size.x / 9), ++k) {
    const Pose at = moved(x, room.min.y + r + 0.02, room.min.z);
    if (k % 3 == 0) {
      p.add(glass, lathe({{0, 0}, {r, 0}, {r * 0.3, tall * 0.7}, {r * 0.34, tall}, {0, tall}}, 12), at);
      p.add(tint, lathe({{0, 0.001}, {r * 0.9, 0.001}, {r * 0.66, tall * 0.3}, {0, tall * 0.3}}, 12), at);
    } else {
      p.add(glass, cylinder({0, 0, 0}, r * (k % 3 == 1 ? 0.9 : 0.5), tall * (k % 3 == 1 ? 0.6 : 1), 12), at);
    }
  }
}

// Small packets in rows and brown bottles.
void medicines(Piece& p, const Box& room) {
  static constexpr Color kPackets[] = {{0.94, 0.94, 0.94}, {0.24, 0.52, 0.74}, {0.82, 0.30, 0.30}, {0.36, 0.64, 0.50}, {0.95, 0.85, 0.55}};
  const Vec size = room.size();
  for (double x = room.min.x + 0.015; x < room.max.x - 0.13;) {
    const int paint = p.tinted("paper", kPackets[p.pick(5)]), n = 2 + p.pick(3);
    const bool bottle = p.random() < 0.3;
    const double wide = bottle ? 0.05 : p.random(0.05, 0.09), tall = std::min(size.z * 0.8, bottle ? 0.1 : p.random(0.08, 0.16));
    const double deep = std::min(0.1, size.y - 0.02);
    for (int i = 0; i < n && x + wide < room.max.x - 0.005; ++i, x += wide + 0.006) {
      const double y0 = room.min.y + 0.012, z = room.min.z;
      if (bottle) {
        p.add(p.tinted("plastic", {0.45, 0.24, 0.10}), cylinder({x + wide / 2, y0 + 0.03, z}, wide * 0.42, tall * 0.8, 10));
        p.add(p.named("plastic"), cylinder({x + wide / 2, y0 + 0.03, z + tall * 0.8}, wide * 0.36, tall * 0.2, 10));
      } else {
        p.add(paint, box(sides(x, x + wide, y0, y0 + deep, z, z + tall), 0));
      }
    }
    x += 0.03;
  }
}

// Pails of cut flowers side by side.
void flowers(Piece& p, const Box& room) {
  static constexpr Color kPetals[] = {{0.86, 0.24, 0.40}, {0.96, 0.78, 0.24}, {0.95, 0.94, 0.92},
                                      {0.62, 0.40, 0.72}, {0.92, 0.46, 0.20}, {0.94, 0.62, 0.70}};
  const Vec size = room.size();
  const double r = std::min({0.11, size.y * 0.42, size.z * 0.3}), pail = std::min(0.2, size.z * 0.45), tall = std::min(size.z * 0.96, 0.46);
  const int n = std::clamp(static_cast<int>(size.x / (2.3 * r)), 1, 8), zinc = p.named("steel"),
            green = p.tinted("leaf", {0.24, 0.44, 0.24});
  for (int i = 0; i < n; ++i) {
    const double x = room.min.x + size.x * (i + 0.5) / n, y = (room.min.y + room.max.y) / 2, z = room.min.z;
    p.add(zinc, cone({x, y, z}, r * 0.66, r * 0.86, pail, 14));
    p.add(green, cone({x, y, z + pail - 0.005}, r * 0.6, r * 0.8, tall * 0.78 - pail, 10));
    const int petals = p.tinted("paper", kPetals[p.pick(6)]);
    for (int k = 0; k < 6; ++k) {
      const double a = 2.39996 * k, out = r * 0.78 * std::sqrt((k + 0.3) / 6), b = r * 0.3;
      p.add(petals, ellipsoid({x + std::cos(a) * out, y + std::sin(a) * out, z + tall - b - 0.03 * r * k / 3}, {b, b, b * 0.8}, 6, 3));
    }
  }
}

// Two rows of lettuces in a tray.
void seedlings(Piece& p, const Box& room) {
  const Vec size = room.size();
  const double r = std::min({0.075, size.y * 0.22, size.z * 0.4});
  const int n = std::clamp(static_cast<int>(size.x / (2.1 * r)), 1, 9);
  for (int i = 0; i < 2 * n; ++i) {
    const int green = p.tinted("leaf", i % 3 == 0 ? Color{0.48, 0.66, 0.26} : Color{0.26, 0.52, 0.22});
    const double x = room.min.x + size.x * (i / 2 + 0.5) / n, y = room.min.y + size.y * (i % 2 == 0 ? 0.26 : 0.74), z = room.min.z;
    for (int k = 0; k < 2; ++k) {
      const double a = 3.1 * k + i, out = r * 0.4, tall = r * p.random(0.55, 0.8);
      p.add(green, ellipsoid({x + std::cos(a) * out, y + std::sin(a) * out, z + tall}, {r * 0.6, r * 0.6, tall}, 6, 3));
    }
  }
}

}  // namespace

ShelfContents shop_contents_named(std::string_view name) {
  static const std::map<std::string_view, ShelfContents> kinds = {
      {"fabric", fabric},       {"detergents", detergents}, {"threads", threads}, {"pastries", pastries},  {"meat", meat},
      {"glassware", glassware}, {"medicines", medicines},   {"flowers", flowers}, {"seedlings", seedlings}};
  const auto found = kinds.find(name);
  return found == kinds.end() ? nullptr : found->second;
}

}  // namespace layoutbox::kit
