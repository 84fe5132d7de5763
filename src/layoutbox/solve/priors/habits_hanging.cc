// Habits of what hangs on walls.
#include "layoutbox/catalog/groups.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {
namespace {

constexpr int kHangHeight = 600;  // points a metre
constexpr Mm kMostUnder = 1300;   // what is higher has nothing above it

}  // namespace

// Several of a kind of which the same is said (hooks above a bench, three pictures) hang side by side at one height.
bool Habits::hang_in_row(ItemId item) {
  constexpr Mm kLeastAir = 120, kMostAir = 250;
  constexpr int kInRow = 400;
  const auto said_of = [&](ItemId i) {
    std::vector<std::pair<RelationType, std::vector<std::string>>> said;
    for (const Relation& r : model_.scene->relations) {
      if (r.type != RelationType::kOnWall && std::ranges::find(r.targets, model_.items[i].id) != r.targets.end())
        said.emplace_back(r.type, r.references);
    }
    return said;
  };
  const auto wall_of = [&](ItemId i) -> std::vector<std::string> {
    for (const Relation& r : model_.scene->relations) {
      if (r.type == RelationType::kOnWall && std::ranges::find(r.targets, model_.items[i].id) != r.targets.end()) return r.references;
    }
    return {};
  };
  const auto mine = said_of(item);
  if (hang_in_row_over(item)) return true;
  const bool faced = seat_facing(item).exists();  // each by a seat of its own
  if (mine.empty() && !faced && !is_of_few_on_wall(item)) return false;
  std::vector<ItemId> row;
  for (const ItemId i : model_.items.ids()) {
    const Item& other = model_.items[i];
    if (!other.is_opening() && other.entry == model_.items[item].entry && other.mount == Mount::kWall && said_of(i) == mine &&
        wall_of(i) == wall_of(item) && seat_facing(i).exists() == faced)
      row.push_back(i);
  }
  const auto rank = std::ranges::find(row, item) - row.begin();
  const Item& self = model_.items[item];
  // Who sits before each of them needs more width than they.
  const Mm close = std::clamp(self.states[0].size.width / 2, kLeastAir, kMostAir);
  const Mm air = mine.empty() && !faced ? std::max(close, air_on_wall(item, static_cast<int>(row.size()))) : close;
  const auto width_of = [&](ItemId i) {
    const ItemId seat = seat_facing(i);
    return std::max(model_.items[i].states[0].size.width + air,
                    !seat.exists() ? 0 : model_.items[seat].states[0].size.width + kBetweenMirrored);
  };
  if (rank == 0) return mine.empty() && begin_row(item, width_of(item), static_cast<int>(row.size()));
  const ItemId before = row[static_cast<std::size_t>(rank) - 1];
  const Mm pitch2 = width_of(item) + width_of(before);
  Formula f;
  for (const RoomWall& wall : model_.walls) {
    if (!wall.straight) continue;
    for (const int sign : {1, -1}) {
      Case& c = f.add().when(item, states_facing(item, wall)).when(before, states_facing(before, wall));
      c.wish(mid2(item, wall.along) - mid2(before, wall.along) - Linear(sign * pitch2), kInRow, 2);
      c.wish(mid2(item, wall.normal()) - mid2(before, wall.normal()), kInRow, 2).wish(lo(item, 2) - lo(before, 2), kInRow);
      // It goes on the way it began.
      if (rank > 1) c.require(sign * (mid2(before, wall.along) - mid2(row[static_cast<std::size_t>(rank) - 2], wall.along)));
    }
  }
  if (f.cases.empty()) return false;
  habit("in a row on the wall", item, kInRow, std::move(f), {before});
  return true;
}

