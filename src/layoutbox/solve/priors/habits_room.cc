// Habits towards the room: its middle, its light, who comes in; doors and windows nobody placed.
#include "layoutbox/solve/objective/cost.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kNearWall = 400;
constexpr int kOddTurn = 120;   // points
constexpr int kWallFree = 400;  // points a metre

}  // namespace

// Do words say no more of where it stands than that it is across from a door, or so far from something?
bool Habits::only_told_across(ItemId item) const {
  return std::ranges::none_of(model_.scene->relations, [&](const Relation& r) {
    const bool leaves = traits_of(r.type).keeps_off || r.type == RelationType::kFacing;
    return !leaves && std::ranges::find(r.targets, model_.items[item].id) != r.targets.end();
  });
}

// "A counter at the back left", "a till just inside the door": which says nothing of how far off a wall it is.
bool Habits::only_told_part_or_opening(ItemId item) const {
  return std::ranges::all_of(model_.scene->relations, [&](const Relation& r) {
    if (std::ranges::find(r.targets, model_.items[item].id) == r.targets.end()) return true;
    const bool opening = !r.references.empty() && std::ranges::all_of(r.references, [&](const std::string& id) {
      const ItemId other = model_.find_item(id);
      return other.exists() && model_.items[other].is_opening();
    });
    return r.type == RelationType::kInRegion || r.type == RelationType::kFacing || (traits_of(r.type).close_by && opening);
  });
}

// A desk that somebody is told to sit behind, or a counter that somebody serves over, stands off the wall, its front to the room.
bool Habits::leave_room_behind(ItemId item) {
  constexpr Mm kForSitter = 1100, kForServer = 590;
  constexpr int kBehind = 400;  // points a metre
  const Item& self = model_.items[item];
  const std::vector<Side> used = used_sides(self);
  const bool open = self.is(Trait::kOpenToRoom) && std::ranges::find(used, Side::kBack) != used.end();
  const bool told = used_side(self) == Side::kFront && looking_side(model_, item) == Side::kFront;
  const bool served_over = open && self.is(Trait::kCounter) && used.size() < 4 && !is_window_bar(item);  // no island
  if ((!self.is(Trait::kDeskLike) || (!open && !told)) && !served_over) return false;
  face_the_class(item);
  const bool placed = placed_besides_facing(item) && !only_told_across(item);
  if (placed && !(open && only_told_part_or_opening(item))) return true;
  Formula f;
  for (const RoomWall& wall : model_.walls) {
    if (!wall.straight) continue;
    Case& c = f.add().when(item, states_with_back_to(model_.items[item], wall));
    c.wish(gap_towards(item, place_of(model_, wall), {wall.normal(), wall.inward}) -
               Linear(served_over ? kForServer + depth_behind_server(item) : kForSitter),
           kBehind);
    if (!placed) wish_middle_of_wall(c, model_, item, wall, kMiddle);
  }
  if (!f.cases.empty()) habit("room behind", item, kBehind, std::move(f));
  return true;
}

// Something else is told to be in the middle.
bool Habits::middle_is_taken(ItemId item) const {
  for (const ItemId index : model_.items.ids()) {
    const Item& other = model_.items[index];
    if (index == item || other.is_opening() || other.mount != Mount::kFloor || other.thin) continue;
    if (std::ranges::any_of(model_.scene->relations, [&](const Relation& r) {
          return r.type == RelationType::kCenterOfRoom && std::ranges::find(r.targets, other.id) != r.targets.end();
        }))
      return true;
  }
  return false;
}

// Seats that words put there, or that usually stand there and are nowhere else.
bool Habits::has_sitters(ItemId item) const { return sitters_of(item) > 0; }

// The only one who sits there works there, and has the wall or the window before him.
bool Habits::is_sat_at_alone(ItemId item) const {
  constexpr std::int64_t kForOne = 1'600'000;  // mm²
  return model_.items[item].is(Trait::kTable) && area_of(model_.items[item]) <= kForOne && sitters_of(item) == 1;
}

