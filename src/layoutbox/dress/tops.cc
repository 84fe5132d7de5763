// Small things on tops.
#include <algorithm>
#include <cmath>
#include <optional>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/dress/places.h"

namespace layoutbox::dressing {
namespace {

constexpr double kToEdge = 20;   // mm between a thing and the edge of what carries it
constexpr double kAboutIt = 20;  // … that are free about it

constexpr Trait kSoft[] = {Trait::kSeat, Trait::kEasySeat, Trait::kCenterPiece, Trait::kBed};  // one lies or sits on them
constexpr double kLowestSeat = 250, kHighestSeat = 750;

// Where things stand or lie on a thing: a level above its underside, and half its sides; y: its middle in the thing's frame.
struct Top {
  double level = 0, half_x = 0, half_y = 0, y = 0;
};

// Its top, else the seat or mattress that nothing is above.
std::optional<Top> top_of(const Dresser& dresser, const PlacedObject& host) {
  const CatalogEntry& entry = dresser.entry_of(host);
  if (entry.top_carries) return Top{double(host.size.height), host.size.width / 2.0, host.size.depth / 2.0, 0};
  const bool soft = std::ranges::any_of(kSoft, [&](Trait trait) { return entry.is(trait); });
  for (const Space& space : host.spaces) {
    const bool seat =
        soft && space.carries && space.min[2] > kLowestSeat && space.min[2] < kHighestSeat && space.max[2] > host.size.height - 1;
    if (seat)
      return Top{space.min[2], (space.max[0] - space.min[0]) / 2, (space.max[1] - space.min[1]) / 2, (space.max[1] + space.min[1]) / 2};
  }
  return std::nullopt;
}

// Chairs whose seats are under a table: their backs are before it, though their boxes reach over its top.
std::vector<std::string> pushed_under(const Dresser& dresser, const PlacedObject& host) {
  std::vector<std::string> ids;
  const CatalogEntry& entry = dresser.entry_of(host);
  if (!entry.is(Trait::kTable) && !entry.is(Trait::kDesk)) return ids;
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

bool carries_one_of(const Dresser& dresser, const PlacedObject& host, const std::vector<std::string>& kinds) {
  return std::ranges::any_of(dresser.layout().objects, [&](const PlacedObject& object) {
    return object.supported_by == host.id && dresser.is_one_of(object, kinds);
  });
}

struct Spot {
  double x = 0, y = 0;  // mm from the middle of the host, in its frame
};

// Where it would stand, the best place first: in the middle of tables, at the side of desks, near the back of what stands at a wall, at
// hand where it is a keyboard or a mouse; else wherever there is room.
std::vector<Spot> spots_on(const CatalogEntry& host, const CatalogEntry& added, const Top& top, const Size& size) {
  constexpr double kAtHand = 0.35, kMouse = 290;  // a share of the way to the front edge, mm from the keyboard's middle
  const double room_x = top.half_x - size.width / 2.0 - kToEdge, room_y = top.half_y - size.depth / 2.0 - kToEdge;
  const bool seat = !host.top_carries, desk = host.is(Trait::kDesk), screen = added.is(Trait::kScreen);
  if (seat) return {{room_x, top.y}, {-room_x, top.y}, {0, top.y}};
  if (added.is(Trait::kKeyboard)) return {{0, -room_y * kAtHand}};
  if (added.is(Trait::kMouse)) return {{kMouse, -room_y * kAtHand}};
  const double y = desk && screen ? room_y * 0.8 : host.back_to_wall ? room_y * 0.5 : 0;
  const double aside = room_x * (desk && !screen ? 1.0 : 0.6);
  std::vector<Spot> spots{{desk && !screen ? aside : 0, y}, {aside, y}, {-aside, y}};
  if (screen) {  // farther to the front where a curtain or a window is behind it
    for (const double share : {0.4, 0.0}) spots.push_back({0, room_y * share});
    return spots;
  }
  for (const double across : {y, room_y * 0.8, -room_y * 0.5}) {
    for (const double share : {0.95, -0.95, 0.7, -0.7, 0.45, -0.45, 0.25, -0.25}) spots.push_back({room_x * share, across});
  }
  return spots;
}

// A thing on a host, at a place and so turned in the host's frame.
struct OnTop {
  Spot at;
  double turned_deg = 0;
};

// Stands it there, unless something is in the way.
bool put_down(Dresser& dresser, const Dressing& row, const PlacedObject& host, const Top& top, const Size& size, const OnTop& put) {
  const double turn = radians_from_degrees(host.rotation_deg), c = std::cos(turn), s = std::sin(turn);
  PlacedObject thing;
  thing.position = {host.position[0] + put.at.x * c - put.at.y * s, host.position[1] + put.at.x * s + put.at.y * c,
                    host.position[2] + top.level};
  thing.rotation_deg = host.rotation_deg + put.turned_deg;
  thing.size = {size.width + static_cast<Mm>(2 * kAboutIt), size.depth + static_cast<Mm>(2 * kAboutIt), size.height};
  const bool seat = !dresser.entry_of(host).top_carries;
  const std::vector<std::string> but = seat ? std::vector{host.id} : pushed_under(dresser, host);
  if (!dresser.room().is_free(box_round(thing), but)) return false;
  dresser.add_on(row.adds, row.words, size, host.id, thing.position[0], thing.position[1], top.level, put.turned_deg);
  return true;
}

bool is_round(const PlacedObject& host, const CatalogEntry& entry) {
  const auto top = entry.shape.words.find("top");
  return std::ranges::find(host.attributes, "round") != host.attributes.end() || (top != entry.shape.words.end() && top->second == "round");
}

// Before a seat, as it is told of in the host's frame: at the edge, else aside of what is there; empty where nobody sits at that edge.
std::vector<OnTop> places_of_guest(const PlacedObject& host, const CatalogEntry& entry, const Spot& seat, const Size& size) {
  constexpr double kReach = 650, kEdge = 30, kAside = 190, kInward = 130;  // mm
  const double half_x = host.size.width / 2.0, half_y = host.size.depth / 2.0, off = kEdge + size.depth / 2.0;
  Spot at, in;  // in: towards the middle of the table
  double turned = 0;
  if (is_round(host, entry)) {
    const double far = std::hypot(seat.x, seat.y);
    if (far < 1 || far > half_x + kReach) return {};
    in = {-seat.x / far, -seat.y / far};
    at = {-in.x * (half_x - off), -in.y * (half_x - off)};
    turned = std::atan2(in.y, in.x) * 180 / kPi - 90;
  } else if (std::abs(seat.x) < half_x && std::abs(seat.y) < half_y + kReach) {
    in = {0, seat.y < 0 ? 1.0 : -1.0};
    at = {seat.x, -in.y * (half_y - off)}, turned = seat.y < 0 ? 0 : 180;
  } else if (std::abs(seat.y) < half_y && std::abs(seat.x) < half_x + kReach) {
    in = {seat.x < 0 ? 1.0 : -1.0, 0};
    at = {-in.x * (half_x - off), seat.y}, turned = seat.x < 0 ? -90 : 90;
  } else {
    return {};
  }
  const Spot aside{at.x + in.y * kAside + in.x * kInward, at.y - in.x * kAside + in.y * kInward};
  return {{at, turned}, {aside, turned}};
}

// 180 where who works at a desk sits at its back: behind a reception, before visitors; there all is the other way round.
double turned_to_user(const Dresser& dresser, const PlacedObject& host, const CatalogEntry& entry) {
  constexpr double kReach = 650;  // mm between the edge and the middle of a seat
  if (!entry.is(Trait::kDesk)) return 0;
  const double turn = radians_from_degrees(host.rotation_deg), c = std::cos(turn), s = std::sin(turn);
  double back = entry.is(Trait::kOpenToRoom) ? 180 : 0;
  for (const PlacedObject& seat : dresser.layout().objects) {
    const CatalogEntry& kind = dresser.entry_of(seat);
    const double dx = seat.position[0] - host.position[0], dy = seat.position[1] - host.position[1];
    const double x = dx * c + dy * s, y = dy * c - dx * s;
    if (!kind.is(Trait::kTableSeat) || std::abs(x) > host.size.width / 2.0 || std::abs(y) > host.size.depth / 2.0 + kReach) continue;
    back = y > 0 ? 180 : 0;
    if (dresser.catalog().is_a(seat.category, "office_chair")) return back;
  }
  return back;
}

}  // namespace

// One on each, the row's first kind first.
void stand_on(Dresser& dresser, const Dressing& row) {
  const CatalogEntry& added = dresser.catalog().entry_or_nearest(row.adds);
  int left = row.most;
  for (const std::size_t i : dresser.things(row.of)) {
    if (left == 0) return;
    const PlacedObject host = dresser.layout().objects[i];
    if (!row.with.empty() && !carries_one_of(dresser, host, row.with)) continue;
    const CatalogEntry& entry = dresser.entry_of(host);
    const std::optional<Top> top = top_of(dresser, host);
    const std::optional<Size> size = top ? fitted(added, dresser.size_of(row), *top) : std::nullopt;
    if (!size) continue;
    const std::vector<Spot> spots = spots_on(entry, added, *top, *size);
    const double turned = turned_to_user(dresser, host, entry), way = turned > 0 ? -1 : 1;
    const auto fits_at = [&](const Spot& spot) {
      return put_down(dresser, row, host, *top, *size, {{spot.x * way, spot.y * way}, turned});
    };
    if (std::ranges::any_of(spots, fits_at)) --left;
  }
}

void lay_before_seats(Dresser& dresser, const Dressing& row) {
  int left = row.most;
  for (const std::size_t i : dresser.things(row.of)) {
    const PlacedObject host = dresser.layout().objects[i];
    const CatalogEntry& entry = dresser.entry_of(host);
    const std::optional<Top> top = top_of(dresser, host);
    if (!top || !entry.top_carries) continue;
    const double turn = radians_from_degrees(host.rotation_deg), c = std::cos(turn), s = std::sin(turn);
    const std::vector<PlacedObject> all = dresser.layout().objects;
    for (const PlacedObject& seat : all) {
      if (left == 0) return;
      if (!dresser.entry_of(seat).is(Trait::kTableSeat) || seat.mount != Mount::kFloor) continue;
      const double dx = seat.position[0] - host.position[0], dy = seat.position[1] - host.position[1];
      const Size size = dresser.size_of(row);
      const std::vector<OnTop> places = places_of_guest(host, entry, {dx * c + dy * s, dy * c - dx * s}, size);
      if (std::ranges::any_of(places, [&](const OnTop& place) { return put_down(dresser, row, host, *top, size, place); })) --left;
    }
  }
}

}  // namespace layoutbox::dressing
