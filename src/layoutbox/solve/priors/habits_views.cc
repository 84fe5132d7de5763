// Habits of who looks at something: into a mirror, at a screen.
#include "layoutbox/catalog/measures.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {

std::uint64_t states_looking(const Item& item, Direction direction) {
  std::uint64_t looking = 0;
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    if (turn % 90 == 0 && side_direction(item, Side::kFront, turn) == direction) looking |= states;
  });
  return looking;
}

// The mirror on the wall that a seat is told to look into, or that is its own by what kind of seat it is, where nothing else says where
// it stands, if any.
ItemId Habits::mirror_of(ItemId item) const {
  const Item& self = model_.items[item];
  if ((!self.is(Trait::kSeat) && !self.is(Trait::kEasySeat)) || !self.has_front) return {};
  ItemId told;
  for (const ItemId i : model_.items.ids()) {
    if (!told.exists() && is_told_before_mirror(item, i)) told = i;
  }
  const auto elsewhere = [&](const Relation* r) {
    const bool target = std::ranges::find(r->targets, self.id) != r->targets.end();
    // That they stand in a row says nothing of where the row is.
    return target && !traits_of(r->type).turns && r->type != RelationType::kRow &&
           (!told.exists() || r->references != std::vector<std::string>{model_.items[told].id});
  };
  if (std::ranges::any_of(said_of(item), elsewhere)) return {};
  return told.exists() ? told : usual_mirror_of(item);
}

// "Facing the mirror", or in front of it, which says the same of a seat.
bool Habits::is_told_before_mirror(ItemId seat, ItemId mirror) const {
  return is_wall_mirror(mirror) && (related_as_target(seat, mirror, RelationType::kFacing) ||
                                    (model_.items[seat].is(Trait::kSeat) && related_as_target(seat, mirror, RelationType::kInFrontOf)));
}

bool Habits::is_wall_mirror(ItemId item) const { return model_.items[item].is(Trait::kMirror) && model_.items[item].mount == Mount::kWall; }

// Seats that look into mirrors by what they are (a barber's chair) have one each, of those that nobody is told to look into and that are
// not told to hang by something; where these are fewer, they share them. None: it looks at something else, or there is none.
ItemId Habits::usual_mirror_of(ItemId item) const {
  const Item& self = model_.items[item];
  if (self.entry->faces.empty() || placed_by_relation(item)) return {};
  const std::vector<ItemId> seen = items_of_kinds(self.entry->faces, item);
  if (seen.empty() || !is_wall_mirror(seen[0])) return {};
  std::vector<ItemId> mirrors;
  for (const ItemId mirror : seen) {
    const bool told = std::ranges::any_of(model_.scene->relations, [&](const Relation& r) {
      return r.type == RelationType::kFacing && std::ranges::find(r.references, model_.items[mirror].id) != r.references.end();
    });
    if (is_wall_mirror(mirror) && !told && !placed_by_relation_besides_walls(mirror)) mirrors.push_back(mirror);
  }
  int rank = 0;
  for (const ItemId i : ids_before(item)) rank += model_.items[i].entry == self.entry && !placed_by_relation(i);
  return mirrors.empty() ? ItemId() : mirrors[static_cast<std::size_t>(rank) % mirrors.size()];
}

// Who is to look into a mirror sits before it, close enough to see. False: there is no such mirror.
bool Habits::sit_before_mirror(ItemId item) {
  const ItemId mirror = mirror_of(item);
  if (!mirror.exists()) return false;
  std::vector<ItemId> seats;  // who look into the same one sit side by side
  for (const ItemId i : model_.items.ids()) {
    if (!model_.items[i].is_opening() && mirror_of(i) == mirror) seats.push_back(i);
  }
  sit_in_row(item, mirror,
             {.name = "before its mirror", .side = Side::kFront, .seats = std::move(seats), .between = kBetweenMirrored, .off = 650});
  return true;
}

// What stands on a cupboard or a stand is looked at where that stands, which finds its place first; else the thing itself.
ItemId Habits::stand_of_screen(ItemId screen) const {
  const Item& self = model_.items[screen];
  if (!self.is(Trait::kScreen) || self.mount != Mount::kSurface) return screen;
  ItemId stand;
  for (const SupportOption& support : self.supports) {
    if (support.kind != SupportOption::Kind::kItem || support.item == stand) continue;
    if (stand.exists()) return screen;
    stand = support.item;
  }
  const bool stands = stand.exists() && model_.items[stand].mount == Mount::kFloor && model_.items[stand].entry->back_to_wall;
  // A TV stand looks for its sofa itself.
  return stands && model_.items[stand].has_front && model_.items[stand].entry->faces.empty() ? stand : screen;
}

