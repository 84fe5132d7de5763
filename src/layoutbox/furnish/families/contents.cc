// What stands on shelves where nothing of the layout does: at home; what shops have is in contents_shop.
#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// Packets, tins and bottles in a row, as in a shop.
void goods(Piece& p, const Box& room) {
  static constexpr Color kPackets[] = {{0.66, 0.36, 0.30}, {0.40, 0.50, 0.60}, {0.84, 0.72, 0.46},
                                       {0.46, 0.56, 0.44}, {0.93, 0.92, 0.88}, {0.74, 0.58, 0.42}};
  const Vec size = room.size();
  for (double x = room.min.x + 0.01; x < room.max.x - 0.2;) {
    const int surface = p.tinted("paper", kPackets[p.pick(static_cast<int>(std::size(kPackets)))]);
    const int n = 2 + p.pick(3);
    const bool tins = p.random() < 0.45;
    const double wide = tins ? 0.08 : p.random(0.1, 0.17), tall = std::min(size.z * 0.9, tins ? 0.12 : p.random(0.18, 0.28));
    for (int i = 0; i < n && x + wide < room.max.x - 0.005; ++i, x += wide + 0.008) {
      const double y0 = room.min.y + 0.015, deep = std::min(size.y - 0.02, tins ? wide : 0.2);
      if (tins) {
        p.add(surface, cylinder({x + wide / 2, y0 + deep / 2, room.min.z}, std::min(wide, deep) / 2, tall, 12));
      } else {
        p.add(surface, box(sides(x, x + wide, y0, y0 + deep, room.min.z, room.min.z + tall), 0));
      }
    }
    x += 0.02;
  }
}

// Bottles in a row.
void bottles(Piece& p, const Box& room) {
  static constexpr Color kGlass[] = {{0.16, 0.34, 0.20}, {0.45, 0.24, 0.10}, {0.75, 0.83, 0.84}, {0.62, 0.16, 0.16}, {0.82, 0.62, 0.22}};
  const Vec size = room.size();
  const double pitch = std::max(0.1, size.x / 16), r = std::min(0.037, size.y * 0.4), tall = std::min(size.z * 0.94, 0.31);
  for (double x = room.min.x + 0.05; x < room.max.x - 0.04; x += pitch) {
    const double h = tall * p.random(0.8, 1.0);
    p.add(p.tinted("plastic", kGlass[p.pick(static_cast<int>(std::size(kGlass)))]),
          lathe({{0, 0}, {r, 0}, {r, h * 0.62}, {r * 0.38, h * 0.78}, {r * 0.38, h}, {0, h}}, 8),
          moved(x, room.min.y + r + 0.02, room.min.z));
  }
}

// Bottles that lie side by side, their necks to the front.
void lying_bottles(Piece& p, const Box& room) {
  static constexpr Color kGlass[] = {{0.13, 0.27, 0.16}, {0.20, 0.09, 0.10}, {0.36, 0.20, 0.09}};
  const Vec size = room.size();
  const double r = std::min(0.04, size.z * 0.45), y0 = room.min.y + 0.01, neck = std::min(0.1, size.y * 0.35);
  const int n = std::clamp(static_cast<int>(size.x / (2.3 * r)), 1, 10);
  for (int i = 0; i < n; ++i) {
    const double x = room.min.x + size.x * (i + 0.5) / n, z = room.min.z + r;
    const int glass = p.tinted("plastic", kGlass[p.pick(3)]);
    p.add(glass, rod({x, y0 + neck, z}, {x, room.max.y - 0.01, z}, r, 10));
    p.add(glass, rod({x, y0, z}, {x, y0 + neck, z}, r * 0.4, 8));
    p.add(p.tinted("plastic", {0.72, 0.58, 0.26}), rod({x, y0 - 0.004, z}, {x, y0 + neck * 0.3, z}, r * 0.45, 8));
  }
}

// Folded towels in piles.
void towels(Piece& p, const Box& room) {
  const int white = p.named("cotton"), other = p.tinted("cotton", p.accent());
  const Vec size = room.size();
  const int piles = std::max(1, static_cast<int>(size.x / 0.34)), most = std::clamp(static_cast<int>(size.z * 0.8 / 0.055), 1, 4);
  for (int i = 0; i < piles; ++i) {
    const double x = room.min.x + size.x * (i + 0.5) / piles, half = std::min(0.14, size.x / piles * 0.46);
    const int surface = i % 2 == 0 ? white : other;
    for (int k = 0, n = 1 + p.pick(most); k < n; ++k) {
      const double z = room.min.z + 0.055 * k;
      p.add(surface, rounded_box(sides(x - half, x + half, room.min.y + 0.012, std::min(room.max.y, room.min.y + 0.3), z,
                                       std::min(z + 0.053, room.max.z)),
                                 0.018, 2));
    }
  }
}

