// Things on walls: pictures, mirrors, clocks, boards, wall shelves.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {

// A frame of four bars round a rectangle; what it holds lies between its front and back.
void picture_frame(Piece& p, int surface, double width) {
  const double x = p.w / 2, t = std::min({width, p.w * 0.2, p.h * 0.2});
  p.add(surface, box(sides(-x, x, -p.d / 2, p.d / 2, 0, t), 0.003));
  p.add(surface, box(sides(-x, x, -p.d / 2, p.d / 2, p.h - t, p.h), 0.003));
  p.add(surface, box(sides(-x, -x + t, -p.d / 2, p.d / 2, t, p.h - t), 0.003));
  p.add(surface, box(sides(x - t, x, -p.d / 2, p.d / 2, t, p.h - t), 0.003));
}

namespace {

void mirror(Piece& p) {
  const int rim = p.main("oak"), glass = p.named("mirror");
  const double t = std::min({0.03, p.w * 0.1, p.h * 0.1}), y = -p.d / 2 + std::min(0.008, p.d * 0.4);
  if (p.word("top", "rect") == "round" || p.says("round") || p.says("oval")) {
    const Pose upright = moved(0, p.d / 2, p.h / 2) * Pose{{1, 0, 0}, {0, 0, p.h / p.w}, {0, -1, 0}, {}};
    const double r = p.w / 2;
    p.add(rim, lathe({{r - t, 0}, {r, 0}, {r, p.d}, {r - t, p.d}, {r - t, 0}}, 40), upright);
    p.add(glass, lathe({{0, 0.001}, {r - t, 0.001}, {r - t, p.d / 2 - y}, {0, p.d / 2 - y}}, 40), upright);
    return;
  }
  const double face = std::min(0.03, p.d);
  if (p.d > 0.08) {
    // A mirror that stands: a frame on a foot.
    for (const double x : {-1.0, 1.0})
      p.add(rim, box(sides(x * p.w / 2 - (x > 0 ? 0.04 : 0), x * p.w / 2 + (x > 0 ? 0 : 0.04), -p.d / 2, p.d / 2, 0, 0.03), 0.005));
    const double lean = std::min(0.12, p.d * 0.4);
    const Pose tilt{{1, 0, 0}, {0, 1, 0}, unit(Vec{0, lean, p.h}), {0, -lean / 2 - face / 2, 0.03}};
    const double tall = (p.h - 0.03) / unit(Vec{0, lean, p.h}).z;
    p.add(rim, box(sides(-p.w / 2 + 0.002, p.w / 2 - 0.002, 0.004, face, 0, tall), 0.004), tilt);
    p.add(glass, box(sides(-p.w / 2 + t, p.w / 2 - t, 0.001, 0.01, t, tall - t), 0), tilt);
    return;
  }
  if (p.word("kind", "") == "frameless") {
    const double back = std::min(0.01, p.d * 0.5);
    p.add(p.named("grey_plastic"), box(sides(-p.w / 2 + t, p.w / 2 - t, p.d / 2 - back, p.d / 2, t, p.h - t), 0));
    p.add(glass, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2 - back, 0, p.h), 0.002));
    return;
  }
  picture_frame(p, rim, t);
  p.add(glass, box(sides(-p.w / 2 + t, p.w / 2 - t, y, p.d / 2 - 0.001, t, p.h - t), 0));
}

// Hammer, saw, spanners and pliers in outline, as they hang on a board for tools.
void hanging_tools(Piece& p, const Box& b) {
  const int steel = p.named("steel"), red = p.tinted("plastic", {0.80, 0.20, 0.16}), wood = p.named("walnut"),
            dark = p.named("black_metal");
  const double y = b.max.y, t = b.size().y, pitch = 0.16, row = 0.34;
  const auto bar = [&](int surface, double x, double z, double half, double low, double high) {
    p.add(surface, box(sides(x - half, x + half, y - t, y, z + low, z + high), 0));
  };
  const int columns = std::max(1, static_cast<int>(b.size().x / pitch)), rows = std::max(1, static_cast<int>(b.size().z / row));
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const double x = b.min.x + b.size().x * (c + 0.5) / columns, z = b.min.z + b.size().z * (r + 0.5) / rows - 0.14;
      const int kind = (c + 2 * r) % 4;
      bar(kind == 1 ? steel : kind == 3 ? dark : kind == 0 ? wood : red, x, z, 0.014, 0, 0.2);
      if (kind == 0) bar(dark, x, z, 0.055, 0.19, 0.235);
      if (kind == 1) bar(steel, x, z, 0.028, 0.19, 0.24);
      if (kind == 2) bar(steel, x, z, 0.007, 0.2, 0.28);
      if (kind == 3) bar(red, x, z, 0.03, 0, 0.1);
    }
  }
}

