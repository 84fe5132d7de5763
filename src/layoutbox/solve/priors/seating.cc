#include "layoutbox/solve/priors/seating.h"
#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/measures.h"

#include <bit>
#include <cmath>
#include <optional>

#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {
namespace {

constexpr std::size_t kOfSides = 10, kOfCircle = 40;  // ways to share seats out over the sides; few of them are a circle

constexpr int kEndTaken = 500;  // points

constexpr std::array kSides{Side::kFront, Side::kBack, Side::kLeft, Side::kRight};

// A stove, a statue, a pit: what one sits round at a distance, for it is neither a table nor stands in for one.
bool is_sat_off(const Item& table) {
  if (table.entry == nullptr || table.thin || table.is(Trait::kTable) || table.is(Trait::kCounter) || table.is(Trait::kDeskLike))
    return false;
  return !table.entry->top_carries || table.entry->back_to_wall;
}

Mm wished_reach_under(const Item& seat, const Item& table) {
  if (is_sat_off(table)) return -measures().knees_free;
  const std::vector<Side> used = seat.object->used_sides.value_or(seat.entry->used_sides);
  if (used.size() == 1 && used[0] == Side::kFront) return -measures().easy_seat_to_table;  // got into from the front only
  return has_knee_room(table) ? measures().pushed_under : -measures().off_kneeless;
}

// At the same height somewhere, so that the distance is that in plan.
void require_level(Case& in, const PlacementModel& model, ItemId t, ItemId r) {
  if (floor_only(model.items[t]) && floor_only(model.items[r])) return;
  in.require(hi(r, 2) - lo(t, 2)).require(hi(t, 2) - lo(r, 2));
}

// How far apart in degrees the seats come seen from the middle, at worst, when each may be 40 mm off its place along the side, and
// anywhere out to `most`. Positions in the table's frame at that extent.
double widest_angle(const Seats& seats, Mm width, Mm depth, const std::vector<Size>& sizes, Mm least_out, Mm most_out) {
  struct Range {
    double low, high;
  };
  std::vector<Range> ranges;
  std::size_t next = 0;
  for (int s = 0; s < 4; ++s) {
    const double length = s < 2 ? width : depth, half = (s < 2 ? depth : width) / 2.0;
    for (int k = 0; k < seats[s]; ++k, ++next) {
      const double along = length * (2 * k + 1) / (2.0 * seats[s]) - length / 2;
      const double middle = s == 0 ? -90 : s == 1 ? 90 : s == 2 ? 180 : 0;
      Range range{1e9, -1e9};
      for (const double off : {-40.0, 40.0}) {
        for (const Mm out : {least_out, most_out}) {
          const double away = half + out + sizes[next].depth / 2.0;
          const double turn = std::atan2(along + off, away) * (180 / kPi);  // from the side's own direction
          const double angle = middle + (s == 0 || s == 3 ? turn : -turn);
          range.low = std::min(range.low, angle), range.high = std::max(range.high, angle);
        }
      }
      ranges.push_back(range);
    }
  }
  std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) { return a.low + a.high < b.low + b.high; });
  double widest = ranges[0].high + 360 - ranges.back().low;
  for (std::size_t i = 1; i < ranges.size(); ++i) widest = std::max(widest, ranges[i].high - ranges[i - 1].low);
  return widest;
}

void add_case(Formula& f, Compilation& c, ItemId r, int table_turn, std::uint64_t table_states, const Seats& seats, int price, Mm most,
              std::optional<Mm> least_gap = std::nullopt) {
  const Item& table = c.item(r);
  Case in;
  in.when(r, table_states);
  in.price = price;
  std::size_t next = 0;
  for (int s = 0; s < 4; ++s) {
    const Direction d = side_direction(table, kSides[s], table_turn);
    const int a = across(d), n = seats[s];
    for (int k = 0; k < n; ++k, ++next) {
      const ItemId t = c.targets[next];
      const Item& seat = c.item(t);
      std::uint64_t facing = 0;
      for_each_turn(seat, [&](int turn, std::uint64_t states) {
        if (turn % 90 == 0 && (!seat.has_front || side_direction(seat, Side::kFront, turn) == opposite(d))) facing |= states;
      });
      if (!facing) return;
      in.when(t, facing);
      const Linear gap = gap_towards(t, r, d);
      require_level(in, c.model, t, r);
      if (c.targets.size() > 1) {  // it stands out farther at this side than at the next: it counts for this one
        for (const int sign : {1, -1}) {
          const Direction beside{a, sign};
          in.require(reach(t, d) - reach(r, d) - reach(t, beside) + reach(r, beside) - Linear(1));
        }
      }
      if (least_gap) in.require(gap - Linear(*least_gap));
      in.require(Linear(most) - gap).require(reach(t, d) - reach(r, d)).require(-2 * reach(t, opposite(d)) - d.sign * mid2(r, d.axis));
      // n · mid2(t) = 2n · lo(r) + (2k + 1) · extent(r): seat k of n, evenly spaced; 40 mm either way.
      const Linear off = n * mid2(t, a) - 2 * n * lo(r, a) - (2 * k + 1) * extent(r, a);
      in.require_small(off, 2 * n * 40).wish(off, 100, 2 * n);
      if (table.least_extent(a) < 2 * n * 40)  // round something small it still looks at that
        in.require(mid2(t, a) - 2 * lo(r, a)).require(2 * hi(r, a) - mid2(t, a));
      in.wish(gap + Linear(wished_reach_under(seat, table)), 40);
    }
  }
  f.cases.push_back(std::move(in));
}

