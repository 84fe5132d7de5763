// Machines whose doors stand open. The doors reach beyond the machine's box, over the floor that is kept clear before it.
#include <algorithm>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {

// The inside of a machine whose door stands open, between z0 and z1: dark, with racks or boards and what is on them.
void open_inside(Piece& p, double z0, double z1, double face, bool cold) {
  const double x = p.w / 2 - 0.03;
  p.add(cold ? p.named("plastic") : p.named("slate"), box(sides(-x, x, face - 0.004, face + 0.006, z0, z1), 0));
  const int rows = std::max(1, static_cast<int>((z1 - z0) / 0.3));
  for (int i = 1; i <= rows; ++i) {
    const double z = z0 + (z1 - z0) * i / (rows + 1.0);
    p.add(p.named(cold ? "glass" : "chrome"), box(sides(-x, x, face - 0.022, face, z, z + 0.008), 0));
    if (!cold || !p.may_show_contents()) continue;
    for (int k = 0; k < 5; ++k) {
      const double at = -x + 2 * x * (k + 0.5) / 5, tall = std::min((z1 - z0) / (rows + 1.0) * 0.7, p.random(0.1, 0.2));
      static constexpr Color kFood[] = {{0.80, 0.24, 0.18}, {0.94, 0.78, 0.30}, {0.36, 0.56, 0.30}, {0.93, 0.92, 0.88}};
      p.add(p.tinted("plastic", kFood[p.pick(4)]),
            box(sides(at - 0.04, at + 0.04, face - 0.021, face - 0.002, z + 0.008, z + 0.008 + tall), 0.006));
    }
  }
}

// A door that dropped open before a machine: it lies level at z, as deep as it is high, and the rack is drawn out over it.
void dropped_door(Piece& p, int surface, double z, double high, double face, bool rack) {
  const double x = p.w / 2 - 0.004, out = face - high;
  p.add(surface, box(sides(-x, x, out, face, z, z + 0.03), 0.006));
  p.add(p.named("steel"), box(sides(-x + 0.03, x - 0.03, out + 0.03, face, z + 0.028, z + 0.034), 0));
  if (!rack) return;
  const int wire = p.named("chrome"), china = p.named("ceramic");
  const double r = 0.004, low = z + 0.06, top = z + 0.16, far = out + 0.08;
  for (const double level : {low, top}) {
    for (const double side : {-1.0, 1.0}) p.add(wire, rod({side * (x - 0.05), far, level}, {side * (x - 0.05), face, level}, r, 6));
    for (const double y : {far, face - 0.01}) p.add(wire, rod({-x + 0.05, y, level}, {x - 0.05, y, level}, r, 6));
  }
  for (int i = 0; i < 6; ++i) {
    const double y = far + (face - far) * (i + 0.5) / 6;
    p.add(wire, rod({-x + 0.05, y, low}, {x - 0.05, y, low}, r, 6));
    if (i > 0 && p.may_show_contents()) p.add(china, cylinder({0, 0, 0}, 0.11, 0.012, 20), aimed({-0.06, y, low + 0.115}, {0, -1, 0}));
    if (i % 2 == 1 && p.may_show_contents()) p.add(china, cylinder({x - 0.13, y, low + 0.004}, 0.04, 0.09, 14));
  }
}

// A door that stands open at the left edge, at a right angle to the front.
void swung_door(Piece& p, int surface, double z0, double z1, double face, double wide) {
  const double x = -p.w / 2;
  p.add(surface, box(sides(x, x + 0.045, face - wide, face, z0, z1), 0.008));
  for (const double share : {0.2, 0.5, 0.8})
    p.add(p.named("plastic"),
          box(sides(x + 0.044, x + 0.1, face - wide + 0.04, face - 0.04, z0 + (z1 - z0) * share - 0.05, z0 + (z1 - z0) * share), 0.004));
}

}  // namespace layoutbox::kit