// The first of a row of three and more, which is about the middle of its wall. False: these are fewer.
bool Habits::begin_row(ItemId item, Mm pitch, int count) {
  constexpr int kMany = 3, kOnCutWall = 60;
  if (count < kMany) return false;
  Formula f;
  for (const RoomWall& wall : model_.walls) {
    if (!wall.straight || std::int64_t{pitch} * count > wall.hi - wall.lo) continue;
    for (const int sign : {1, -1}) {
      Case& c = f.add().when(item, states_facing(item, wall));
      c.wish(mid2(item, wall.along) - Linear(std::int64_t{wall.lo} + wall.hi + std::int64_t{sign} * (count - 1) * pitch), kHangs / 4, 2);
      c.price = wall.turn == 180 || wall.turn == 270 ? kOnCutWall : 0;
    }
  }
  if (f.cases.empty()) return false;
  habit("begins the row", item, kHangs / 4, std::move(f));
  return true;
}

// One of a few of a kind told to hang on the same wall (or on a wall, and no more): a set, but for lamps, which light it from its ends.
bool Habits::is_of_few_on_wall(ItemId item) const {
  constexpr int kFew = 8;
  const auto wall_of = [&](ItemId i) -> const Relation* {
    const Item& other = model_.items[i];
    if (other.is_opening() || other.mount != Mount::kWall || other.curtain || other.is(Trait::kLamp) || other.is(Trait::kScreen))
      return nullptr;
    const Relation* told = nullptr;
    for (const Relation& r : model_.scene->relations) {
      if (std::ranges::find(r.targets, other.id) == r.targets.end()) continue;
      if (r.type != RelationType::kOnWall || told != nullptr) return nullptr;
      told = &r;
    }
    return told;
  };
  const Relation* mine = wall_of(item);
  if (mine == nullptr) return false;
  int alike = 0;
  for (const ItemId i : model_.items.ids()) {
    if (model_.items[i].entry != model_.items[item].entry) continue;
    const Relation* other = wall_of(i);
    if (other == nullptr) return false;
    if (other->references != mine->references) continue;  // on another wall
    ++alike;
  }
  return alike >= 2 && alike <= kFew;
}

// The seat that alone is told to face what hangs on the wall, or that has it for its mirror, if any.
ItemId Habits::seat_facing(ItemId item) const {
  for (const ItemId seat : model_.items.ids()) {
    if (!model_.items[seat].is(Trait::kSeat) && !model_.items[seat].is(Trait::kEasySeat)) continue;
    if (related_as_target(seat, item, RelationType::kFacing) || is_told_before_mirror(seat, item) ||
        (is_wall_mirror(item) && usual_mirror_of(seat) == item))
      return seat;
  }
  return {};
}

// The table that a meeting sits round, if any.
ItemId Habits::long_table() const {
  for (const ItemId i : model_.items.ids()) {
    const Item& table = model_.items[i];
    const Size& size = table.states[0].size;
    const bool long_one = 2 * std::max(size.width, size.depth) >= 3 * std::min(size.width, size.depth);
    if (table.is(Trait::kTable) && table.mount == Mount::kFloor && !table.entry->back_to_wall && !table.has_front && long_one &&
        has_knee_room(table) && !table.is(Trait::kCoffeeTable))
      return i;
  }
  return {};
}

// At the end of the table, so that nobody has it behind.
void Habits::hang_before_table(Formula& f, ItemId item, ItemId table) {
  constexpr int kAtSide = 100;
  const Item& long_one = model_.items[table];
  for (const RoomWall& wall : model_.walls) {
    for_each_turn(long_one, [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0 || !wall.straight) return;
      const int side = side_direction(long_one, Side::kRight, turn).axis;
      const Size& size = long_one.states[0].size;
      const int axis = size.width >= size.depth ? side : 1 - side;
      Case& c = f.add().when(item, states_facing(item, wall)).when(table, states);
      c.wish(mid2(item, wall.along) - mid2(table, wall.along), kHangs, 2);
      c.price = (axis == wall.normal() ? 0 : kAtSide) + (wall.turn == 180 || wall.turn == 270 ? 60 : 0);
    });
  }
}

