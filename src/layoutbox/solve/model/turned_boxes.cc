// Boxes of an object in its own frame, turned: by quarters, and by any angle.
#include <array>
#include <cmath>

#include "layoutbox/solve/model/items.h"

namespace layoutbox::placement {

GridBox own_box(const Size& size) {
  return {{-(size.width / 2), -(size.depth / 2), 0}, {size.width - size.width / 2, size.depth - size.depth / 2, size.height}};
}

GridBox in_turned(const GridBox& own, const GridBox& box, double turn) {
  const GridBox whole = turned(own, turn);
  return turned(box, turn).shifted({-whole.lo[0], -whole.lo[1], -whole.lo[2]});
}

GridBox within_turned(const GridBox& own, const GridBox& box, double turn) {
  const GridBox whole = turned(own, turn);
  return turned_within(box, turn).shifted({-whole.lo[0], -whole.lo[1], -whole.lo[2]});
}

int nearest_turn(double angle) {
  const int turn = static_cast<int>(std::lround(normalized_degrees(angle))) % 360;
  return turn % 90 == 0 && angle != 90 * std::round(angle / 90) ? turn + 1 : turn;
}

void note_odd_states(Item& item) {
  for (std::size_t s = 0; s < item.states.size(); ++s) {
    if (!is_quarter(item.states[s])) item.odd_states |= std::uint64_t{1} << s;
  }
  if (item.odd_states == 0) return;
  item.footprint = kFirstConstant + static_cast<int>(item.states[0].constants.size());
  for (State& state : item.states) {
    const GridBox own = own_box(state.size), whole = turned(own, state.angle), within = within_turned(own, own, state.angle);
    for (const Vec3& corner : {within.lo, within.hi}) state.constants.insert(state.constants.end(), corner.begin(), corner.begin() + 2);
    const double c = std::cos(radians_from_degrees(state.angle)), s = std::sin(radians_from_degrees(state.angle));
    const std::array corners{Point{own.lo[0], own.lo[1]}, Point{own.hi[0], own.lo[1]}, Point{own.hi[0], own.hi[1]},
                             Point{own.lo[0], own.hi[1]}};
    for (const auto& [x, y] : corners) {
      state.constants.push_back(static_cast<Mm>(std::lround(c * x - s * y)) - whole.lo[0]);
      state.constants.push_back(static_cast<Mm>(std::lround(s * x + c * y)) - whole.lo[1]);
    }
  }
}

GridBox beside(const GridBox& own, Side side, Mm from, Mm to, Mm height) {
  GridBox strip = own;
  strip.lo[2] = 0, strip.hi[2] = height;
  switch (side) {
    case Side::kFront: strip.hi[1] = own.lo[1] - from, strip.lo[1] = own.lo[1] - to; break;
    case Side::kBack: strip.lo[1] = own.hi[1] + from, strip.hi[1] = own.hi[1] + to; break;
    case Side::kLeft: strip.hi[0] = own.lo[0] - from, strip.lo[0] = own.lo[0] - to; break;
    default: strip.lo[0] = own.hi[0] + from, strip.hi[0] = own.hi[0] + to; break;
  }
  return strip;
}

}  // namespace layoutbox::placement
