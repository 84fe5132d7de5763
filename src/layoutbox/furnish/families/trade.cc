// What traders and hobbyists have: cooled show cases, stepped stands, model railways.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// An upright cooler behind glass doors, its shelves at its spaces' floors and lit from above.
void display_fridge(Piece& p) {
  const int body = p.solid_main("white"), dark = p.named("black_plastic"), glass = p.named("glass"), shelf = p.named("steel");
  double low = p.h * 0.15, high = p.h * 0.88, side = 0.05, back = p.d / 2 - 0.05;
  for (const FreeSpace& s : p.spaces) {
    low = &s == &p.spaces.front() ? s.box.min.z : std::min(low, s.box.min.z);
    high = &s == &p.spaces.front() ? s.box.max.z : std::max(high, s.box.max.z);
    side = std::min(side, s.box.min.x + p.w / 2);
    back = s.box.max.y;
  }
  const double front = -p.d / 2 + 0.03;
  p.add(body, box(sides(-p.w / 2, p.w / 2, front, p.d / 2, 0.05, low - 0.012), 0.006));
  p.add(dark, box(sides(-p.w / 2 + 0.03, p.w / 2 - 0.03, front + 0.05, p.d / 2 - 0.03, 0, 0.05), 0));
  p.add(body, box(sides(-p.w / 2, p.w / 2, front, p.d / 2, high, p.h), 0.006));
  p.add(p.named("lit_screen"), box(sides(-p.w / 2 + 0.04, p.w / 2 - 0.04, front - 0.006, front, high + 0.02, p.h - 0.03), 0));
  p.add(body, box(sides(-p.w / 2, p.w / 2, back, p.d / 2, low - 0.013, high + 0.001), 0));
  for (const double s : {-1.0, 1.0})
    p.add(body,
          box(sides(s > 0 ? p.w / 2 - side : -p.w / 2, s > 0 ? p.w / 2 : -p.w / 2 + side, front, back, low - 0.013, high + 0.001), 0));
  const ShelfContents contents = contents_of(p);
  for (const FreeSpace& s : p.spaces) {
    p.add(shelf, box(sides(s.box.min.x, s.box.max.x, s.box.min.y, s.box.max.y, s.box.min.z - 0.011, s.box.min.z), 0));
    if (p.may_show_contents() && !s.held && contents != nullptr) contents(p, s.box);
  }
  const int doors = std::max(1, static_cast<int>(std::lround(p.w / 0.65)));
  for (int i = 0; i < doors; ++i) {
    const double x0 = -p.w / 2 + p.w * i / doors + 0.003, x1 = -p.w / 2 + p.w * (i + 1) / doors - 0.003, z0 = low - 0.01, z1 = high;
    const double rim = 0.035;
    p.add(glass, box(sides(x0 + rim, x1 - rim, front - 0.006, front - 0.002, z0 + rim, z1 - rim), 0));
    for (const double x : {x0, x1 - rim}) p.add(dark, box(sides(x, x + rim, front - 0.012, front, z0, z1), 0.002));
    for (const double z : {z0, z1 - rim}) p.add(dark, box(sides(x0 + rim, x1 - rim, front - 0.012, front, z, z + rim), 0.002));
    const double at = i % 2 == 0 ? x1 - rim / 2 : x0 + rim / 2;
    handle(p, shelf, Handle::kVertical, {at, front - 0.012, (z0 + z1) / 2}, std::min(0.5, (z1 - z0) * 0.5), front - 0.012 + p.d / 2);
  }
}

// Boards like a stair, one for each of its spaces, on stepped sides.
void stepped_stand(Piece& p) {
  const int wood = p.main("pine");
  const double thick = 0.024, wall = 0.02, back = p.d / 2 - 0.03;
  std::vector<Vec2> outline{{back, 0}};
  for (auto s = p.spaces.rbegin(); s != p.spaces.rend(); ++s) {
    const double y1 = s == p.spaces.rbegin() ? back : s->box.max.y;
    outline.push_back({y1, s->box.min.z - thick - 0.002});
    outline.push_back({s->box.min.y + 0.01, s->box.min.z - thick - 0.002});
  }
  outline.push_back({p.spaces.front().box.min.y + 0.01, 0});
  const Pose across{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {}};
  for (const double s : {-1.0, 1.0})
    p.add(wood, prism(outline, s > 0 ? p.w / 2 - wall - 0.01 : -p.w / 2 + 0.01, s > 0 ? p.w / 2 - 0.01 : -p.w / 2 + wall + 0.01), across);
  const ShelfContents contents = contents_of(p);
  for (const FreeSpace& s : p.spaces) {
    const double z = s.box.min.z - 0.001;
    p.add(wood, box(sides(-p.w / 2, p.w / 2, s.box.min.y, s.box.max.y, z - thick, z), 0.003));
    if (p.may_show_contents() && !s.held && contents != nullptr) {
      Box room = s.box;
      room.max.z = std::min(room.max.z, room.min.z + 0.5);
      contents(p, room);
    }
  }
  for (const double s : {-1.0, 1.0})
    p.add(wood, box(sides(s > 0 ? p.w / 2 - 0.04 : -p.w / 2, s > 0 ? p.w / 2 : -p.w / 2 + 0.04, back, p.d / 2, 0, p.h), 0.003));
  p.add(wood, box(sides(-p.w / 2 + 0.04, p.w / 2 - 0.04, back, p.d / 2, p.h - 0.06, p.h), 0.003));
}

