#include <cmath>
#include <set>

#include "layoutbox/solve/model/items.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kWindowDepth = 500;  // kept free before a window, above its sill
constexpr Mm kOpeningDepth = 0;   // an opening is a box of no depth in the wall's inner face

int turn_of_wall(int along, int inward) { return along == 0 ? (inward < 0 ? 0 : 180) : (inward > 0 ? 90 : 270); }

// The turn of what has its back against the wall, to a ten-thousandth of a degree.
double angle_at(const Wall& wall) {
  const double degrees = std::atan2(wall.start.y - wall.end.y, wall.start.x - wall.end.x) * 180 / kPi;
  return normalized_degrees(std::round(degrees * 1e4) / 1e4);
}

// The wall at an angle in which an opening is: the one it names, the longest where no wall of the room runs along x or y; else null.
// An opening there does not move: it is where its offset says, in the middle of the wall where it says nothing.
const Wall* angled_wall_of(const Opening& opening, const Room& room) {
  const Wall* found = nullptr;
  double longest = 0;
  for (const Wall& wall : room.walls) {
    const double length = std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y);
    const bool straight = room_wall(wall).straight;
    if (wall.id == opening.wall) return straight ? nullptr : &wall;
    if (straight && opening.wall.empty()) return nullptr;
    if (opening.wall.empty() && length > longest) longest = length, found = &wall;
  }
  return found;
}

// The low corner of the box around an opening in such a wall.
std::array<Mm, 2> place_in_angled(const Wall& wall, const Opening& opening, const Vec3& extent, const GridBox& room) {
  const double dx = wall.end.x - wall.start.x, dy = wall.end.y - wall.start.y, length = std::hypot(dx, dy);
  const double middle = (opening.offset ? *opening.offset + opening.width / 2.0 : length / 2) / length;
  const double at[2] = {wall.start.x + dx * middle, wall.start.y + dy * middle};
  std::array<Mm, 2> low{};
  for (int k = 0; k < 2; ++k) {
    low[k] = static_cast<Mm>(std::lround(at[k] - extent[k] / 2.0));
    low[k] = std::max(room.lo[k], std::min(low[k], room.hi[k] - extent[k]));
  }
  return low;
}

constexpr Mm kBand = 200;  // how finely a turned box is cut into upright ones
constexpr int kMostBands = 6;

// Upright boxes that cover a box of the own frame as it lies in the turned one, from its low corner: itself at quarter turns, else bands.
std::vector<GridBox> cover_turned(const GridBox& own, const GridBox& box, double turn) {
  const GridBox around = in_turned(own, box, turn), whole = turned(own, turn);
  if (turn == 90 * std::floor(turn / 90)) return {around};
  const double c = std::cos(radians_from_degrees(turn)), s = std::sin(radians_from_degrees(turn));
  std::array<std::array<double, 2>, 4> corners{};
  for (int k = 0; k < 4; ++k) {
    const double x = k == 0 || k == 3 ? box.lo[0] : box.hi[0], y = k < 2 ? box.lo[1] : box.hi[1];
    corners[k] = {c * x - s * y - whole.lo[0], s * x + c * y - whole.lo[1]};
  }
  const int bands = std::clamp((around.extent(1) + kBand - 1) / kBand, 1, kMostBands);
  std::vector<GridBox> out;
  for (int b = 0; b < bands; ++b) {
    GridBox band = around;
    band.lo[1] = around.lo[1] + around.extent(1) * b / bands, band.hi[1] = around.lo[1] + around.extent(1) * (b + 1) / bands;
    double low = around.hi[0], high = around.lo[0];
    for (int k = 0; k < 4; ++k) {  // what of each side lies in the band
      const auto &from = corners[k], &to = corners[(k + 1) % 4];
      const auto [down, up] = std::minmax(from[1], to[1]);
      if (up < band.lo[1] || down > band.hi[1]) continue;
      for (const double y : {std::max<double>(down, band.lo[1]), std::min<double>(up, band.hi[1])}) {
        const double x = from[0] + (to[0] - from[0]) * (up > down ? (y - from[1]) / (to[1] - from[1]) : 0);
        low = std::min(low, x), high = std::max(high, x);
      }
    }
    band.lo[0] = std::max(around.lo[0], static_cast<Mm>(std::floor(low))),
    band.hi[0] = std::min(around.hi[0], static_cast<Mm>(std::ceil(high)));
    if (!band.empty()) out.push_back(band);
  }
  return out;
}

}  // namespace

