// Habits of sets that share something: a row on the wall over one thing, small things along a wall, the floor round a table for play.
#include "layoutbox/catalog/measures.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {

// What hangs over one thing (hooks above a bench, pictures above a sofa) hangs in a row about its middle, at one height and within its
// width where that goes. False: it is the only one of its kind, or words put it elsewhere.
bool Habits::hang_in_row_over(ItemId item) {
  constexpr Mm kLeastAir = 20, kMostAir = 250, kUsualAir = 80;
  constexpr int kInRow = 400;
  const Item& self = model_.items[item];
  const auto host_of = [&](ItemId i) -> ItemId {
    ItemId host;
    for (const Relation& r : model_.scene->relations) {
      if (r.type == RelationType::kOnWall || std::ranges::find(r.targets, model_.items[i].id) == r.targets.end()) continue;
      if (r.type != RelationType::kAbove || r.references.size() != 1 || host.exists()) return {};
      host = model_.find_item(r.references[0]);
      if (!host.exists()) return {};
    }
    return host;
  };
  const ItemId host = host_of(item);
  if (!host.exists() || model_.items[host].is_opening()) return false;
  std::vector<ItemId> peers;
  for (const ItemId index : model_.items.ids()) {
    const Item& other = model_.items[index];
    if (!other.is_opening() && other.entry == self.entry && other.mount == Mount::kWall && host_of(index) == host) peers.push_back(index);
  }
  const auto n = static_cast<int>(peers.size());
  if (n < 2) return false;
  const auto k = static_cast<int>(std::ranges::find(peers, item) - peers.begin());
  const Mm width = self.states[0].size.width;
  const Mm room = (model_.items[host].states[0].size.width - n * width) / (n - 1);
  const Mm air = std::max(kLeastAir, std::min(room, std::clamp(width / 2, kUsualAir, kMostAir)));
  Formula f;
  for (const RoomWall& wall : model_.walls) {
    if (!wall.straight) continue;
    Case& c = f.add().when(item, states_facing(item, wall));
    c.wish(mid2(item, wall.along) - mid2(host, wall.along) - Linear((2 * k - (n - 1)) * (width + air)), kInRow, 2);
    c.wish(mid2(item, wall.normal()) - mid2(host, wall.normal()), kHangs / 2, 2);
    if (k == 0) continue;
    c.when(peers[0], states_facing(peers[0], wall)).wish(lo(item, 2) - lo(peers[0], 2), kInRow);
  }
  if (f.cases.empty()) return false;
  habit("in a row over it", item, kInRow, std::move(f), {host});
  return true;
}

// Large things that have a wall to themselves share all of it out: each is looked at alone. 0: they are no such things.
Mm Habits::air_on_wall(ItemId item, int count) const {
  constexpr Mm kLarge = 900, kMostApart = 1200;
  const Mm width = model_.items[item].states[0].size.width;
  const std::vector<const Relation*>& said = said_of(item);
  const auto told = std::ranges::find_if(said, [](const Relation* r) { return r->type == RelationType::kOnWall; });
  if (width < kLarge || told == said.end() || (*told)->references.size() != 1) return 0;
  const auto wall = std::ranges::find(model_.walls, (*told)->references[0], &RoomWall::id);
  return wall == model_.walls.end() || !wall->straight ? 0 : std::min(kMostApart, (wall->hi - wall->lo - count * width) / (count + 1));
}

// "Washer and dryer side by side with a shelf above": over the middle of both, where it is as wide as one. False: it hangs over no such
// two.
bool Habits::hang_over_both(ItemId item) {
  const auto host_of = [&](ItemId i) {
    for (const Relation* r : said_of(i)) {
      if (r->type == RelationType::kAbove && r->references.size() == 1 && r->targets[0] == model_.items[i].id)
        return model_.find_item(r->references[0]);
    }
    return ItemId();
  };
  const ItemId host = host_of(item);
  // What stands at a wall stands close to its mate there; over two benches that stand apart it would be over neither.
  if (!host.exists() || model_.items[host].is_opening() || !model_.items[host].entry->back_to_wall ||
      model_.items[item].states[0].size.width < model_.items[host].states[0].size.width)
    return false;
  for (const ItemId mate : model_.items.ids()) {
    const bool abreast = related_as_target(host, mate, RelationType::kEdgeAlign) || related_as_target(mate, host, RelationType::kEdgeAlign);
    if (!abreast || model_.items[mate].is_opening()) continue;
    Formula f;
    for (const RoomWall& wall : model_.walls) {
      if (!wall.straight) continue;
      Case& c = f.add().when(item, states_facing(item, wall));
      c.wish(2 * mid2(item, wall.along) - mid2(host, wall.along) - mid2(mate, wall.along), kHangs, 4);
    }
    if (f.cases.empty()) return false;
    habit("over both", item, kHangs, std::move(f), {host});
    return true;
  }
  return false;
}

