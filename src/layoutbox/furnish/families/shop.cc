// Shop, stage and street: tills, show cases, podiums, carts.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// Wheels in the corners, as wide as the room beside the shelves.
void wheels(Piece& p, double r, double wide) {
  const int dark = p.named("black_plastic");
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0})
      p.add(dark, rod({x * (p.w / 2 - wide), y * (p.d / 2 - r), r}, {x * p.w / 2, y * (p.d / 2 - r), r}, r, 14));
  }
}

void cash_register(Piece& p) {
  const int body = p.main("grey_plastic"), dark = p.named("black_plastic");
  p.add(dark, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, p.h * 0.3), 0.006));
  p.add(body, taper({0, 0.02 * p.d, p.h * 0.3}, {p.w * 0.46, p.d * 0.46}, {0, p.d * 0.2, p.h * 0.62}, {p.w * 0.46, p.d * 0.27}));
  const Pose tilt = moved(0, p.d * 0.18, p.h * 0.58) * turned_x(-15);
  p.add(dark, box(sides(-p.w * 0.4, p.w * 0.4, 0, p.d * 0.06, 0, p.h * 0.42), 0.006), tilt);
  p.add(p.named("lit_screen"), box(sides(-p.w * 0.36, p.w * 0.36, -0.002, 0.003, p.h * 0.04, p.h * 0.38), 0), tilt);
  p.fit();
}

// Measures of a glass case: half its width and depth, how thick its frame is, where the glass begins and ends, its shelves' heights.
struct GlassCase {
  double x, y, frame, low, roof;
  std::vector<double> levels;  // the floors of its spaces
};

GlassCase glass_case_of(const Piece& p) {
  GlassCase c{p.w / 2, p.d / 2, 0, p.h * 0.25, p.h - std::min(0.03, p.h * 0.02), {}};
  double side = 0.02;
  for (const FreeSpace& s : p.spaces) {
    c.levels.push_back(s.box.min.z);
    side = std::min({side, s.box.min.x + c.x, c.x - s.box.max.x, s.box.min.y + c.y, c.y - s.box.max.y});
    c.roof = std::max(c.roof, s.box.max.z);
  }
  c.frame = std::max(0.004, side);
  c.roof = std::min(c.roof, p.h - 0.004);
  std::sort(c.levels.begin(), c.levels.end());
  if (!c.levels.empty()) c.low = c.levels.front();
  if (c.levels.empty()) c.levels = {c.low, c.low + (p.h - c.low) * 0.45};
  return c;
}

// Base, roof, posts, and glass at the sides and the front.
void case_shell(Piece& p, const GlassCase& c, int base, int glass, bool glass_roof) {
  const double x = c.x, y = c.y, t = c.frame, low = c.low, roof = c.roof;
  p.add(base, box(sides(-x, x, -y, y, 0, low), 0.006));
  const double bevel = std::min(0.004, (p.h - roof) * 0.4);
  if (glass_roof) {
    const double rim = std::min(0.025, x * 0.2);
    p.add(glass, box(sides(-x + rim, x - rim, -y + rim, y - rim, roof, p.h), 0));
    for (const double s : {-1.0, 1.0}) {
      p.add(base, box(sides(s > 0 ? x - rim : -x, s > 0 ? x : rim - x, -y, y, roof, p.h), bevel));
      p.add(base, box(sides(-x + rim, x - rim, s > 0 ? y - rim : -y, s > 0 ? y : rim - y, roof, p.h), bevel));
    }
  } else {
    p.add(base, box(sides(-x, x, -y, y, roof, p.h), bevel));
  }
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0})
      p.add(base,
            box(sides(sx > 0 ? x - t : -x, sx > 0 ? x : t - x, sy > 0 ? y - t : -y, sy > 0 ? y : t - y, low - 0.001, roof + 0.001), 0.001));
    p.add(glass, box(sides(sx > 0 ? x - t * 0.6 : -x + t * 0.4, sx > 0 ? x - t * 0.4 : -x + t * 0.6, -y + t, y - t, low, roof), 0));
  }
  p.add(glass, box(sides(-x + t, x - t, -y + t * 0.4, -y + t * 0.6, low, roof), 0));
}

