// Habits of things that come in numbers.
#include <array>
#include <cmath>

#include "layoutbox/catalog/measures.h"
#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/solve/priors/formation.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {
namespace {

constexpr std::size_t kManyInFormation = 4, kManySeats = 7;
constexpr std::int64_t kManySize = 3'000'000;       // mm²: larger things are no crowd
constexpr std::int64_t kTableToSitRound = 400'000;  // mm²
constexpr int kKeepOff = 300;                       // points a metre

}  // namespace

// The grid that a relation asks for.
std::optional<Habits::Group> Habits::grid_with(ItemId item) const {
  for (const Relation& r : model_.scene->relations) {
    if (r.type != RelationType::kGrid || std::find(r.targets.begin(), r.targets.end(), model_.items[item].id) == r.targets.end()) continue;
    Group group{{}, r.parameters.columns.value_or(static_cast<int>(std::ceil(std::sqrt(static_cast<double>(r.targets.size())))))};
    for (const std::string& id : r.targets) group.members.push_back(model_.find_item(id));
    return group;
  }
  return std::nullopt;
}

// How many of a kind stand in a formation at least.
std::size_t Habits::least_in_formation(ItemId item) const {
  const Item& self = model_.items[item];
  // A few chairs with nothing to look at and no table stand at the walls.
  const bool watches = board_of_room().exists() || told_where_to_look(item);
  const std::size_t fewest_seats = self.is(Trait::kTableSeat) && self.has_front && !watches ? kManySeats : kManyInFormation;
  // Two that one sits or walks round are enough: side by side, turned alike.
  const bool round_about = has_knee_room(self) || used_sides(self).size() >= 4;
  if (told_middle_with_others(item)) return 2;
  if (self.is(Trait::kTableSeat) && self.has_front && told_where_to_look(item)) return 3;
  if (self.is(Trait::kSeat) || area_of(self) < kTableToSitRound) return fewest_seats;
  if (!self.has_front && round_about) return 2;
  return has_knee_room(self) ? 3 : kManyInFormation;
}

std::optional<Habits::Group> Habits::formation_with(ItemId item) const {
  const Item& self = model_.items[item];
  if (const std::optional<Group> grid = grid_with(item)) {
    // The beds of a ward in two rows have the walls to go by, and are turned to one another.
    const bool at_wall = self.entry->back_to_wall && std::ranges::any_of(said_of(item), [](const Relation* r) {
                           return r->type == RelationType::kAgainstWall || r->type == RelationType::kOnWall;
                         });
    return at_wall ? std::nullopt : grid;
  }
  // What usually stands at a wall and is told where to look, as a class's desks are, stands in rows, desks of an office in islands.
  const bool at_wall = self.entry->back_to_wall && !told_where_to_look(item) && !fits_islands(item);
  // Easy chairs in rows are for those who look at something; who talks sits face to face.
  if (self.is(Trait::kEasySeat) && !told_where_to_look(item) && !board_of_room().exists()) return std::nullopt;
  if (self.mount != Mount::kFloor || at_wall || area_of(self) > kManySize) return std::nullopt;
  // Small things that nobody walks up to (plants, barrels) stand at the walls and in the corners, however many.
  if (used_sides(self).empty() && !self.is(Trait::kBearsCeiling) && !self.thin && !self.is(Trait::kSeat) &&
      area_of(self) < kTableToSitRound && !told_middle_with_others(item))
    return std::nullopt;
  const bool has_host = std::ranges::any_of(items_of_kinds(self.entry->beside, item),
                                            [&](ItemId h) { return !model_.items[h].thin && area_of(model_.items[h]) > area_of(self); });
  if (has_host && !has_knee_room(self)) return std::nullopt;
  if (mirror_of(item).exists()) return std::nullopt;
  Group group;
  for (const ItemId other : model_.items.ids()) {
    if (model_.items[other].entry == self.entry && !model_.items[other].fixed &&
        (!placed_besides_facing(other) || told_middle_with_others(other)))
      group.members.push_back(other);
  }
  if (self.entry->back_to_wall && !told_where_to_look(item) && group.members.size() < kManyInFormation) return std::nullopt;
  if (group.members.size() < least_in_formation(item) || std::find(group.members.begin(), group.members.end(), item) == group.members.end())
    return std::nullopt;
  // "Three plinths down the middle": the long way, where there is no bar.
  if (told_in_line(group) && told_middle_with_others(item) && !self.has_front) {
    group.columns = model_.room.extent(0) >= model_.room.extent(1) ? static_cast<int>(group.members.size()) : 1;
    group.spread = true;
  }
  return group;
}

bool Habits::told_in_line(const Group& group) const {
  return std::ranges::any_of(model_.scene->relations, [&](const Relation& r) {
    return r.type == RelationType::kRow && r.targets.size() == group.members.size() &&
           std::ranges::all_of(group.members,
                               [&](ItemId member) { return std::ranges::find(r.targets, model_.items[member].id) != r.targets.end(); });
  });
}

