// Kitchen and laundry: counters, sinks and machines.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

void counter(Piece& p) {
  const int body = p.main("lacquer"), top = worktop(p);
  const double slab_thick = std::min(0.04, p.h * 0.08), foot = std::min(0.08, p.h * 0.1);
  p.add(top, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, p.h - slab_thick, p.h), 0.005));
  const double under = p.clear_below(0);
  double front = -p.d / 2 + 0.02, back = p.d / 2 - 0.005;
  // A knee room along one side stays open: the body stands behind or before it.
  for (const FreeSpace& s : p.spaces) {
    if (s.box.min.z > 0.01 || under <= 0) continue;
    if (s.box.max.y < 0.35 * p.d)
      front = std::max(front, s.box.max.y);
    else
      back = std::min(back, s.box.min.y);
  }
  if (back - front < 0.05) {
    p.legs(p.frame("steel"), p.h - slab_thick, 0.05, 0.02);
    return;
  }
  p.add(p.named("black_plastic"), box(sides(-p.w / 2 + 0.02, p.w / 2 - 0.02, front + 0.04, back - 0.01, 0, foot), 0));
  Carcass c{sides(-p.w / 2 + 0.004, p.w / 2 - 0.004, front - 0.016, back, foot, p.h - slab_thick), body, body, p.part("handles", "steel")};
  c.drawers = p.count("drawers", 0);
  c.doors = p.count("doors", 0);
  carcass(p, c);
}

// A tall or low machine with one or two doors and bar handles.
void fridge(Piece& p) {
  const int steel = p.main("steel"), bar = p.named("chrome");
  machine_body(p, steel, sides(-p.w / 2, p.w / 2, -p.d / 2 + 0.075, p.d / 2, 0, p.h));
  const double low = std::min(0.06, p.h * 0.08), split = p.h > 1.2 ? low + (p.h - low) * 0.36 : p.h;
  if (p.says("open")) {
    open_inside(p, low + 0.04, p.h - 0.04, -p.d / 2 + 0.075, true);
    return swung_door(p, steel, low, p.h, -p.d / 2 + 0.075, p.w - 0.004);
  }
  const bool wide = p.w > 0.85;
  const auto door = [&](double x0, double x1, double z0, double z1, bool handle_right) {
    p.add(steel, rounded_box(sides(x0 + 0.002, x1 - 0.002, -p.d / 2 + 0.03, -p.d / 2 + 0.08, z0 + 0.003, z1 - 0.003), 0.01, 2));
    const double x = handle_right ? x1 - 0.05 : x0 + 0.05, len = std::min(0.5, (z1 - z0) * 0.6),
                 z = z0 > 0.3 ? z0 + len * 0.6 + 0.03 : z1 - len * 0.6;
    handle(p, bar, Handle::kVertical, {x, -p.d / 2 + 0.03, z}, len, 0.03);
  };
  if (wide) {
    door(-p.w / 2, 0, low, p.h, true);
    door(0, p.w / 2, low, p.h, false);
  } else {
    door(-p.w / 2, p.w / 2, low, split, false);
    if (split < p.h) door(-p.w / 2, p.w / 2, split, p.h, false);
  }
}

void oven_front(Piece& p, double z0, double z1, double face) {
  const int dark = p.named("screen"), bar = p.named("steel");
  p.add(dark, box(sides(-p.w / 2 + 0.04, p.w / 2 - 0.04, face - 0.012, face + 0.01, z0 + 0.02, z1 - 0.09), 0.004));
  handle(p, bar, Handle::kHorizontal, {0, face, z1 - 0.045}, p.w * 0.75, face + p.d / 2);
}

void burners(Piece& p, double level, double room) {
  const int black = p.named("black_metal"), glass = p.named("screen");
  p.add(glass, box(sides(-p.w / 2 + 0.02, p.w / 2 - 0.02, -p.d / 2 + 0.04, p.d / 2 - 0.04, level, level + room * 0.4), 0.002));
  for (const double x : {-0.24, 0.24}) {
    for (const double y : {-0.2, 0.22}) {
      const double r = std::min(p.w, p.d) * (x * y > 0 ? 0.16 : 0.12);
      p.add(black, lathe({{r * 0.86, 0}, {r, 0}, {r, room * 0.6}, {r * 0.86, room * 0.6}, {r * 0.86, 0}}, 28),
            moved(x * p.w, y * p.d, level + room * 0.4));
    }
  }
}