// What has no front has its sides by the room (`side_direction`): turned by a quarter, its width is along the other two.
Size size_by_sides(const Item& table, int turn) {
  Size size = table.states[0].size;
  if (!table.has_front && turn % 180 == 90) std::swap(size.width, size.depth);
  return size;
}

// Seen from its middle much the same all round: what stands in a circle around it need not stand at its sides.
bool is_compact(const Item& table) {
  const Size& size = table.states[0].size;
  return 2 * std::max(size.width, size.depth) <= 3 * std::min(size.width, size.depth);
}

bool is_circle(const Item& table) {
  const Size& size = table.states[0].size;
  return table.entry != nullptr && is_round(*table.object, *table.entry) && std::abs(size.width - size.depth) <= 100;
}

// Seats at the sides of one state of the table such that no two neighbours are too far apart, seen from its middle. How far out they may
// be is narrowed until that is sure.
void add_even_seats(Formula& f, Compilation& c, ItemId r, std::size_t state, const Seats& seats, int price, Mm most) {
  const Item& table = c.item(r);
  const State& s = table.states[state];
  const auto n = static_cast<int>(c.targets.size());
  std::vector<Size> sizes;
  for (const ItemId t : c.targets) sizes.push_back(c.item(t).states[0].size);
  Size size = s.size;
  if (!table.has_front && s.turn % 180 == 90) std::swap(size.width, size.depth);
  const double limit = 1.5 * 360 / n;
  const Mm under = -wished_reach_under(c.item(c.targets[0]), table);
  for (const Mm reach : {most, 300, 150, 50}) {
    for (const Mm inward : {150, 50}) {
      const Mm low = std::min(under - inward, most), high = std::min(most, std::max(low, under + reach));
      if (n > 1 && widest_angle(seats, size.width, size.depth, sizes, low, high) > limit) continue;
      add_case(f, c, r, s.turn, std::uint64_t{1} << state, seats, price, high, low);
      return;
    }
  }
}

// What is surely needed for "around" and "in a circle around".
void add_needed(Compilation& c, ItemId r, Mm most) {
  for (const ItemId t : c.targets) {
    Formula& near = c.formula();
    near.add();
    near.exact = false;
    add_within(near.outer, {}, c.model, t, place_of(r), most, Purpose::kProving);
    if (near.outer.empty()) {  // never near enough
      near.exact = true;
      near.cases.clear();
    }
    Formula looks;
    add_looks_at(looks, c.model, t, r);
    Formula& turned = c.formula();
    turned.add();
    turned.outer = looks.exact ? std::move(looks.cases) : std::move(looks.outer);
    turned.exact = false;
  }
}

// Who is told to sit at an end of the table has it: so many of its ends are taken.
int ends_taken(const Compilation& c, ItemId r) {
  const std::string& table = c.item(r).id;
  int taken = 0;
  for (const Relation& relation : c.model.scene->relations) {
    if (relation.type == RelationType::kAlongSide && or_default(relation, &RelationParameters::side) == Side::kShort &&
        std::ranges::find(relation.references, table) != relation.references.end())
      taken += static_cast<int>(relation.targets.size());
  }
  return taken;
}

int ends_used(const Seats& seats, const Size& size) {
  return size.width >= size.depth ? (seats[2] > 0) + (seats[3] > 0) : (seats[0] > 0) + (seats[1] > 0);
}

}  // namespace

void add_seating(Compilation& c, ItemId r, Mm most, bool circle) {
  const Item& table = c.item(r);
  const int n = static_cast<int>(c.targets.size());
  if (n == 0) return;
  add_needed(c, r, most);
  Formula& f = c.formula();
  f.exact = false;
  Mm seat_width = 0;
  for (const ItemId t : c.targets) seat_width = std::max(seat_width, c.item(t).states[0].size.width);
  const bool round = (n >= 5 || n == 3) && (is_circle(table) || (circle && is_compact(table)));
  if (round) add_circle(f, c, r, most);
  const int base = round && !f.cases.empty() ? 200 : 0;
  const int ends = 2 - ends_taken(c, r);
  for_each_turn(table, [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Size size = size_by_sides(table, turn);
    for (const auto& [seats, even] : seatings(n, size.width, size.depth, seat_width, circle, circle ? kOfCircle : kOfSides)) {
      const int price = even + (ends_used(seats, size) > ends ? kEndTaken : 0);
      if (!circle) add_case(f, c, r, turn, states, seats, price + base, most);
      for (std::size_t s = 0; circle && s < table.states.size(); ++s) {
        if ((states >> s & 1) != 0) add_even_seats(f, c, r, s, seats, price + base, most);
      }
    }
  });
  if (!f.cases.empty() || circle) return;
  // More than the sides hold: one side after the other, as near as it gets, looking at it.
  c.out.formulas.pop_back();
  for (int i = 0; i < n; ++i) {
    const ItemId t = c.targets[i];
    Formula& at = c.formula();
    at.exact = false;
    add_beside(at, c.model, t, r, kSides[i % 4], {.most = most, .wished_gap = 50, .may_reach_under = true});
    at.outer.clear();
    for (Case& one : at.cases) {
      const int turn = table.states[static_cast<std::size_t>(std::countr_zero(one.states[0].states))].turn;
      const Direction d = side_direction(table, kSides[i % 4], turn);
      require_level(one, c.model, t, r);
      for (const int sign : {1, -1}) {
        const Direction next{across(d), sign};
        one.require(reach(t, d) - reach(r, d) - reach(t, next) + reach(r, next) - Linear(1));
      }
    }
    add_looks_at(c.formula(), c.model, t, r);
  }
}

}  // namespace layoutbox::placement
