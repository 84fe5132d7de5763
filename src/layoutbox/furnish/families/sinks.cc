// Sinks, taps and what water runs into.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

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
  bool steel = false, cabinet = false, apron = false;
  int surface = 0;
  std::vector<Box> bowls;
  double floor = 0, worktop = 0, rim = 0;
};

Sink sink_of(Piece& p) {
  Sink s;
  s.steel = p.word("kind", "") == "sink";  // a kitchen's
  s.apron = s.steel && (p.says("apron") || p.says("farmhouse") || p.says("belfast") || p.says("butler") || p.is_style("farmhouse"));
  s.surface = s.apron ? p.named("ceramic") : s.steel ? p.named("steel") : p.main("ceramic");
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

// The bowl's own front, of the same stuff, which stands before the doors below it.
void apron_front(Piece& p, const Sink& s) {
  constexpr double kRim = 0.03, kDeep = 0.24;
  const Box& first = s.bowls.front();
  const Box& last = s.bowls.back();
  const double y = -p.d / 2, x0 = std::max(-p.w / 2, first.min.x - kRim), x1 = std::min(p.w / 2, last.max.x + kRim);
  p.add(s.surface, rounded_box(sides(x0, x1, y, first.min.y, std::max(0.1, s.rim - kDeep), s.rim + 0.004), 0.012, 3));
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
  if (s.apron) apron_front(p, s);
  if (s.cabinet) return sink_cabinet(p, s);
  p.add(s.surface, lathe({{0, 0}, {0.13, 0}, {0.12, 0.03}, {0.075, 0.25}, {0.08, floor * 0.7}, {0.14, floor}, {0, floor}}, 24),
        moved(0, p.d * 0.1, 0));
}

}  // namespace

void add_sinks(Families& to) { to["sink"] = sink; }

}  // namespace layoutbox::kit
