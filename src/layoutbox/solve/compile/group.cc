// Relations of several objects: around a table, on either side, in rows and grids, symmetric.
#include <cmath>
#include <numeric>

#include "layoutbox/solve/compile/phrases.h"
#include "layoutbox/solve/compile/seating.h"

namespace layoutbox::placement {
namespace {

// All orders of a few things; only the given one where there are more than four (identical objects need no other).
std::vector<std::vector<int>> orders_of(std::vector<int> things, const Model& model) {
  const auto same_kind = [&](int a, int b) { return model.items[a].entry == model.items[b].entry; };
  const bool identical = std::all_of(things.begin(), things.end(), [&](int t) { return same_kind(t, things[0]); });
  if (identical || things.size() > 4) return {things};
  std::vector<std::vector<int>> orders;
  std::sort(things.begin(), things.end());
  do {
    orders.push_back(things);
  } while (std::next_permutation(things.begin(), things.end()));
  return orders;
}

// Targets in a line along an axis, in that order; `gap` 0 or more: exactly so far apart.
void require_line(Case& c, const std::vector<int>& order, int axis, const std::optional<Mm>& gap, int edge) {
  for (std::size_t i = 1; i < order.size(); ++i) {
    const int a = order[i - 1], b = order[i];
    const Linear between = lo(b, axis) - hi(a, axis);
    if (gap) {
      c.require_small(between - Linear(*gap), 0);
    } else {
      c.require(between).wish(between - Linear(150), 20);
    }
    const int other = 1 - axis;
    if (edge == 0) c.require_small(mid2(b, other) - mid2(order[0], other), 1);
    if (edge == 1) c.require_small(lo(b, other) - lo(order[0], other), 0);
    if (edge == 2) c.require_small(hi(b, other) - hi(order[0], other), 0);
  }
}

void line_of_all(Compilation& c, const std::vector<int>& axes) {
  Formula& f = c.formula();
  if (c.targets.size() < 2) {
    f.add();
    return;
  }
  for (const std::vector<int>& order : orders_of(c.targets, c.model)) {
    for (const int axis : axes) {
      for (const int edge : {0, 1, 2}) {
        Case& in = f.add();
        require_line(in, order, axis, c.relation.parameters.gap, edge);
        // The same way round, as a row is.
        in.price = edge * 5;
      }
    }
  }
}

// The extent of a reference: an item's box or a wall's line.
Linear low_of(const Compilation& c, const Reference& r, int axis) {
  if (r.kind == Reference::Kind::kItem) return lo(r.index, axis);
  const RoomWall& wall = c.model.walls[r.index];
  return {axis == wall.along ? wall.lo : wall.at};
}

Linear high_of(const Compilation& c, const Reference& r, int axis) {
  if (r.kind == Reference::Kind::kItem) return hi(r.index, axis);
  const RoomWall& wall = c.model.walls[r.index];
  return {axis == wall.along ? wall.hi : wall.at};
}

}  // namespace

void compile_EachSideOf(Compilation& c) {
  const Mm most = c.length(c.relation.parameters.max, "max", 500);
  const bool fore_and_aft = c.relation.parameters.axis == Axis::kY;
  const Side first = fore_and_aft ? Side::kFront : Side::kLeft, second = fore_and_aft ? Side::kBack : Side::kRight;
  for (const int r : c.reference_items()) {
    // Alternately to either side, in the order given (or turned round): how many to each side is then as it must be.
    const auto orders = orders_of(c.targets, c.model);
    std::vector<std::vector<Formula>> ways;
    for (const bool swapped : {false, true}) {
      if (swapped && orders.size() == 1 && c.targets.size() % 2 == 0) continue;  // identical: nothing new
      std::vector<Formula>& way = ways.emplace_back();
      for (std::size_t i = 0; i < c.targets.size(); ++i) {
        const Side side = (i % 2 == 0) == !swapped ? first : second;
        Formula& f = way.emplace_back();
        add_beyond(f, c.model, c.targets[i], r, side, most, 50);
      }
    }
    if (ways.size() == 1) {
      for (Formula& f : ways[0]) c.formula() = std::move(f);
      continue;
    }
    // Each target beyond one of the sides, and any two neighbours in the list beyond different ones.
    for (std::size_t i = 0; i < c.targets.size(); ++i) {
      Formula& f = c.formula();
      for (auto& way : ways) {
        for (Case& one : way[i].cases) f.cases.push_back(one);
      }
    }
    for (std::size_t i = 1; i < c.targets.size(); ++i) {
      Formula& f = c.formula();
      for_each_turn(c.item(r), [&](int turn, std::uint64_t states) {
        for (const Side side : {first, second}) {
          const Direction d = side_direction(c.item(r), side, turn);
          Case& in = f.add().when(r, states);
          in.require(gap_towards(c.targets[i - 1], r, d)).require(gap_towards(c.targets[i], r, opposite(d)));
        }
      });
    }
  }
}

void compile_Between(Compilation& c) {
  for (const int t : c.targets) {
    Formula& f = c.formula();
    const std::size_t n = c.references.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        if (i == j || c.references[i].kind == Reference::Kind::kRoom || c.references[j].kind == Reference::Kind::kRoom) continue;
        for (int axis = 0; axis < 2; ++axis) {
          const Reference &a = c.references[i], &b = c.references[j];
          Case& in = f.add();
          in.require(lo(t, axis) - high_of(c, a, axis)).require(low_of(c, b, axis) - hi(t, axis));
          in.wish(mid2(t, axis) - high_of(c, a, axis) - low_of(c, b, axis), 60, 2);
          const int other = 1 - axis;
          for (const Reference* ref : {&a, &b}) {
            if (ref->kind == Reference::Kind::kWall && c.model.walls[ref->index].along != other) continue;
            in.require(mid2(t, other) - 2 * low_of(c, *ref, other)).require(2 * high_of(c, *ref, other) - mid2(t, other));
            in.wish(mid2(t, other) - low_of(c, *ref, other) - high_of(c, *ref, other), 40, 2);
          }
        }
      }
    }
    if (n < 2) f.add();
  }
}