void case_shelves(Piece& p, const GlassCase& c, int surface, double usual) {
  for (std::size_t i = 1; i < c.levels.size(); ++i) {
    double thick = usual;
    for (const FreeSpace& s : p.spaces) {
      if (s.box.max.z < c.levels[i] + 0.001) thick = std::min(thick, std::max(0.002, c.levels[i] - s.box.max.z));
    }
    p.add(surface, box(sides(-c.x + c.frame, c.x - c.frame, -c.y + c.frame, c.y - c.frame, c.levels[i] - thick, c.levels[i]), 0));
  }
}

// China in a space where nothing of the room stands: plates leaning at the back, cups and bowls before them. `k`: pieces so far.
void china_in(Piece& p, const Box& space, int& k) {
  const Vec c = space.center();
  const double plate = std::min({0.11, space.size().z * 0.38, space.size().y * 0.4});
  for (double px = space.min.x + plate * 1.2; px + plate < space.max.x; px += plate * 2.6, ++k) {
    const int china = p.tinted("ceramic", k % 3 == 1 ? mixed(p.accent(), {0.95, 0.95, 0.93}, 0.5) : Color{0.95, 0.95, 0.93});
    if (k % 2 == 0) {
      p.add(china, lathe({{0, 0}, {plate * 0.6, 0}, {plate, 0.012}, {plate, 0.016}, {plate * 0.6, 0.005}, {0, 0.005}}, 28),
            aimed({px, space.max.y - 0.03, space.min.z + plate + 0.001}, unit({0, -1, 0.12})));
    } else {
      p.add(china,
            lathe({{0, 0},
                   {plate * 0.35, 0},
                   {plate * 0.5, plate * 0.2},
                   {plate * 0.66, plate * 0.75},
                   {plate * 0.6, plate * 0.75},
                   {plate * 0.45, plate * 0.25},
                   {0, plate * 0.12}},
                  22),
            moved(px, c.y, space.min.z));
    }
  }
}

// What a shop shows under glass: what the text says, else what such shops do.
void shown_goods(Piece& p) {
  const std::string said = p.said_contents();
  if (said.empty() && p.case_contents().empty()) return;
  const ShelfContents contents = contents_named(said.empty() ? p.case_contents() : said);
  for (const FreeSpace& s : p.spaces) {
    if (contents != nullptr && s.carries && !s.held) contents(p, s.box);
  }
}

// A glass case on a base, framed at its corners; its shelves stand at its spaces' floors. Under a wooden top the back is of wood, too.
void display_case(Piece& p) {
  const bool cabinet = p.count("doors", 0) > 0;
  // What is called a glass case has a body of something else; without it nothing of it would be seen.
  const int base = p.solid_main(cabinet ? "oak" : "lacquer"), glass = p.named("glass");
  const GlassCase c = glass_case_of(p);
  const double x = c.x, y = c.y, t = c.frame, low = c.low, roof = c.roof;
  case_shell(p, c, base, glass, !cabinet);
  if (cabinet) {
    p.add(base, box(sides(-x + t, x - t, y - t, y - t * 0.4, low, roof), 0));
    p.add(base, box(sides(-t * 0.7, t * 0.7, -y, -y + t, low, roof), 0.001));  // where its doors meet
    for (const double s : {-1.0, 1.0})
      handle(p, p.named("brass"), Handle::kKnob, {s * t * 2.4, -y + t * 0.45, low + (roof - low) * 0.5}, 0.02, t * 0.44);
  } else {
    p.add(glass, box(sides(-x + t, x - t, y - t * 0.6, y - t * 0.4, low, roof), 0));
  }
  case_shelves(p, c, cabinet ? base : glass, cabinet ? 0.014 : 0.006);
  if (!p.may_show_contents()) return;
  if (!cabinet) return shown_goods(p);
  int k = 0;
  for (const FreeSpace& s : p.spaces) {
    if (s.carries && !s.held && s.box.size().z >= 0.2 && s.box.size().y >= 0.16) china_in(p, s.box, k);
  }
}

