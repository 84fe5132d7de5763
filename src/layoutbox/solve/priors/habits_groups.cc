// Habits of groups: those who sit by the fire, those who dine and those who talk, each with room of their own.
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {

// A table that one sits at upright, with those who do.
bool Habits::is_dined_at(int item) const {
  constexpr Mm kHigh = 600;
  const Item& table = model_.items[item];
  return table.is(Trait::kTable) && !table.is(Trait::kDeskLike) && table.mount == Mount::kFloor && !table.entry->back_to_wall &&
         table.states[0].size.height >= kHigh && has_sitters(item);
}

// Who dines does not sit among the sofas: the table, with the chairs round it, keeps off what belongs to the talking group; nor do those
// who read lean against the shelves.
void Habits::keep_off_sofas(int item) {
  constexpr Mm kChairsAndWay = 1200, kTall = 1200;
  constexpr int kApart = 300;  // points a metre
  if (!is_dined_at(item)) return;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const int other = static_cast<int>(i);
    const Item& ref = model_.items[i];
    if (ref.is_opening() || ref.mount != Mount::kFloor || ref.thin || related(item, other)) continue;
    const bool sofa = ref.is(Trait::kCenterPiece) && !ref.is(Trait::kBed);
    const bool shelf = ref.is(Trait::kShelving) && ref.states[0].size.height >= kTall;
    if (!sofa && !shelf && !ref.is(Trait::kCoffeeTable)) continue;
    Formula f;
    for (const int axis : {0, 1}) {
      for (const int sign : {1, -1}) f.add().require(gap_towards(item, other, {axis, sign}) - Linear(kChairsAndWay));
    }
    habit("off the sofas", item, kApart, std::move(f));
  }
}

// The relation by which it parts two groups of the room: a shelf between the bed and the sofa. Null: none.
const Relation* Habits::divided_by(int item) const {
  const auto found = std::ranges::find_if(model_.scene->relations, [&](const Relation& r) {
    return r.type == RelationType::kBetween && r.origin == Origin::kConcluded && r.references.size() == 2 &&
           r.targets == std::vector<std::string>{model_.items[item].id};
  });
  return found == model_.scene->relations.end() ? nullptr : &*found;
}

// What parts two groups stands across the way from one to the other, before the middle of the first.
void Habits::stand_across(int item) {
  constexpr Mm kRoom = 700;
  constexpr int kAcross = 500;  // points a metre
  const Relation* parts = divided_by(item);
  if (parts == nullptr) return;
  const int one = model_.find_item(parts->references[0]), other = model_.find_item(parts->references[1]);
  if (one < 0 || other < 0) return;
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

// Easy chairs that have nothing but the fire to look at sit before it, side by side and close enough to feel it.
bool Habits::sit_by_fire(int item) {
  constexpr Mm kOff = 1100, kBetween = 450;
  const auto sits = [&](int i) {
    const Item& other = model_.items[i];
    return !other.is_opening() && other.mount == Mount::kFloor && other.is(Trait::kEasySeat) && other.has_front && !other.fixed &&
           !placed_besides_facing(i);
  };
  if (!sits(item)) return false;
  const std::vector<int> seen = items_of_kinds(model_.items[item].entry->faces, item);
  const auto else_seen = [&](int i) {
    const Item& ref = model_.items[i];
    return ref.is(Trait::kScreen) || ref.is(Trait::kCoffeeTable) || ref.is(Trait::kCenterPiece);
  };
  const auto is_fire = [&](int i) { return !model_.items[i].is(Trait::kTable) && model_.items[i].has_front; };
  const auto fire = std::ranges::find_if(seen, is_fire);
  if (fire == seen.end() || std::ranges::any_of(seen, else_seen)) return false;
  std::vector<int> seats;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    if (sits(static_cast<int>(i)) && model_.items[i].entry == model_.items[item].entry) seats.push_back(static_cast<int>(i));
  }
  const auto k = std::ranges::find(seats, item) - seats.begin();
  const auto n = static_cast<std::ptrdiff_t>(seats.size());
  const Mm pitch = model_.items[item].states[0].size.width + kBetween;
  Formula f;
  for_each_turn(model_.items[*fire], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(model_.items[*fire], Side::kFront, turn);
    Case& c = f.add().when(*fire, states).when(item, states_looking(model_.items[item], opposite(front)));
    c.wish(mid2(item, across(front)) - mid2(*fire, across(front)) - Linear((2 * k - (n - 1)) * pitch), kBeside, 2);
    c.wish(gap_towards(item, *fire, front) - Linear(kOff), kBeside);
  });
  habit("by the fire", item, kBeside, std::move(f), {*fire});
  return true;
}

