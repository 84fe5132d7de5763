// What a formation stands before, and the floor that it leaves for that and for those who sit there; what goes by a window, a door or who
// waits.
#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/measures.h"
#include "layoutbox/solve/priors/habits.h"
#include "layoutbox/solve/priors/seating.h"

namespace layoutbox::placement {
namespace {

constexpr int kAlongWindow = 2000;    // points a metre: more than the free floor that a bar wants behind it
constexpr int kGuestsTable = 250;     // points a metre
constexpr Mm kMostUnderWindow = 300;  // off the wall, as the relation has it

}  // namespace

// Where guests or customers are served, of which words say at most at which wall or end of the room it is, if anywhere.
ItemId Habits::counter_of_room() const {
  const auto only_told_end = [&](ItemId bar) {
    return std::ranges::all_of(said_of(bar), [&](const Relation* r) {
      if (std::ranges::find(r->targets, model_.items[bar].id) == r->targets.end() || traits_of(r->type).turns) return true;
      return r->type == RelationType::kInRegion || r->type == RelationType::kAgainstWall;
    });
  };
  for (const ItemId i : model_.items.ids()) {
    const Item& bar = model_.items[i];
    const bool served_over = bar.is(Trait::kCounter) && bar.is(Trait::kOpenToRoom) && bar.has_front && bar.mount == Mount::kFloor;
    if (served_over && used_sides(bar).size() < 4 && only_told_end(i)) return i;
  }
  return {};
}

// The reception desk that these seats wait before, where nothing says what they look at, if any.
ItemId Habits::desk_waited_at(const Group& group) const {
  const ItemId first = group.members[0];
  if (!model_.items[first].is_seat || !model_.items[first].has_front || told_where_to_look(first)) return {};
  for (const ItemId desk : model_.items.ids()) {
    if (!model_.items[desk].is_opening() && model_.items[desk].mount == Mount::kFloor && is_served_over(desk) && waits_for(first, desk))
      return desk;
  }
  return {};
}

// What a teacher's desk that nobody placed takes between the class and its board.
Mm Habits::teachers_depth() const {
  for (const ItemId i : model_.items.ids()) {
    if (faces_a_class(i)) return measures().for_teacher;
  }
  return 0;
}

// The floor behind each of them that its seat takes: all of that where words put it behind or before, else what is not tucked under.
Mm Habits::depth_of_seats(const Group& group) const {
  constexpr Mm kOffDesk = 50;
  const ItemId first = group.members[0];
  const Item& desk = model_.items[first];
  if (!desk.has_front || desk.is_seat || !(has_knee_room(desk) || desk.is(Trait::kDeskLike))) return 0;
  Mm deepest = 0;
  for (const ItemId seat : model_.items.ids()) {
    const Item& chair = model_.items[seat];
    if (chair.is_opening() || chair.mount != Mount::kFloor || !chair.is(Trait::kTableSeat)) continue;
    const bool told = std::ranges::any_of(group.members, [&](ItemId desk_of_it) {
      return related_as_target(seat, desk_of_it, RelationType::kBehind) || related_as_target(seat, desk_of_it, RelationType::kInFrontOf);
    });
    const bool here =
        told || (!placed_besides_facing(seat) && std::ranges::any_of(usual_hosts(seat), [&](ItemId host) { return host == first; })) ||
        std::ranges::any_of(group.members, [&](ItemId desk_of_it) { return related(seat, desk_of_it); });
    if (here) deepest = std::max(deepest, chair.states[0].size.depth - (told ? -kOffDesk : kTucked));
  }
  return deepest;
}

// Floor left free before the first row for what all look at and who stands there.
Mm Habits::depth_before(ItemId first) const {
  Mm depth = measures().stage_depth + teachers_depth();
  for (const Relation* r : said_of(first)) {
    if (r->type != RelationType::kFacing || r->references.size() != 1) continue;
    const ItemId faced = model_.find_item(r->references[0]);
    if (!faced.exists() || model_.items[faced].is_opening() || model_.items[faced].mount != Mount::kFloor) continue;
    const Size& size = model_.items[faced].states[0].size;
    depth = std::max(depth, std::min(size.width, size.depth) + measures().before_crowd);
  }
  return depth;
}

// How wide what each of them is told to look at is; 0: one looks for all, or nobody.
Mm Habits::view_of(const Group& group) const {
  constexpr Mm kEdge = 200;  // of it that nobody looks at
  int lookers = 0;
  ItemId seen;
  for (const ItemId member : group.members) {
    for (const Relation* r : said_of(member)) {
      if (r->type != RelationType::kFacing || r->references.size() != 1 || r->targets[0] != model_.items[member].id) continue;
      seen = model_.find_item(r->references[0]);
      ++lookers;
    }
  }
  return lookers < 2 || !seen.exists() || model_.items[seen].is_opening() ? 0
                                                                          : std::max(0, model_.items[seen].states[0].size.width - kEdge);
}

// What is long and told to be along or under a window lies with its long side there, a bar with its back; not what people dine round.
void Habits::lie_along_window(ItemId item) {
  const Item& self = model_.items[item];
  const Size& size = self.states[0].size;
  const bool is_long = 2 * std::max(size.width, size.depth) >= 3 * std::min(size.width, size.depth);
  const bool told = std::ranges::any_of(said_of(item), [&](const Relation* r) {
    return r->type == RelationType::kUnderWindow && std::ranges::find(r->targets, self.id) != r->targets.end();
  });
  if (!told || !is_long || self.thin || self.entry->back_to_wall || is_dined_at(item)) return;
  const Side side = self.has_front && self.is(Trait::kOpenToRoom) && size.width > size.depth ? Side::kBack : Side::kLong;
  Formula f;
  for (const RoomWall& wall : model_.walls) {
    const std::uint64_t along = states_with_side_to(self, wall, side);
    if (!along) continue;
    Case& c = f.add().when(item, along);
    if (wall.straight) {
      const Linear off = gap_towards(item, place_of(model_, wall), {wall.normal(), wall.inward});
      c.require(Linear(kMostUnderWindow) - off).wish(off, kBackToWall);
    } else {
      require_near_slanted_wall(c, model_, item, wall, kMostUnderWindow);
    }
  }
  if (!f.cases.empty()) habit("along its window", item, kAlongWindow, std::move(f));
}

// Where one pays, and what comes and goes with people (a bicycle), is by the door.
void Habits::stand_near_door(ItemId item) {
  constexpr Mm kNearDoor = 1500;  // nearer it would be in the way
  constexpr int kByDoor = 80;     // points a metre
  const auto is_such = [&](const std::string& kind) { return model_.is_a(item, kind); };
  if (placed_by_relation(item) || std::ranges::none_of(Groups::builtin().by_door, is_such)) return;
  Formula f;
  std::vector<ItemId> doors;
  for (const ItemId door : model_.items.ids()) {
    if (!model_.items[door].is_opening() || model_.items[door].opening->type != OpeningType::kDoor) continue;
    doors.push_back(door);
    Case& c = f.add();
    for (const int axis : {0, 1}) {
      for (const int sign : {1, -1}) c.require(Linear(2 * kNearDoor) - sign * (mid2(item, axis) - mid2(door, axis)), 2);
    }
  }
  if (!doors.empty()) habit("by the door", item, kByDoor, std::move(f));
}

// The low table of those who wait, where no sofa is there, is before the middle of its share of the seats.
bool Habits::stand_before_waiting(ItemId item) {
  constexpr Mm kOff = 500;
  constexpr std::size_t kFewest = 3;
  const Item& self = model_.items[item];
  if (!self.is(Trait::kCoffeeTable) || self.mount != Mount::kFloor || placed_by_relation(item)) return false;
  std::vector<ItemId> seats;
  int tables = 0;
  for (const ItemId other : model_.items.ids()) {
    const Item& ref = model_.items[other];
    if (ref.is_opening() || ref.mount != Mount::kFloor) continue;
    if (ref.is(Trait::kCenterPiece)) return false;
    if (ref.entry == self.entry) ++tables;
    const bool sits = (ref.is(Trait::kSeat) || ref.is(Trait::kEasySeat)) && ref.has_front;
    const bool at_work = std::ranges::any_of(said_of(other), [](const Relation* r) { return r->type != RelationType::kAgainstWall; });
    if (sits && !at_work) seats.push_back(other);
  }
  if (seats.size() < kFewest) return false;
  const auto rank = static_cast<std::size_t>(rank_of(item)), n = static_cast<std::size_t>(tables);
  if (n > seats.size()) return false;
  const std::vector<ItemId> share(seats.begin() + static_cast<std::ptrdiff_t>(rank * seats.size() / n),
                                  seats.begin() + static_cast<std::ptrdiff_t>((rank + 1) * seats.size() / n));
  const ItemId seat = share[share.size() / 2];
  Formula f;
  for_each_turn(model_.items[seat], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(model_.items[seat], Side::kFront, turn);
    Case& c = f.add().when(seat, states).when(item, states_with_width_along(self, across(front)));
    c.wish(gap_towards(item, seat, front) - Linear(kOff), kGuestsTable);
    Linear off = static_cast<std::int32_t>(share.size()) * mid2(item, across(front));
    for (const ItemId other : share) off = off - mid2(other, across(front));
    c.wish(std::move(off), kGuestsTable, 2 * static_cast<int>(share.size()));
  });
  habit("before those who wait", item, kGuestsTable, std::move(f), share);
  return true;
}

}  // namespace layoutbox::placement
