// Habits towards walls: backs to them, in their corners, off them where that is better.
#include "layoutbox/catalog/measures.h"
#include "layoutbox/solve/objective/cost.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {
namespace {

constexpr int kBedToCorner = 150, kToCorner = 20, kTallToCorner = 160, kHighBedToCorner = 400;  // points for not being in a corner
constexpr Mm kFlushInCorner = 20;
constexpr int kFloats = 250;  // points for a sofa that stands off the walls of a large room

// A stage, a dais: low, with a top that much stands on.
bool is_platform(const Item& item) {
  constexpr Mm kLow = 650;
  constexpr std::int64_t kLarge = 2'500'000;  // mm²
  return item.entry->top_carries && item.states[0].size.height <= kLow && area_of(item) >= kLarge && !item.is(Trait::kBed);
}

// A shower, a sauna, a booth: as deep as it is wide, and nobody looks over it.
bool is_tall_cell(const Item& item) {
  const Size& size = item.states[0].size;
  return size.height >= measures().tall_from && 4 * std::min(size.width, size.depth) >= 3 * std::max(size.width, size.depth);
}

}  // namespace

void Habits::back_to_wall(ItemId item, int weight) {
  Formula f;
  int alike = 0;  // that nobody placed
  for (const ItemId i : model_.items.ids())
    alike += model_.items[i].entry == model_.items[item].entry && !placed_by_relation_besides_walls(i);
  const bool narrow_bed = is_narrow_bed(item);
  const bool heart =
      (model_.items[item].is(Trait::kCenterPiece) || is_looked_at(item) || is_platform(model_.items[item])) && alike <= 1 && !narrow_bed;
  // In a corner it gives up the free floor at one side, and keeps that at the other.
  const std::map<Side, Mm>& wanted = model_.items[item].entry->clearance;
  // What rocks or leans back keeps the room for that.
  const bool rocks = model_.items[item].is(Trait::kEasySeat) && wanted.contains(Side::kBack);
  const Mm behind = rocks ? wanted.at(Side::kBack) : kFlushInCorner;
  const int for_side = wanted.contains(Side::kLeft) && wanted.contains(Side::kRight) ? kCostWeights.wanted : 0;
  const int for_bed = model_.items[item].is(Trait::kClimbedInto) ? kHighBedToCorner : kBedToCorner;
  const bool parts_wall = ends_run(item) || (keeps_to_corner(item) && is_tall_cell(model_.items[item]));
  const int to_corner = narrow_bed ? for_bed + for_side : parts_wall ? kTallToCorner : keeps_to_corner(item) ? kToCorner : 0;
  for (const RoomWall& wall : model_.walls) {
    const std::size_t known = f.cases.size();
    add_against(f, model_, item, states_with_back_to(model_.items[item], wall), wall, behind, true);
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
void Habits::back_to_divider(Formula& f, ItemId item) {
  constexpr Mm kOff = 50;
  for (const ItemId divider : model_.items.ids()) {
    if (model_.items[divider].is_opening() || divided_by(divider) == nullptr) continue;
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
bool Habits::may_float(ItemId item) const {
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
bool Habits::is_narrow_bed(ItemId item) const {
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
bool Habits::has_bedside(ItemId bed) const {
  return std::ranges::any_of(model_.items, [&](const Item& other) {
    return !other.is_opening() && other.mount == Mount::kFloor && other.entry->back_to_wall &&
           area_of(other) < area_of(model_.items[bed]) / 4 &&
           std::ranges::any_of(other.entry->beside, [&](const std::string& kind) { return model_.is_a(bed, kind); });
  });
}

// A fridge in the middle of a kitchen's run would part the worktop.
bool Habits::ends_run(ItemId item) const {
  const Item& self = model_.items[item];
  if (!self.is(Trait::kKitchenRun) || self.states.empty() || self.states[0].size.height < measures().tall_from) return false;
  const bool placed = std::ranges::any_of(model_.scene->relations, [&](const Relation& r) {
    const bool where = r.type != RelationType::kInRegion && r.type != RelationType::kAgainstWall && r.type != RelationType::kCorner;
    return where && std::ranges::find(r.targets, self.id) != r.targets.end();
  });
  if (placed) return false;
  return std::ranges::any_of(model_.items, [&](const Item& other) {
    return &other != &self && other.is(Trait::kKitchenRun) && other.mount == Mount::kFloor &&
           other.states[0].size.height < measures().tall_from;
  });
}

// Cupboards, tubs and machines that nothing looks at and that stand by nothing leave the middle of the wall free.
bool Habits::keeps_to_corner(ItemId item) const {
  const Item& self = model_.items[item];
  if (self.is(Trait::kCenterPiece) || self.is(Trait::kTable) || self.is(Trait::kDeskLike) || self.is(Trait::kSeat)) return false;
  if (is_platform(self) || table_served_by(item).exists()) return false;
  // "the shower at the far end" may stand in the corner there.
  const bool placed = std::ranges::any_of(said_of(item), [&](const Relation* r) {
    const bool wall = r->type == RelationType::kOnWall || r->type == RelationType::kAgainstWall || r->type == RelationType::kInRegion;
    return !wall && std::ranges::find(r->targets, self.id) != r->targets.end();
  });
  if (self.is(Trait::kOpenToRoom) || placed || !items_of_kinds(self.entry->beside, item).empty()) return false;
  return !is_faced_by_kind(item);
}

// What is built in an L stands in a corner with both its backs to walls: the open part is at the front and the other side.
void Habits::stand_in_its_corner(ItemId item) {
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
bool Habits::is_looked_at(ItemId item) const {
  const Item& self = model_.items[item];
  return is_faced_by_kind(item) && !self.is(Trait::kTable) && !self.is(Trait::kDeskLike) && !self.is(Trait::kCounter);
}

// Is it what something there usually faces?
bool Habits::is_faced_by_kind(ItemId item) const {
  const Item& self = model_.items[item];
  return std::ranges::any_of(model_.items, [&](const Item& other) {
    return other.entry != nullptr && other.entry != self.entry &&
           std::ranges::any_of(other.entry->faces, [&](const std::string& kind) { return model_.is_a(item, kind); });
  });
}

// Small things at walls, best in corners; a plant in the middle of a room is in the way. What is long stands along the wall.
void Habits::stand_at_wall(ItemId item) {
  const Size& size = model_.items[item].states[0].size;
  const bool is_long = 2 * std::max(size.width, size.depth) >= 3 * std::min(size.width, size.depth);
  const auto near_wall = [&](Case& c, const RoomWall& wall, Mm most) {
    const Side side = model_.items[item].has_front ? Side::kBack : Side::kLong;
    const std::uint64_t along = is_long ? states_with_side_to(model_.items[item], wall, side) : 0;
    if (along) c.when(item, along);
    require_near_wall(c, model_, item, wall, most);
    c.wish(gap_towards(item, place_of(model_, wall), {wall.normal(), wall.inward}), kAtWall);
  };
  Formula f;
  for (const WallId w : model_.walls.ids()) {
    const RoomWall &a = model_.walls[w], &b = model_.walls[model_.walls.next(w)];
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

}  // namespace layoutbox::placement