// Folded clothes in piles, each piece of another colour.
void clothes(Piece& p, const Box& room) {
  static constexpr Color kCloth[] = {{0.30, 0.40, 0.54}, {0.90, 0.87, 0.80}, {0.66, 0.32, 0.28}, {0.40, 0.50, 0.42}, {0.26, 0.27, 0.30}};
  const Vec size = room.size();
  const int piles = std::max(1, static_cast<int>(size.x / 0.32)), most = std::clamp(static_cast<int>(size.z * 0.8 / 0.045), 1, 6);
  for (int i = 0; i < piles; ++i) {
    const double x = room.min.x + size.x * (i + 0.5) / piles, half = std::min(0.13, size.x / piles * 0.44);
    for (int k = 0, n = std::max(1, most - p.pick(3)); k < n; ++k) {
      const double z = room.min.z + 0.045 * k;
      p.add(p.tinted("cotton", kCloth[p.pick(5)]),
            box(sides(x - half, x + half, room.min.y + 0.015, std::min(room.max.y, room.min.y + 0.3), z, std::min(z + 0.043, room.max.z)),
                0.012));
    }
  }
}

// Pairs of low shoes, toes to the front.
void shoe_pairs(Piece& p, const Box& room) {
  static constexpr Color kUppers[] = {{0.92, 0.92, 0.90}, {0.14, 0.14, 0.16}, {0.55, 0.34, 0.26}, {0.30, 0.36, 0.46}, {0.72, 0.60, 0.44}};
  const Vec size = room.size();
  const double length = std::min(0.27, size.y - 0.02), wide = 0.09, tall = std::min(0.11, size.z * 0.8), y0 = room.min.y + 0.01;
  const int pairs = std::clamp(static_cast<int>(size.x / 0.25), 1, 6), sole = p.tinted("plastic", {0.95, 0.95, 0.94});
  for (int i = 0; i < pairs; ++i) {
    const int upper = p.tinted("leather", kUppers[p.pick(5)]);
    for (const double side : {-1.0, 1.0}) {
      const double x = room.min.x + size.x * (i + 0.5) / pairs + side * (wide / 2 + 0.006), z = room.min.z, a = x - wide / 2,
                   b = x + wide / 2;
      p.add(sole, box(sides(a, b, y0, y0 + length, z, z + 0.024), 0.01));
      p.add(upper, box(sides(a + 0.004, b - 0.004, y0 + 0.008, y0 + length - 0.004, z + 0.022, z + tall * 0.58), 0.016));
      p.add(upper, box(sides(a + 0.007, b - 0.007, y0 + length * 0.45, y0 + length - 0.006, z + tall * 0.5, z + tall), 0.012));
    }
  }
}

// Jars with lids, filled with one thing and another.
void jars(Piece& p, const Box& room) {
  static constexpr Color kFood[] = {{0.86, 0.72, 0.44}, {0.62, 0.20, 0.16}, {0.42, 0.26, 0.14}, {0.90, 0.86, 0.76}, {0.46, 0.52, 0.24}};
  const Vec size = room.size();
  const int lid = p.named("oak");
  const double r = std::min(0.05, size.y * 0.4), pitch = std::max(2 * r + 0.02, size.x / 9);
  for (double x = room.min.x + r + 0.015; x < room.max.x - r; x += pitch) {
    const double tall = std::min(size.z * 0.85, p.random(0.12, 0.24)), y = room.min.y + r + 0.02;
    p.add(p.tinted("plastic", kFood[p.pick(5)]), cylinder({x, y, room.min.z}, r, tall * 0.86, 12));
    p.add(lid, cylinder({x, y, room.min.z + tall * 0.86}, r * 0.9, tall * 0.14, 12));
  }
}