// Cupboards and desks do not stand before a board or a screen that all look at, nor beds, sofas and chairs under a television, nor basins
// under the mirror that a barber's chair is before.
void Habits::leave_free_before(ItemId item) {
  constexpr Mm kBefore = 800;
  constexpr int kFree = 400, kOverRun = 120;  // points a metre
  const Item& self = model_.items[item];
  const bool mirror = is_wall_mirror(item) && seat_facing(item).exists();
  if (!self.is(Trait::kScreen) && !mirror) return;
  const bool board = mirror || !self.is(Trait::kElseOnWall);
  for (const ItemId other : model_.items.ids()) {
    const Item& ref = model_.items[other];
    if (ref.is_opening() || ref.mount != Mount::kFloor) continue;
    const bool sits_under = !board && (ref.is(Trait::kSeat) || ref.is(Trait::kEasySeat)) && !placed_by_relation(other);
    if ((!ref.entry->back_to_wall && !sits_under) || (mirror && ref.entry->top_carries)) continue;
    // A visitor's chair, an armchair that goes to nothing: nobody sits with the head under it.
    const bool loose = sits_under && usual_hosts(other).empty();
    const bool cooked_at = ref.is(Trait::kKitchenRun) && !related(item, other);  // nor over a kitchen's worktop
    const bool lain_in = ref.is(Trait::kCenterPiece) && only_turned_by(item, other);
    if (!loose && (board ? related(item, other) : !lain_in && !cooked_at)) continue;
    Formula f;
    for_each_turn(self, [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      const Direction front = side_direction(self, Side::kFront, turn);
      f.add().when(item, states).require(gap_towards(other, item, front) - Linear(kBefore));
      for (const int sign : {1, -1}) f.add().when(item, states).require(gap_towards(other, item, {across(front), sign}));
    });
    if (!f.cases.empty()) habit("free before it", item, cooked_at ? kOverRun : kFree, std::move(f));
  }
}

// What is looked at (no hooks) does not hang where an open door's leaf covers it: so far from the door, or so far into the room.
void Habits::hang_clear_of_doors(ItemId item) {
  constexpr Mm kBesideFrame = 80;
  const Item& self = model_.items[item];
  const bool looked_into = self.is(Trait::kScreen) || self.is(Trait::kMirror);
  if (!looked_into && (!used_sides(self).empty() || self.entry->mount != Mount::kWall)) return;
  const int behind_leaf = looked_into ? 400 : 150;  // points a metre
  for (const ItemId door : model_.items.ids()) {
    const Item& ref = model_.items[door];
    if (!ref.is_opening() || ref.opening->type != OpeningType::kDoor || related(item, door)) continue;
    Formula f;
    for_each_turn(ref, [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      const Direction into = side_direction(ref, Side::kFront, turn);
      f.add().when(door, states).require(gap_towards(item, door, into) - Linear(ref.opening->width));
      for (const int sign : {1, -1})
        f.add().when(door, states).require(gap_towards(item, door, {across(into), sign}) - Linear(kBesideFrame));
    });
    if (!f.cases.empty()) habit("not behind the door", item, behind_leaf, std::move(f));
  }
}

// Over what the thing on the wall usually hangs.
std::vector<ItemId> Habits::usually_under(ItemId item) const {
  const Item& self = model_.items[item];
  std::vector<ItemId> under;
  // A board that a class looks at hangs over nobody's desk.
  const bool is_faced = std::ranges::any_of(model_.scene->relations, [&](const Relation& r) {
    return r.type == RelationType::kFacing && std::ranges::find(r.references, self.id) != r.references.end();
  });
  const bool board = self.is(Trait::kScreen) && !self.is(Trait::kElseOnWall);
  if (is_faced || board || (is_wall_mirror(item) && seat_facing(item).exists())) return under;
  under = items_of_kinds(Groups::usual_at(Groups::builtin().hangs, *model_.catalog, *self.entry, Mount::kWall), item);
  // A wardrobe leaves no wall above it.
  std::erase_if(under, [&](ItemId i) {
    return model_.items[i].states[0].size.height > kMostUnder || (self.is(Trait::kScreen) && model_.items[i].is(Trait::kKitchenRun));
  });
  return under;
}

