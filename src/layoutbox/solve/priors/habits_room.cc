// Habits towards the room: backs to walls, the middle, light, rugs; doors and windows nobody placed.
#include "layoutbox/catalog/groups.h"
#include "layoutbox/solve/objective/cost.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kRugBeyondFoot = 500;
constexpr Mm kNearWall = 400;
constexpr int kOddTurn = 120;                                          // points
constexpr int kBedToCorner = 80, kToCorner = 20, kTallToCorner = 160;  // points for not being in a corner
constexpr Mm kFlushInCorner = 20;
constexpr int kWallFree = 400;  // points a metre
constexpr int kFloats = 250;    // points for a sofa that stands off the walls of a large room

// A stage, a dais: low, with a top that much stands on.
bool is_platform(const Item& item) {
  constexpr Mm kLow = 650;
  constexpr std::int64_t kLarge = 2'500'000;  // mm²
  return item.entry->top_carries && item.states[0].size.height <= kLow && area_of(item) >= kLarge && !item.is(Trait::kBed);
}

}  // namespace

void Habits::back_to_wall(int item, int weight) {
  Formula f;
  int alike = 0;  // that nobody placed
  for (std::size_t i = 0; i < model_.items.size(); ++i)
    alike += model_.items[i].entry == model_.items[item].entry && !placed_by_relation_besides_walls(static_cast<int>(i));
  const bool narrow_bed = is_narrow_bed(item);
  const bool heart =
      (model_.items[item].is(Trait::kCenterPiece) || is_looked_at(item) || is_platform(model_.items[item])) && alike <= 1 && !narrow_bed;
  // In a corner it gives up the free floor at one side, and keeps that at the other.
  const std::map<Side, Mm>& wanted = model_.items[item].entry->clearance;
  const int for_side = wanted.contains(Side::kLeft) && wanted.contains(Side::kRight) ? kCostWeights.wanted : 0;
  const int to_corner = narrow_bed ? kBedToCorner + for_side : ends_run(item) ? kTallToCorner : keeps_to_corner(item) ? kToCorner : 0;
  for (const RoomWall& wall : model_.walls) {
    const std::size_t known = f.cases.size();
    add_against(f, model_, item, states_with_back_to(model_.items[item], wall), wall, 20, true);
    for (std::size_t i = known; heart && i < f.cases.size(); ++i) wish_middle_of_wall(f.cases[i], model_, item, wall, kMiddle);
    if (to_corner == 0 || !wall.straight || f.cases.size() == known) continue;
    const Case anywhere = f.cases[known];
    f.cases[known].price += to_corner;
    Case low = anywhere, high = anywhere;
    f.cases.push_back(low.require(Linear(std::int64_t{wall.lo} + kFlushInCorner) - lo(item, wall.along)));
    f.cases.push_back(high.require(hi(item, wall.along) - Linear(std::int64_t{wall.hi} - kFlushInCorner)));
  }
  if (model_.items[item].is(Trait::kCenterPiece) && !model_.items[item].is(Trait::kBed)) back_to_divider(f, item);
  if (may_float(item)) f.add().price = kFloats;
  stand_in_its_corner(item);
  habit("back to wall", item, weight, std::move(f));
}

// … or to what parts its group from another.
void Habits::back_to_divider(Formula& f, int item) {
  constexpr Mm kOff = 50;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const int divider = static_cast<int>(i);
    if (model_.items[i].is_opening() || divided_by(divider) == nullptr) continue;
    for_each_turn(model_.items[item], [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      const Direction front = side_direction(model_.items[item], Side::kFront, turn);
      Case& c = f.add().when(item, states).require(gap_towards(item, divider, front));
      c.wish(gap_towards(item, divider, front) - Linear(kOff), kBackToWall)
          .wish(mid2(item, across(front)) - mid2(divider, across(front)), kMiddle, 2);
    });
  }
}

// In a large room a sofa comes off its wall rather than look at a screen from afar.
bool Habits::may_float(int item) const {
  constexpr Mm kLarge = 5600;
  const Item& self = model_.items[item];
  return self.is(Trait::kCenterPiece) && !self.is(Trait::kBed) && std::min(model_.room.extent(0), model_.room.extent(1)) >= kLarge &&
         !placed_by_relation_besides_walls(item) && std::ranges::any_of(model_.items, [&](const Item& other) {
           return other.is(Trait::kScreen) && other.is(Trait::kElseOnWall) &&
                  std::ranges::any_of(self.entry->faces,
                                      [&](const std::string& kind) { return model_.catalog->is_a(other.entry->id, kind); });
         });
}