// Two easy chairs that nothing is there for to look at stand face to face: the second across from the first.
bool Habits::sit_to_talk(int item) {
  constexpr Mm kBetween = 1000;
  const auto talks = [&](int i) {
    const Item& other = model_.items[i];
    return !other.is_opening() && other.mount == Mount::kFloor && other.entry == model_.items[item].entry && !other.fixed &&
           !placed_by_relation(i);
  };
  const Item& self = model_.items[item];
  if (!self.is(Trait::kEasySeat) || !self.has_front || !talks(item) || !items_of_kinds(self.entry->faces, item).empty()) return false;
  std::vector<int> seats;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    if (talks(static_cast<int>(i))) seats.push_back(static_cast<int>(i));
  }
  if (seats.size() != 2 || seats[1] != item) return false;
  Formula f;
  for_each_turn(model_.items[seats[0]], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(model_.items[seats[0]], Side::kFront, turn);
    Case& c = f.add().when(seats[0], states).when(item, states_looking(self, opposite(front)));
    c.wish(mid2(item, across(front)) - mid2(seats[0], across(front)), kBeside, 2);
    c.wish(gap_towards(item, seats[0], front) - Linear(kBetween), kBeside);
  });
  habit("face to face", item, kBeside, std::move(f), {seats[0]});
  return true;
}