// Upright laths on a dark felt.
void lath_panel(Piece& p) {
  const int wood = p.main("oak");
  const double pitch = 0.045, back = p.d / 2 - std::min(0.01, p.d * 0.4);
  const int n = std::max(2, static_cast<int>(p.w / pitch));
  p.add(p.tinted("wool", {0.16, 0.16, 0.17}), box(sides(-p.w / 2, p.w / 2, back, p.d / 2, 0, p.h), 0));
  for (int i = 0; i < n; ++i) {
    const double x = -p.w / 2 + p.w * i / n;
    p.add(wood, box(sides(x, x + p.w / n * (i + 1 < n ? 0.62 : 1), -p.d / 2, back, 0, p.h), 0.001));
  }
}

// A heading and lines of words, as strokes on the face at `front`.
void writing(Piece& p, bool chalk, double front) {
  const int ink = chalk ? p.tinted("paper", {0.86, 0.88, 0.84}) : p.tinted("plastic", {0.16, 0.30, 0.58});
  const double left = -p.w * 0.42, line = std::min(0.11, p.h * 0.13), thick = line * 0.22, lift = std::min(0.001, p.d * 0.1);
  const int lines = std::min(5, static_cast<int>(p.h * 0.62 / line));
  for (int row = 0; row < lines; ++row) {
    const double z = p.h * 0.84 - row * line, end = left + p.w * (row == 0 ? 0.34 : p.random(0.36, 0.5));
    for (double x = left; x < end;) {
      const double word = std::min(line * p.random(0.6, 1.6), end - x + 0.01);
      p.add(ink, box(sides(x, x + word, front - lift, front + lift, z - thick * (row == 0 ? 1 : 0.6), z), 0));
      x += word + line * 0.3;
    }
  }
}

void board(Piece& p) {
  if (p.word("kind", "") == "panel") return lath_panel(p);
  const std::string kind = p.word("kind", p.says("cork") || p.says("bulletin") ? "cork"
                                          : p.says("black") || p.says("chalk") ? "chalk"
                                                                               : "white");
  picture_frame(p, p.frame(kind == "white" ? "steel" : "oak"), 0.02);
  const double t = std::min({0.02, p.w * 0.2, p.h * 0.2});
  const int face = kind == "cork"    ? p.named("cork")
                   : kind == "peg"   ? p.tinted("lacquer", {0.80, 0.66, 0.46})
                   : kind == "chalk" ? p.tinted("plaster", {0.14, 0.22, 0.19})
                                     : p.named("ceramic");
  const double front = -p.d / 2 + (kind == "peg" ? p.d * 0.6 : std::min(0.006, p.d * 0.4));
  p.add(face, box(sides(-p.w / 2 + t, p.w / 2 - t, front, p.d / 2 - 0.001, t, p.h - t), 0));
  if ((kind == "chalk" || kind == "white") && p.may_show_contents() && std::min(p.w, p.h) > 0.4) writing(p, kind == "chalk", front);
  if (kind == "peg" && p.may_show_contents())
    hanging_tools(p, sides(-p.w / 2 + t * 2, p.w / 2 - t * 2, -p.d / 2 + 0.002, front, t * 2, p.h - t * 2));
}

void wall_shelf(Piece& p) {
  const int wood = p.main("oak");
  if (!p.spaces.empty()) {
    carcass(p, {p.body(), wood, wood, p.named("brass"), 0, 0, false, 0});
    return;
  }
  const double t = std::min(0.03, p.h);
  // What the text says that it is for stands on a board as low as leaves room for it.
  const ShelfContents contents =
      p.bears || !p.may_show_contents() || p.said_contents().empty() ? nullptr : contents_named(p.said_contents());
  if (contents != nullptr && p.h > 4 * t) {
    p.add(wood, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, t), 0.004));
    return contents(p, sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, t, p.h));
  }
  p.add(wood, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, p.h - t, p.h), 0.004));
  if (p.h - t < 0.01) return;
  for (const double s : {-0.36, 0.36}) {
    const double x = s * p.w, y = p.d / 2, z = p.h - t;
    p.add(p.frame("black_metal"),
          prism({{y, 0}, {y, z}, {y - p.d * 0.8, z}, {y - p.d * 0.8, z - std::min(0.015, z)}, {y - 0.012, 0}}, -0.008, 0.008),
          Pose{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {x, 0, 0}});
  }
}

}  // namespace

void add_wall_things(Families& to) {
  to["mirror"] = mirror;
  to["board"] = board;
  to["wall_shelf"] = wall_shelf;
}

}  // namespace layoutbox::kit