void compile_Row(Compilation& c) {
  std::vector<int> axes{0, 1};
  if (c.relation.parameters.axis) axes = {static_cast<int>(*c.relation.parameters.axis)};
  line_of_all(c, axes);
}

void compile_Column(Compilation& c) { line_of_all(c, {1}); }

void compile_Grid(Compilation& c) {
  const int n = static_cast<int>(c.targets.size());
  int columns = c.relation.parameters.columns.value_or(0);
  if (columns < 1) columns = static_cast<int>(std::ceil(std::sqrt(n)));
  columns = std::min(columns, std::max(n, 1));
  Case& in = c.formula().add();
  const auto centre_step = [&](int from, int to, int like_from, int like_to, int axis) {
    in.require_small((mid2(to, axis) - mid2(from, axis)) - (mid2(like_to, axis) - mid2(like_from, axis)), 0);
  };
  const auto at = [&](int row, int column) { return c.targets[row * columns + column]; };
  const int rows = (n + columns - 1) / columns;
  for (int i = 0; i < n; ++i) {
    const int row = i / columns, column = i % columns;
    if (row > 0) {
      in.require_small(mid2(at(row, column), 0) - mid2(at(0, column), 0), 0);
      const Linear gap = lo(at(row, column), 1) - hi(at(row - 1, column), 1);
      in.require(gap);
      if (c.relation.parameters.gap) in.require_small(gap - Linear(*c.relation.parameters.gap), 0);
      in.wish(gap - Linear(600), 20);
    }
    if (column > 0) {
      in.require_small(mid2(at(row, column), 1) - mid2(at(row, 0), 1), 0);
      const Linear gap = lo(at(row, column), 0) - hi(at(row, column - 1), 0);
      in.require(gap);
      if (c.relation.parameters.gap) in.require_small(gap - Linear(*c.relation.parameters.gap), 0);
      in.wish(gap - Linear(400), 20);
    }
  }
  for (int column = 2; column < columns; ++column) centre_step(at(0, column - 1), at(0, column), at(0, column - 2), at(0, column - 1), 0);
  for (int row = 2; row < rows; ++row) centre_step(at(row - 1, 0), at(row, 0), at(row - 2, 0), at(row - 1, 0), 1);
}

