// What people are served at: counters of shops and bars, reception desks.
#include <algorithm>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// The front of a counter that people stand before: upright planks at a bar, else a panel with a lit strip under the top.
void counter_front(Piece& p, std::string_view kind, const Box& b) {
  const double low = b.min.z, high = b.max.z;
  if (kind == "bar") {
    const int wood = p.main("walnut"), n = std::max(4, static_cast<int>((b.max.x - b.min.x) / 0.14));
    const double wide = (b.max.x - b.min.x) / n;
    for (int i = 0; i < n; ++i)
      p.add(wood, box(sides(b.min.x + wide * i + 0.004, b.min.x + wide * (i + 1) - 0.004, b.min.y, b.max.y, low, high), 0.006));
    return;
  }
  const double split = low + (high - low) * 0.82;
  p.add(p.main("oak"), box(sides(b.min.x, b.max.x, b.min.y, b.max.y, low, split), 0.004));
  p.add(kind == "reception" ? p.named("lampshade") : p.tinted("lacquer", p.accent()),
        box(sides(b.min.x + 0.004, b.max.x - 0.004, b.min.y + 0.008, b.max.y, split, high - 0.004), 0));
  const int joints = std::max(1, static_cast<int>((b.max.x - b.min.x) / 0.7));
  for (int i = 1; i < joints; ++i) {
    const double x = b.min.x + (b.max.x - b.min.x) * i / joints;
    p.add(p.named("black_plastic"), box(sides(x - 0.003, x + 0.003, b.min.y - 0.001, b.min.y + 0.004, low + 0.01, split - 0.01), 0));
  }
}

// Of shops, bars and receptions: the top stands over the front and its people's side is of another look.
void serving_counter(Piece& p) {
  const std::string kind = p.word("kind", "shop");
  const double slab_thick = std::min(0.04, p.h * 0.08), foot = std::min(0.08, p.h * 0.1), front = -p.d / 2;
  double back = p.d / 2 - 0.005;
  for (const FreeSpace& s : p.spaces) {
    if (s.box.min.z < 0.01) back = std::min(back, s.box.min.y);  // a knee room
  }
  const int wood = p.main(kind == "bar" ? "walnut" : "oak");
  const double edge = -p.d / 2 + std::min(0.3, p.d * 0.38), z = p.h - slab_thick;
  p.add(kind == "bar" ? wood : p.color_asked() ? p.named("lacquer") : wood, box(sides(-p.w / 2, p.w / 2, edge, p.d / 2, z, p.h), 0.005));
  p.add(kind == "bar" ? wood : p.named("lacquer"), box(sides(-p.w / 2, p.w / 2, -p.d / 2, edge - 0.002, z, p.h), 0.005));
  if (kind == "bar")
    p.add(p.named("brass"), rod({-p.w / 2 + 0.01, -p.d / 2 + 0.03, 0.2}, {p.w / 2 - 0.01, -p.d / 2 + 0.03, 0.2}, 0.02, 10));
  const double face = front + (kind == "bar" ? 0.06 : 0.01);
  p.add(p.named("black_plastic"), box(sides(-p.w / 2 + 0.03, p.w / 2 - 0.03, face + 0.05, back - 0.01, 0, foot), 0));
  counter_front(p, kind, sides(-p.w / 2 + 0.01, p.w / 2 - 0.01, face, face + 0.03, foot, z));
  Carcass c{sides(-p.w / 2 + 0.01, p.w / 2 - 0.01, face + 0.03, back, foot, z), wood, wood, p.named("steel")};
  c.closed_fronts = false;
  carcass(p, c);
}

}  // namespace

void add_serving(Families& to) { to["serving_counter"] = serving_counter; }

}  // namespace layoutbox::kit