// Many small things that are told their wall and no more (buckets, plants) stand along all of it.
void Habits::share_wall_out(ItemId item) {
  constexpr std::size_t kMany = 4;
  constexpr int kShare = 200;  // points a metre
  const auto told_of = [&](ItemId i) -> const std::string* {
    const Item& other = model_.items[i];
    if (other.is_opening() || other.mount != Mount::kFloor || other.entry->back_to_wall || other.is(Trait::kSeat) || !only_told_its_wall(i))
      return nullptr;
    for (const Relation& r : model_.scene->relations) {
      if (r.type == RelationType::kAgainstWall && r.references.size() == 1 && std::ranges::find(r.targets, other.id) != r.targets.end())
        return &r.references[0];
    }
    return nullptr;
  };
  const std::string* told = told_of(item);
  if (told == nullptr) return;
  std::vector<ItemId> peers;
  for (const ItemId index : model_.items.ids()) {
    if (model_.items[index].entry != model_.items[item].entry) continue;
    const std::string* wall = told_of(index);
    if (wall != nullptr && *wall == *told) peers.push_back(index);
  }
  const auto wall = std::ranges::find_if(model_.walls, [&](const RoomWall& w) { return w.id == *told; });
  if (peers.size() < kMany || wall == model_.walls.end() || !wall->straight) return;
  const auto n = static_cast<std::int64_t>(peers.size()), k = std::ranges::find(peers, item) - peers.begin();
  Formula f;
  f.add().wish(mid2(item, wall->along) - Linear(2 * wall->lo + (2 * k + 1) * (wall->hi - wall->lo) / n), kShare, 2);
  habit("along all of the wall", item, kShare, std::move(f));
}

// What is played from behind only (a drum kit) leaves the player a seat between it and the wall.
void Habits::leave_seat_behind(ItemId item) {
  constexpr Mm kSeat = 420;
  constexpr int kBehind = 500;  // points a metre
  const Item& self = model_.items[item];
  const bool served = is_served_over(item) && !self.is(Trait::kDeskLike);
  const bool manned = used_sides(self) == std::vector<Side>{Side::kBack} && !self.is(Trait::kTable) && !self.is(Trait::kDeskLike);
  if (!served && !manned) return;
  const Mm behind = served ? measures().behind_bar : kSeat;
  Formula f;
  for (const RoomWall& wall : model_.walls) {
    if (!wall.straight) continue;
    const Direction away{wall.normal(), wall.inward};
    f.add().when(item, states_with_back_to(self, wall)).wish(gap_towards(item, place_of(model_, wall), away) - Linear(behind), kBehind);
  }
  if (!f.cases.empty()) habit("a seat behind", item, kBehind, std::move(f));
}

// Nobody plays billiards between tables: what else stands on the floor keeps off as far as the player needs.
void Habits::keep_off_play(ItemId item) {
  constexpr int kOff = 500;  // points a metre
  for (const ItemId table : model_.items.ids()) {
    const Item& played = model_.items[table];
    if (played.is_opening() || !played.is(Trait::kPlayTable) || table == item || played.mount != Mount::kFloor || related(item, table))
      continue;
    Formula f;
    for_each_turn(played, [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      for (const Side side : {Side::kFront, Side::kBack, Side::kLeft, Side::kRight}) {
        const auto wanted = played.entry->clearance.find(side);
        const Mm off = wanted == played.entry->clearance.end() ? 0 : wanted->second;
        f.add().when(table, states).require(gap_towards(item, table, side_direction(played, side, turn)) - Linear(off));
      }
    });
    habit("clear of the play", item, kOff, std::move(f));
  }
}

// A lamp to read by stands beside the back of its seat, where it is in nobody's way.
void Habits::stand_at_back_of_seat(ItemId item) {
  constexpr int kAtBack = 200;  // points a metre
  const Item& self = model_.items[item];
  if (!self.is(Trait::kLamp) || self.mount != Mount::kFloor) return;
  for (const ItemId host : model_.items.ids()) {
    const Item& seat = model_.items[host];
    if (seat.is_opening() || !seat.has_front || !(seat.is(Trait::kEasySeat) || seat.is(Trait::kCenterPiece))) continue;
    const bool before = related_as_target(item, host, RelationType::kBehind) || related_as_target(item, host, RelationType::kInFrontOf);
    if (before || !related_by_any(item, host, relations_that<&RelationTraits::close_by>())) continue;
    Formula f;
    for_each_turn(seat, [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      const Direction back = side_direction(seat, Side::kBack, turn);
      f.add().when(host, states).wish(reach(item, back) - reach(host, back), kAtBack);
    });
    if (!f.cases.empty()) habit("at the back of its seat", item, kAtBack, std::move(f), {host});
    return;
  }
}

}  // namespace layoutbox::placement
