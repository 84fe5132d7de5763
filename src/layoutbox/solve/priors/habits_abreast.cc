// Habits of things that stand side by side: twins, the run of a kitchen, rows at walls.
#include <array>

#include "layoutbox/catalog/measures.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kTwinAir = 60;                              // between twins besides what stands there
constexpr int kInRun = 250, kTwins = 300, kOfRun = 450;  // points a metre

}  // namespace

// Twins with something between them (beds and a nightstand) stand side by side, turned alike, as far apart as that needs.
bool Habits::stand_as_twin(ItemId item) {
  const Item& self = model_.items[item];
  for (const Relation& r : model_.scene->relations) {
    if (r.type != RelationType::kBetween || r.references.size() != 2 || r.targets.empty() || r.references[1] != self.id) continue;
    const ItemId twin = model_.find_item(r.references[0]), middle = model_.find_item(r.targets[0]);
    if (!twin.exists() || !middle.exists() || model_.items[twin].entry != self.entry || !self.entry->back_to_wall) continue;
    if (model_.items[middle].mount != Mount::kFloor) continue;
    const Mm apart = model_.items[middle].states[0].size.width + kTwinAir;
    Formula f;
    for_each_turn(model_.items[twin], [&](int turn, std::uint64_t states) {
      const std::uint64_t alike = self.states_at(turn);
      if (!alike) return;
      const Direction back = side_direction(self, Side::kBack, turn);
      for (const Side side : {Side::kLeft, Side::kRight}) {
        const Linear gap = gap_towards(item, twin, side_direction(self, side, turn));
        f.add()
            .when(twin, states)
            .when(item, alike)
            .require(gap)
            .wish(gap - Linear(apart), kTwins)
            .wish(reach(item, back) - reach(twin, back), kTwins);
      }
    });
    habit("twins", item, kTwins, std::move(f), {twin});
    return true;
  }
  return false;
}

// Kitchen units and machines stand side by side in one run.
void Habits::stand_in_run(ItemId item) {
  const auto in_runs = [&](ItemId i) {
    return model_.items[i].mount == Mount::kFloor && model_.items[i].entry->back_to_wall && model_.items[i].is(Trait::kKitchenRun);
  };
  if (!in_runs(item)) return;
  const auto is_low = [&](ItemId i) { return in_runs(i) && model_.items[i].states[0].size.height < measures().tall_from; };
  // One works beside sink and hob: worktops stand by them, and by a fridge where there is nothing else.
  const RelationSet beside_it = relations_that<&RelationTraits::close_by>() | relations_that<&RelationTraits::sideways>();
  bool by_low = false;
  for (const ItemId other : ids_before(item)) by_low |= model_.items[item].is(Trait::kCounter) && is_low(other);
  Formula f;
  for (const ItemId other : ids_before(item)) {
    if (!in_runs(other) || (by_low && !is_low(other))) continue;
    // Words that say more than which side say how these two stand.
    if (!only_related_by(item, other, beside_it)) return;
    for (const Side side : {Side::kLeft, Side::kRight}) add_beside(f, model_, item, other, side, {.most = 60});
  }
  if (!f.cases.empty()) habit("in the run", item, kOfRun, std::move(f));
  keep_tall_off_worked_at(item);
  have_worktop_aside(item);
}

// … nor with one in the wall: who cooks has worktop at both sides.
void Habits::have_worktop_aside(ItemId item) {
  constexpr int kAside = 150;  // points a metre
  const Item& self = model_.items[item];
  const bool worked_at = self.is(Trait::kHob);
  const bool kitchen =
      std::ranges::count_if(model_.items, [](const Item& i) { return i.mount == Mount::kFloor && i.is(Trait::kKitchenRun); }) > 2;
  if (!worked_at || !kitchen || self.states[0].size.height >= measures().tall_from || placed_by_relation_besides_walls(item)) return;
  const Mm aside = measures().worktop_between;
  Formula f;
  for (const RoomWall& wall : model_.walls) {
    if (!wall.straight || wall.hi - wall.lo < 2 * aside + self.states[0].size.width) continue;
    Case& c = f.add().when(item, states_with_back_to(self, wall));
    c.require(lo(item, wall.along) - Linear(std::int64_t{wall.lo} + aside))
        .require(Linear(std::int64_t{wall.hi} - aside) - hi(item, wall.along));
  }
  if (!f.cases.empty()) habit("worktop at both sides", item, kAside, std::move(f));
}

