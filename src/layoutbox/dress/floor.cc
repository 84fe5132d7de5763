// What stands on the floor or lies there, and what hangs over its middle.
#include <algorithm>
#include <cmath>

#include "layoutbox/catalog/measures.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/dress/places.h"

namespace layoutbox::dressing {
namespace {

constexpr double kOffWall = 40;                         // mm between a plant and its walls
constexpr double kAbout = 60;                           // … that are free about it
constexpr double kBesideGap = 60;                       // between a lamp and what it stands beside
constexpr double kRugOffWall = 150;                     // least floor between a rug and a wall
constexpr double kBeforeSeat = 1600, kUnderSeat = 250;  // of a seat's rug: how deep it is, and how much of that is under the seat
constexpr double kBeforeFoot = 500, kOfBed = 0.7;       // of a bed's rug: what lies before its foot; its depth as a share of the bed's

double distance_to_door(const Dresser& dresser, const std::array<double, 3>& point) {
  double least = 1e9;
  for (const Opening& opening : dresser.layout().room.openings) {
    for (const DressedWall& wall : dresser.room().walls()) {
      if (opening.type == OpeningType::kWindow || wall.wall->id != opening.wall || !opening.offset) continue;
      const auto at = wall.point(*opening.offset + opening.width / 2.0, 0, 0);
      least = std::min(least, std::hypot(at[0] - point[0], at[1] - point[1]));
    }
  }
  return least;
}

// A point in the frame of a thing, as it lies in the room; z is kept.
std::array<double, 3> in_room(const PlacedObject& object, double x, double y) {
  const double turn = radians_from_degrees(object.rotation_deg), c = std::cos(turn), s = std::sin(turn);
  return {object.position[0] + x * c - y * s, object.position[1] + x * s + y * c, 0};
}

bool is_square(const PlacedObject& object) { return std::abs(std::remainder(object.rotation_deg, 90.0)) < 0.1; }

PlacedObject flat(const std::array<double, 3>& at, double turn_deg, const Size& size) {
  PlacedObject object;
  object.position = at, object.rotation_deg = turn_deg, object.size = size;
  return object;
}

bool has_soft_floor(const Layout& layout) { return layout.room.floor_material.find("carpet") != std::string::npos; }

}  // namespace

// Farthest from the doors first.
void stand_in_corners(Dresser& dresser, const Dressing& row) {
  const Size size = dresser.size_of(row);
  const double side = std::max(size.width, size.depth);
  std::vector<std::array<double, 3>> places;
  for (const DressedWall& wall : dresser.room().walls()) {
    if (dresser.room().next(wall) == nullptr) continue;
    const Span along{wall.length - kOffWall - side - kAbout, wall.length - kOffWall}, off{kOffWall, kOffWall + side + kAbout};
    if (!dresser.room().is_free(wall.box(along, off, {0, double(size.height)}))) continue;
    places.push_back(wall.point(wall.length - on_grid(kOffWall + side / 2), on_grid(kOffWall + side / 2), 0));
  }
  std::ranges::stable_sort(places, std::greater{}, [&](const auto& place) { return distance_to_door(dresser, place); });
  for (std::size_t i = 0; i < places.size() && i < static_cast<std::size_t>(row.most); ++i) {
    dresser.add(row.adds, row.words, size, {places[i]});
  }
}

void stand_beside(Dresser& dresser, const Dressing& row) {
  const Size size = dresser.size_of(row);
  int left = row.most;
  for (const std::size_t i : dresser.things(row.of)) {
    const PlacedObject thing = dresser.layout().objects[i];
    if (left == 0) return;
    if (!is_square(thing) || thing.mount != Mount::kFloor) continue;
    for (const double side : {1.0, -1.0}) {
      const double x = side * (thing.size.width / 2.0 + kBesideGap + size.width / 2.0), y = thing.size.depth / 2.0 - size.depth / 2.0;
      const auto at = in_room(thing, x, y);
      const RoomBox box = box_round(flat(at, 0, size));
      if (!dresser.room().is_free(box)) continue;
      dresser.add(row.adds, row.words, size, {at});
      --left;
      break;
    }
  }
}

// At walls that the picture shows first, the longest stretch of these; what is tall would turn its back to it at others.
void stand_at_free_wall(Dresser& dresser, const Dressing& row) {
  const Size size = dresser.size_of(row);
  const DressedWall* best = nullptr;
  std::pair<bool, double> most{false, 0};
  Span longest;
  for (const DressedWall& wall : dresser.room().walls()) {
    const bool shown = dresser.is_shown(wall);
    if (!shown && size.height > measures().tall_from) continue;  // its back is an eyesore
    for (const Span& span : dresser.room().free_along(wall, {0, size.depth + double(row.before)}, {0, double(size.height)})) {
      const std::pair worth{shown, span.length()};
      if (span.length() >= row.stretch && worth > most) best = &wall, longest = span, most = worth;
    }
  }
  if (best == nullptr) return;
  dresser.add_at_wall(row.adds, row.words, size, *best, on_grid(longest.middle() - size.width / 2.0), 0);
}

// Under the middle of a table; half under a bed, from its foot on; before a seat, whose front feet stand on it; as large as the thing and
// the room let it be.
void lie_under(Dresser& dresser, const Dressing& row) {
  const CatalogEntry& entry = dresser.catalog().entry_or_nearest(row.adds);
  if (has_soft_floor(dresser.layout())) return;
  int left = row.most;
  for (const std::size_t i : dresser.things(row.of)) {
    const PlacedObject thing = dresser.layout().objects[i];
    if (left == 0) return;
    if (!is_square(thing) || thing.mount != Mount::kFloor) continue;
    const bool bed = dresser.entry_of(thing).is(Trait::kBed), seat = dresser.is_one_of(thing, {"sofa", "armchair"});
    for (const double scale : {1.0, 0.85, 0.7}) {
      const auto held = [&](double side, Mm least, Mm most) {
        return static_cast<Mm>(on_grid(std::clamp(side * scale, double(least), double(most))));
      };
      const double depth = bed ? thing.size.depth * kOfBed : seat ? kBeforeSeat : thing.size.depth + 2.0 * row.before;
      const Size size{held(thing.size.width + 2.0 * row.before, entry.size.least.width, entry.size.greatest.width),
                      held(depth, entry.size.least.depth, entry.size.greatest.depth), entry.size.usual.height};
      const double front = -thing.size.depth / 2.0;
      const auto at = in_room(thing, 0,
                              bed    ? front - kBeforeFoot * scale + size.depth / 2.0
                              : seat ? front + kUnderSeat - size.depth / 2.0
                                     : 0);
      RoomBox box = box_round(flat(at, thing.rotation_deg, size));
      box = {box.x0 - kRugOffWall, box.y0 - kRugOffWall, 0, box.x1 + kRugOffWall, box.y1 + kRugOffWall, 1};
      if (!dresser.room().inside(box)) continue;
      dresser.add(row.adds, row.words, size, {at, thing.rotation_deg});
      --left;
      break;
    }
  }
}

void lie_before(Dresser& dresser, const Dressing& row) {
  const Size size = dresser.size_of(row);
  int left = row.most;
  for (const std::size_t i : dresser.things(row.of)) {
    const PlacedObject thing = dresser.layout().objects[i];
    if (left == 0 || !is_square(thing)) continue;
    const auto at = in_room(thing, 0, -thing.size.depth / 2.0 - row.before - size.depth / 2.0);
    if (!dresser.room().is_free(box_round(flat(at, thing.rotation_deg, size)))) continue;
    dresser.add(row.adds, row.words, size, {at, thing.rotation_deg});
    --left;
  }
}

// Over the middle of a thing where the row names kinds, else of the room.
void hang_from_ceiling(Dresser& dresser, const Dressing& row) {
  const Size size = dresser.size_of(row);
  const double top = dresser.layout().room.height;
  int left = row.most;
  const auto hang = [&](double x, double y) {
    const PlacedObject lamp = flat({on_grid(x), on_grid(y), top - size.height}, 0, size);
    if (left == 0 || !dresser.room().is_free(box_round(lamp))) return;
    dresser.add(row.adds, row.words, size, {lamp.position, 0, "ceiling"});
    --left;
  };
  if (row.of.empty()) {
    double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
    for (const Point& p : dresser.layout().room.polygon) {
      x0 = std::min(x0, double(p.x)), x1 = std::max(x1, double(p.x)), y0 = std::min(y0, double(p.y)), y1 = std::max(y1, double(p.y));
    }
    return hang((x0 + x1) / 2, (y0 + y1) / 2);
  }
  for (const std::size_t i : dresser.things(row.of)) {
    const PlacedObject below = dresser.layout().objects[i];
    const int count = row.stretch == 0 ? 1 : std::clamp(below.size.width / row.stretch, 1, std::max(1, left));
    for (int k = 0; k < count; ++k) {
      const auto at = in_room(below, below.size.width * ((k + 0.5) / count - 0.5), 0);
      hang(at[0], at[1]);
    }
  }
}

}  // namespace layoutbox::dressing
