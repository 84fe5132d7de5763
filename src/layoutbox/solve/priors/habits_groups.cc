// Habits of groups: those who dine, those who serve and those who wait, each with room of their own.
#include "layoutbox/catalog/measures.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {

// The desk below a loft bed does not reach out beyond it, where the ladder is and one walks.
void Habits::stay_under_loft(ItemId item) {
  constexpr int kWithin = 400;  // points a metre
  for (const ItemId loft : model_.items.ids()) {
    if (!model_.items[loft].stood_under || !related_as_target(item, loft, RelationType::kUnder)) continue;
    Formula f;
    Case& c = f.add();
    for (const int axis : {0, 1}) c.require(lo(item, axis) - lo(loft, axis)).require(hi(loft, axis) - hi(item, axis));
    habit("below the loft", item, kWithin, std::move(f), {loft});
  }
}

// A table that one sits at upright, with those who do.
bool Habits::is_dined_at(ItemId item) const {
  const Item& table = model_.items[item];
  return table.is(Trait::kTable) && !table.is(Trait::kDeskLike) && table.mount == Mount::kFloor && !table.entry->back_to_wall &&
         table.states[0].size.height >= measures().sat_at_from && has_sitters(item);
}

// Who dines does not sit among the sofas: the table, with the chairs round it, keeps off what belongs to the talking group; nor do those
// who read lean against the shelves.
void Habits::keep_off_sofas(ItemId item) {
  constexpr int kApart = 300;  // points a metre
  if (!is_dined_at(item)) return;
  for (const ItemId other : model_.items.ids()) {
    const Item& ref = model_.items[other];
    if (ref.is_opening() || ref.mount != Mount::kFloor || ref.thin || related(item, other)) continue;
    const bool sofa = ref.is(Trait::kCenterPiece) && !ref.is(Trait::kBed);
    const bool shelf = ref.is(Trait::kShelving) && ref.states[0].size.height >= measures().tall_from;
    if (!sofa && !shelf && !ref.is(Trait::kCoffeeTable)) continue;
    Formula f;
    for (const int axis : {0, 1}) {
      for (const int sign : {1, -1}) f.add().require(gap_towards(item, other, {axis, sign}) - Linear(measures().chairs_and_way));
    }
    habit("off the sofas", item, kApart, std::move(f));
  }
}

// Tables that are dined at leave room between them for who sits at both and a way through; told to be by the same wall or window, they
// stand in line along it.
void Habits::keep_off_other_tables(ItemId item) {
  constexpr Mm kSeatsAndWay = 900;
  constexpr int kApart = 400, kInLineByWall = 200;  // points a metre
  if (!is_dined_at(item)) return;
  const auto sides_of_room = [&](ItemId table) {
    std::vector<std::pair<RelationType, std::vector<std::string>>> told;
    for (const Relation* r : said_of(table)) {
      const ItemId reference = r->references.size() == 1 ? model_.find_item(r->references[0]) : ItemId();
      const bool at_side = traits_of(r->type).back_to_wall || (reference.exists() && model_.items[reference].is_opening());
      if (at_side && std::ranges::find(r->targets, model_.items[table].id) != r->targets.end()) told.emplace_back(r->type, r->references);
    }
    return told;
  };
  const auto mine = sides_of_room(item);
  for (const ItemId other : ids_before(item)) {
    if (model_.items[other].is_opening() || !is_dined_at(other) || related(item, other)) continue;
    const bool in_line = !mine.empty() && sides_of_room(other) == mine;
    Formula f;
    for (const int axis : {0, 1}) {
      for (const int sign : {1, -1}) {
        Case& c = f.add().require(gap_towards(item, other, {axis, sign}) - Linear(kSeatsAndWay));
        if (in_line) c.wish(mid2(item, 1 - axis) - mid2(other, 1 - axis), kInLineByWall, 2);
      }
    }
    habit("off the other tables", item, kApart, std::move(f));
  }
}

