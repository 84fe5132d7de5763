#include "layoutbox/solve/priors/seating.h"
#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/measures.h"

#include <bit>
#include <cmath>
#include <optional>

#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kSquare = 150;  // sides that differ by less are alike
constexpr int kSqueezed = 60;
constexpr std::size_t kOfSides = 10, kOfCircle = 40;  // ways to share seats out over the sides; few of them are a circle

constexpr std::array kSides{Side::kFront, Side::kBack, Side::kLeft, Side::kRight};

struct Arm {
  double x, y;
};

// 0 (one heap) to 1 (like distances, like angles), the measure of SceneEval for "surround".
double evenness(const std::vector<Arm>& arms) {
  const std::size_t n = arms.size();
  if (n < 2) return 1;
  std::vector<double> lengths, angles;
  for (const Arm& a : arms) {
    lengths.push_back(std::hypot(a.x, a.y));
    angles.push_back(std::atan2(a.y, a.x));
  }
  std::vector<double> sorted = lengths;
  std::sort(sorted.begin(), sorted.end());
  const double typical = n % 2 ? sorted[n / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2;
  const double ideal = 2 * kPi / static_cast<double>(n);
  double total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double next = 2 * kPi;
    for (std::size_t j = 0; j < n; ++j) {
      if (i == j) continue;
      const double turn = std::fmod(angles[j] - angles[i] + 4 * kPi, 2 * kPi);
      next = std::min(next, turn);
    }
    const double off_distance = std::min(1.0, std::abs(lengths[i] - typical) / typical),
                 off_angle = std::min(1.0, std::abs(next - ideal) / ideal);
    total += (0.5 * (1 - off_distance) * (1 - off_distance) + 0.5 * (1 - off_angle) * (1 - off_angle)) / static_cast<double>(n);
  }
  return total;
}

std::vector<Arm> arms_of(const Seats& seats, Mm width, Mm depth, Mm out) {
  std::vector<Arm> arms;
  for (int s = 0; s < 4; ++s) {
    const double length = s < 2 ? width : depth, off = (s < 2 ? depth : width) / 2.0 + out;
    for (int k = 0; k < seats[s]; ++k) {
      const double along = length * (2 * k + 1) / (2.0 * seats[s]) - length / 2;
      if (s == 0) arms.push_back({along, -off});
      if (s == 1) arms.push_back({along, off});
      if (s == 2) arms.push_back({-off, along});
      if (s == 3) arms.push_back({off, along});
    }
  }
  return arms;
}

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

// Seats on a circle at multiples of 15°, turned to the middle; the circle as small as the seats' boxes allow. Who comes first takes the
// smallest: one on which another would stand in the table is offered only where all are so.
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

// The less even, the more crowded and the less usual, the dearer.
int price_of(const Seats& s, int n, Mm width, Mm depth, Mm seat_width, bool circle) {
  const double even = n == 1 ? 1 : evenness(arms_of(s, width, depth, seat_width / 2 - measures().pushed_under));
  int price = static_cast<int>((1 - even) * (circle ? 600 : 300));
  price += 40 * (std::abs(s[0] - s[1]) + std::abs(s[2] - s[3]));
  for (std::size_t side = 0; side < s.size(); ++side) {
    if (s[side] >= 2 && s[side] * (seat_width + measures().elbows) > (side < 2 ? width : depth)) price += kSqueezed;
  }
  if (n <= 4 && std::abs(width - depth) < kSquare && std::ranges::max(s) > 1) price += 120;        // one at each side of a square one
  if (n <= 2 && (width > depth ? s[2] + s[3] : width < depth ? s[0] + s[1] : 0) > 0) price += 20;  // long sides first
  return price;
}

}  // namespace

std::vector<std::pair<Seats, int>> seatings(int n, Mm width, Mm depth, Mm seat_width, bool circle, std::size_t limit) {
  std::vector<std::pair<Seats, int>> found;
  const int half = (n + 1) / 2;
  const auto room_for = [&](Mm length) { return std::max(1, static_cast<int>((length + 40) / (seat_width + 40))); };
  const int along = std::min(room_for(width), n), deep = std::min(room_for(depth), n);
  for (Seats s{}; s[0] <= std::min(along, half); ++s[0]) {
    for (s[1] = 0; s[1] <= std::min(along, half); ++s[1]) {
      for (s[2] = 0; s[2] <= std::min(deep, half); ++s[2]) {
        s[3] = n - s[0] - s[1] - s[2];
        if (s[3] < 0 || s[3] > std::min(deep, half)) continue;
        found.push_back({s, price_of(s, n, width, depth, seat_width, circle)});
      }
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (found.size() > limit) found.resize(limit);
  return found;
}

namespace {

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
  for_each_turn(table, [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Size size = size_by_sides(table, turn);
    for (const auto& [seats, price] : seatings(n, size.width, size.depth, seat_width, circle, circle ? kOfCircle : kOfSides)) {
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