// Nobody cooks or washes up with an elbow in the fridge: a hand of worktop is between what is tall and what is no worktop.
void Habits::keep_tall_off_worked_at(ItemId item) {
  constexpr int kOff = 300;  // points a metre
  const auto is_unit = [&](ItemId i) { return model_.items[i].mount == Mount::kFloor && model_.items[i].is(Trait::kKitchenRun); };
  const auto is_tall = [&](ItemId i) { return model_.items[i].states[0].size.height >= measures().tall_from; };
  const auto is_worktop = [&](const Item& unit) {
    return unit.mount == Mount::kFloor && unit.is(Trait::kKitchenRun) && unit.is(Trait::kCounter);
  };
  if (!is_unit(item) || std::ranges::none_of(model_.items, is_worktop)) return;
  for (const ItemId other : ids_before(item)) {
    if (!is_unit(other) || is_tall(other) == is_tall(item) || related(item, other)) continue;
    const ItemId low = is_tall(item) ? other : item;
    if (model_.items[low].is(Trait::kCounter)) continue;
    Formula f;
    for (const int axis : {0, 1}) {
      for (const int sign : {1, -1}) f.add().require(gap_towards(item, other, {axis, sign}) - Linear(measures().worktop_between));
    }
    habit("a worktop between", item, kOff, std::move(f));
  }
}

// An island stands along the run, its front away from it, an aisle between. False: there is no run, or words say where it is.
bool Habits::stand_along_run(ItemId item) {
  constexpr int kAlong = 300, kBeforeIsland = 150;
  if (placed_besides_facing(item)) return false;
  for (const ItemId unit : model_.items.ids()) {
    const Item& run = model_.items[unit];
    if (unit == item || run.mount != Mount::kFloor || !run.is(Trait::kKitchenRun) || !run.entry->back_to_wall || !run.has_front) continue;
    Formula f;
    for_each_turn(run, [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      const std::uint64_t alike = model_.items[item].states_at(turn);
      const Direction front = side_direction(run, Side::kFront, turn);
      if (!alike) return;
      Case& c = f.add().when(unit, states).when(item, alike);
      c.wish(gap_towards(item, unit, front) - Linear(measures().island_aisle), kBeforeIsland);
      c.wish(mid2(item, across(front)) - mid2(unit, across(front)), kMiddle, 2);
    });
    if (f.cases.empty()) return false;
    habit("along the run", item, kAlong, std::move(f));
    return true;
  }
  return false;
}

// Do words say at most at which wall it stands (its own, the one opposite something, one far from the door), and nothing of where along
// it? What stands anywhere has to be told to be at a wall.
bool Habits::only_told_its_wall(ItemId item) const {
  using R = RelationType;
  const RelationSet of_walls = RelationSet(R::kOnWall, R::kAgainstWall) | relations_that<&RelationTraits::keeps_off>();
  const auto& relations = model_.scene->relations;
  const auto told = [&](const Relation& r) { return std::ranges::find(r.targets, model_.items[item].id) != r.targets.end(); };
  const auto at_wall = [&](const Relation& r) { return r.type == R::kAgainstWall && told(r); };
  const auto elsewhere = [&](const Relation& r) { return told(r) && !of_walls.has(r.type); };
  return (model_.items[item].entry->back_to_wall || std::ranges::any_of(relations, at_wall)) && std::ranges::none_of(relations, elsewhere);
}