// A glass plate with rings, let into a counter.
void cooktop(Piece& p) {
  const double plate = std::max(p.h * 0.35, p.h - 0.012);
  burners(p, plate, p.h - plate);
  p.add(p.main("black_metal"), box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, plate), 0.002));
  for (int i = 0; i < 4; ++i) dial(p, p.named("steel"), {p.w * (-0.12 + 0.08 * i), -p.d / 2 + 0.006, plate * 0.6}, plate * 0.28, 0.006);
}

void stove(Piece& p) {
  if (p.h < 0.3) return cooktop(p);
  const int steel = p.main("steel"), black = p.named("black_plastic");
  const double room = 0.02, top = p.h - room, face = -p.d / 2 + 0.035;
  machine_body(p, steel, sides(-p.w / 2, p.w / 2, face, p.d / 2, 0, top), 0.006);
  oven_front(p, std::min(0.15, top * 0.2), top - 0.1, face);
  const int knobs = 5;
  for (int i = 0; i < knobs; ++i) dial(p, black, {-p.w * 0.36 + p.w * 0.72 * i / (knobs - 1), face + 0.002, top - 0.055}, 0.02, 0.025);
  burners(p, top, room);
}

// In a tall unit: a door below, the oven (or two) at hand's height, a door above.
void oven_tower(Piece& p) {
  const int body = p.part("fronts", "white"), bar = p.part("handles", "steel"), steel = p.main("steel");
  const double face = -p.d / 2 + 0.035, gap = 0.003, front = face - 0.018;
  p.add(body, box(sides(-p.w / 2, p.w / 2, face, p.d / 2, 0, p.h), 0.004));
  const auto panel = [&](int surface, double z0, double z1) {
    p.add(surface, box(sides(-p.w / 2 + gap, p.w / 2 - gap, front, face, z0 + gap, z1 - gap), 0.003));
  };
  const auto door = [&](double z0, double z1, double grip) {
    panel(body, z0, z1);
    handle(p, bar, Handle::kVertical, {p.w / 2 - 0.06, front, grip}, 0.16, front + p.d / 2);
  };
  constexpr double kPlinth = 0.08, kOven = 0.6, kSliver = 0.15;
  const int ovens = p.says("double") ? 2 : 1;
  const double low = ovens == 2 ? p.h * 0.2 : p.h * 0.32, each = std::min(kOven, (p.h - low) / ovens), high = low + ovens * each;
  door(kPlinth, low, low - 0.14);
  for (double z = low; z < high - kSliver; z += each) {
    panel(steel, z, z + each);
    oven_front(p, z, z + each - 0.06, front);
  }
  if (high + kSliver < p.h) door(high, p.h, high + 0.14);
}

void oven(Piece& p) {
  constexpr double kTower = 1.3;
  if (p.h > kTower && !p.says("open")) return oven_tower(p);
  const int steel = p.main("steel"), face_surface = p.named("black_plastic");
  const double face = -p.d / 2 + std::min(0.035, p.d * 0.1);
  p.add(steel, box(sides(-p.w / 2, p.w / 2, face, p.d / 2, 0, p.h), 0.006));
  if (p.says("open")) {
    open_inside(p, p.h * 0.06, p.h * 0.8, face, false);
    dropped_door(p, face_surface, p.h * 0.02, p.h * 0.78, face, false);
  } else {
    oven_front(p, 0, p.h * 0.82, face);
  }
  p.add(p.named("lit_screen"), box(sides(-0.05, 0.05, face - 0.003, face + 0.01, p.h * 0.88, p.h * 0.94), 0.001));
  for (const double s : {-1.0, 1.0}) dial(p, face_surface, {s * p.w * 0.32, face + 0.002, p.h * 0.9}, std::min(0.02, p.h * 0.04), 0.02);
}

void dishwasher(Piece& p) {
  const int body = p.main("steel");
  const double face = -p.d / 2 + 0.03;
  machine_body(p, body, sides(-p.w / 2, p.w / 2, face + 0.02, p.d / 2, 0, p.h), 0.006);
  if (p.says("open")) {
    open_inside(p, p.h * 0.12, p.h - 0.03, face + 0.02, false);
    return dropped_door(p, body, p.h * 0.1, p.h * 0.86, face + 0.02, true);
  }
  p.add(body, box(sides(-p.w / 2 + 0.003, p.w / 2 - 0.003, face, face + 0.022, p.h * 0.1, p.h - 0.003), 0.005));
  handle(p, p.named("chrome"), Handle::kHorizontal, {0, face, p.h * 0.86}, p.w * 0.7, 0.03);
  p.add(p.named("screen"), box(sides(-p.w * 0.15, p.w * 0.15, face - 0.002, face + 0.004, p.h * 0.93, p.h * 0.96), 0));
}

