// Several things opposite one: they stand there as a group, side by side.
#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {
namespace {

constexpr std::size_t kMostAbreast = 3;  // more may stand in rows
constexpr Mm kTalking = 300;             // beyond the least distance, between seats

// Of more than quarter turns nothing is said.
void leave_odd_turns_open(Formula& f, const PlacementModel& model, std::initializer_list<ItemId> items) {
  for (const ItemId item : items) f.exact = f.exact && model.items[item].odd_states == 0;
}

// The middle of r is before the group, and no member is behind its front.
void add_faced_by(Formula& f, const Compilation& c, ItemId r) {
  leave_odd_turns_open(f, c.model, {r});
  const auto n = static_cast<std::int32_t>(c.targets.size());
  for_each_turn(c.item(r), [&](int turn, std::uint64_t states) {
    if (!quarter(turn)) return;
    const Direction d = side_direction(c.item(r), Side::kFront, turn);
    const int a = across(d);
    Linear off = Linear(0) - n * mid2(r, a);
    for (const ItemId t : c.targets) off = off + mid2(t, a);
    for (const ItemId low : c.targets) {
      for (const ItemId high : c.targets) {
        Case& in = f.add().when(r, states).require(mid2(r, a) - 2 * lo(low, a)).require(2 * hi(high, a) - mid2(r, a));
        for (const ItemId t : c.targets) in.require(reach(t, d) - reach(r, d));
        in.wish(off, 200, 2 * n);
      }
    }
  });
}

// None stands behind another, seen from where they look, or from r where they have no front.
void add_abreast(Compilation& c, ItemId r) {
  const ItemId lead = c.item(r).has_front ? r : c.targets[0];
  for (std::size_t i = 0; i < c.targets.size(); ++i) {
    for (std::size_t j = i + 1; j < c.targets.size(); ++j) {
      Formula& f = c.formula();
      leave_odd_turns_open(f, c.model, {lead, c.targets[i], c.targets[j]});
      for_each_turn(c.item(lead), [&](int turn, std::uint64_t states) {
        if (!quarter(turn)) return;
        const int a = across(side_direction(c.item(lead), Side::kFront, turn));
        for (const auto& [first, second] : {std::pair{c.targets[i], c.targets[j]}, {c.targets[j], c.targets[i]}})
          f.add().when(lead, states).require(lo(second, a) - hi(first, a));
      });
    }
  }
}

}  // namespace

void add_opposite_group(Compilation& c, ItemId r, Mm least, Mm most) {
  const bool seats = c.item(c.targets[0]).is_seat;
  for (const ItemId t : c.targets) {
    add_looks_with_group(c.formula(), c.model, t, c.targets, r);
    add_band(c.formula(), c.model, t, place_of(r), least, most, seats ? least + kTalking : (least + most) / 2);
  }
  if (c.item(r).has_front) add_faced_by(c.formula(), c, r);
  if (c.targets.size() <= kMostAbreast) add_abreast(c, r);
}

}  // namespace layoutbox::placement