// A bed for one has a long side at the second wall too, but where one is cared for from both sides or more than two stand there.
bool Habits::is_narrow_bed(int item) const {
  constexpr Mm kForOne = 1200, kForCare = 700;
  const Item& self = model_.items[item];
  const auto is_wide = [&](Side side) {
    const auto wanted = self.entry->clearance.find(side);
    return wanted != self.entry->clearance.end() && wanted->second > kForCare;
  };
  const auto alike = std::ranges::count_if(model_.items, [&](const Item& other) { return other.entry == self.entry; });
  return self.is(Trait::kBed) && self.states[0].size.width <= kForOne && self.states[0].size.depth > self.states[0].size.width &&
         alike <= 2 && !(alike == 2 && has_bedside(item)) && !(is_wide(Side::kLeft) && is_wide(Side::kRight));
}

// Twin beds with nightstands stand beside each other as a wide one would, those of children in a corner each.
bool Habits::has_bedside(int bed) const {
  return std::ranges::any_of(model_.items, [&](const Item& other) {
    return !other.is_opening() && other.mount == Mount::kFloor && other.entry->back_to_wall &&
           area_of(other) < area_of(model_.items[bed]) / 4 &&
           std::ranges::any_of(other.entry->beside, [&](const std::string& kind) { return model_.is_a(bed, kind); });
  });
}

// A fridge in the middle of a kitchen's run would part the worktop.
bool Habits::ends_run(int item) const {
  constexpr Mm kTall = 1200;
  const Item& self = model_.items[item];
  if (!self.is(Trait::kKitchenRun) || self.states.empty() || self.states[0].size.height < kTall) return false;
  const bool placed = std::ranges::any_of(model_.scene->relations, [&](const Relation& r) {
    const bool where = r.type != RelationType::kInRegion && r.type != RelationType::kAgainstWall && r.type != RelationType::kCorner;
    return where && std::ranges::find(r.targets, self.id) != r.targets.end();
  });
  if (placed) return false;
  return std::ranges::any_of(model_.items, [&](const Item& other) {
    return &other != &self && other.is(Trait::kKitchenRun) && other.mount == Mount::kFloor && other.states[0].size.height < kTall;
  });
}

// Cupboards, tubs and machines that nothing looks at and that stand by nothing leave the middle of the wall free.
bool Habits::keeps_to_corner(int item) const {
  const Item& self = model_.items[item];
  if (self.is(Trait::kCenterPiece) || self.is(Trait::kTable) || self.is(Trait::kDeskLike) || self.is(Trait::kSeat)) return false;
  if (is_platform(self)) return false;
  if (self.is(Trait::kOpenToRoom) || placed_by_relation_besides_walls(item) || !items_of_kinds(self.entry->beside, item).empty())
    return false;
  return !is_faced_by_kind(item);
}

// What is built in an L stands in a corner with both its backs to walls: the open part is at the front and the other side.
void Habits::stand_in_its_corner(int item) {
  const Item& self = model_.items[item];
  const Size& size = self.states[0].size;
  const auto is_open = [&](const Space& s) {
    return !s.carries && s.max[2] >= size.height - 1 && s.min[0] <= -size.width / 2 + 1 && s.min[1] <= -size.depth / 2 + 1 &&
           s.min[2] <= 0 && s.max[0] < size.width / 2;
  };
  if (std::ranges::none_of(spaces_of(*self.object, *self.entry, size), is_open) || !self.has_front) return;
  Formula f;
  for_each_turn(self, [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction right = side_direction(self, Side::kRight, turn);
    const Mm edge = right.sign > 0 ? model_.room.hi[right.axis] : model_.room.lo[right.axis];
    f.add()
        .when(item, states)
        .wish(Linear(std::int64_t{right.sign} * edge) - right.sign * (right.sign > 0 ? hi(item, right.axis) : lo(item, right.axis)),
              kBackToWall / 2);
  });
  habit("in its corner", item, kBackToWall / 2, std::move(f));
}

// A fireplace, a piano; no desk, at which one sits.
bool Habits::is_looked_at(int item) const {
  const Item& self = model_.items[item];
  return is_faced_by_kind(item) && !self.is(Trait::kTable) && !self.is(Trait::kDeskLike) && !self.is(Trait::kCounter);
}

// Is it what something there usually faces?
bool Habits::is_faced_by_kind(int item) const {
  const Item& self = model_.items[item];
  return std::ranges::any_of(model_.items, [&](const Item& other) {
    return other.entry != nullptr && other.entry != self.entry &&
           std::ranges::any_of(other.entry->faces, [&](const std::string& kind) { return model_.is_a(item, kind); });
  });
}

