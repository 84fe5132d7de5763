// Desks in islands: two rows back to back.
#include <algorithm>

#include "layoutbox/solve/compile/phrases.h"
#include "layoutbox/solve/priors/formation.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kSeatOfIsland = 450;  // what the seats take at either side of an island of desks
constexpr Mm kBetweenIslands = 1500;

}  // namespace

void add_island_place(Formula& f, const PlacementModel& model, const FormationOf& of) {
  const std::vector<ItemId>& group = of.group;
  const int k = of.k, pairs = (static_cast<int>(group.size()) + 1) / 2, pair = k / 2;
  const ItemId item = group[k];
  const Size& desk = model.items[group[0]].states[0].size;
  const auto extent = [&](int axis) { return hi_of(model, of.part, axis) - lo_of(model, of.part, axis); };
  const Size island{desk.width, 2 * (desk.depth + kSeatOfIsland), desk.height};
  for_each_turn(model.items[item], [&](int turn, std::uint64_t states) {
    if (!quarter(turn)) return;
    // Of a pair the first has the side that is looked out over (its front where the seats are told to be behind it) up the axis, the second
    // down.
    const Direction back = side_direction(model.items[item], looking_side(model, item), turn);
    if (back.sign != (k % 2 == 0 ? 1 : -1)) return;
    const int row_axis = across(back);
    Formation form{0, 0, 0};
    for (int tenths = 10; tenths > 0 && form.columns == 0; tenths -= 3) {
      form = formation_of(pairs, island, kBetweenDesks, kBetweenIslands * tenths / 10, extent(row_axis), extent(back.axis));
    }
    if (form.columns == 0) return;
    const int rows = (pairs + form.columns - 1) / form.columns;
    // Twice the way of an island's middle from the room's, along the row and from row to row.
    const auto place_of = [&](int one) {
      const int row = one / form.columns, column = one % form.columns;
      const int here = row + 1 == rows ? pairs - row * form.columns : form.columns;
      return std::pair{std::int64_t{form.across} * (2 * column - (here - 1)), std::int64_t{form.deep} * (2 * row - (rows - 1))};
    };
    Case& c = f.add().when(item, states);
    const auto wish_at = [&](int axis, std::int64_t twice) {
      c.wish(mid2(item, axis) - Linear(std::int64_t{lo_of(model, of.part, axis)} + hi_of(model, of.part, axis) + twice), of.weight, 2);
    };
    const auto [along, deep] = place_of(pair);
    wish_at(row_axis, along);
    wish_at(back.axis, deep - std::int64_t{back.sign} * desk.depth);
    if (k == 0) return;
    // In line with its mate, back to back, or with the island beside or before.
    const bool mate = k % 2 == 1;
    const int neighbour = mate ? pair : pair % form.columns > 0 ? pair - 1 : pair - form.columns;
    const ItemId other = group[2 * neighbour];
    const auto [next_along, next_deep] = place_of(neighbour);
    c.wish(mid2(item, row_axis) - mid2(other, row_axis) - Linear(along - next_along), of.in_line, 2);
    c.wish(mid2(item, back.axis) - mid2(other, back.axis) - Linear(deep - next_deep - (mate ? 2 * back.sign * desk.depth : 0)), of.in_line,
           2);
  });
  // Both of a pair have their cases in the same order: those along y first.
  if (k % 2 == 1) std::ranges::reverse(f.cases);
}

}  // namespace layoutbox::placement