// Cups on feet, a tall one between low ones, and a figure on a plinth here and there.
void trophies(Piece& p, const Box& room) {
  const int gold = p.named("brass"), silver = p.named("steel"), dark = p.tinted("plastic", {0.14, 0.10, 0.08});
  const Vec size = room.size();
  const double r = std::min(0.05, size.y * 0.36), most = std::min(size.z * 0.94, 0.34);
  const int n = std::clamp(static_cast<int>(size.x / 0.15), 1, 8);
  for (int i = 0; i < n; ++i) {
    const double tall = most * (i % 2 == 0 ? 0.98 : 0.74), foot = tall * 0.2;
    const Vec at{room.min.x + size.x * (i + 0.5) / n, (room.min.y + room.max.y) / 2, room.min.z};
    p.add(dark, box(sides(at.x - r * 0.7, at.x + r * 0.7, at.y - r * 0.7, at.y + r * 0.7, at.z, at.z + foot), 0.004));
    p.add(i % 3 == 1 ? silver : gold,
          lathe({{0, 0},
                 {r * 0.5, 0},
                 {r * 0.16, tall * 0.14},
                 {r * 0.16, tall * 0.26},
                 {r * 0.7, tall * 0.42},
                 {r, tall * 0.8},
                 {r * 0.9, tall * 0.8},
                 {0, tall * 0.5}},
                14),
          moved(at.x, at.y, at.z + foot - 0.002));
  }
}

constexpr Color kPlayThings[] = {{0.84, 0.30, 0.26}, {0.26, 0.50, 0.76}, {0.95, 0.76, 0.28}, {0.36, 0.64, 0.40}, {0.90, 0.55, 0.24}};

// One toy, so wide at most, its middle at the place: a ball, a bear, a tower of blocks, a car, a bin of something.
void toy(Piece& p, int kind, Vec at, double wide, double tall) {
  const int paint = p.tinted("plastic", kPlayThings[p.pick(5)]), other = p.tinted("plastic", kPlayThings[p.pick(5)]);
  const double r = std::min(wide, tall) / 2;
  if (kind == 0) return p.add(paint, ellipsoid({at.x, at.y, at.z + r}, {r, r, r}, 12, 8));
  if (kind == 1) {
    const int fur = p.tinted("fur", {0.66, 0.47, 0.30});
    p.add(fur, ellipsoid({at.x, at.y, at.z + r * 0.62}, {r * 0.62, r * 0.55, r * 0.62}, 10, 6));
    p.add(fur, ellipsoid({at.x, at.y, at.z + r * 1.5}, {r * 0.5, r * 0.45, r * 0.45}, 10, 6));
    for (const double s : {-1.0, 1.0}) {
      p.add(fur, ellipsoid({at.x + s * r * 0.38, at.y, at.z + r * 1.85}, {r * 0.17, r * 0.12, r * 0.15}, 6, 4));
      p.add(fur, ellipsoid({at.x + s * r * 0.5, at.y - r * 0.4, at.z + r * 0.2}, {r * 0.2, r * 0.4, r * 0.2}, 8, 4));
    }
    return;
  }
  if (kind == 2) {
    const double e = std::min(0.075, tall / 3);
    for (int k = 0; k < 3; ++k)
      p.add(p.tinted("plastic", kPlayThings[p.pick(5)]),
            box(sides(at.x - e / 2, at.x + e / 2, at.y - e / 2, at.y + e / 2, at.z + e * k, at.z + e * (k + 1)), 0.004));
    return;
  }
  if (kind == 3) {
    const double x = wide * 0.48, y = std::min(0.05, x * 0.5);
    p.add(paint, box(sides(at.x - x, at.x + x, at.y - y, at.y + y, at.z + 0.02, at.z + 0.07), 0.012));
    p.add(other, box(sides(at.x - x * 0.5, at.x + x * 0.4, at.y - y * 0.9, at.y + y * 0.9, at.z + 0.068, at.z + 0.11), 0.012));
    for (const double sx : {-0.6, 0.6})
      p.add(p.named("black_plastic"),
            rod({at.x + sx * x, at.y - y - 0.004, at.z + 0.022}, {at.x + sx * x, at.y + y, at.z + 0.022}, 0.022, 8));
    return;
  }
  const double h = std::min(tall, 0.2);
  p.add(paint, box(sides(at.x - wide * 0.48, at.x + wide * 0.48, at.y - 0.1, at.y + 0.1, at.z, at.z + h), 0.012));
  p.add(other, box(sides(at.x - wide * 0.5, at.x + wide * 0.5, at.y - 0.105, at.y + 0.105, at.z + h * 0.9, at.z + h), 0.006));
}