// Do words say no more of where it stands than that it is across from a door, or so far from something?
bool Habits::only_told_across(int item) const {
  using R = RelationType;
  return std::ranges::none_of(model_.scene->relations, [&](const Relation& r) {
    const bool leaves = r.type == R::kOpposite || r.type == R::kDistance || r.type == R::kFarFromDoor || r.type == R::kFacing;
    return !leaves && std::ranges::find(r.targets, model_.items[item].id) != r.targets.end();
  });
}

// A desk that somebody is told to sit behind, or a counter that somebody serves over, stands off the wall, its front to the room.
bool Habits::leave_room_behind(int item) {
  constexpr Mm kForSitter = 1100, kForServer = 590;
  constexpr int kBehind = 400;  // points a metre
  const Item& self = model_.items[item];
  const std::vector<Side> used = used_sides(self);
  const bool open = self.is(Trait::kOpenToRoom) && std::ranges::find(used, Side::kBack) != used.end();
  const bool told = used_side(self) == Side::kFront && looking_side(model_, item) == Side::kFront;
  const bool served_over = open && self.is(Trait::kCounter) && used.size() < 4;  // no island
  if ((!self.is(Trait::kDeskLike) || (!open && !told)) && !served_over) return false;
  face_the_class(item);
  if (placed_besides_facing(item) && !only_told_across(item)) return true;
  Formula f;
  for (const RoomWall& wall : model_.walls) {
    if (!wall.straight) continue;
    Case& c = f.add().when(item, states_with_back_to(model_.items[item], wall));
    c.wish(gap_towards(item, place_of(model_, wall), {wall.normal(), wall.inward}) -
               Linear(served_over ? kForServer + depth_behind_server(item) : kForSitter),
           kBehind);
    wish_middle_of_wall(c, model_, item, wall, kMiddle);
  }
  if (!f.cases.empty()) habit("room behind", item, kBehind, std::move(f));
  return true;
}

// Small things at walls, best in corners; a plant in the middle of a room is in the way. What is long stands along the wall.
void Habits::stand_at_wall(int item) {
  const Size& size = model_.items[item].states[0].size;
  const bool is_long = 2 * std::max(size.width, size.depth) >= 3 * std::min(size.width, size.depth);
  const auto near_wall = [&](Case& c, const RoomWall& wall, Mm most) {
    const Side side = model_.items[item].has_front ? Side::kBack : Side::kLong;
    const std::uint64_t along = is_long ? states_with_side_to(model_.items[item], wall, side) : 0;
    if (along) c.when(item, along);
    require_near_wall(c, model_, item, wall, most);
  };
  Formula f;
  for (std::size_t i = 0; i < model_.walls.size(); ++i) {
    const RoomWall &a = model_.walls[i], &b = model_.walls[(i + 1) % model_.walls.size()];
    if (!a.straight) {
      require_near_slanted_wall(f.add(), model_, item, a, 100);
      f.cases.back().price = 60;
      continue;
    }
    near_wall(f.add(), a, 100);
    f.cases.back().price = 60;
    if (!b.straight || a.along == b.along) continue;
    for (const bool first : {true, false}) {
      Case& corner = f.add();
      near_wall(corner, first ? a : b, 150);
      require_near_wall(corner, model_, item, first ? b : a, 150);
      if (!is_long) break;
    }
  }
  habit("at a wall", item, kAtWall, std::move(f));
}

// Something else is told to be in the middle.
bool Habits::middle_is_taken(int item) const {
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const Item& other = model_.items[i];
    const int index = static_cast<int>(i);
    if (index == item || other.is_opening() || other.mount != Mount::kFloor || other.thin) continue;
    if (std::ranges::any_of(model_.scene->relations, [&](const Relation& r) {
          return r.type == RelationType::kCenterOfRoom && std::ranges::find(r.targets, other.id) != r.targets.end();
        }))
      return true;
  }
  return false;
}

// Seats that words put there, or that usually stand there and are nowhere else.
bool Habits::has_sitters(int item) const {
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const int seat = static_cast<int>(i);
    if (!model_.items[i].is(Trait::kTableSeat) || !takes_seat(item, seat)) continue;
    const std::vector<std::string>& at = model_.items[i].entry->beside;
    const bool usual = std::ranges::any_of(at, [&](const std::string& kind) { return model_.is_a(item, kind); });
    if (related(seat, item) || (usual && !placed_besides_facing(seat))) return true;
  }
  return false;
}

