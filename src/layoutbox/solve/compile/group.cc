// Relations of several objects: around a table, on either side, in rows and grids.
#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "layoutbox/catalog/close_rows.h"
#include "layoutbox/solve/compile/phrases.h"
#include "layoutbox/solve/priors/seating.h"

namespace layoutbox::placement {
namespace {

// The orders to try, and whether they are all there are.
std::vector<std::vector<ItemId>> orders_into(Formula& f, const Compilation& c) {
  std::vector<std::vector<ItemId>> orders = orders_of(c.model, c.relation, c.targets);
  if (!orders.empty()) return orders;
  f.exact = false;
  return {c.targets};
}

std::vector<int> axes_of(const Compilation& c) {
  if (!c.relation.parameters.axis) return {0, 1};
  const int axis = static_cast<int>(*c.relation.parameters.axis);
  return axis < 2 ? std::vector<int>{axis} : std::vector<int>{};
}

// Targets in a line along an axis, in that order; `gap` 0 or more: exactly so far apart.
void require_line(const PlacementModel& model, Case& c, const std::vector<ItemId>& order, int axis, const std::optional<Mm>& gap,
                  int edge) {
  const bool close = std::ranges::all_of(order, [&](ItemId item) {
    const Item& one = model.items[item];
    return !one.is_opening() && one.mount == Mount::kFloor && layoutbox::stands_close(*one.entry);
  });
  for (std::size_t i = 1; i < order.size(); ++i) {
    const ItemId a = order[i - 1], b = order[i];
    const Linear between = lo(b, axis) - hi(a, axis);
    if (gap) {
      c.require_small(between - Linear(*gap), 0);
    } else {
      c.require(between).wish(between - Linear(close ? 0 : 150), close ? 100 : 20);
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
  for (const std::vector<ItemId>& order : orders_into(f, c)) {
    for (const int axis : axes) {
      for (const int edge : {0, 1, 2}) {
        Case& in = f.add();
        require_line(c.model, in, order, axis, c.relation.parameters.gap, edge);
        // The same way round, as a row is.
        in.price = edge * 5;
      }
    }
  }
}

// Every choice of half of the things, of an odd number either half.
std::vector<std::vector<char>> halves_of(std::size_t n) {
  std::vector<std::vector<char>> halves;
  for (std::uint32_t mask = 0; mask < (1u << n); ++mask) {
    const auto count = static_cast<std::size_t>(std::popcount(mask));
    if (count != n / 2 && count != n - n / 2) continue;
    std::vector<char>& first = halves.emplace_back(n);
    for (std::size_t i = 0; i < n; ++i) first[i] = static_cast<char>(mask >> i & 1);
  }
  return halves;
}

constexpr std::size_t kMostDivided = 6;

// The sides of the reference that may be meant, in pairs: what has no front, and tables, are flanked from front and back, too.
std::vector<std::pair<Side, Side>> pairs_of_sides(const Compilation& c, ItemId r) {
  const std::pair across{Side::kLeft, Side::kRight}, along{Side::kFront, Side::kBack};
  if (c.relation.parameters.axis) return {c.relation.parameters.axis == Axis::kY ? along : across};
  if (c.item(r).is_opening() || (c.item(r).has_front && !c.item(r).takes_seats)) return {across};
  return {across, along};
}

constexpr int kFromFrontAndBack = 150;  // points

// Alternately to either side, in the order given.
std::vector<std::vector<char>> alternating(std::size_t n) {
  std::vector<std::vector<char>> halves(n % 2 == 1 ? 2 : 1, std::vector<char>(n));
  for (std::size_t k = 0; k < halves.size(); ++k) {
    for (std::size_t i = 0; i < n; ++i) halves[k][i] = static_cast<char>(i % 2 == k);
  }
  return halves;
}

// Half of the targets are beyond the one side of r, the others beyond the other.
void part_evenly(Formula& f, const Compilation& c, ItemId r, const std::vector<std::pair<Side, Side>>& pairs,
                 const std::vector<std::vector<char>>& halves) {
  for_each_turn(c.item(r), [&](int turn, std::uint64_t states) {
    for (const auto& [first, second] : pairs) {
      const Direction d = side_direction(c.item(r), first, turn);
      for (const std::vector<char>& half : halves) {
        Case& in = f.add().when(r, states);
        for (std::size_t i = 0; i < half.size(); ++i) in.require(gap_towards(c.targets[i], r, half[i] ? d : opposite(d)));
        if (first == Side::kFront && pairs.size() > 1) in.price = kFromFrontAndBack;
      }
    }
  });
}

// The middle of t within the common extent of a and b along the other axis; best within either's own.
void stand_between(Formula& f, ItemId t, const Place& a, const Place& b, int axis) {
  const int other = 1 - axis;
  for (const auto& [low, high] : {std::pair{&a, &a}, {&b, &b}, {&a, &b}, {&b, &a}}) {
    Case& in = f.add();
    in.require(lo(t, axis) - a.hi[axis]).require(b.lo[axis] - hi(t, axis));
    in.wish(mid2(t, axis) - a.hi[axis] - b.lo[axis], 60, 2);
    in.require(mid2(t, other) - 2 * low->lo[other]).require(2 * high->hi[other] - mid2(t, other));
    for (const Place* ref : {&a, &b}) {
      if (ref->item.exists()) in.wish(mid2(t, other) - ref->lo[other] - ref->hi[other], 40, 2);
    }
    if (low != high) in.price = 60;
  }
}

bool is_known_exactly(const Compilation& c, const Reference& r) {
  return r.kind == Reference::Kind::kItem || (r.kind == Reference::Kind::kWall && c.model.walls[r.wall].straight);
}

}  // namespace

void compile_EachSideOf(Compilation& c) {
  const Mm most = c.length(&RelationParameters::max);
  const std::size_t n = c.targets.size();
  // In the order given, where that is as good as any other or the others are too many.
  const bool alike = orders_of(c.model, c.relation, c.targets).size() == 1;
  const std::vector<std::vector<char>> halves = alike || n > kMostDivided ? alternating(n) : halves_of(n);
  for (const ItemId r : c.reference_items()) {
    const auto pairs = pairs_of_sides(c, r);
    for (const ItemId t : c.targets) {  // each beyond one of the sides…
      Formula& f = c.formula();
      for (const auto& [first, second] : pairs) {
        for (const Side side : {first, second}) add_beside(f, c.model, t, r, side, {.most = most, .wished_gap = 50});
      }
    }
    if (n < 2) continue;
    Formula& f = c.formula();  // …and half of them beyond either
    f.exact = alike || n <= kMostDivided;
    part_evenly(f, c, r, pairs, halves);
  }
}

void compile_Between(Compilation& c) {
  const auto is_place = [](const Reference& r) { return r.kind != Reference::Kind::kRoom; };
  for (const ItemId t : c.targets) {
    Formula& f = c.formula();
    const std::size_t n = c.references.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        if (i == j || !is_place(c.references[i]) || !is_place(c.references[j])) continue;
        const Place a = c.place(c.references[i]), b = c.place(c.references[j]);
        for (const int axis : {0, 1}) stand_between(f, t, a, b, axis);
      }
    }
    f.exact = f.exact && std::ranges::all_of(c.references, [&](const Reference& r) { return is_known_exactly(c, r); });
  }
}

void compile_Row(Compilation& c) { line_of_all(c, axes_of(c)); }

void compile_Column(Compilation& c) { line_of_all(c, {1}); }

void compile_EvenlySpaced(Compilation& c) {
  if (c.targets.size() < 3) {
    c.formula().add();
    return;
  }
  const std::vector<int> axes = axes_of(c);
  Formula& f = c.formula();
  f.exact = false;
  const std::vector<std::vector<ItemId>> orders = orders_into(f, c);
  const bool all_orders = !orders_of(c.model, c.relation, c.targets).empty();
  for (const std::vector<ItemId>& order : orders) {
    for (const int axis : axes) {
      const auto gap = [&](std::size_t i) { return lo(order[i], axis) - hi(order[i - 1], axis); };
      if (all_orders) {  // overlapping things may be evenly spaced as well
        Case& outer = f.add_outer();
        for (std::size_t i = 2; i < order.size(); ++i) outer.require_small(gap(i) - gap(1), kSurelyUneven);
      }
      Case& in = f.add();
      for (std::size_t i = 1; i < order.size(); ++i) {
        in.require(gap(i));
        if (i > 1) in.require_small(gap(i) - gap(1), 5);
      }
      if (axes.size() < 2) continue;
      // Spread farther along this axis than along the other; as far as along x counts as along x.
      const Linear spread = mid2(order.back(), axis) - mid2(order.front(), axis) - Linear(axis == 0 ? 0 : 1);
      for (const ItemId a : order) {
        for (const ItemId b : order) {
          if (a != b) in.require(spread - mid2(a, 1 - axis) + mid2(b, 1 - axis));
        }
      }
    }
  }
}

namespace {

// All choices of a target of its own for each reference; those in the order given where they are too many.
std::vector<std::vector<ItemId>> choices(const std::vector<ItemId>& targets, std::size_t refs) {
  if (targets.size() > 4) return {{targets.begin(), targets.begin() + static_cast<std::ptrdiff_t>(refs)}};
  std::vector<std::vector<ItemId>> out;
  std::vector<ItemId> order = targets;
  std::sort(order.begin(), order.end());
  do {
    std::vector<ItemId> head(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(refs));
    if (out.empty() || out.back() != head) out.push_back(std::move(head));
  } while (std::next_permutation(order.begin(), order.end()));
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace

void compile_PairedWith(Compilation& c) {
  const Mm most = c.length(&RelationParameters::max);
  const std::vector<ItemId> refs = c.reference_items();
  if (refs.size() != c.references.size() || refs.size() > c.targets.size() || refs.empty()) {
    c.never();
    return;
  }
  for (const ItemId t : c.targets) {  // by one of them each…
    Formula& f = c.formula();
    for (const ItemId r : refs) add_band(f, c.model, t, place_of(r), 0, most, 100);
  }
  if (refs.size() < 2) return;
  for (const ItemId r : refs) {  // …and each has one, surely…
    Formula& f = c.formula();
    for (const ItemId t : c.targets) add_band(f, c.model, t, place_of(r), 0, most, 100);
  }
  Formula& own = c.formula();  // …of its own
  own.exact = false;
  for (const std::vector<ItemId>& chosen : choices(c.targets, refs.size())) {
    Case in;
    for (std::size_t i = 0; i < refs.size(); ++i) {
      std::vector<Case> near;
      add_within(near, {}, c.model, chosen[i], place_of(refs[i]), most, Purpose::kPlacing);
      if (near.empty()) continue;
      const Case& round = near.back();
      in.states.insert(in.states.end(), round.states.begin(), round.states.end());
      in.at_least_zero.insert(in.at_least_zero.end(), round.at_least_zero.begin(), round.at_least_zero.end());
      for (int axis = 0; axis < 2; ++axis) in.wish(mid2(chosen[i], axis) - mid2(refs[i], axis), 20, 2);
    }
    own.cases.push_back(std::move(in));
  }
}

void compile_Around(Compilation& c) {
  const Mm most = c.length(&RelationParameters::max);
  for (const ItemId r : c.reference_items()) add_seating(c, r, most, false);
}

void compile_Surround(Compilation& c) {
  const Mm most = c.length(&RelationParameters::max);
  for (const ItemId r : c.reference_items()) add_seating(c, r, most, true);
}

}  // namespace layoutbox::placement
