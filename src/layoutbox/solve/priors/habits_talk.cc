// Habits of those who sit to talk: round a sofa without a low table, before a fire, face to face.
#include "layoutbox/catalog/measures.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kAbreast = 250;  // between easy chairs side by side

}  // namespace

// Easy chairs that nobody placed, of the same kind.
std::vector<ItemId> Habits::loose_easy_chairs(ItemId item) const {
  std::vector<ItemId> seats;
  for (const ItemId other : model_.items.ids()) {
    const Item& seat = model_.items[other];
    if (seat.is_opening() || seat.entry != model_.items[item].entry || seat.mount != Mount::kFloor || seat.fixed) continue;
    if (seat.is(Trait::kEasySeat) && seat.has_front && (!placed_besides_facing(other) || only_told_fire(other))) seats.push_back(other);
  }
  return seats;
}

// "By the fire", and nothing else.
bool Habits::only_told_fire(ItemId item) const {
  return std::ranges::all_of(model_.scene->relations, [&](const Relation& r) {
    if (!r.hard || std::ranges::find(r.targets, model_.items[item].id) == r.targets.end()) return true;
    const ItemId by = r.references.size() == 1 ? model_.find_item(r.references[0]) : ItemId();
    return r.type == RelationType::kFacing || (r.type == RelationType::kNear && by.exists() && model_.items[by].is(Trait::kFire));
  });
}

// Easy chairs by a sofa that looks at nothing else sit before it: across from it side by side, or at its ends, looking along it.
// False: there is a table to sit round, or a screen to look at.
bool Habits::sit_round_sofa(ItemId item, ItemId sofa) {
  constexpr Mm kBeforeEnd = 150;
  constexpr int kAtEnd = 40;  // points
  const Item &self = model_.items[item], &ref = model_.items[sofa];
  if (!self.is(Trait::kEasySeat) || !self.has_front || !ref.has_front || !ref.is(Trait::kCenterPiece) || ref.is(Trait::kBed)) return false;
  const auto else_seen = [&](ItemId other) {
    const Item& seen = model_.items[other];
    return seen.is(Trait::kScreen) || seen.is(Trait::kCoffeeTable) || is_looked_at(other);
  };
  if (std::ranges::any_of(items_of_kinds(self.entry->faces, item), [&](ItemId other) { return other != sofa && else_seen(other); }))
    return false;
  const std::vector<ItemId> seats = loose_easy_chairs(item);
  const auto n = std::ssize(seats), k = std::ranges::find(seats, item) - seats.begin();
  if (k == n) return false;
  const Mm pitch = self.states[0].size.width + kAbreast;
  Formula f;
  for_each_turn(ref, [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(ref, Side::kFront, turn);
    Case& opposite_it = f.add().when(sofa, states).when(item, states_looking(self, opposite(front)));
    opposite_it.wish(gap_towards(item, sofa, front) - Linear(measures().talking_apart), kBeside);
    opposite_it.wish(mid2(item, across(front)) - mid2(sofa, across(front)) - Linear((2 * k - (n - 1)) * pitch), kBeside, 2);
    for (const int sign : {1, -1}) {
      if (n > 1 && sign != (k % 2 == 0 ? 1 : -1)) continue;  // one at each end
      const Direction end{across(front), sign};
      Case& c = f.add().when(sofa, states).when(item, states_looking(self, opposite(end)));
      c.wish(gap_towards(item, sofa, front) - Linear(kBeforeEnd), kBeside).wish(gap_towards(item, sofa, end), kBeside).price = kAtEnd;
    }
  });
  habit("round the sofa", item, kBeside, std::move(f), {sofa});
  return true;
}

// Easy chairs that have nothing but the fire to look at sit before it: up to three side by side and close enough to feel it, more face
// to face at both sides of the way to it.
bool Habits::sit_by_fire(ItemId item) {
  constexpr Mm kOff = 1100, kBetween = 450, kMostAbreast = 3, kOffInPairs = 500;
  const std::vector<ItemId> seats = loose_easy_chairs(item);
  const auto k = std::ranges::find(seats, item) - seats.begin(), n = std::ssize(seats);
  if (k == n) return false;
  const Item& self = model_.items[item];
  const std::vector<ItemId> seen = items_of_kinds(self.entry->faces, item);
  const auto else_seen = [&](ItemId i) {
    const Item& ref = model_.items[i];
    return ref.is(Trait::kScreen) || ref.is(Trait::kCoffeeTable) || ref.is(Trait::kCenterPiece);
  };
  const auto is_fire = [&](ItemId i) { return !model_.items[i].is(Trait::kTable) && model_.items[i].has_front; };
  const auto fire = std::ranges::find_if(seen, is_fire);
  if (fire == seen.end() || std::ranges::any_of(seen, else_seen)) return false;
  const Size& size = self.states[0].size;
  Formula f;
  for_each_turn(model_.items[*fire], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(model_.items[*fire], Side::kFront, turn);
    Case& c = f.add().when(*fire, states);
    const bool pairs = n > kMostAbreast;
    const std::int64_t row = k / 2, sign = k % 2 == 0 ? 1 : -1;
    const std::int64_t beside = pairs ? sign * (measures().talking_apart + size.depth) : (2 * k - (n - 1)) * (size.width + kBetween);
    c.when(item, states_looking(self, pairs ? Direction{across(front), sign > 0 ? -1 : 1} : opposite(front)));
    c.wish(mid2(item, across(front)) - mid2(*fire, across(front)) - Linear(beside), kBeside, 2);
    c.wish(gap_towards(item, *fire, front) - Linear(pairs ? kOffInPairs + row * (size.width + kAbreast) : kOff), kBeside);
  });
  habit("by the fire", item, kBeside, std::move(f), {*fire});
  return true;
}

// Easy chairs that nothing is there for to look at stand face to face: every second across from the one before, further pairs beside
// the first.
bool Habits::sit_to_talk(ItemId item) {
  const Item& self = model_.items[item];
  if (!self.is(Trait::kEasySeat) || !self.has_front || placed_by_relation(item) || !items_of_kinds(self.entry->faces, item).empty())
    return false;
  std::vector<ItemId> seats = loose_easy_chairs(item);
  std::erase_if(seats, [&](ItemId other) { return placed_by_relation(other); });
  const auto k = std::ranges::find(seats, item) - seats.begin();
  if (seats.size() < 2 || k == 0) return false;
  const std::int64_t beside = 2 * (k / 2) * (self.states[0].size.width + kAbreast);
  Formula f;
  for_each_turn(model_.items[seats[0]], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(model_.items[seats[0]], Side::kFront, turn);
    Case& c = f.add().when(seats[0], states);
    c.wish(mid2(item, across(front)) - mid2(seats[0], across(front)) - Linear(beside), kBeside, 2);
    if (k % 2 == 0) {
      c.when(item, states_looking(self, front)).wish(mid2(item, front.axis) - mid2(seats[0], front.axis), kBeside, 2);
      return;
    }
    c.when(item, states_looking(self, opposite(front)))
        .wish(gap_towards(item, seats[0], front) - Linear(measures().talking_apart), kBeside);
  });
  habit("face to face", item, kBeside, std::move(f), {seats[0]});
  return true;
}

}  // namespace layoutbox::placement