void Habits::stand_in_middle(int item) {
  Formula f;
  Case& c = f.add();
  for (int axis = 0; axis < 2; ++axis) c.wish(mid2(item, axis) - room_mid2(model_, axis), kMiddle, 2);
  habit("in the middle", item, kMiddle, std::move(f));
}

// What has no front is turned with a slanted wall only where it is near one.
void Habits::lie_straight(int item) {
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
void Habits::open_to_room(int item, int weight) {
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
void Habits::keep_before_counter(int item) {
  constexpr Mm kBefore = 700;
  constexpr int kGuests = 300;  // points a metre
  const Item& self = model_.items[item];
  if (!self.is(Trait::kTable) || self.is(Trait::kDesk) || self.is(Trait::kCounter)) return;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const Item& bar = model_.items[i];
    const int host = static_cast<int>(i);
    const bool bar_or_desk = (bar.is(Trait::kCounter) && bar.is(Trait::kOpenToRoom) && bar.has_front) || is_served_over(host);
    if (host == item || !bar_or_desk || related(item, host)) continue;
    Formula f;
    for_each_turn(bar, [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      f.add().when(host, states).require(gap_towards(item, host, side_direction(bar, Side::kFront, turn)) - Linear(kBefore));
    });
    habit("before the bar", item, kGuests, std::move(f));
  }
}

void Habits::near_light(int item) {
  Formula f;
  std::vector<int> windows;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const Item& other = model_.items[i];
    if (!other.is_opening() || other.opening->type != OpeningType::kWindow) continue;
    Case& c = f.add();
    windows.push_back(static_cast<int>(i));
    for (int axis = 0; axis < 2; ++axis) c.wish(mid2(item, axis) - mid2(windows.back(), axis), kLight, 2);
  }
  if (!windows.empty()) habit("near light", item, kLight, std::move(f));
}

// A rug lies under what stands in the middle of things, else in the middle of the room; a bed would hide it, so there it shows at
// both sides and beyond the foot.
void Habits::lie_under(int item) {
  if (const std::vector<int> by = items_of_kinds(model_.items[item].entry->beside, item); !by.empty()) {
    lie_before_use(item, by[static_cast<std::size_t>(rank_of(item)) % by.size()]);
    return;
  }
  std::vector<int> over =
      items_of_kinds(Groups::usual_at(Groups::builtin().lies, *model_.catalog, *model_.items[item].entry, Mount::kFloor), item);
  const auto beds = std::count_if(over.begin(), over.end(), [&](int i) { return model_.items[i].is(Trait::kBed); });
  std::erase_if(over, [&](int i) {
    if (model_.items[i].is(Trait::kBed)) return beds > 1 || !model_.items[i].is(Trait::kCenterPiece);
    return model_.items[i].is(Trait::kTable) && model_.items[i].entry->back_to_wall;
  });
  Formula f;
  if (!over.empty() && model_.items[over[rank_of(item) % static_cast<int>(over.size())]].is(Trait::kBed)) {
    lie_at_foot(item, over[rank_of(item) % static_cast<int>(over.size())]);
    return;
  }
  if (!over.empty() && model_.items[over[rank_of(item) % static_cast<int>(over.size())]].is(Trait::kCenterPiece)) {
    lie_before(item, over[rank_of(item) % static_cast<int>(over.size())]);
    return;
  }
  Case& c = f.add();
  std::vector<int> hosts;
  if (!over.empty()) hosts.push_back(over[rank_of(item) % static_cast<int>(over.size())]);
  for (int axis = 0; axis < 2; ++axis) c.wish(mid2(item, axis) - (hosts.empty() ? room_mid2(model_, axis) : mid2(hosts[0], axis)), kRug, 2);
  habit("rug", item, kRug, std::move(f), hosts);
}

// A runner lies along a narrow room: down the aisle of a galley, along a hall.
void Habits::lie_lengthwise(int item) {
  const Item& self = model_.items[item];
  const Size& size = self.states[0].size;
  const Mm across = model_.room.extent(0), deep = model_.room.extent(1);
  const bool is_runner = size.width >= 2 * size.depth && std::max(across, deep) * 4 >= std::min(across, deep) * 5;
  const bool free = std::ranges::all_of(model_.scene->relations, [&](const Relation& r) {
    return r.type == RelationType::kCenterOfRoom || std::ranges::find(r.targets, self.id) == r.targets.end();
  });
  if (!is_runner || !free) return;
  Formula f;
  f.add().when(item, states_with_width_along(self, across > deep ? 0 : 1));
  habit("lengthwise", item, kRug, std::move(f));
}