void washing_machine(Piece& p) {
  const int body = p.main("painted_metal"), chrome = p.named("chrome"), glass = p.named("screen"), dark = p.named("grey_plastic");
  const double face = -p.d / 2 + 0.035, r = std::min(p.w * 0.34, p.h * 0.24), z = p.h * 0.45;
  machine_body(p, body, sides(-p.w / 2, p.w / 2, face, p.d / 2, 0, p.h), 0.012);
  if (p.word("kind", "") == "dryer") {  // a closed door in the body's colour, and the grille of its heat exchanger
    p.add(body, lathe({{0, 0}, {r * 1.08, 0}, {r * 1.08, 0.02}, {r * 0.9, 0.034}, {0, 0.034}}, 36),
          aimed({0, face + 0.002, z}, {0, -1, 0}));
    p.add(chrome, lathe({{r * 0.6, 0.02}, {r * 0.66, 0.02}, {r * 0.66, 0.036}, {r * 0.6, 0.036}, {r * 0.6, 0.02}}, 36),
          aimed({0, face + 0.002, z}, {0, -1, 0}));
    for (int i = 0; i < 5; ++i)
      p.add(dark, box(sides(p.w * 0.2, p.w * 0.42, face - 0.003, face + 0.004, p.h * (0.07 + 0.016 * i), p.h * (0.078 + 0.016 * i)), 0));
    dial(p, chrome, {0, face + 0.001, p.h * 0.91}, std::min(0.035, p.h * 0.04), 0.02);
    p.add(p.named("lit_screen"), box(sides(p.w * 0.18, p.w * 0.4, face - 0.003, face + 0.004, p.h * 0.885, p.h * 0.935), 0.001));
    return;
  }
  p.add(chrome, lathe({{r * 0.76, 0}, {r, 0}, {r, 0.02}, {r * 0.9, 0.033}, {r * 0.76, 0.033}, {r * 0.76, 0}}, 36),
        aimed({0, face + 0.002, z}, {0, -1, 0}));
  p.add(glass, lathe({{0, 0}, {r * 0.77, 0}, {r * 0.77, 0.02}, {r * 0.4, 0.037}, {0, 0.037}}, 32), aimed({0, face + 0.002, z}, {0, -1, 0}));
  p.add(dark, box(sides(-p.w * 0.44, -p.w * 0.12, face - 0.004, face + 0.004, p.h * 0.87, p.h * 0.95), 0.002));
  dial(p, chrome, {p.w * 0.05, face + 0.001, p.h * 0.91}, std::min(0.03, p.h * 0.035), 0.02);
  p.add(p.named("lit_screen"), box(sides(p.w * 0.18, p.w * 0.4, face - 0.003, face + 0.004, p.h * 0.885, p.h * 0.935), 0.001));
}

// A swan neck that ends `reach` before its foot, and two handles.
void tap(Piece& p, double x, double y, double z, double tall, double reach) {
  const int chrome = p.named("chrome");
  const double r = std::min(0.012, tall * 0.12);
  p.add(chrome, cylinder({x, y, z}, r * 2, std::min(0.02, tall * 0.2), 16));
  p.add(
      chrome,
      tube(curve({{x, y, z + 0.005}, {x, y, z + tall * 0.7}, {x, y - reach * 0.4, z + tall - r * 1.2}, {x, y - reach, z + tall * 0.68}}, 6),
           r, 10));
  p.add(chrome, ellipsoid({x, y - reach * 0.4, z + tall - r}, {r, r, r}, 12, 6));
  for (const double s : {-1.0, 1.0}) {
    p.add(chrome, cylinder({x + s * 0.08, y, z}, r * 1.5, std::min(0.035, tall * 0.35), 14));
    p.add(chrome, rod({x + s * 0.08, y, z + std::min(0.04, tall * 0.38)}, {x + s * (0.08 + r * 3.5), y, z + std::min(0.046, tall * 0.45)},
                      r * 0.6, 8));
  }
}

void urinal(Piece& p) {
  const int ceramic = p.main("ceramic");
  p.add(ceramic, rounded_box(sides(-p.w * 0.42, p.w * 0.42, p.d / 2 - std::min(0.08, p.d * 0.3), p.d / 2, p.h * 0.1, p.h), 0.03, 3));
  p.add(ceramic, rounded_box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, p.h * 0.34), std::min(p.w, p.d) * 0.3, 4));
  for (const double s : {-1.0, 1.0})
    p.add(ceramic, rounded_box(sides(s > 0 ? p.w * 0.36 : -p.w / 2, s > 0 ? p.w / 2 : -p.w * 0.36, -p.d * 0.1, p.d / 2 - 0.01, p.h * 0.15,
                                     p.h * 0.97),
                               0.03, 3));
  p.add(p.named("chrome"), cylinder({0, p.d / 2 - 0.04, p.h - 0.012}, 0.02, 0.012, 14));
}