// Several of a kind with their backs to a wall stand side by side along it: lockers, bookshelves, the beds of a ward, chairs told to have
// it behind them. Beds also opposite one another.
void Habits::stand_in_wall_row(ItemId item) {
  constexpr Mm kBesideBed = 900, kBesideDesk = 200, kBesideSeat = 80;
  constexpr int kOutOfRow = 200, kSeatOutOfRow = 400, kAcross = 40;  // points
  const auto in_row = [&](ItemId i) {
    const Item& other = model_.items[i];
    const bool by_itself = other.is(Trait::kSeat) && !placed_by_relation(i);  // who waits
    return other.entry == model_.items[item].entry && !other.fixed && other.mount == Mount::kFloor && (only_told_its_wall(i) || by_itself);
  };
  const Item& self = model_.items[item];
  if (self.is(Trait::kKitchenRun) || (self.is(Trait::kCenterPiece) && !self.is(Trait::kBed)) || !in_row(item)) return;
  // A seat joins the row at either end: it may stand beside the first or one of the last two.
  std::vector<ItemId> row;
  for (const ItemId i : ids_before(item)) {
    if (in_row(i)) row.push_back(i);
  }
  if (row.empty()) return;
  if (!self.is(Trait::kSeat)) row.erase(row.begin(), row.end() - 1);
  if (row.size() > 3) row.erase(row.begin() + 1, row.end() - 2);
  const Mm air = self.is(Trait::kBed) ? kBesideBed : self.is(Trait::kSeat) ? kBesideSeat : has_knee_room(self) ? kBesideDesk : 0;
  const bool twins =
      std::ranges::count_if(model_.items, [&](const Item& other) { return other.entry == self.entry; }) == 2 && has_bedside(item);
  Formula f;
  for (const ItemId before : row) {
    for_each_turn(model_.items[before], [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      const Direction back = side_direction(model_.items[before], Side::kBack, turn);
      for (const int sign : {1, -1}) {
        const Linear gap = gap_towards(item, before, {across(back), sign});
        Case& c = f.add().when(before, states).when(item, self.states_at(turn)).require(gap).wish(gap - Linear(air), kInRun);
        c.wish(reach(item, back) - reach(before, back), kInRun);
      }
      if (!self.is(Trait::kBed) || twins) return;
      Case& opposite_it = f.add().when(before, states).when(item, self.states_at((turn + 180) % 360));
      opposite_it.wish(mid2(item, across(back)) - mid2(before, across(back)), kInRun, 2).price = kAcross;
    });
  }
  f.add().price = self.is(Trait::kSeat) ? kSeatOutOfRow : kOutOfRow;
  // No host: that one looks for another place does not send the whole row to look for one.
  habit("in a row at the wall", item, kInRun, std::move(f));
}

// What stands in a row and has a front stands side by side there, not one behind the other.
void Habits::stand_abreast_in_row(ItemId item) {
  for (const Relation& r : model_.scene->relations) {
    const auto at = std::ranges::find(r.targets, model_.items[item].id);
    if (r.type != RelationType::kRow || at == r.targets.begin() || at == r.targets.end()) continue;
    const ItemId before = model_.find_item(*(at - 1));
    if (!before.exists() || !model_.items[item].has_front || model_.items[before].entry != model_.items[item].entry) continue;
    Formula f;
    for_each_turn(model_.items[item], [&](int turn, std::uint64_t states) {
      const std::uint64_t same = model_.items[before].states_at(turn);
      if (turn % 90 != 0 || !same) return;
      const Direction back = side_direction(model_.items[item], Side::kBack, turn);
      f.add().when(item, states).when(before, same).wish(reach(item, back) - reach(before, back), kTwins);
    });
    habit("abreast in the row", item, kTwins, std::move(f));
    return;
  }
}

}  // namespace layoutbox::placement