// A sofa does not take the floor by a bed, where one gets up.
void Habits::keep_off_beds(ItemId item) {
  constexpr int kOff = 300;  // points a metre
  const Item& self = model_.items[item];
  if (!self.is(Trait::kCenterPiece) || self.is(Trait::kBed)) return;
  for (const ItemId bed : model_.items.ids()) {
    if (model_.items[bed].is_opening() || model_.items[bed].mount != Mount::kFloor || !model_.items[bed].is(Trait::kBed) ||
        related(item, bed))
      continue;
    Formula f;
    for (const int axis : {0, 1}) {
      for (const int sign : {1, -1}) f.add().require(gap_towards(item, bed, {axis, sign}) - Linear(measures().getting_up));
    }
    habit("off the bed", item, kOff, std::move(f));
  }
}

// The table that a sideboard (a low and long cupboard that nothing looks at) goes with: the only one that is dined at, if any.
ItemId Habits::table_served_by(ItemId item) const {
  constexpr Mm kHigh = 1100, kLong = 1000;
  const Item& self = model_.items[item];
  const Size& size = self.states[0].size;
  const bool sideboard = self.mount == Mount::kFloor && self.entry->back_to_wall && self.entry->top_carries && size.height <= kHigh &&
                         size.width >= kLong && !self.is(Trait::kBed) && !self.is(Trait::kSeat);
  const bool worked_at = self.is(Trait::kKitchenRun) || self.is(Trait::kCounter) || self.is(Trait::kDeskLike);
  if (!sideboard || worked_at || is_faced_by_kind(item) || placed_by_relation_besides_walls(item)) return {};
  ItemId table;
  for (const ItemId other : model_.items.ids()) {
    if (model_.items[other].is_opening() || !is_dined_at(other)) continue;
    if (table.exists()) return {};
    table = other;
  }
  return table;
}

// A sideboard has its middle before that of its table, and no window behind what it carries.
void Habits::stand_in_table_axis(ItemId item) {
  constexpr int kInAxis = 120, kClearOfWindow = 100;  // points a metre
  constexpr Mm kBehind = 400;
  const ItemId table = table_served_by(item);
  if (!table.exists()) return;
  Formula f;
  for (const RoomWall& wall : model_.walls) {
    if (!wall.straight) continue;
    f.add().when(item, states_with_back_to(model_.items[item], wall)).wish(mid2(item, wall.along) - mid2(table, wall.along), kInAxis, 2);
  }
  if (!f.cases.empty()) habit("in the table's axis", item, kInAxis, std::move(f), {table});
  for (const ItemId window : model_.items.ids()) {
    if (!model_.items[window].is_opening() || model_.items[window].opening->type != OpeningType::kWindow) continue;
    Formula clear;
    for_each_turn(model_.items[window], [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      const Direction front = side_direction(model_.items[window], Side::kFront, turn);
      clear.add().when(window, states).require(gap_towards(item, window, front) - Linear(kBehind));
      for (const int sign : {1, -1}) clear.add().when(window, states).require(gap_towards(item, window, {across(front), sign}));
    });
    if (!clear.cases.empty()) habit("clear of the window", item, kClearOfWindow, std::move(clear));
  }
}

// The relation by which it parts two groups of the room: a shelf between the bed and the sofa. Null: none.
const Relation* Habits::divided_by(ItemId item) const {
  const auto found = std::ranges::find_if(model_.scene->relations, [&](const Relation& r) {
    return r.type == RelationType::kBetween && r.origin == Origin::kConcluded && r.references.size() == 2 &&
           r.targets == std::vector<std::string>{model_.items[item].id};
  });
  return found == model_.scene->relations.end() ? nullptr : &*found;
}