// A bowl let into a slab: the slab's ring round it at `rim`, walls and floor of the bowl below.
void basin(Piece& p, int surface, const Box& in, const Box& around, double rim, double slab_thick, double wall, bool bottom = true) {
  const double low = rim - slab_thick, e = 0.003;
  p.add(surface, box(sides(around.min.x, in.min.x, around.min.y, around.max.y, low, rim), e));
  p.add(surface, box(sides(in.max.x, around.max.x, around.min.y, around.max.y, low, rim), e));
  p.add(surface, box(sides(in.min.x - e, in.max.x + e, around.min.y, in.min.y, low, rim), e));
  p.add(surface, box(sides(in.min.x - e, in.max.x + e, in.max.y, around.max.y, low, rim), e));
  if (!bottom) return;
  if (low > in.min.z) {
    const Box out = {{in.min.x - wall, in.min.y - wall, in.min.z - wall}, {in.max.x + wall, in.max.y + wall, low + 0.002}};
    p.add(surface, box(sides(out.min.x, in.min.x, out.min.y, out.max.y, out.min.z, out.max.z), e));
    p.add(surface, box(sides(in.max.x, out.max.x, out.min.y, out.max.y, out.min.z, out.max.z), e));
    p.add(surface, box(sides(in.min.x - e, in.max.x + e, out.min.y, in.min.y, out.min.z, out.max.z), e));
    p.add(surface, box(sides(in.min.x - e, in.max.x + e, in.max.y, out.max.y, out.min.z, out.max.z), e));
  }
  p.add(surface, box(sides(in.min.x - e, in.max.x + e, in.min.y - e, in.max.y + e, in.min.z - wall, in.min.z), 0.001));
  p.add(p.named("chrome"), lathe({{0, 0}, {0.022, 0}, {0.022, 0.0008}, {0, 0.0008}}, 16), moved(in.center().x, in.center().y, in.min.z));
}

// A wash basin or kitchen sink: bowls in a slab, on a cabinet, a pedestal or a wall. A bowl is a space with a floor below the others'
// (worktops beside it); where no other says how high the slab lies and the bowl reaches far above its floor, the tap takes the rest.
struct Sink {
  bool steel = false, cabinet = false;
  int surface = 0;
  std::vector<Box> bowls;
  double floor = 0, worktop = 0, rim = 0;
};

Sink sink_of(Piece& p) {
  Sink s;
  s.steel = p.word("kind", "") == "sink";  // a kitchen's
  s.surface = s.steel ? p.named("steel") : p.main("ceramic");
  s.floor = p.h;
  for (const FreeSpace& space : p.spaces) s.floor = space.carries ? std::min(s.floor, space.box.min.z) : s.floor;
  for (const FreeSpace& space : p.spaces) {
    if (!space.carries) continue;
    if (space.box.min.z < s.floor + 0.02)
      s.bowls.push_back(space.box);
    else
      s.worktop = space.box.min.z;
  }
  if (s.bowls.empty()) s.bowls.push_back(sides(-p.w * 0.36, p.w * 0.36, -p.d * 0.36, p.d * 0.2, p.h - std::min(0.14, p.h * 0.5), p.h));
  const double deep = p.h - s.bowls.front().min.z;
  s.rim = s.worktop > 0 ? s.worktop : deep > 0.18 ? p.h - deep + 0.13 : p.h;
  s.cabinet = p.mount() != Mount::kWall && (p.w > 0.5 || p.says("vanity") || s.steel) && p.h > 0.5;
  return s;
}

// A steel bowl in a worktop of another stuff, from x0 to x1: a sheet lies on it round the bowl, beside it the grooves of the drainer.
void steel_bowl(Piece& p, const Sink& s, const Box& in, double x0, double x1, double wall) {
  const double y = p.d / 2;
  const int top = worktop(p);
  basin(p, top, {{in.min.x, in.min.y, s.rim - 0.038}, in.max}, sides(x0, x1, -y, y, 0, 0), s.rim - 0.002, 0.036, wall, false);
  basin(p, s.surface, in,
        sides(std::max(x0, in.min.x - 0.025), std::min(x1, in.max.x + 0.025), in.min.y - 0.025, std::min(y, in.max.y + 0.08), 0, 0), s.rim,
        0.003, wall);
  for (int k = 0; k < 6 && s.worktop > 0; ++k) {
    const double gx = in.max.x + 0.07 + 0.045 * k;
    if (gx < x1 - 0.03) p.add(s.surface, box(sides(gx, gx + 0.012, in.min.y, in.max.y, s.rim - 0.003, s.rim), 0.001));
  }
}