// The rug that others sit on, on beanbags and cushions, is theirs: no table stands on it.
void Habits::keep_off_sitters_rug(int item) {
  constexpr int kOff = 400;  // points a metre
  const Item& self = model_.items[item];
  if (!self.is(Trait::kTable)) return;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const int rug = static_cast<int>(i);
    if (!model_.items[i].thin || model_.items[i].mount != Mount::kFloor || related(item, rug)) continue;
    const bool sat_on = std::ranges::any_of(model_.scene->relations, [&](const Relation& r) {
      const int sitter = r.type == RelationType::kOn && r.references == std::vector<std::string>{model_.items[i].id} && !r.targets.empty()
                             ? model_.find_item(r.targets[0])
                             : -1;
      return sitter >= 0 && !model_.items[sitter].is(Trait::kTableSeat) && !model_.items[sitter].has_front;
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
void Habits::keep_hall_free(int item) {
  constexpr Mm kNarrow = 1800;
  constexpr int kOpposite = 250;  // points a metre
  const Mm width = model_.room.extent(0), depth = model_.room.extent(1);
  const int along = width > depth ? 0 : 1;
  if (std::min(width, depth) > kNarrow || std::max(width, depth) < 2 * std::min(width, depth)) return;
  for (int other = 0; other < item; ++other) {
    const Item& ref = model_.items[other];
    if (ref.is_opening() || ref.mount != Mount::kFloor || ref.thin || related(item, other)) continue;
    Formula f;
    for (const int sign : {1, -1}) f.add().require(gap_towards(item, other, {along, sign}));
    habit("one by one along the hall", item, kOpposite, std::move(f));
  }
}

// A reception desk, a counter: guests before it, who serves behind.
bool Habits::is_served_over(int item) const {
  const Item& desk = model_.items[item];
  if (desk.is_opening() || desk.mount != Mount::kFloor || !desk.has_front || !desk.is(Trait::kOpenToRoom)) return false;
  const std::vector<Side> used = used_sides(desk);
  return (desk.is(Trait::kDeskLike) || desk.is(Trait::kCounter)) && used.size() < 4 && std::ranges::find(used, Side::kBack) != used.end() &&
         std::ranges::find(used, Side::kFront) != used.end();
}

// Is the seat a guest's there, who waits to be served? The worker's own is of a kind that stands by desks before all else.
bool Habits::waits_for(int item, int desk) const {
  if (!is_served_over(desk) || !model_.items[desk].is(Trait::kDeskLike) || related(item, desk)) return false;
  const std::vector<std::string>& by = model_.items[item].entry->beside;
  const CatalogEntry* first = by.empty() ? nullptr : model_.catalog->find(by[0]);
  return first == nullptr || !first->is(Trait::kDeskLike) || !model_.is_a(desk, by[0]);
}

// Guests wait before who serves: not behind a reception desk or a counter.
void Habits::wait_before_counter(int item) {
  constexpr int kGuests = 700;  // points a metre
  const Item& self = model_.items[item];
  const bool sofa = self.is(Trait::kCenterPiece) && !self.is(Trait::kBed) && self.has_front;
  if (!self.is(Trait::kTableSeat) && !self.is(Trait::kSeat) && !self.is(Trait::kEasySeat) && !sofa) return;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const Item& desk = model_.items[i];
    const int host = static_cast<int>(i);
    if (host == item || !is_served_over(host) || related(item, host)) continue;
    if (desk.is(Trait::kDeskLike) && !waits_for(item, host)) continue;
    Formula f;
    for_each_turn(desk, [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      const Direction front = side_direction(desk, Side::kFront, turn);
      f.add().when(host, states).require(gap_towards(item, host, front) + Linear(desk.states[0].size.depth));
    });
    habit("waits before the desk", item, kGuests, std::move(f));
  }
}

// Bottles are at the back of who serves: along the counter, an arm and a step behind it.
bool Habits::stand_behind_server(int item) {
  constexpr Mm kForServer = 900;
  constexpr int kBehindServer = 500, kBeforeMiddle = 200;  // points a metre
  const int counter = model_.items[item].is(Trait::kBehindServer) && !placed_by_relation(item) ? counter_of_room() : -1;
  if (counter < 0) return false;
  Formula f;
  for_each_turn(model_.items[counter], [&](int turn, std::uint64_t states) {
    const std::uint64_t alike = model_.items[item].states_at(turn);
    if (turn % 90 != 0 || !alike) return;
    const Direction back = side_direction(model_.items[counter], Side::kBack, turn);
    Case& c = f.add().when(counter, states).when(item, alike);
    c.require(gap_towards(item, counter, back));
    c.wish(gap_towards(item, counter, back) - Linear(kForServer), kBehindServer);
    c.wish(mid2(item, across(back)) - mid2(counter, across(back)), kBeforeMiddle, 2);
  });
  if (f.cases.empty()) return false;
  habit("behind who serves", item, kBehindServer, std::move(f), {counter});
  return true;
}

// What stands there between who serves and the wall.
Mm Habits::depth_behind_server(int counter) const {
  Mm depth = 0;
  for (const Item& item : model_.items) {
    if (!item.is_opening() && item.is(Trait::kBehindServer) && counter_of_room() == counter)
      depth = std::max(depth, item.states[0].size.depth + 310);
  }
  return depth;
}

// Who receives looks at those who come in: the doors are before a reception desk or a counter, not behind it.
void Habits::face_entrance(int item) {
  constexpr int kSeen = 250;  // points a metre
  if (!is_served_over(item)) return;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const Item& door = model_.items[i];
    const int host = static_cast<int>(i);
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