// The outline of a layout's boards: a rectangle, or an L or U about the place where one stands.
std::vector<Vec2> boards_of(const Piece& p) {
  const double x = p.w / 2, y = p.d / 2;
  if (p.spaces.empty()) return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  const Box& in = p.spaces.front().box;
  if (in.min.x < -x + 0.01) return {{in.max.x, -y}, {x, -y}, {x, y}, {-x, y}, {-x, in.max.y}, {in.max.x, in.max.y}};
  return {{-x, -y}, {in.min.x, -y}, {in.min.x, in.max.y}, {in.max.x, in.max.y}, {in.max.x, -y}, {x, -y}, {x, y}, {-x, y}};
}

// The same as boards: one, or one along the back and one or two arms.
std::vector<Box> parts_of(const Piece& p) {
  const double x = p.w / 2, y = p.d / 2;
  if (p.spaces.empty()) return {sides(-x, x, -y, y, 0, 0)};
  const Box& in = p.spaces.front().box;
  std::vector<Box> parts{sides(-x, x, in.max.y, y, 0, 0), sides(in.max.x, x, -y, in.max.y, 0, 0)};
  if (in.min.x > -x + 0.01) parts.push_back(sides(-x, in.min.x, -y, in.max.y, 0, 0));
  return parts;
}

// An outline of right angles, so much farther in.
std::vector<Vec2> inset(const std::vector<Vec2>& outline, double by) {
  std::vector<Vec2> out;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = outline[(i + n - 1) % n], &b = outline[i], &c = outline[(i + 1) % n];
    const auto inward = [](const Vec2& from, const Vec2& to) {
      const double l = std::hypot(to.x - from.x, to.y - from.y);
      return Vec2{-(to.y - from.y) / l, (to.x - from.x) / l};
    };
    const Vec2 one = inward(a, b), other = inward(b, c);
    out.push_back({b.x + by * (one.x + other.x), b.y + by * (one.y + other.y)});
  }
  return out;
}

// A closed path with its corners rounded.
std::vector<Vec> rounded_path(const std::vector<Vec2>& corners, double radius, double z) {
  std::vector<Vec> path;
  const std::size_t n = corners.size();
  constexpr int kSteps = 5;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = corners[(i + n - 1) % n], &b = corners[i], &c = corners[(i + 1) % n];
    // Round where the layout goes in it must not reach into the place where one stands.
    const bool inwards = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x) < 0;
    const double round = inwards ? radius * 0.25 : radius;
    const auto towards = [&](const Vec2& to) {
      const double l = std::hypot(to.x - b.x, to.y - b.y), r = std::min(round, l * 0.48);
      return Vec2{b.x + (to.x - b.x) / l * r, b.y + (to.y - b.y) / l * r};
    };
    const Vec2 in = towards(a), out = towards(c);
    for (int k = 0; k <= kSteps; ++k) {
      const double t = double(k) / kSteps, s = 1 - t;
      path.push_back({s * s * in.x + 2 * s * t * b.x + t * t * out.x, s * s * in.y + 2 * s * t * b.y + t * t * out.y, z});
    }
  }
  return path;
}

// A locomotive and its coaches, one after the other along a path.
void train(Piece& p, const std::vector<Vec>& path, std::size_t from, int coaches, const Color& color) {
  constexpr double kLong = 0.17, kGap = 0.02;
  double before = 0;
  int placed = 0;
  for (std::size_t i = from; placed <= coaches && i < from + path.size(); ++i) {
    const Vec a = path[i % path.size()], b = path[(i + 1) % path.size()];
    const Vec way = b - a;
    const double l = length(way);
    if (l < 1e-6) continue;
    while (placed <= coaches && before + kLong <= l) {
      const Vec at = a + way * ((before + kLong / 2) / l);
      const Pose pose = moved(at.x, at.y, at.z) * turned_z(std::atan2(way.y, way.x) * 180 / kPi);
      const int paint = placed == 0 ? p.named("black_metal") : p.tinted("lacquer", color);
      p.add(paint, box(sides(-kLong / 2, kLong / 2, -0.026, 0.026, 0.012, placed == 0 ? 0.05 : 0.07), 0.008), pose);
      p.add(placed == 0 ? p.tinted("lacquer", color) : p.named("grey_plastic"),
            box(sides(placed == 0 ? kLong * 0.1 : -kLong / 2, kLong / 2, -0.024, 0.024, placed == 0 ? 0.05 : 0.07,
                      placed == 0 ? 0.088 : 0.078),
                0.006),
            pose);
      before += kLong + kGap;
      ++placed;
    }
    before = std::max(0.0, before - l);
  }
}