RoomWall room_wall(const Wall& wall) {
  RoomWall out;
  out.id = wall.id;
  const Point a = wall.start, b = wall.end;
  out.straight = a.x == b.x || a.y == b.y;
  out.along = std::abs(b.x - a.x) >= std::abs(b.y - a.y) ? 0 : 1;
  const Mm from = out.along == 0 ? a.x : a.y, to = out.along == 0 ? b.x : b.y;
  out.at = out.along == 0 ? a.y : a.x;
  out.lo = std::min(from, to), out.hi = std::max(from, to);
  out.runs_up = to > from;
  // Counter-clockwise: the room lies to the left of the wall's direction.
  out.inward = out.along == 0 ? (out.runs_up ? 1 : -1) : (out.runs_up ? -1 : 1);
  out.turn = turn_of_wall(out.along, out.inward);
  out.start = a, out.end = b;
  out.angle = angle_at(wall);
  if (!out.straight) out.turn = nearest_turn(out.angle);
  return out;
}

// Before a gate as deep as one that walks through needs, however wide it is.
Mm clear_depth(const Opening& opening) {
  constexpr Mm kMostBeforeDoor = 1200;
  return opening.type == OpeningType::kWindow ? kWindowDepth : std::min(opening.width, kMostBeforeDoor);
}

Item opening_item(const Opening& opening, const Room& room, std::span<const RoomWall> walls) {
  Item item;
  item.id = opening.id;
  item.opening = &opening;
  item.mount = Mount::kWall;
  std::set<int> turns;
  for (const RoomWall& wall : walls) {
    if (wall.straight && (opening.wall.empty() || wall.id == opening.wall)) turns.insert(wall.turn);
  }
  if (const Wall* in_angled = angled_wall_of(opening, room)) turns = {nearest_turn(angle_at(*in_angled))};
  const Wall* angled = angled_wall_of(opening, room);
  for (const int turn : turns) {
    State state;
    state.turn = turn, state.angle = angled ? angle_at(*angled) : turn;
    state.size = {opening.width, kOpeningDepth, opening.height};
    const GridBox own = own_box(state.size);
    const GridBox whole = turned(own, state.angle);
    for (int k = 0; k < 3; ++k) state.extent[k] = whole.extent(k);
    state.clear = cover_turned(own, beside(own, Side::kFront, 0, clear_depth(opening), opening.height), state.angle);
    item.states.push_back(std::move(state));
  }
  note_odd_states(item);
  return item;
}

Constraint opening_place(const PlacementModel& model, ItemId index) {
  const Item& item = model.items[index];
  const Opening& opening = *item.opening;
  Constraint out;
  out.name = "place of " + item.id;
  out.firmness = Firmness::kAlways;
  Formula& f = out.formulas.emplace_back();
  if (const Wall* angled = angled_wall_of(opening, model.scene->room)) {
    Case& c = f.add();
    const auto low = place_in_angled(*angled, opening, item.states[0].extent, model.room);
    for (int k = 0; k < 2; ++k) c.require_small(lo(index, k) - Linear(low[k]), 0);
    c.require_small(lo(index, 2) - Linear(opening.sill), 0);
  }
  for (const RoomWall& wall : model.walls) {
    if (!wall.straight || (!opening.wall.empty() && wall.id != opening.wall)) continue;
    Case& c = f.add();
    c.when(index, item.states_at(wall.turn));
    c.require_small(lo(index, wall.normal()) - Linear(wall.at), 0).require_small(lo(index, 2) - Linear(opening.sill), 0);
    if (opening.offset) {
      const Mm low = wall.runs_up ? wall.lo + *opening.offset : wall.hi - *opening.offset - opening.width;
      c.require_small(lo(index, wall.along) - Linear(low), 0);
      continue;
    }
    const Mm margin = std::min<Mm>(100, std::max<Mm>(0, (wall.hi - wall.lo - opening.width) / 2));
    c.require(lo(index, wall.along) - Linear(wall.lo + margin)).require(Linear(wall.hi - margin) - hi(index, wall.along));
  }
  return out;
}

Constraint opening_clearance(const Item& item) {
  Constraint out;
  out.name = (item.opening->type == OpeningType::kWindow ? "free space before " : "door swing of ") + item.id;
  out.firmness = Firmness::kImplied;
  out.weight = 1;
  return out;
}

}  // namespace layoutbox::placement