// What parts two groups stands across the way from one to the other, before the middle of the first.
void Habits::stand_across(ItemId item) {
  constexpr Mm kRoom = 700;
  constexpr int kAcross = 500;  // points a metre
  const Relation* parts = divided_by(item);
  if (parts == nullptr) return;
  const ItemId one = model_.find_item(parts->references[0]), other = model_.find_item(parts->references[1]);
  if (!one.exists() || !other.exists()) return;
  Formula f;
  for (const int axis : {0, 1}) {
    const std::uint64_t across = states_with_width_along(model_.items[item], 1 - axis);
    for (const int sign : {1, -1}) {
      f.add()
          .when(item, across)
          .require(gap_towards(item, one, {axis, sign}) - Linear(kRoom))
          .require(gap_towards(item, other, {axis, -sign}))
          .wish(mid2(item, 1 - axis) - mid2(one, 1 - axis), kBeside / 2, 2);
    }
  }
  habit("parts the groups", item, kAcross, std::move(f), {one, other});
}

// The rug that others sit on, on beanbags and cushions, is theirs: no table stands on it.
void Habits::keep_off_sitters_rug(ItemId item) {
  constexpr int kOff = 400;  // points a metre
  const Item& self = model_.items[item];
  if (!self.is(Trait::kTable)) return;
  for (const ItemId rug : model_.items.ids()) {
    if (!model_.items[rug].thin || model_.items[rug].mount != Mount::kFloor || related(item, rug)) continue;
    const bool sat_on = std::ranges::any_of(model_.scene->relations, [&](const Relation& r) {
      const ItemId sitter =
          r.type == RelationType::kOn && r.references == std::vector<std::string>{model_.items[rug].id} && !r.targets.empty()
              ? model_.find_item(r.targets[0])
              : ItemId();
      return sitter.exists() && !model_.items[sitter].is(Trait::kTableSeat) && !model_.items[sitter].has_front;
    });
    if (!sat_on) continue;
    Formula f;
    for (const int axis : {0, 1}) {
      for (const int sign : {1, -1}) f.add().require(gap_towards(item, rug, {axis, sign}));
    }
    habit("off the sitters' rug", item, kOff, std::move(f));
  }
}

// In a hall nothing stands opposite anything: one walks past each by itself.
void Habits::keep_hall_free(ItemId item) {
  constexpr Mm kNarrow = 1800;
  constexpr int kOpposite = 250;  // points a metre
  const Mm width = model_.room.extent(0), depth = model_.room.extent(1);
  const int along = width > depth ? 0 : 1;
  if (std::min(width, depth) > kNarrow || std::max(width, depth) < 2 * std::min(width, depth)) return;
  for (const ItemId other : ids_before(item)) {
    const Item& ref = model_.items[other];
    if (ref.is_opening() || ref.mount != Mount::kFloor || ref.thin || related(item, other)) continue;
    Formula f;
    for (const int sign : {1, -1}) f.add().require(gap_towards(item, other, {along, sign}));
    habit("one by one along the hall", item, kOpposite, std::move(f));
  }
}

// A counter at a window is sat at, looking out: nobody serves there.
bool Habits::is_window_bar(ItemId item) const {
  if (!model_.items[item].is(Trait::kCounter)) return false;
  return std::ranges::any_of(said_of(item), [&](const Relation* r) {
    if (std::ranges::find(r->targets, model_.items[item].id) == r->targets.end()) return false;
    if (r->type == RelationType::kUnderWindow || r->type == RelationType::kNearWindow) return true;
    const ItemId other = r->references.size() == 1 ? model_.find_item(r->references[0]) : ItemId();
    return traits_of(r->type).close_by && other.exists() && model_.items[other].is_opening() &&
           model_.items[other].opening->type == OpeningType::kWindow;
  });
}