void podium(Piece& p) {
  const int wood = p.main("walnut");
  const double top = std::min(0.16, p.h * 0.14);
  p.add(wood, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, 0.06), 0.008));
  p.add(wood, box(sides(-p.w * 0.42, p.w * 0.42, -p.d * 0.36, p.d * 0.36, 0.05, p.h - top * 0.9), 0.006));
  p.add(p.frame("oak"), box(sides(-p.w * 0.34, p.w * 0.34, -p.d * 0.375, -p.d * 0.34, p.h * 0.2, p.h * 0.7), 0.006));
  const Pose across{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {}};
  p.add(wood, prism({{-p.d / 2, p.h - top}, {p.d / 2, p.h - top}, {p.d / 2, p.h - top * 0.7}, {-p.d / 2, p.h}}, -p.w / 2, p.w / 2), across);
}

void cart(Piece& p) {
  const int metal = p.frame("steel"), board = p.main("steel");
  const double r = std::min({0.05, p.h * 0.08, p.d * 0.15}), t = side_room(p, 0.02);
  wheels(p, r, t);
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const double cx = x * (p.w / 2 - t / 2), cy = y * (p.d / 2 - t / 2);
      p.add(metal, box(sides(cx - t / 2, cx + t / 2, cy - t / 2, cy + t / 2, r * 1.6, p.h), 0.004));
    }
  }
  std::vector<double> levels;
  for (const FreeSpace& s : p.spaces) {
    if (s.carries) levels.push_back(s.box.min.z);
  }
  if (levels.empty()) levels = {r * 1.6 + 0.04, (r * 1.6 + p.h) / 2, p.h - 0.05};
  for (const double z : levels) {
    p.add(board, box(sides(-p.w / 2 + 0.002, p.w / 2 - 0.002, -p.d / 2 + 0.002, p.d / 2 - 0.002, std::max(0.002, z - 0.018), z), 0.003));
  }
  // A bar to push at by both ends, in the width that the shelves leave beside them.
  for (const double x : {-1.0, 1.0}) {
    const double cx = x * (p.w / 2 - t / 2);
    p.add(metal, rod({cx, -p.d / 2 + t / 2, p.h - t * 0.5}, {cx, p.d / 2 - t / 2, p.h - t * 0.5}, t * 0.5, 10));
    p.add(metal, rod({cx, -p.d / 2 + t / 2, p.h * 0.6}, {cx, p.d / 2 - t / 2, p.h * 0.6}, t * 0.35, 8));
  }
  if (p.open_above() == nullptr) {
    for (const double y : {-1.0, 1.0})
      p.add(metal, rod({-p.w / 2 + t, y * (p.d / 2 - t / 2), p.h - 0.012}, {p.w / 2 - t, y * (p.d / 2 - t / 2), p.h - 0.012}, 0.008, 8));
  }
}

void stand(Piece& p) {
  const int wood = p.main("oak");
  const double board = std::min(0.03, p.h * 0.1), foot = std::min(0.03, p.h * 0.1);
  p.add(wood, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, p.h - board, p.h), 0.006));
  const double under = p.clear_below(0);
  if (under > 0) {
    p.legs(p.frame("oak"), p.h - board, 0.04, 0.02);
    return;
  }
  p.add(wood, box(sides(-p.w * 0.45, p.w * 0.45, -p.d * 0.45, p.d * 0.45, 0, foot), 0.005));
  p.add(p.frame("oak"), box(sides(-std::min(0.05, p.w * 0.2), std::min(0.05, p.w * 0.2), -std::min(0.05, p.d * 0.2),
                                  std::min(0.05, p.d * 0.2), foot, p.h - board),
                            0.006));
}

