// What hangs on something that is no wall: coats on racks and hooks, what is pinned to a board.
#include "layoutbox/solve/compile/phrases.h"
#include "layoutbox/solve/compile/support.h"

namespace layoutbox::placement {
namespace {

constexpr int kBesideItsHook = 300;  // as much as on top of what is not used so

// Against that side of it, no higher than its top, off the floor.
void require_hanging(Case& c, const PlacementModel& model, ItemId t, ItemId r, Direction side) {
  const int along = 1 - side.axis;
  c.require_small(gap_towards(t, r, side), 0);
  const Linear off = mid2(t, along) - mid2(r, along);
  c.require(extent(r, along) - off).require(extent(r, along) + off);
  c.require(hi(r, 2) - hi(t, 2)).require(hi(t, 2) - lo(r, 2)).require(lo(t, 2) - Linear(model.room.lo[2] + 60));
  c.wish(mid2(t, along) - mid2(r, along), 30, 2);
}

// A coat hangs before its hook, beside it only where nothing else is left.
constexpr Mm kWidestHook = 150;

}  // namespace

void add_hanging(Formula& f, const PlacementModel& model, ItemId t, ItemId r) {
  const Item& host = model.items[r];
  if (host.odd_states != 0) f.exact = false;  // on the sides of the box around it nothing hangs
  const bool hook = host.mount == Mount::kWall && host.states[0].size.width <= kWidestHook;
  if (hook) {
    for_each_turn(host, [&](int turn, std::uint64_t states) {
      require_hanging(f.add().when(r, states), model, t, r, side_direction(host, Side::kFront, turn));
    });
  }
  for (int axis = 0; axis < 2; ++axis) {
    for (const int sign : {1, -1}) {
      Case& c = f.add();
      if (host.odd_states != 0) c.when(r, quarter_states(host));
      require_hanging(c, model, t, r, {axis, sign});
      if (hook) c.price += kBesideItsHook;
      // What is pinned to a board is within it.
      const Size &board = host.states[0].size, &own = model.items[t].states[0].size;
      if (host.mount != Mount::kWall || own.width * 2 > board.width || own.height > board.height) continue;
      c.require(lo(t, 1 - axis) - lo(r, 1 - axis)).require(hi(r, 1 - axis) - hi(t, 1 - axis)).require(lo(t, 2) - lo(r, 2));
    }
  }
}

}  // namespace layoutbox::placement