void Habits::lie_at_foot(int item, int bed) {
  // Most of it shows.
  const Mm beyond = std::max(kRugBeyondFoot, model_.items[item].states[0].size.depth * 3 / 5);
  Formula f;
  for_each_turn(model_.items[bed], [&](int turn, std::uint64_t states) {
    const Direction foot = side_direction(model_.items[bed], Side::kFront, turn);
    Case& c = f.add().when(bed, states);
    if (const std::uint64_t along = model_.items[item].states_at(turn)) c.when(item, along);
    c.wish(mid2(item, across(foot)) - mid2(bed, across(foot)), kRug, 2);
    c.wish(reach(item, foot) - reach(bed, foot) - Linear(beyond), kRug);
  });
  habit("rug", item, kRug, std::move(f), {bed});
}

// Before a sofa without a table, its front legs on it.
void Habits::lie_before(int item, int sofa) {
  constexpr Mm kUnderFeet = 250;
  Formula f;
  for_each_turn(model_.items[sofa], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(model_.items[sofa], Side::kFront, turn);
    Case& c = f.add().when(sofa, states).when(item, states_with_width_along(model_.items[item], across(front)));
    c.wish(mid2(item, across(front)) - mid2(sofa, across(front)), kRug, 2);
    c.wish(gap_towards(item, sofa, front) + Linear(kUnderFeet), kRug);
  });
  habit("rug", item, kRug, std::move(f), {sofa});
}

// A mat lies where one steps out, or stands before the basin.
void Habits::lie_before_use(int item, int host) {
  constexpr Mm kOff = 80;
  const Item& ref = model_.items[host];
  const std::vector<Side> used = used_sides(ref);
  Formula f;
  for_each_turn(ref, [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    for (const Side side : used) {
      const Direction before = side_direction(ref, side, turn);
      Case& c = f.add().when(host, states).when(item, states_with_width_along(model_.items[item], across(before)));
      c.wish(mid2(item, across(before)) - mid2(host, across(before)), kRug, 2);
      c.wish(gap_towards(item, host, before) - Linear(kOff), kRug);
    }
  });
  if (!f.cases.empty()) habit("mat", item, kRug, std::move(f), {host});
}

// A window that nobody placed is not in the wall that the board is said to hang on.
void Habits::leave_wall_free(int item) {
  Formula f;
  bool any_taken = false;
  for (const RoomWall& wall : model_.walls) {
    const bool taken = std::ranges::any_of(model_.scene->relations, [&](const Relation& r) {
      return r.type == RelationType::kOnWall && std::ranges::find(r.references, wall.id) != r.references.end();
    });
    any_taken |= taken;
    if (wall.straight && !taken) f.add().when(item, model_.items[item].states_at(wall.turn));
  }
  if (any_taken && !f.cases.empty()) habit("leaves the wall free", item, kWallFree, std::move(f));
}

// Doors near a corner, the front wall first; windows in the middle of a wall that the picture shows.
void Habits::open_well(int item) {
  const Opening& opening = *model_.items[item].opening;
  if (opening.offset) return;
  if (opening.type == OpeningType::kWindow && opening.wall.empty()) leave_wall_free(item);
  Formula f;
  for (const RoomWall& wall : model_.walls) {
    if (!wall.straight || (!opening.wall.empty() && wall.id != opening.wall)) continue;
    const std::uint64_t states = model_.items[item].states_at(wall.turn);
    if (opening.type == OpeningType::kWindow) {
      Case& c = f.add().when(item, states).wish(mid2(item, wall.along) - Linear(std::int64_t{wall.lo} + wall.hi), kOpeningPlace, 2);
      c.price = std::max(0, 3000 - (wall.hi - wall.lo)) / 40 + (wall.turn == 180 || wall.turn == 270 ? 40 : 0);
      continue;
    }
    for (const bool low : {true, false}) {
      Case& c = f.add().when(item, states);
      c.wish(low ? lo(item, wall.along) - Linear(wall.lo + 100) : Linear(wall.hi - 100) - hi(item, wall.along), kOpeningPlace);
      c.price = wall.turn == 180 ? 0 : wall.turn == 270 ? 10 : 30;
    }
  }
  habit("place", item, kOpeningPlace, std::move(f));
  if (opening.type == OpeningType::kDoor) enter_behind_class(item);
}

}  // namespace layoutbox::placement
