// Small things on tops.
#include <algorithm>
#include <array>
#include <cmath>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/dress/places.h"

namespace layoutbox::dressing {
namespace {

constexpr double kToEdge = 20;   // mm between a thing and the edge of what carries it
constexpr double kAboutIt = 20;  // … that are free about it

}  // namespace

// In the middle of tables, at the side of desks, near the back of what stands at a wall; one on each, the row's first kind first.
void stand_on(Dresser& dresser, const Dressing& row) {
  const Size size = dresser.size_of(row);
  int left = row.most;
  for (const std::size_t i : dresser.things(row.of)) {
    if (left == 0) return;
    const PlacedObject host = dresser.layout().objects[i];
    const CatalogEntry& entry = dresser.entry_of(host);
    if (!entry.top_carries) continue;
    const double turn = radians_from_degrees(host.rotation_deg), c = std::cos(turn), s = std::sin(turn);
    const double room_x = host.size.width / 2.0 - size.width / 2.0 - kToEdge, room_y = host.size.depth / 2.0 - size.depth / 2.0 - kToEdge;
    if (room_x < 0 || room_y < 0) continue;
    const double y = entry.back_to_wall ? room_y * 0.5 : 0;
    const double top = host.position[2] + host.size.height;
    const auto empty = [&](double x) {
      PlacedObject thing;
      thing.position = {host.position[0] + x * c - y * s, host.position[1] + x * s + y * c, top};
      thing.size = {size.width + static_cast<Mm>(2 * kAboutIt), size.depth + static_cast<Mm>(2 * kAboutIt), size.height};
      return dresser.room().is_free(box_round(thing));
    };
    const double aside = room_x * (entry.is(Trait::kDesk) ? 1.0 : 0.6);
    const std::array places = entry.is(Trait::kDesk) ? std::array{aside, -aside} : std::array{0.0, aside};
    for (const double x : {places[0], places[1], -aside}) {
      if (!empty(x)) continue;
      dresser.add_on(row.adds, row.words, size, host.id, host.position[0] + x * c - y * s, host.position[1] + x * s + y * c);
      --left;
      break;
    }
  }
}

}  // namespace layoutbox::dressing
