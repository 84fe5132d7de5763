// Small things on tops.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/dress/places.h"

namespace layoutbox::dressing {
namespace {

constexpr double kToEdge = 20;   // mm between a thing and the edge of what carries it
constexpr double kAboutIt = 20;  // … that are free about it

constexpr double kLowestSeat = 250, kHighestSeat = 750;

// Where things stand or lie on a thing: a level above its underside, and half its sides; y: its middle in the thing's frame.
struct Top {
  double level = 0, half_x = 0, half_y = 0, y = 0;
};

// Its top, else the seat or mattress that nothing is above.
std::optional<Top> top_of(const Dresser& dresser, const PlacedObject& host) {
  const CatalogEntry& entry = dresser.entry_of(host);
  if (entry.top_carries) return Top{double(host.size.height), host.size.width / 2.0, host.size.depth / 2.0, 0};
  for (const Space& space : host.spaces) {
    const bool seat = space.carries && space.min[2] > kLowestSeat && space.min[2] < kHighestSeat && space.max[2] > host.size.height - 1;
    if (seat)
      return Top{space.min[2], (space.max[0] - space.min[0]) / 2, (space.max[1] - space.min[1]) / 2, (space.max[1] + space.min[1]) / 2};
  }
  return std::nullopt;
}

// Chairs whose seats are under a desk: their backs are before it, though their boxes reach over its top.
std::vector<std::string> pushed_under(const Dresser& dresser, const PlacedObject& host) {
  std::vector<std::string> ids;
  if (!dresser.entry_of(host).is(Trait::kDesk)) return ids;
  for (const PlacedObject& object : dresser.layout().objects) {
    if (dresser.is_one_of(object, {"chair", "office_chair", "stool"}) && overlap(box_round(object), box_round(host)))
      ids.push_back(object.id);
  }
  return ids;
}

// As usual, smaller where the top is too short for it; nothing where it may not be so small.
std::optional<Size> fitted(const CatalogEntry& entry, Size size, const Top& top) {
  const double share = std::min(1.0, (2 * top.half_x - 2 * kToEdge) / size.width);
  if (size.width * share < std::min(size.width, entry.size.least.width) || top.half_y - size.depth / 2.0 - kToEdge < 0) return std::nullopt;
  if (share < 1) size.width = static_cast<Mm>(size.width * share), size.height = static_cast<Mm>(size.height * share);
  return size;
}

}  // namespace

// In the middle of tables, at the side of desks, near the back of what stands at a wall; one on each, the row's first kind first.
void stand_on(Dresser& dresser, const Dressing& row) {
  const CatalogEntry& added = dresser.catalog().entry_or_nearest(row.adds);
  int left = row.most;
  for (const std::size_t i : dresser.things(row.of)) {
    if (left == 0) return;
    const PlacedObject host = dresser.layout().objects[i];
    const CatalogEntry& entry = dresser.entry_of(host);
    const std::optional<Top> top = top_of(dresser, host);
    const std::optional<Size> fit = top ? fitted(added, dresser.size_of(row), *top) : std::nullopt;
    if (!fit) continue;
    const Size size = *fit;
    const bool seat = !entry.top_carries;
    const double turn = radians_from_degrees(host.rotation_deg), c = std::cos(turn), s = std::sin(turn);
    const double room_x = top->half_x - size.width / 2.0 - kToEdge, room_y = top->half_y - size.depth / 2.0 - kToEdge;
    const double y = top->y + (seat                                                 ? 0
                               : entry.is(Trait::kDesk) && added.is(Trait::kScreen) ? room_y * 0.8
                               : entry.back_to_wall                                 ? room_y * 0.5
                                                                                    : 0);
    const double level = host.position[2] + top->level;
    const std::vector<std::string> but = seat ? std::vector{host.id} : pushed_under(dresser, host);
    const auto empty = [&](double x) {
      PlacedObject thing;
      thing.position = {host.position[0] + x * c - y * s, host.position[1] + x * s + y * c, level};
      thing.size = {size.width + static_cast<Mm>(2 * kAboutIt), size.depth + static_cast<Mm>(2 * kAboutIt), size.height};
      return dresser.room().is_free(box_round(thing), but);
    };
    const bool at_side = seat || (entry.is(Trait::kDesk) && !added.is(Trait::kScreen));
    const double aside = room_x * (at_side ? 1.0 : 0.6);
    const std::array places = at_side ? std::array{aside, -aside} : std::array{0.0, aside};
    for (const double x : {places[0], places[1], -aside}) {
      if (!empty(x)) continue;
      dresser.add_on(row.adds, row.words, size, host.id, host.position[0] + x * c - y * s, host.position[1] + x * s + y * c, top->level);
      --left;
      break;
    }
  }
}

}  // namespace layoutbox::dressing