// … with its back to the wall below, before the middle of the window.
void Habits::stand_at_window(ItemId item) {
  back_to_wall(item, kBackToWall);
  Formula f;
  for (const ItemId i : model_.items.ids()) {
    const Item& window = model_.items[i];
    if (!window.is_opening() || window.opening->type != OpeningType::kWindow) continue;
    for (const RoomWall& wall : model_.walls) {
      if (!wall.straight || (!window.opening->wall.empty() && window.opening->wall != wall.id)) continue;
      Case& c = f.add().when(item, states_with_back_to(model_.items[item], wall));
      if (window.opening->wall.empty()) c.when(i, window.states_at(wall.turn));
      c.wish(mid2(item, wall.along) - mid2(i, wall.along), kAtWall, 2);
    }
  }
  if (!f.cases.empty()) habit("at its window", item, kAtWall, std::move(f));
}

// A reception desk, a counter: guests before it, who serves behind.
bool Habits::is_served_over(ItemId item) const {
  const Item& desk = model_.items[item];
  if (desk.is_opening() || desk.mount != Mount::kFloor || !desk.has_front || !desk.is(Trait::kOpenToRoom) || is_window_bar(item))
    return false;
  const std::vector<Side> used = used_sides(desk);
  return (desk.is(Trait::kDeskLike) || desk.is(Trait::kCounter)) && used.size() < 4 && std::ranges::find(used, Side::kBack) != used.end() &&
         std::ranges::find(used, Side::kFront) != used.end();
}

// Is the seat a guest's there, who waits to be served? The worker's own is of a kind that stands by desks before all else.
bool Habits::waits_for(ItemId item, ItemId desk) const {
  if (!is_served_over(desk) || !model_.items[desk].is(Trait::kDeskLike) || related(item, desk)) return false;
  const std::vector<std::string>& by = model_.items[item].entry->beside;
  const CatalogEntry* first = by.empty() ? nullptr : model_.catalog->find(by[0]);
  return first == nullptr || !first->is(Trait::kDeskLike) || !model_.is_a(desk, by[0]);
}

// Bottles are at the back of who serves: along the counter, an arm and a step behind it.
bool Habits::stand_behind_server(ItemId item) {
  constexpr int kBehindServer = 500, kBeforeMiddle = 200;  // points a metre
  const ItemId counter = model_.items[item].is(Trait::kBehindServer) && !placed_by_relation(item) ? counter_of_room() : ItemId();
  if (!counter.exists()) return false;
  Formula f;
  for_each_turn(model_.items[counter], [&](int turn, std::uint64_t states) {
    const std::uint64_t alike = model_.items[item].states_at(turn);
    if (turn % 90 != 0 || !alike) return;
    const Direction back = side_direction(model_.items[counter], Side::kBack, turn);
    Case& c = f.add().when(counter, states).when(item, alike);
    c.require(gap_towards(item, counter, back));
    c.wish(gap_towards(item, counter, back) - Linear(measures().behind_bar), kBehindServer);
    c.wish(mid2(item, across(back)) - mid2(counter, across(back)), kBeforeMiddle, 2);
  });
  if (f.cases.empty()) return false;
  habit("behind who serves", item, kBehindServer, std::move(f), {counter});
  return true;
}

// What stands there between who serves and the wall.
Mm Habits::depth_behind_server(ItemId counter) const {
  Mm depth = 0;
  for (const Item& item : model_.items) {
    if (!item.is_opening() && item.is(Trait::kBehindServer) && counter_of_room() == counter)
      depth = std::max(depth, item.states[0].size.depth + 310);
  }
  return depth;
}

// Who receives looks at those who come in: the doors are before a reception desk or a counter, not behind it.
void Habits::face_entrance(ItemId item) {
  constexpr int kSeen = 250;  // points a metre
  if (!is_served_over(item)) return;
  for (const ItemId host : model_.items.ids()) {
    const Item& door = model_.items[host];
    if (!door.is_opening() || door.opening->type != OpeningType::kDoor) continue;
    Formula f;
    for_each_turn(model_.items[item], [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      const Direction front = side_direction(model_.items[item], Side::kFront, turn);
      f.add().when(item, states).require(gap_towards(host, item, front));
    });
    habit("sees who comes in", item, kSeen, std::move(f), {host});
  }
}

}  // namespace layoutbox::placement