int Habits::sitters_of(ItemId item) const {
  int sitters = 0;
  for (const ItemId seat : model_.items.ids()) {
    if (!model_.items[seat].is(Trait::kTableSeat) || !takes_seat(item, seat)) continue;
    const std::vector<std::string>& at = model_.items[seat].entry->beside;
    const bool usual = std::ranges::any_of(at, [&](const std::string& kind) { return model_.is_a(item, kind); });
    sitters += related(seat, item) || (usual && !placed_besides_facing(seat));
  }
  return sitters;
}

void Habits::stand_in_middle(ItemId item) {
  Formula f;
  Case& c = f.add();
  for (int axis = 0; axis < 2; ++axis) c.wish(mid2(item, axis) - room_mid2(model_, axis), kMiddle, 2);
  habit("in the middle", item, kMiddle, std::move(f));
}

// What has no front is turned with a slanted wall only where it is near one.
void Habits::lie_straight(ItemId item) {
  const Item& self = model_.items[item];
  if (self.has_front || self.odd_states == 0 || quarter_states(self) == 0) return;
  Formula f;
  f.add().when(item, quarter_states(self));
  for (const RoomWall& wall : model_.walls) {
    if (wall.straight) continue;
    const std::uint64_t states = states_at_angle(self, wall.angle, 90);
    if (states) require_near_slanted_wall(f.add().when(item, states), model_, item, wall, kNearWall);
  }
  f.add().price = kOddTurn;
  habit("straight", item, kAtWall, std::move(f));
}

// A bar or a reception desk turns its front to where the guests are; a face, a loudspeaker or a drum kit to all.
void Habits::open_to_room(ItemId item, int weight) {
  if (!model_.items[item].has_front) return;
  Formula f;
  for_each_turn(model_.items[item], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction d = side_direction(model_.items[item], Side::kFront, turn);
    f.add().when(item, states).require(d.sign * (room_mid2(model_, d.axis) - mid2(item, d.axis)));
  });
  habit("open to the room", item, weight, std::move(f));
}

// Behind a bar is who serves: the guests' tables stand before it.
void Habits::keep_before_counter(ItemId item) {
  constexpr Mm kBefore = 800, kStools = 700;  // a chair and a way; the stools at the bar besides
  constexpr int kGuests = 300;                // points a metre
  const Item& self = model_.items[item];
  if (!self.is(Trait::kTable) || self.is(Trait::kDesk) || self.is(Trait::kCounter)) return;
  for (const ItemId host : model_.items.ids()) {
    const Item& bar = model_.items[host];
    const bool bar_or_desk = (bar.is(Trait::kCounter) && bar.is(Trait::kOpenToRoom) && bar.has_front) || is_served_over(host);
    if (is_window_bar(host)) continue;
    if (host == item || !bar_or_desk || related(item, host)) continue;
    const Mm before = kBefore + (has_sitters(host) ? kStools : 0);
    Formula f;
    for_each_turn(bar, [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      f.add().when(host, states).require(gap_towards(item, host, side_direction(bar, Side::kFront, turn)) - Linear(before));
    });
    habit("before the bar", item, kGuests, std::move(f));
  }
}

void Habits::near_light(ItemId item) {
  constexpr int kAtFaced = 200;  // "facing the window": at it
  Formula f;
  std::vector<ItemId> windows, faced;
  for (const ItemId i : model_.items.ids()) {
    const Item& other = model_.items[i];
    if (!other.is_opening() || other.opening->type != OpeningType::kWindow) continue;
    windows.push_back(i);
    if (related_as_target(item, windows.back(), RelationType::kFacing)) faced.push_back(windows.back());
  }
  const int weight = faced.empty() ? kLight : kAtFaced;
  if (!faced.empty()) windows = faced;
  for (const ItemId window : windows) {
    Case& c = f.add();
    for (int axis = 0; axis < 2; ++axis) c.wish(mid2(item, axis) - mid2(window, axis), weight, 2);
  }
  if (!windows.empty()) habit("near light", item, weight, std::move(f));
}

// A window that nobody placed is not in the wall that something is said to hang on, nor beside the board that all look at.
void Habits::leave_wall_free(ItemId item) {
  const ItemId board = board_of_room();
  Formula f;
  bool any_taken = board.exists();
  for (const RoomWall& wall : model_.walls) {
    const bool taken = std::ranges::any_of(model_.scene->relations, [&](const Relation& r) {
      return r.type == RelationType::kOnWall && std::ranges::find(r.references, wall.id) != r.references.end();
    });
    any_taken |= taken;
    if (!wall.straight || taken) continue;
    Case& c = f.add().when(item, model_.items[item].states_at(wall.turn));
    if (board.exists()) c.when(board, model_.items[board].all_states & ~states_facing(board, wall));
  }
  if (any_taken && !f.cases.empty()) habit("leaves the wall free", item, kWallFree, std::move(f));
}

