#include "layoutbox/solve/compile/seating.h"

#include <cmath>

#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {
namespace {

// How far a seat is pushed under a table that has room for knees: a little, so that it still counts as round the table and can be sat on.
constexpr Mm kReachUnder = 100, kKneeless = -40, kEasyChair = -350;

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

Mm wished_reach_under(const Item& seat, const Item& table) {
  const std::vector<Side> used = seat.object->used_sides.value_or(seat.entry->used_sides);
  if (used.size() == 1 && used[0] == Side::kFront) return kEasyChair;  // got into from the front only
  const bool knees = std::any_of(table.spaces.begin(), table.spaces.end(), [](const ItemSpace& s) { return !s.carries; });
  return knees ? kReachUnder : kKneeless;
}

void add_case(Formula& f, Compilation& c, int r, int table_turn, std::uint64_t table_states, const Seats& seats, int price, Mm most) {
  const Item& table = c.item(r);
  Case in;
  in.when(r, table_states);
  in.price = price;
  std::size_t next = 0;
  for (int s = 0; s < 4; ++s) {
    const Direction d = side_direction(table, kSides[s], table_turn);
    const int a = across(d), n = seats[s];
    for (int k = 0; k < n; ++k, ++next) {
      const int t = c.targets[next];
      const Item& seat = c.item(t);
      std::uint64_t facing = 0;
      for_each_turn(seat, [&](int turn, std::uint64_t states) {
        if (turn % 90 == 0 && (!seat.has_front || side_direction(seat, Side::kFront, turn) == opposite(d))) facing |= states;
      });
      if (!facing) return;
      in.when(t, facing);
      const Linear gap = gap_towards(t, r, d);
      in.require(Linear(most) - gap).require(reach(t, d) - reach(r, d)).require(-2 * reach(t, opposite(d)) - d.sign * mid2(r, d.axis));
      // n · mid2(t) = 2n · lo(r) + (2k + 1) · extent(r): seat k of n, evenly spaced; 40 mm either way.
      const Linear off = n * mid2(t, a) - 2 * n * lo(r, a) - (2 * k + 1) * extent(r, a);
      in.require_small(off, 2 * n * 40).wish(off, 100, 2 * n);
      in.wish(gap + Linear(wished_reach_under(seat, table)), 40);
    }
  }
  f.cases.push_back(std::move(in));
}

// Seats on a circle at multiples of 15°, turned to the middle; the circle as small as the seats' boxes allow.
void add_circle(Formula& f, Compilation& c, int r, Mm most) {
  const Item& table = c.item(r);
  const int n = static_cast<int>(c.targets.size());
  const Size& size = table.states[0].size;
  for (const int shift : {0, 15, 30, 45}) {
    for (const Mm extra : {0, 100, 200, 300}) {
      Case in;
      in.price = extra / 2 + (shift % 45 ? 10 : 0);
      bool possible = true;
      for (int k = 0; k < n && possible; ++k) {
        const int angle = (static_cast<int>(std::lround(360.0 * k / n / 15)) * 15 + shift) % 360;  // where it stands: 0 = front
        const int t = c.targets[k];
        const Item& seat = c.item(t);
        // At angle 0 it stands before the table and looks to the back: half round from the turn of the table's own front.
        std::uint64_t facing = 0;
        for_each_turn(seat, [&](int turn, std::uint64_t states) {
          if (turn == (angle + 180) % 360 || !seat.has_front) facing |= states;
        });
        possible = facing != 0;
        if (!possible) break;
        in.when(t, facing);
        const double away =
            std::min(size.width, size.depth) / 2.0 + seat.states[0].size.depth * 0.5 - 0.4 * seat.states[0].size.depth + extra;
        const double x = std::sin(radians_from_degrees(angle)) * away, y = -std::cos(radians_from_degrees(angle)) * away;
        const Mm place[2] = {static_cast<Mm>(std::lround(x)), static_cast<Mm>(std::lround(y))};
        for (int axis = 0; axis < 2; ++axis) {
          const Linear off = mid2(t, axis) - mid2(r, axis) - Linear(2 * place[axis]);
          in.require_small(off, 60).wish(off, 50, 2);
        }
        in.require(Linear(most) - gap_towards(t, r, {1, angle < 90 || angle > 270 ? -1 : 1}));
      }
      if (possible) f.cases.push_back(std::move(in));
    }
  }
}

bool is_round(const Item& table) {
  if (!table.entry) return false;
  const auto top = table.entry->shape.words.find("top");
  const bool round_kind = top != table.entry->shape.words.end() && top->second == "round";
  const auto& words = table.object->attributes;
  const bool said = std::any_of(words.begin(), words.end(), [](const std::string& w) { return w == "round" || w == "circular"; });
  const Size& size = table.states[0].size;
  return (round_kind || said || table.object->name.find("round") != std::string::npos) && std::abs(size.width - size.depth) <= 100;
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
        const double even = n == 1 ? 1 : evenness(arms_of(s, width, depth, seat_width / 2 - kReachUnder));
        int price = static_cast<int>((1 - even) * (circle ? 600 : 300));
        price += 40 * (std::abs(s[0] - s[1]) + std::abs(s[2] - s[3]));
        if (n <= 2 && (width > depth ? s[2] + s[3] : width < depth ? s[0] + s[1] : 0) > 0) price += 20;  // long sides first
        found.push_back({s, price});
      }
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (found.size() > limit) found.resize(limit);
  return found;
}

void add_seating(Compilation& c, int r, Mm most, bool circle) {
  const Item& table = c.item(r);
  const int n = static_cast<int>(c.targets.size());
  Formula& f = c.formula();
  if (n == 0) return;
  Mm seat_width = 0;
  for (const int t : c.targets) seat_width = std::max(seat_width, c.item(t).states[0].size.width);
  if (n >= 5 && is_round(table)) add_circle(f, c, r, most);
  const Size& size = table.states[0].size;
  for (const auto& [seats, price] : seatings(n, size.width, size.depth, seat_width, circle)) {
    const int base = f.cases.empty() ? 0 : 200;
    for_each_turn(table, [&](int turn, std::uint64_t states) {
      if (turn % 90 == 0) add_case(f, c, r, turn, states, seats, price + (n >= 5 && is_round(table) ? base : 0), most);
    });
  }
  if (!f.cases.empty()) return;
  // More than the sides hold: each as near as it gets, looking at it.
  c.out.formulas.pop_back();
  for (const int t : c.targets) {
    add_within(c.formula(), {}, c.model, t, r, most);
    add_looks_at(c.formula(), c.model, t, r);
  }
}

}  // namespace layoutbox::placement