// One of its bowls with the slab to half way to the next one, and its tap.
void add_bowl(Piece& p, const Sink& s, std::size_t i) {
  const auto middle = [&](std::size_t k) { return (s.bowls[k].max.x + s.bowls[k + 1].min.x) / 2; };
  const Box& in = s.bowls[i];
  const double x = p.w / 2, y = p.d / 2, tall = p.h - s.rim;
  const double x0 = i == 0 ? -x : middle(i - 1), x1 = i + 1 == s.bowls.size() ? x : middle(i);
  const double thick = s.cabinet ? std::min(0.04, s.rim - in.min.z) : s.rim - in.min.z;
  const double wall = std::min({0.02, in.min.z, in.min.x - x0, x1 - in.max.x, in.min.y + y, y - in.max.y}) * 0.9;
  if (s.steel)
    steel_bowl(p, s, in, x0, x1, wall);
  else
    basin(p, s.surface, in, sides(x0, x1, -y, y, 0, 0), s.rim, std::max(thick, 0.004), std::max(wall, 0.004));
  if (tall > 0) tap(p, in.center().x, (in.max.y + y) / 2, s.rim - 0.002, tall + 0.002, std::min(0.03, (y - in.max.y) * 0.4));
}

// The sheets of its cabinet stand round the bowls.
void sink_cabinet(Piece& p, const Sink& sink) {
  const double x = p.w / 2, y = p.d / 2;
  const int wood = sink.steel ? p.main("lacquer") : p.frame("oak");
  const double foot = std::min(0.1, sink.rim * 0.12), top = sink.rim - 0.036, t = std::min(0.016, sink.bowls.front().min.x + x - 0.006),
               front = -y + 0.045;
  p.add(p.named("black_plastic"), box(sides(-x + 0.03, x - 0.03, -y + 0.08, y - 0.002, 0, foot), 0));
  for (const double s : {-1.0, 1.0})
    p.add(wood, box(sides(s > 0 ? x - 0.006 - t : -x + 0.006, s > 0 ? x - 0.006 : -x + 0.006 + t, front, y - 0.003, foot, top), 0.002));
  p.add(wood, box(sides(-x + 0.006, x - 0.006, y - 0.012, y - 0.003, foot, top), 0.001));
  p.add(wood, box(sides(-x + 0.006, x - 0.006, front, y - 0.004, foot, foot + 0.018), 0.001));
  Fronts f{-x + 0.01, x - 0.01, foot + 0.004, top - 0.006, -y + 0.027};
  f.thick = 0.018;
  f.out = 0.022;
  f.doors = true;
  f.columns = std::max(1, static_cast<int>(std::lround(p.w / 0.45)));
  fronts(p, wood, p.part("handles", "steel"), f);
}

void sink(Piece& p) {
  if (p.category() == "urinal") return urinal(p);
  const Sink s = sink_of(p);
  const double x = p.w / 2, y = p.d / 2, floor = s.floor;
  for (std::size_t i = 0; i < s.bowls.size(); ++i) add_bowl(p, s, i);
  if (p.mount() == Mount::kWall) {
    if (floor > 0.01)
      p.add(s.surface, rounded_box(sides(-x * 0.8, x * 0.8, -y * 0.7, y, 0, floor - 0.003), std::min(0.03, floor * 0.4), 3));
    return;
  }
  if (floor < 0.15) {
    if (floor > 0.004) p.add(s.surface, box(sides(-x, x, -y, y, 0, floor), 0.006));
    return;
  }
  if (s.cabinet) return sink_cabinet(p, s);
  p.add(s.surface, lathe({{0, 0}, {0.13, 0}, {0.12, 0.03}, {0.075, 0.25}, {0.08, floor * 0.7}, {0.14, floor}, {0, floor}}, 24),
        moved(0, p.d * 0.1, 0));
}

}  // namespace

void add_kitchen(Families& to) {
  to["counter"] = counter;
  to["fridge"] = fridge;
  to["stove"] = stove;
  to["oven"] = oven;
  to["dishwasher"] = dishwasher;
  to["washing_machine"] = washing_machine;
  to["sink"] = sink;
}

}  // namespace layoutbox::kit