// How many windows share the wall that the opening is said to be in, and how many of them come before it; a window of no said wall is
// alone, a door of none has none beside it.
std::pair<int, int> Habits::window_in_wall(ItemId item) const {
  const Opening& opening = *model_.items[item].opening;
  const bool window = opening.type == OpeningType::kWindow;
  if (opening.wall.empty()) return {0, window ? 1 : 0};
  int rank = 0, count = 0;
  for (const ItemId i : model_.items.ids()) {
    const Item& other = model_.items[i];
    if (!other.is_opening() || other.opening->type != OpeningType::kWindow || other.opening->wall != opening.wall) continue;
    rank += i < item, ++count;
  }
  return {rank, count};
}

// Doors near a corner, the front wall first, or between two windows; windows in the middle of a wall that the picture shows, several
// spread over it.
void Habits::open_well(ItemId item) {
  const Opening& opening = *model_.items[item].opening;
  if (opening.offset) return;
  if (opening.type == OpeningType::kWindow && opening.wall.empty()) leave_wall_free(item);
  Formula f;
  for (const RoomWall& wall : model_.walls) {
    if (!wall.straight || (!opening.wall.empty() && wall.id != opening.wall)) continue;
    const std::uint64_t states = model_.items[item].states_at(wall.turn);
    if (opening.type == OpeningType::kWindow) {
      const auto [rank, count] = window_in_wall(item);
      const std::int64_t middle = 2 * std::int64_t{wall.lo} + (2 * rank + 1) * (std::int64_t{wall.hi} - wall.lo) / count;
      Case& c = f.add().when(item, states).wish(mid2(item, wall.along) - Linear(middle), kOpeningPlace, 2);
      c.price = std::max(0, 3000 - (wall.hi - wall.lo)) / 40 + (wall.turn == 180 || wall.turn == 270 ? 40 : 0);
      continue;
    }
    if (const auto [rank, count] = window_in_wall(item); count > 0 && count % 2 == 0) {  // "a window on each side of it"
      f.add().when(item, states).wish(mid2(item, wall.along) - Linear(std::int64_t{wall.lo} + wall.hi), kOpeningPlace, 2);
      continue;
    }
    if (2 * opening.width > wall.hi - wall.lo) {  // a gate
      Case& c = f.add().when(item, states);
      c.wish(mid2(item, wall.along) - Linear(std::int64_t{wall.lo} + wall.hi), kOpeningPlace, 2).price = wall.turn == 180 ? 0 : 30;
      continue;
    }
    for (const bool low : {true, false}) {
      Case& c = f.add().when(item, states);
      c.wish(low ? lo(item, wall.along) - Linear(wall.lo + 100) : Linear(wall.hi - 100) - hi(item, wall.along), kOpeningPlace);
      c.price = wall.turn == 180 ? 0 : wall.turn == 270 ? 10 : 30;
    }
  }
  habit("place", item, kOpeningPlace, std::move(f));
  if (opening.type != OpeningType::kDoor) return;
  enter_behind_class(item);
  swing_clear_of_doors(item);
}

// No two leaves meet.
void Habits::swing_clear_of_doors(ItemId item) {
  constexpr int kLeavesMeet = 300;
  constexpr Mm kWidestLeaf = 1000;
  for (const ItemId other : model_.items.ids()) {
    const Item& door = model_.items[other];
    if (other == item || !door.is_opening() || door.opening->type != OpeningType::kDoor) continue;
    const Mm leaf = std::min(std::max(door.opening->width, model_.items[item].opening->width), kWidestLeaf);
    Formula f;
    for (const int axis : {0, 1}) {
      for (const int sign : {1, -1}) f.add().require(gap_towards(item, other, {axis, sign}) - Linear(leaf));
    }
    habit("swings clear of doors", item, kLeavesMeet, std::move(f), {other});
  }
}

}  // namespace layoutbox::placement