// What is told to hang below something on the wall hangs close below it, not at a height of its own: a shelf below a mirror.
bool Habits::hang_close_below(ItemId item) {
  constexpr Mm kAir = 60;
  for (const ItemId over : model_.items.ids()) {
    if (over == item || model_.items[over].is_opening() || model_.items[over].mount != Mount::kWall) continue;
    const bool below_mirror = is_wall_mirror(over) && !is_wall_mirror(item) && related_as_target(over, item, RelationType::kAbove);
    if (!related_as_target(item, over, RelationType::kUnder) && !below_mirror) continue;
    Formula f;
    f.add().wish(lo(over, 2) - hi(item, 2) - Linear(kAir), kHangHeight);
    habit("close below", item, kHangHeight, std::move(f), {over});
    return true;
  }
  return false;
}

// At its usual height; a curtain at its window, a picture over something, else in the middle of a wall.
void Habits::hang_on_wall(ItemId item) {
  const Item& self = model_.items[item];
  if (!hang_close_below(item)) {
    Formula height;
    const Mm wished = self.entry->hang_height > 0 ? self.entry->hang_height : 1200;
    height.add().wish(lo(item, 2) - Linear(wished), kHangHeight);
    habit("height", item, kHangHeight, std::move(height));
  }
  if (self.curtain) {
    cover_window(item);
    return;
  }
  leave_free_before(item);
  hang_clear_of_doors(item);
  if (hang_along_side(item) || stand_beside(item)) return;
  look_at(item, self.is(Trait::kScreen));
  if (hang_over_both(item) || hang_in_row(item)) return;
  if (placed_by_relation_besides_walls(item)) return;
  const std::vector<ItemId> under = usually_under(item);
  Formula f;
  std::vector<ItemId> hosts;
  if (static_cast<std::size_t>(rank_of(item)) < under.size()) {
    hosts.push_back(under[rank_of(item)]);
    for (const RoomWall& wall : model_.walls) {
      Case& c = f.add().when(item, states_facing(item, wall));
      c.wish(mid2(item, wall.along) - mid2(hosts[0], wall.along), kHangs, 2);
      c.wish(mid2(item, wall.normal()) - mid2(hosts[0], wall.normal()), kHangs / 2, 2);
      c.require(lo(item, 2) - hi(hosts[0], 2) - Linear(120));
    }
  } else if (const ItemId table = self.is(Trait::kScreen) && items_of_kinds(self.entry->faces, item).empty() ? long_table() : ItemId();
             table.exists()) {
    hang_before_table(f, item, table);
    hosts.push_back(table);
  } else {
    for (const RoomWall& wall : model_.walls) {
      Case& c = f.add().when(item, states_facing(item, wall));
      wish_middle_of_wall(c, model_, item, wall, kHangs / 4);
      // The picture cuts away the front and the right wall: hung there, nobody sees it.
      c.price = wall.turn == 180 || wall.turn == 270 ? 60 : 0;
    }
  }
  habit("hangs", item, kHangs, std::move(f), hosts);
}

std::uint64_t Habits::states_facing(ItemId item, const RoomWall& wall) const {
  const std::uint64_t states = states_at_angle(model_.items[item], wall.angle, 360);
  return states ? states : model_.items[item].all_states;
}

bool Habits::placed_by_relation_besides_walls(ItemId item) const {
  return std::ranges::any_of(said_of(item), [&](const Relation* r) {
    const bool target = std::ranges::find(r->targets, model_.items[item].id) != r->targets.end();
    return target && r->type != RelationType::kOnWall && r->type != RelationType::kAgainstWall;
  });
}

}  // namespace layoutbox::placement