// The part of the room that it shares with other formations, of things of which the floor is full: study tables beside rows of shelves.
PartOfRoom Habits::part_of(const Group& group) {
  if (!formations_) {
    formations_.emplace();
    ById<ItemId, char> known(model_.items.size(), 0);
    for (const ItemId i : model_.items.ids()) {
      if (known[i] || model_.items[i].is_opening() || model_.items[i].fixed || model_.items[i].mount != Mount::kFloor) continue;
      const std::optional<Group> found = formation_with(i);
      if (!found) continue;
      for (const ItemId member : found->members) known[member] = 1;
      formations_->push_back(found->members);
    }
  }
  const std::vector<PartOfRoom> parts = parts_of_room(model_, *formations_);
  const auto own = std::ranges::find(*formations_, group.members);
  return own == formations_->end() ? PartOfRoom{} : parts[static_cast<std::size_t>(own - formations_->begin())];
}

// Desks that one sits down at from the front, in a room that is wide enough for two rows of them with chairs on both sides.
bool Habits::fits_islands(ItemId item) const {
  constexpr Mm kLeastRoom = 4200;
  const Item& self = model_.items[item];
  return self.is(Trait::kDesk) && self.entry->back_to_wall && self.has_front && has_knee_room(self) && used_side(self) == Side::kFront &&
         !told_where_to_look(item) && std::min(model_.room.extent(0), model_.room.extent(1)) >= kLeastRoom;
}

// Does a relation say which way it looks?
bool Habits::told_where_to_look(ItemId item) const {
  return std::ranges::any_of(said_of(item), [&](const Relation* r) {
    return traits_of(r->type).looks && std::ranges::find(r->targets, model_.items[item].id) != r->targets.end();
  });
}

// Does a relation say where it stands, not only which way it looks?
bool Habits::placed_besides_facing(ItemId item) const {
  return std::ranges::any_of(said_of(item), [&](const Relation* r) {
    return !traits_of(r->type).turns && std::ranges::find(r->targets, model_.items[item].id) != r->targets.end();
  });
}

// "Six tables in the middle": they cannot all be there, so their rows are about it.
bool Habits::told_middle_with_others(ItemId item) const {
  constexpr std::size_t kSeveral = 2;
  bool middle = false;
  for (const Relation& r : model_.scene->relations) {
    if (std::find(r.targets.begin(), r.targets.end(), model_.items[item].id) == r.targets.end()) continue;
    // In line down the middle; a bar takes up some of it.
    if (traits_of(r.type).turns || (r.type == RelationType::kRow && !counter_of_room().exists())) continue;
    if (r.type != RelationType::kCenterOfRoom || r.targets.size() < kSeveral) return false;
    middle = true;
  }
  return middle;
}

void Habits::turn_as(ItemId item, ItemId other) {
  Formula f;
  for_each_turn(model_.items[item], [&](int turn, std::uint64_t states) {
    if (const std::uint64_t same = model_.items[other].states_at(turn)) f.add().when(item, states).when(other, same);
  });
  habit("turned alike", item, kFaces, std::move(f), {other});
}

// What a crowd looks at stands before the middle of it: an altar before the pews, not before one half of them.
void Habits::stand_before_crowd(ItemId faced) {
  std::vector<ItemId> crowd;
  for (const ItemId other : model_.items.ids()) {
    if (other == faced || model_.items[other].is_opening()) continue;
    const std::optional<Group> group = formation_with(other);
    if (!group) continue;
    const bool looks = std::any_of(group->members.begin(), group->members.end(),
                                   [&](ItemId m) { return related_as_target(m, faced, RelationType::kFacing); });
    if (!looks) continue;
    crowd = group->members;
    break;
  }
  stand_before_middle_of(crowd, faced);
}

void Habits::stand_before_middle_of(const std::vector<ItemId>& crowd, ItemId faced) {
  const std::string name = "before the middle of the crowd";
  const bool placed = model_.items[faced].mount == Mount::kWall ? placed_by_relation_besides_walls(faced) : placed_besides_facing(faced);
  if (crowd.size() < kManyInFormation || placed) return;
  if (std::any_of(model_.constraints.begin(), model_.constraints.end(), [&](const Constraint& c) { return c.name.starts_with(name); }))
    return;
  Formula f;
  for_each_turn(model_.items[crowd[0]], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const int along = across(side_direction(model_.items[crowd[0]], Side::kFront, turn));
    const auto n = static_cast<std::int64_t>(crowd.size());
    Linear off = n * mid2(faced, along);
    for (const ItemId member : crowd) off = off - mid2(member, along);
    f.add().when(crowd[0], states).wish(off, kBeside, 2 * n);
  });
  habit(name, faced, kBeside, std::move(f), {crowd[0]});
}