// Where a sofa and a bed share a room, the television is the sofa's.
bool Habits::leaves_screen_to_others(ItemId item, ItemId screen) const {
  if (!model_.items[item].is(Trait::kBed) || !model_.items[screen].is(Trait::kScreen)) return false;
  for (const ItemId i : model_.items.ids()) {
    const Item& sofa = model_.items[i];
    if (sofa.is_opening() || !sofa.is(Trait::kCenterPiece) || sofa.is(Trait::kBed) || sofa.mount != Mount::kFloor) continue;
    const std::vector<ItemId> seen = items_of_kinds(sofa.entry->faces, i);
    if (std::ranges::find(seen, screen) != seen.end()) return true;
  }
  return false;
}

// Is a screen all that there is for it to look at? Then it is watched from the wall, not drawn up to like a table.
bool Habits::only_sees_screen(ItemId item) const {
  const std::vector<ItemId> seen = items_of_kinds(model_.items[item].entry->faces, item);
  return !seen.empty() && std::ranges::all_of(seen, [&](ItemId other) { return model_.items[other].is(Trait::kScreen); });
}

// A sofa that shares its room with a bed finds its place after the television on the wall: with both at their walls none would be left
// for that.
bool Habits::comes_after_screen(ItemId item, ItemId screen) const {
  const Item &self = model_.items[item], &ref = model_.items[screen];
  if (!self.is(Trait::kCenterPiece) || self.is(Trait::kBed) || !ref.is(Trait::kScreen) || ref.mount != Mount::kWall) return false;
  return !placed_besides_facing(item) &&
         std::ranges::any_of(model_.items, [](const Item& other) { return other.is(Trait::kBed) && other.mount == Mount::kFloor; });
}

// Who looks along the wall that a screen hangs on sees its edge: machines and chairs; to sofas and beds the screen turns itself.
void Habits::stay_before_screen(ItemId item, ItemId screen, bool at_ease) {
  constexpr Mm kOff = 300, kEasyOff = 1300;
  constexpr int kSeesEdge = 300;             // points a metre
  const Mm off = at_ease ? kEasyOff : kOff;  // nobody rests right before it
  if (!model_.items[screen].has_front || model_.items[item].is(Trait::kCenterPiece)) return;
  Formula f;
  for_each_turn(model_.items[screen], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(model_.items[screen], Side::kFront, turn);
    f.add().when(screen, states).require(gap_towards(item, screen, front) - Linear(off));
  });
  if (!f.cases.empty()) habit("before the screen", item, kSeesEdge, std::move(f));
}

// A sofa has its screen before it, not behind its back, whatever a bed sees of that.
void Habits::have_screen_before(ItemId item, ItemId screen) {
  constexpr Mm kLeast = 950;
  Formula f;
  for_each_turn(model_.items[item], [&](int turn, std::uint64_t states) {
    if (turn % 90 == 0)
      f.add()
          .when(item, states)
          .require(gap_towards(screen, item, side_direction(model_.items[item], Side::kFront, turn)) - Linear(kLeast));
  });
  if (!f.cases.empty()) habit("has the screen before it", item, kFaces, std::move(f));
}

// A screen is watched from no farther than one sees it well.
void Habits::watch_from_near(ItemId item, ItemId screen) {
  constexpr int kTooFar = 300;  // points a metre
  Formula f;
  for_each_turn(model_.items[item], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(model_.items[item], Side::kFront, turn);
    f.add().when(item, states).require(Linear(measures().watched_from) - gap_towards(screen, item, front));
  });
  habit("near enough to see", item, kTooFar, std::move(f));
}

// Nobody watches over those who sit at table: high tables, bars, chairs, beds and dividers are not between a sofa and its screen or fire.
void Habits::watch_past_tables(ItemId item, ItemId screen) {
  constexpr int kBetween = 250;  // points a metre
  constexpr Mm kHigh = 600;
  for (const ItemId other : model_.items.ids()) {
    const Item& table = model_.items[other];
    if (table.is_opening() || table.mount != Mount::kFloor || other == item || other == screen || rests_on(screen, other) ||
        related(item, other))
      continue;
    const bool bar = table.is(Trait::kCounter) || table.is(Trait::kPlayTable);
    const bool high = (table.is(Trait::kTable) || bar) && table.states[0].size.height >= kHigh && !table.entry->back_to_wall;
    const bool seat = table.is(Trait::kEasySeat) && !placed_besides_facing(other);
    if (!high && !seat && !table.is(Trait::kBed) && divided_by(other) == nullptr) continue;
    Formula f;
    for_each_turn(model_.items[item], [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      const Direction front = side_direction(model_.items[item], Side::kFront, turn);
      for (const int sign : {1, -1}) f.add().when(item, states).require(gap_towards(other, item, {across(front), sign}));
      f.add().when(item, states).require(gap_towards(other, item, opposite(front)));
      f.add().when(item, states).require(gap_towards(other, screen, front));
    });
    habit("not before the screen", other, kBetween, std::move(f));
  }
}

}  // namespace layoutbox::placement