void compile_EvenlySpaced(Compilation& c) {
  if (c.targets.size() < 3) {
    c.formula().add();
    return;
  }
  std::vector<int> axes{0, 1};
  if (c.relation.parameters.axis) axes = {static_cast<int>(*c.relation.parameters.axis)};
  Formula& f = c.formula();
  for (const std::vector<int>& order : orders_of(c.targets, c.model)) {
    for (const int axis : axes) {
      Case& in = f.add();
      for (std::size_t i = 1; i < order.size(); ++i) {
        const Linear gap = lo(order[i], axis) - hi(order[i - 1], axis);
        in.require(gap);
        if (i > 1) in.require_small(gap - (lo(order[i - 1], axis) - hi(order[i - 2], axis)), 4);
      }
      if (axes.size() > 1) {  // spread farther along this axis than along the other
        const int a = order.front(), b = order.back();
        for (const int sign : {1, -1}) {
          in.require(lo(b, axis) - lo(a, axis) - sign * (lo(b, 1 - axis) - lo(a, 1 - axis)));
        }
      }
    }
  }
}

void compile_SymmetricAbout(Compilation& c) {
  const std::size_t n = c.targets.size();
  for (const Reference& r : c.references) {
    Formula& f = c.formula();
    const auto mirror = [&](Case& in, int axis, const Linear& twice_middle) {
      for (std::size_t i = 0; i < (n + 1) / 2; ++i) {
        const int a = c.targets[i], b = c.targets[n - 1 - i];
        in.require_small(mid2(a, axis) + mid2(b, axis) - 2 * twice_middle, 4);
        if (a != b) in.require_small(mid2(a, 1 - axis) - mid2(b, 1 - axis), 4);
      }
    };
    if (r.kind == Reference::Kind::kWall) {
      const RoomWall& wall = c.model.walls[r.index];
      mirror(f.add(), wall.along, Linear(std::int64_t{wall.lo} + wall.hi));
    } else if (r.kind == Reference::Kind::kItem) {
      const Side along = c.relation.parameters.axis == Axis::kY ? Side::kBack : Side::kRight;
      for_each_turn(c.item(r.index), [&](int turn, std::uint64_t states) {
        const int axis = side_direction(c.item(r.index), along, turn).axis;
        mirror(f.add().when(r.index, states), axis, mid2(r.index, axis));
      });
    }
  }
}

void compile_PairedWith(Compilation& c) {
  const Mm most = c.length(c.relation.parameters.max, "max", 500);
  const std::vector<int> refs = c.reference_items();
  if (refs.empty()) return;
  for (std::size_t i = 0; i < c.targets.size(); ++i) {
    Case in;
    const int r = refs[i % refs.size()];
    for (int axis = 0; axis < 2; ++axis) in.wish(mid2(c.targets[i], axis) - mid2(r, axis), 20, 2);
    add_within(c.formula(), std::move(in), c.model, c.targets[i], r, most);
  }
}

void compile_Around(Compilation& c) {
  const Mm most = c.length(c.relation.parameters.max, "max", 500);
  for (const int r : c.reference_items()) add_seating(c, r, most, false);
}

void compile_Surround(Compilation& c) {
  const Mm most = c.length(c.relation.parameters.max, "max", 500);
  for (const int r : c.reference_items()) add_seating(c, r, most, true);
}

}  // namespace layoutbox::placement