// Toys with gaps between them.
void toys(Piece& p, const Box& room) {
  const Vec size = room.size();
  const double tall = std::min(size.z * 0.88, 0.26), deep = std::min(0.12, size.y / 2);
  if (deep < 0.108) return books(p, room);
  const int first = p.pick(5), n = std::clamp(static_cast<int>(size.x / 0.25), 1, 6);
  for (int i = 0; i < n; ++i)
    toy(p, (first + i * 2) % 5, {room.min.x + size.x * (i + 0.5) / n, room.min.y + deep + 0.005, room.min.z},
        std::min(0.22, size.x / n * 0.9), tall);
}

// Cartons and plastic boxes.
void boxes(Piece& p, const Box& room) {
  static constexpr Color kBoxes[] = {{0.42, 0.50, 0.58}, {0.80, 0.80, 0.78}, {0.62, 0.44, 0.36}, {0.42, 0.52, 0.46}};
  const Vec size = room.size();
  for (double x = room.min.x + 0.02; x < room.max.x - 0.2;) {
    const double wide = std::min(p.random(0.2, 0.38), room.max.x - 0.01 - x), tall = size.z * p.random(0.45, 0.88);
    const int surface = p.random() < 0.5 ? p.named("cardboard") : p.tinted("plastic", kBoxes[p.pick(4)]);
    const double y0 = room.min.y + 0.02, y1 = std::max(y0 + 0.05, room.max.y - 0.01);
    p.add(surface, box(sides(x, x + wide, y0, y1, room.min.z, room.min.z + tall), 0.004));
    p.add(p.named("paper"),
          box(sides(x + wide * 0.3, x + wide * 0.7, y0 - 0.003, y0 + 0.002, room.min.z + tall * 0.4, room.min.z + tall * 0.7), 0));
    x += wide + 0.03;
  }
}

// Ring binders, a label on every back.
void binders(Piece& p, const Box& room) {
  static constexpr Color kBacks[] = {{0.15, 0.30, 0.52}, {0.13, 0.13, 0.14}, {0.62, 0.16, 0.15}, {0.55, 0.57, 0.58}};
  const Vec size = room.size();
  const double tall = std::min(size.z * 0.94, 0.32), deep = std::min(size.y * 0.9, 0.28), thick = 0.07;
  for (double x = room.min.x + 0.01; x + thick < room.max.x - 0.005; x += thick + 0.004) {
    if (p.random() < 0.12) continue;
    p.add(p.tinted("plastic", kBacks[p.pick(4)]),
          box(sides(x, x + thick, room.min.y + 0.012, room.min.y + deep, room.min.z, room.min.z + tall), 0));
    p.add(p.named("paper"), box(sides(x + 0.012, x + thick - 0.012, room.min.y + 0.009, room.min.y + 0.014, room.min.z + tall * 0.5,
                                      room.min.z + tall * 0.85),
                                0));
  }
}

// A folded duvet with a pillow on it, at one end: what makes a bed of a sofa.
void folded_bedding(Piece& p, const Box& room) {
  const Vec size = room.size();
  const double x0 = room.min.x + 0.02, x1 = x0 + std::min(0.6, size.x * 0.4), y0 = room.min.y + 0.06, y1 = room.max.y - 0.04;
  const int duvet = p.tinted("cotton", mixed(p.accent(), {0.95, 0.94, 0.92}, 0.35)), white = p.named("cotton");
  double z = room.min.z;
  for (const int cloth : {white, duvet, duvet}) {
    p.add(cloth, rounded_box(sides(x0, x1, y0, y1, z, z + 0.06), 0.028, 3));
    z += 0.058;
  }
  if (size.z > 0.32) p.add(white, pillow(sides(x0 + 0.03, x1 - 0.03, y0 + 0.06, y1 - 0.02, z - 0.01, z + 0.12), 8));
}

}  // namespace

ShelfContents contents_named(std::string_view name) {
  static const std::map<std::string_view, ShelfContents> kinds = {
      {"books", books},       {"goods", goods},     {"bottles", bottles},    {"towels", towels},
      {"boxes", boxes},       {"binders", binders}, {"wine", lying_bottles}, {"clothes", clothes},
      {"shoes", shoe_pairs},  {"jars", jars},       {"toys", toys},          {"bedding", folded_bedding},
      {"trophies", trophies}, {"none", nullptr}};
  if (const auto found = kinds.find(name); found != kinds.end()) return found->second;
  const ShelfContents shop = shop_contents_named(name);
  return shop == nullptr ? books : shop;
}

ShelfContents contents_of(const Piece& p) {
  return contents_named(p.said_contents().empty() ? p.word("contents", p.shelf_contents()) : p.said_contents());
}

}  // namespace layoutbox::kit