// A limb or a trunk: level ellipses (x, y of the half axes in `halves`, their z unused) round a line from low to high, smooth between.
Mesh limb(std::initializer_list<Vec> middles, std::initializer_list<Vec> halves) {
  const std::vector<Vec> at = curve(middles, 5), half = curve(halves, 5);
  std::vector<std::vector<Vec>> rings;
  for (std::size_t i = 0; i < at.size(); ++i) rings.push_back(ring_at(ellipse({at[i].x, at[i].y}, {half[i].x, half[i].y}, 18), at[i].z));
  return loft(rings);
}

// A figure in a quiet stance on a round plate. Its measures are shares of its height.
void mannequin(Piece& p) {
  const int skin = p.main("plastic"), metal = p.named("chrome");
  const double h = p.h - 0.012, wide = (p.w / 2 - h * 0.016) / h;  // how far out the hands are
  const auto at = [&](double x, double y, double z) { return Vec{x * h, y * h, 0.012 + z * h}; };
  const auto round = [&](double r) { return Vec{r * h, r * h, 0}; };
  const auto oval = [&](double x, double y) { return Vec{x * h, y * h, 0}; };
  p.add(metal, lathe({{0, 0}, {1, 0}, {1, 0.007}, {0.97, 0.012}, {0, 0.012}}, 40), scaled(std::min(p.w / 2, p.d / 2), p.d / 2, 1));
  for (const double s : {-1.0, 1.0}) {
    p.add(skin, limb({at(s * 0.05, 0.012, 0.02), at(s * 0.052, 0.014, 0.06), at(s * 0.052, 0.012, 0.19), at(s * 0.05, 0, 0.28),
                      at(s * 0.053, -0.004, 0.4), at(s * 0.05, 0, 0.5)},
                     {round(0.02), round(0.02), round(0.032), round(0.027), round(0.043), round(0.05)}));
    p.add(skin, ellipsoid(at(s * 0.054, -0.022, 0.017), {h * 0.024, h * 0.06, h * 0.018}, 14, 8));
    const double out = std::max(wide, 0.1), elbow = 0.5 * (out + 0.115);
    p.add(skin, limb({at(s * out, -0.03, 0.475), at(s * (out - 0.003), -0.02, 0.52), at(s * elbow, 0.005, 0.63), at(s * 0.112, 0, 0.76),
                      at(s * 0.104, 0, 0.812)},
                     {round(0.013), round(0.014), round(0.02), round(0.026), round(0.026)}));
    p.add(skin, ellipsoid(at(s * out, -0.034, 0.455), {h * 0.013, h * 0.022, h * 0.036}, 12, 8));
  }
  p.add(skin, limb({at(0, 0, 0.455), at(0, 0, 0.51), at(0, 0, 0.61), at(0, -0.006, 0.72), at(0, 0, 0.8), at(0, 0, 0.835), at(0, 0, 0.86),
                    at(0, -0.004, 0.9)},
                   {oval(0.075, 0.056), oval(0.098, 0.066), oval(0.072, 0.05), oval(0.094, 0.066), oval(0.104, 0.05), oval(0.062, 0.036),
                    oval(0.03, 0.03), oval(0.028, 0.028)}));
  p.add(skin, ellipsoid(at(0, -0.008, 0.936), {h * 0.043, h * 0.053, h * 0.064}, 20, 14));
  p.fit();
}

}  // namespace

void add_shop(Families& to) {
  to["cash_register"] = cash_register;
  to["display_case"] = display_case;
  to["podium"] = podium;
  to["cart"] = cart;
  to["trolley"] = cart;
  to["stand"] = stand;
  to["mannequin"] = mannequin;
}

}  // namespace layoutbox::kit
