// Things in rows and columns.
#include <algorithm>
#include <cmath>

#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {
namespace {

// The targets of a relation in rows from the front and columns from the left, in the order given.
struct Grid {
  const std::vector<ItemId>& targets;
  int columns;

  int rows() const { return (static_cast<int>(targets.size()) + columns - 1) / columns; }
  ItemId at(int row, int column) const { return targets[static_cast<std::size_t>(row * columns + column)]; }
};

Grid grid_of(const Compilation& c) {
  const int n = static_cast<int>(c.targets.size());
  int columns = c.relation.parameters.columns.value_or(0);
  if (columns < 1) columns = static_cast<int>(std::ceil(std::sqrt(n)));
  return {c.targets, std::min(columns, std::max(n, 1))};
}

// In line with the first of its row or column, and behind the one before it.
void follow(Case& in, const Grid& grid, int row, int column, int axis, Mm usual) {
  const ItemId t = grid.at(row, column), before = axis == 0 ? grid.at(row, column - 1) : grid.at(row - 1, column),
               first = axis == 0 ? grid.at(row, 0) : grid.at(0, column);
  in.require_small(mid2(t, 1 - axis) - mid2(first, 1 - axis), 0);
  const Linear gap = lo(t, axis) - hi(before, axis);
  in.require(gap);
  if (usual > 0) in.wish(gap - Linear(usual), 20);
}

// The middles of three that follow one another are as far apart, and the third in line with the second.
void step_evenly(Case& in, ItemId t, ItemId before, ItemId before_that, int axis) {
  in.require_small((mid2(t, axis) - mid2(before, axis)) - (mid2(before, axis) - mid2(before_that, axis)), 0);
}

// The gap is that between the longest: one of them is that.
void keep_gap(Compilation& c, const Grid& grid, int axis, Mm gap) {
  const ItemId next = axis == 0 ? (grid.columns > 1 ? grid.at(0, 1) : ItemId()) : (grid.rows() > 1 ? grid.at(1, 0) : ItemId());
  if (!next.exists()) return;
  Formula& spacing = c.formula();
  spacing.exact = false;
  for (const ItemId longest : c.targets) {
    Case& one = spacing.add();
    for (const ItemId t : c.targets) {
      if (t != longest) one.require(extent(longest, axis) - extent(t, axis));
    }
    one.require_small(mid2(next, axis) - mid2(grid.at(0, 0), axis) - 2 * extent(longest, axis) - Linear(std::int64_t{2} * gap), 2);
  }
}

}  // namespace

void compile_Grid(Compilation& c) {
  const Grid grid = grid_of(c);
  const int n = static_cast<int>(c.targets.size());
  Formula& f = c.formula();
  f.exact = false;                              // in the order given only
  if (grid.rows() == 1 || grid.columns == 1) {  // whatever the order: one line
    const int across = grid.rows() == 1 ? 1 : 0;
    Case& line = f.add_outer();
    for (const ItemId t : c.targets) line.require_small(mid2(t, across) - mid2(c.targets[0], across), 2 * kSurelyUneven);
  }
  Case& in = f.add();
  const bool anywhere = n > 0 && c.model.items[c.targets[0]].is(Trait::kBearsCeiling);  // pillars are as far apart as the room is long
  for (int i = 0; i < n; ++i) {
    const int row = i / grid.columns, column = i % grid.columns;
    if (row > 0) follow(in, grid, row, column, 1, anywhere ? 0 : 600);
    if (column > 0) follow(in, grid, row, column, 0, anywhere ? 0 : 400);
  }
  // Said of every row and column, not of the first alone: a search that places one after another sees at once what each must keep to.
  for (int i = 0; i < n; ++i) {
    const int row = i / grid.columns, column = i % grid.columns;
    const ItemId t = grid.at(row, column);
    if (column > 1) step_evenly(in, t, grid.at(row, column - 1), grid.at(row, column - 2), 0);
    if (row > 1) step_evenly(in, t, grid.at(row - 1, column), grid.at(row - 2, column), 1);
    if (row > 1) in.require_small(mid2(t, 0) - mid2(grid.at(row - 1, column), 0), 0);
    if (column > 1) in.require_small(mid2(t, 1) - mid2(grid.at(row, column - 1), 1), 0);
  }
  if (!c.relation.parameters.gap) return;
  for (const int axis : {0, 1}) keep_gap(c, grid, axis, *c.relation.parameters.gap);
}

}  // namespace layoutbox::placement