void scenery(Piece& p, const std::vector<Vec>& path, double z) {
  static constexpr Color kHouses[] = {{0.86, 0.78, 0.62}, {0.72, 0.42, 0.34}, {0.80, 0.82, 0.80}};
  const int roof = p.tinted("plastic", {0.52, 0.22, 0.16}), trunk = p.named("walnut"), leaves = p.tinted("leaf", {0.18, 0.38, 0.18});
  // A hill in the back right corner, which the top of the whole is.
  const double x = p.w / 2, y = p.d / 2;
  const double arm = p.spaces.empty() ? std::min(p.w, p.d) : std::min(x - p.spaces.front().box.max.x, y - p.spaces.front().box.max.y);
  const double hill = std::min({0.34, p.d * 0.2, p.w * 0.2, arm * 0.5});
  p.add(p.tinted("leaf", {0.36, 0.46, 0.26}), cone({x - hill - 0.02, y - hill - 0.02, z}, hill, hill * 0.25, p.h - z, 14));
  for (std::size_t i = 0; i < path.size(); i += 3) {
    const Vec a = path[i], b = path[(i + 1) % path.size()], way = unit(b - a);
    const Vec at = (a + b) * 0.5 + Vec{-way.y, way.x, 0} * 0.13;
    constexpr double kOff = 0.1;  // from the edge where one stands
    const auto near = [&](const FreeSpace& s) {
      return at.x > s.box.min.x - kOff && at.x < s.box.max.x + kOff && at.y > s.box.min.y - kOff && at.y < s.box.max.y + kOff;
    };
    if (std::ranges::any_of(p.spaces, near)) continue;
    if (std::hypot(at.x - (x - hill), at.y - (y - hill)) < hill * 1.2) continue;
    if (i % 2 == 0) {
      const Pose pose = moved(at.x, at.y, z) * turned_z(std::atan2(way.y, way.x) * 180 / kPi);
      p.add(p.tinted("plaster", kHouses[(i / 6) % 3]), box(sides(-0.05, 0.05, -0.035, 0.035, 0, 0.06), 0), pose);
      p.add(roof, prism({{-0.042, 0.06}, {0.042, 0.06}, {0, 0.1}}, -0.055, 0.055), pose * Pose{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {}});
    } else {
      p.add(trunk, cylinder({at.x, at.y, z}, 0.006, 0.03, 6));
      p.add(leaves, cone({at.x, at.y, z + 0.025}, 0.035, 0.002, 0.1, 8));
    }
  }
}

// Boards on legs, green, with a double line of track all the way round, two trains, houses, trees and a hill.
void model_railway(Piece& p) {
  const std::vector<Vec2> outline = boards_of(p);
  const double rise = std::min(0.26, p.h * 0.24), z = p.h - rise, board = 0.06, t = 0.05;
  const int wood = p.main("oak"), grass = p.tinted("leaf", {0.34, 0.50, 0.26});
  for (const Box& part : parts_of(p)) {
    p.add(wood, box({{part.min.x, part.min.y, z - board}, {part.max.x, part.max.y, z}}, 0));
    p.add(grass, box({{part.min.x, part.min.y, z - 0.001}, {part.max.x, part.max.y, z + 0.004}}, 0));
  }
  for (const Vec2& at : inset(outline, t))
    p.add(p.frame("oak"), box(sides(at.x - t / 2, at.x + t / 2, at.y - t / 2, at.y + t / 2, 0, z - board), 0.003));
  const int rail = p.named("steel"), ballast = p.tinted("stone", {0.46, 0.43, 0.40}), sleeper = p.named("walnut");
  constexpr Color kTrains[] = {{0.66, 0.12, 0.12}, {0.14, 0.30, 0.52}};
  int k = 0;
  for (const double off : {0.1, 0.2}) {
    const std::vector<Vec> bed = rounded_path(inset(outline, off), 0.22, z + 0.006);
    for (std::size_t i = 0; i < bed.size(); ++i) {
      const Vec a = bed[i], b = bed[(i + 1) % bed.size()];
      if (length(b - a) < 1e-4) continue;
      p.add(ballast, beam(a, b, {0.075, 0.008}));
      const Vec way = unit(b - a), aside = Vec{-way.y, way.x, 0};
      for (const double s : {-0.018, 0.018})
        p.add(rail, beam(a + aside * s + Vec{0, 0, 0.008}, b + aside * s + Vec{0, 0, 0.008}, {0.004, 0.006}));
      const int n = std::max(1, static_cast<int>(length(b - a) / (0.02 * (p.w + p.d))));
      for (int j = 0; j < n; ++j) {
        const Vec at = a + (b - a) * ((j + 0.5) / n) + Vec{0, 0, 0.005};
        p.add(sleeper, beam(at - aside * 0.028, at + aside * 0.028, {0.014, 0.004}));
      }
    }
    train(p, bed, k == 0 ? bed.size() / 3 : 5, k == 0 ? 4 : 3, kTrains[k]);
    ++k;
  }
  scenery(p, rounded_path(inset(outline, 0.28), 0.2, z), z + 0.004);
}

}  // namespace

void add_trade(Families& to) {
  to["display_fridge"] = display_fridge;
  to["stepped_stand"] = stepped_stand;
  to["model_railway"] = model_railway;
}

}  // namespace layoutbox::kit
