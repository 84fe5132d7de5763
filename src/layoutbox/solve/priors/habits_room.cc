// Habits towards the room: backs to walls, the middle, light, rugs; doors and windows nobody placed.
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kRugBeyondFoot = 500;
constexpr Mm kNearWall = 400;
constexpr int kOddTurn = 120;  // points
const std::vector<std::string> kOnRugs{"coffee_table", "dining_table", "bed", "crib", "table", "sofa", "desk"};

}  // namespace

void Habits::back_to_wall(int item, int weight) {
  Formula f;
  const bool heart = model_.items[item].is(Trait::kCenterPiece);
  for (const RoomWall& wall : model_.walls) {
    const std::size_t known = f.cases.size();
    add_against(f, model_, item, states_with_back_to(model_.items[item], wall), wall, 20, true);
    for (std::size_t i = known; heart && i < f.cases.size(); ++i) wish_middle_of_wall(f.cases[i], model_, item, wall, kMiddle);
  }
  habit("back to wall", item, weight, std::move(f));
}

// Small things at walls, best in corners; a plant in the middle of a room is in the way.
void Habits::stand_at_wall(int item) {
  Formula f;
  for (std::size_t i = 0; i < model_.walls.size(); ++i) {
    const RoomWall &a = model_.walls[i], &b = model_.walls[(i + 1) % model_.walls.size()];
    if (!a.straight) {
      require_near_slanted_wall(f.add(), model_, item, a, 100);
      f.cases.back().price = 60;
      continue;
    }
    require_near_wall(f.add(), model_, item, a, 100);
    f.cases.back().price = 60;
    if (!b.straight || a.along == b.along) continue;
    Case& corner = f.add();
    require_near_wall(corner, model_, item, a, 150);
    require_near_wall(corner, model_, item, b, 150);
  }
  habit("at a wall", item, kAtWall, std::move(f));
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

// A bar or a reception desk turns its front to where the guests are.
void Habits::open_to_room(int item) {
  if (!model_.items[item].has_front) return;
  Formula f;
  for_each_turn(model_.items[item], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction d = side_direction(model_.items[item], Side::kFront, turn);
    f.add().when(item, states).require(d.sign * (room_mid2(model_, d.axis) - mid2(item, d.axis)));
  });
  habit("open to the room", item, kAtWall, std::move(f));
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
  std::vector<int> over = items_of_kinds(kOnRugs, item);
  const auto beds = std::count_if(over.begin(), over.end(), [&](int i) { return model_.items[i].is(Trait::kBed); });
  std::erase_if(over, [&](int i) {
    if (model_.items[i].is(Trait::kBed)) return beds > 1 || !model_.items[i].is(Trait::kCenterPiece);
    return model_.items[i].is(Trait::kTable) && !model_.items[i].is(Trait::kDesk) && model_.items[i].entry->back_to_wall;
  });
  Formula f;
  if (!over.empty() && model_.items[over[rank_of(item) % static_cast<int>(over.size())]].is(Trait::kBed)) {
    lie_at_foot(item, over[rank_of(item) % static_cast<int>(over.size())]);
    return;
  }
  Case& c = f.add();
  std::vector<int> hosts;
  if (!over.empty()) hosts.push_back(over[rank_of(item) % static_cast<int>(over.size())]);
  for (int axis = 0; axis < 2; ++axis) c.wish(mid2(item, axis) - (hosts.empty() ? room_mid2(model_, axis) : mid2(hosts[0], axis)), kRug, 2);
  habit("rug", item, kRug, std::move(f), hosts);
}

void Habits::lie_at_foot(int item, int bed) {
  Formula f;
  for_each_turn(model_.items[bed], [&](int turn, std::uint64_t states) {
    const Direction foot = side_direction(model_.items[bed], Side::kFront, turn);
    Case& c = f.add().when(bed, states);
    if (const std::uint64_t along = model_.items[item].states_at(turn)) c.when(item, along);
    c.wish(mid2(item, across(foot)) - mid2(bed, across(foot)), kRug, 2);
    c.wish(reach(item, foot) - reach(bed, foot) - Linear(kRugBeyondFoot), kRug);
  });
  habit("rug", item, kRug, std::move(f), {bed});
}

// Doors near a corner, the front wall first; windows in the middle of a wall that the picture shows.
void Habits::open_well(int item) {
  const Opening& opening = *model_.items[item].opening;
  if (opening.offset) return;
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
}

}  // namespace layoutbox::placement
