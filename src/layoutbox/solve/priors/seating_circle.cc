// Seats on a circle round what is as wide as it is deep.
#include <algorithm>
#include <bit>
#include <cmath>

#include "layoutbox/solve/compile/phrases.h"
#include "layoutbox/solve/priors/seating.h"

namespace layoutbox::placement {
namespace {

// With both at their usual sizes: does a seat whose middle is so far off the table's stand in it?
bool stands_in(const Compilation& c, ItemId seat, std::uint64_t facing, ItemId table, const Mm (&off)[2]) {
  const State &s = c.item(seat).states[static_cast<std::size_t>(std::countr_zero(facing))], &t = c.item(table).states[0];
  Placement of_seat{std::countr_zero(facing), {}}, of_table{0, {}};
  for (int axis = 0; axis < 2; ++axis) of_seat.at[axis] = off[axis] + (t.extent[axis] - s.extent[axis]) / 2;
  return collide(c.model, seat, of_seat, table, of_table, false);
}

// Which states of the seat look to the middle from that angle. At angle 0 it stands before the table and looks to the back: half round
// from the turn of the table's own front.
std::uint64_t looks_inwards(const Item& seat, int angle) {
  std::uint64_t facing = 0;
  for_each_turn(seat, [&](int turn, std::uint64_t states) {
    if (turn == (angle + 180) % 360 || !seat.has_front) facing |= states;
  });
  return facing;
}

// One seat at that angle of the circle, so far from the middle. Does it stand clear of the table?
bool add_to_circle(Case& in, const Compilation& c, ItemId t, ItemId r, int angle, std::uint64_t facing, double away, Mm most) {
  const double x = std::sin(radians_from_degrees(angle)) * away, y = -std::cos(radians_from_degrees(angle)) * away;
  const Mm place[2] = {static_cast<Mm>(std::lround(x)), static_cast<Mm>(std::lround(y))};
  const Mm play2 = std::min<Mm>(60, static_cast<Mm>(away) / 5);  // so little that it still looks at the middle
  Mm outer[2];
  in.when(t, facing);
  for (int axis = 0; axis < 2; ++axis) {
    outer[axis] = place[axis] + (place[axis] > 0 ? play2 / 2 : place[axis] < 0 ? -play2 / 2 : 0);
    const Linear off = mid2(t, axis) - mid2(r, axis) - Linear(2 * place[axis]);
    in.require_small(off, play2).wish(off, 50, 2);
  }
  in.require(Linear(most) - gap_towards(t, r, {1, angle < 90 || angle > 270 ? -1 : 1}));
  return !stands_in(c, t, facing, r, outer);
}

}  // namespace

void add_circle(Formula& f, Compilation& c, ItemId r, Mm most) {
  const Item& table = c.item(r);
  const int n = static_cast<int>(c.targets.size());
  const Size& size = table.states[0].size;
  std::vector<Case> narrow;
  const std::size_t before = f.cases.size();
  for (const int shift : {0, 15, 30, 45}) {
    for (const Mm extra : {0, 100, 200, 300}) {
      Case in;
      in.price = extra / 2 + (shift % 45 ? 10 : 0);
      bool possible = true, free = true;
      for (int k = 0; k < n && possible; ++k) {
        const int angle = (static_cast<int>(std::lround(360.0 * k / n / 15)) * 15 + shift) % 360;  // where it stands: 0 = front
        const ItemId t = c.targets[k];
        const Item& seat = c.item(t);
        const std::uint64_t facing = looks_inwards(seat, angle);
        possible = facing != 0;
        if (!possible) break;
        const double away =
            std::min(size.width, size.depth) / 2.0 + seat.states[0].size.depth * 0.5 - 0.4 * seat.states[0].size.depth + extra;
        free = add_to_circle(in, c, t, r, angle, facing, away, most) && free;
      }
      if (possible) (free ? f.cases : narrow).push_back(std::move(in));
    }
  }
  if (f.cases.size() == before) std::ranges::move(narrow, std::back_inserter(f.cases));
}

}  // namespace layoutbox::placement
