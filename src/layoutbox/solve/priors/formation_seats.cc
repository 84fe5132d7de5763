// Seats shared out along the sides of a table, a desk or a counter.
#include <algorithm>

#include "layoutbox/solve/compile/phrases.h"
#include "layoutbox/solve/priors/formation.h"
#include "layoutbox/solve/priors/habits.h"
#include "layoutbox/solve/priors/seating.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kBackOfSeat = 130;      // what of a chair stays before the edge
constexpr Mm kBeforeKneeless = 100;  // from what one sits before without room for the knees

}  // namespace

void add_seat_place(Formula& f, const PlacementModel& model, ItemId seat, ItemId table, int k, int n, int weight, SeatSides sides) {
  const Item &chair = model.items[seat], &host = model.items[table];
  const Size &size = host.states[0].size, &own = chair.states[0].size;
  Side side = used_side(host);
  int place = k, places = n;
  if (sides != SeatSides::kUsed) {
    const bool wide = (size.width >= size.depth) == (sides == SeatSides::kLong);
    side = k % 2 == 0 ? (wide ? Side::kFront : Side::kLeft) : wide ? Side::kBack : Side::kRight;
    place = k / 2, places = k % 2 == 0 ? (n + 1) / 2 : n / 2;
  } else if (!host.has_front) {
    const auto ways = seatings(n, size.width, size.depth, own.width, false, 1);
    if (ways.empty()) return;
    const Seats& seats = ways[0].first;
    constexpr std::array kSides{Side::kFront, Side::kBack, Side::kLeft, Side::kRight};
    int s = 0;
    while (s < 3 && place >= seats[s]) place -= seats[s++];
    side = kSides[s], places = std::max(1, seats[s]);
  }
  for_each_turn(host, [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction d = side_direction(host, side, turn);
    std::uint64_t facing = 0;
    for_each_turn(chair, [&](int chair_turn, std::uint64_t chair_states) {
      if (!chair.has_front || (chair_turn % 90 == 0 && side_direction(chair, Side::kFront, chair_turn) == opposite(d)))
        facing |= chair_states;
    });
    Case& c = f.add().when(table, states);
    if (facing) c.when(seat, facing);
    // places · mid2(seat) = 2 · places · lo(table) + (2 · place + 1) · extent(table)
    c.wish(places * mid2(seat, across(d)) - 2 * places * lo(table, across(d)) - (2 * place + 1) * extent(table, across(d)), weight,
           2 * places);
    // One alone goes under as far as its back allows.
    const Mm under = n == 1 && host.has_front ? std::max(kTucked, own.depth - kBackOfSeat) : std::min<Mm>(kTucked, own.depth / 2);
    c.wish(gap_towards(seat, table, d) + Linear(has_knee_room(host) ? under : -kBeforeKneeless), weight);
    c.require(reach(seat, d) - reach(table, d));
  });
  if (host.spans < 0 || side != Side::kFront) return;
  for (const State& state : host.states) {  // before a desk at a slanted wall, looking at it
    const std::uint64_t states = states_at_angle(host, state.angle, 360), facing = states_at_angle(chair, state.angle + 180, 360);
    if (is_quarter(state) || !facing || !(states & host.odd_states)) continue;
    const std::size_t known = f.cases.size();
    add_beside(f, model, seat, table, side, {.most = 600, .wished_gap = 10, .ref_states = states});
    for (std::size_t i = known; i < f.cases.size(); ++i) {
      f.cases[i].when(seat, facing).wishes[0].weight = weight;
    }
  }
}

}  // namespace layoutbox::placement