// What a crowd looks at stands clear of its first row.
void Habits::keep_off_faced(ItemId item) {
  for (const Relation* said : said_of(item)) {
    const Relation& r = *said;
    if (r.type != RelationType::kFacing || r.references.size() != 1) continue;
    const ItemId faced = model_.find_item(r.references[0]);
    if (!faced.exists() || model_.items[faced].is_opening() || !related_as_target(item, faced, r.type)) continue;
    stand_before_crowd(faced);
    if (model_.items[faced].mount != Mount::kFloor) continue;
    Formula f;
    for (const int axis : {0, 1}) {
      for (const int sign : {1, -1}) f.add().require(gap_towards(item, faced, {axis, sign}) - Linear(measures().before_crowd));
    }
    habit("keeps off", item, kKeepOff, std::move(f), {faced});
    return;
  }
}

// The only one of them that is told to look at something else; -1: none, or several.
int Habits::leader_of(const Group& group) const {
  int leader = -1;
  for (std::size_t k = 0; k < group.members.size(); ++k) {
    const bool leads = std::ranges::any_of(model_.scene->relations, [&](const Relation& r) {
      return r.type == RelationType::kFacing && std::ranges::find(r.targets, model_.items[group.members[k]].id) != r.targets.end();
    });
    if (leads && leader >= 0) return -1;
    if (leads) leader = static_cast<int>(k);
  }
  return leader;
}

// Two rows back to back, turned one way and the other.
bool Habits::stand_in_islands(ItemId item, const Group& group, int k) {
  Formula f;
  add_island_place(f, model_, {.group = group.members, .k = k, .weight = kFormation, .in_line = kInLine, .part = part_of(group)});
  if (f.cases.empty()) return false;
  Constraint& place = habit("in an island", item, kFormation, std::move(f));
  place.formation = group.members[0], place.member = item;
  if (k == 0) return true;
  Formula alike;
  const ItemId first = group.members[0];
  for_each_turn(model_.items[item], [&](int turn, std::uint64_t states) {
    const std::uint64_t same = model_.items[first].states_at((turn + (k % 2 == 0 ? 0 : 180)) % 360);
    if (same) alike.add().when(item, states).when(first, same);
  });
  habit("turned as the island", item, kFaces, std::move(alike), {first});
  return true;
}

bool Habits::stand_in_formation(ItemId item) {
  if (stand_in_blocks(item)) return true;
  const std::optional<Group> group = formation_with(item);
  if (!group) return false;
  const int k = static_cast<int>(std::find(group->members.begin(), group->members.end(), item) - group->members.begin());
  const ItemId first = group->members[0];
  if (group->columns == 0 && model_.items[first].entry->back_to_wall && fits_islands(first)) return stand_in_islands(item, *group, k);
  Formula f;
  // Tables stand before the bar; those of a class before the board.
  const bool tables = group->columns == 0 && model_.items[first].is(Trait::kTable);
  const ItemId bar = tables ? counter_of_room() : ItemId(), waited_at = group->columns > 0 || !tables ? desk_waited_at(*group) : ItemId();
  const ItemId counter = waited_at.exists() ? waited_at : tables && !bar.exists() ? board_of_room() : bar;
  // Round something in the middle of the room each stands where there is room for it.
  const bool crossed = !told_middle_with_others(first) && middle_is_taken(first);
  const bool looks =
      told_where_to_look(first) || (model_.items[first].has_front && (!items_of_kinds(model_.items[first].entry->faces, first).empty() ||
                                                                      (!seen_by_crowd(first).empty() && model_.items[first].is_seat)));
  add_formation_place(f, model_,
                      {.group = group->members,
                       .k = k,
                       .columns = group->columns,
                       .spread = group->spread,
                       .weight = crossed ? 2 * kFormation : kFormation,
                       .in_line = crossed ? 0 : kInLine,
                       .before = !waited_at.exists() && (looks || counter != bar) ? depth_before(first) : 0,
                       .seats = depth_of_seats(*group),
                       .in_view = view_of(*group),
                       .leader = group->columns == 0 ? leader_of(*group) : -1,
                       .counter = counter,
                       .part = part_of(*group)});
  if (f.cases.empty()) return false;
  Constraint& place =
      habit("in formation", item, kFormation, std::move(f), counter.exists() ? std::vector<ItemId>{counter} : std::vector<ItemId>{});
  place.formation = first, place.member = item;
  keep_off_faced(item);
  if (k == 0) {
    if (told_where_to_look(item)) return true;
    look_at(item, true, group->members);
    const std::vector<ItemId> seen = seen_by_crowd(item);
    if (!seen.empty() && model_.items[seen[0]].is(Trait::kScreen)) stand_before_middle_of(group->members, stand_of_screen(seen[0]));
  } else if (model_.items[item].has_front) {
    turn_as(item, group->members[0]);
  }
  return true;
}

}  // namespace layoutbox::placement
