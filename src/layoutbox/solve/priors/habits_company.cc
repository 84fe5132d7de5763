// Habits towards other things: beside, round, before and facing what they belong to.
#include <bit>

#include "layoutbox/catalog/measures.h"
#include "layoutbox/solve/model/slanted.h"
#include "layoutbox/solve/priors/formation.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {

// Several of a kind before or behind one thing stand abreast: chairs behind a news desk, cameras before it.
bool Habits::stand_abreast(ItemId item) {
  for (const Relation* said : said_of(item)) {
    const Relation& r = *said;
    const Item& self = model_.items[item];
    // Desks that are sat behind stand free, as what has no back does.
    const bool free = !self.is(Trait::kTableSeat) && (!self.entry->back_to_wall || is_sat_behind(item));
    const bool abreast = r.type == RelationType::kInFrontOf || r.type == RelationType::kBehind ||
                         (r.type == RelationType::kOpposite && free) ||
                         (r.type == RelationType::kFacing && free && !placed_besides_facing(item));
    if (r.references.size() != 1 || !abreast) continue;
    const ItemId host = model_.find_item(r.references[0]);
    if (host.exists() && related_as_target(item, host, r.type) && stand_abreast_of(item, host, r.type)) return true;
  }
  return false;
}

bool Habits::stand_abreast_of(ItemId item, ItemId host, RelationType how) {
  constexpr Mm kApart = 100, kOff = 600, kSeatOff = 50, kTalkingOff = 1800;
  constexpr std::size_t kMostAbreast = 3;
  const bool across_from = how == RelationType::kOpposite || how == RelationType::kFacing;
  const Item &self = model_.items[item], &ref = model_.items[host];
  const bool seat = self.is(Trait::kTableSeat);
  const bool window = ref.is_opening() && how == RelationType::kFacing && !self.is(Trait::kTable);
  const bool sided =
      window || (!ref.is_opening() && (ref.has_front || (seat && how == RelationType::kBehind)));  // a table's back is that of the room
  if (!sided || (seat && how == RelationType::kInFrontOf)) return false;
  const RelationSet only(how, RelationType::kFacing, RelationType::kCenteredOn, across_from ? RelationType::kDistance : how);
  std::vector<ItemId> peers;
  for (const ItemId other : model_.items.ids()) {
    if (model_.items[other].entry == self.entry && related_as_target(other, host, how) && only_related_by(other, host, only))
      peers.push_back(other);
  }
  const auto k = std::find(peers.begin(), peers.end(), item) - peers.begin();
  const auto n = static_cast<std::ptrdiff_t>(peers.size());
  if (n < 2 || k == n || (across_from && peers.size() > kMostAbreast)) return false;
  const Mm pitch = self.states[0].size.width + kApart;
  // A bar's back shelves have the wall behind them, however far that is from the bar.
  const bool at_wall = how == RelationType::kBehind && self.entry->back_to_wall && !self.is(Trait::kDeskLike);
  Formula f;
  for_each_turn(ref, [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction away = side_direction(ref, how == RelationType::kBehind ? Side::kBack : Side::kFront, turn);
    Case& c = f.add().when(host, states);
    const int along = across(away);
    if (self.has_front) c.when(item, states_looking(self, opposite(away)));
    c.wish(mid2(item, along) - mid2(host, along) - Linear((2 * k - (n - 1)) * pitch), kBeside, 2);
    if (!at_wall) c.wish(gap_towards(item, host, away) - Linear(seat ? kSeatOff : across_from && !window ? kTalkingOff : kOff), kBeside);
  });
  habit("abreast", item, kBeside, std::move(f), {host});
  if (at_wall) back_to_wall(item, kBackToWall);
  return true;
}

// Does anything but its neighbour say where a seat is?
bool Habits::is_seated(ItemId item, ItemId neighbour) const {
  return std::ranges::any_of(said_of(item), [&](const Relation* r) {
    const bool target = std::ranges::find(r->targets, model_.items[item].id) != r->targets.end();
    return target && r->references != std::vector<std::string>{model_.items[neighbour].id};
  });
}

// What is told to stand next to something that is used from its front stands at its side: a plant beside the television, a cabinet beside
// the bed. On a table too, and not so close that they touch.
void Habits::stand_at_side(ItemId item) {
  const Item& self = model_.items[item];
  const bool seat = self.is(Trait::kTableSeat);
  if (before_its_host(item)) return;
  for (const Relation* said : said_of(item)) {
    const Relation& r = *said;
    if (r.type != RelationType::kNextTo || r.references.size() != 1) continue;
    const ItemId host = model_.find_item(r.references[0]);
    if (host.exists() && self.is(Trait::kEasySeat) && !model_.items[host].is(Trait::kBed)) continue;
    if (!host.exists() || !related_as_target(item, host, r.type) ||
        !only_related_by(item, host, relations_that<&RelationTraits::close_by>()))
      continue;
    const Item& ref = model_.items[host];
    if (seat && (ref.is_opening() || !ref.is(Trait::kTableSeat) || is_seated(item, host))) continue;
    const bool small = self.mount == Mount::kSurface && ref.mount == Mount::kSurface;
    // A basin that hangs is stood before as well.
    const bool hangs = !ref.is_opening() && ref.mount == Mount::kWall && self.mount == Mount::kFloor && !used_sides(ref).empty();
    if (!small && (ref.is_opening() || (ref.mount != Mount::kFloor && !hangs) || !ref.has_front || area_of(ref) < area_of(self))) continue;
    Formula f;
    const Mm gap = small ? 40 : 60;
    for (const Side side : {Side::kLeft, Side::kRight})
      add_beside(f, model_, item, host, side, {.most = 500, .wished_gap = gap, .in_plan_only = hangs});
    for (Case& c : f.cases) {
      if (!c.wishes.empty()) c.wishes[0].weight = kBeside;
    }
    habit("at its side", item, kBeside, std::move(f), {host});
    if (seat && self.has_front) turn_as(item, host);
    return;
  }
}

bool Habits::before_its_host(ItemId item) const { return model_.items[item].is(Trait::kStandsBefore); }

// What it may look at, the likeliest first.
std::vector<ItemId> Habits::seen_from(ItemId item) const {
  const Item& self = model_.items[item];
  std::vector<ItemId> seen = items_of_kinds(self.entry->faces, item);
  // What it is to be away from it does not look at.
  std::erase_if(seen, [&](ItemId other) { return self.is(Trait::kTableSeat) && related_as_target(item, other, RelationType::kFar); });
  // Each has its own mirror before all others.
  std::ranges::stable_partition(seen, [&](ItemId other) { return related_as_target(item, other, RelationType::kFacing); });
  // … an easy chair the low table that it sits at
  if (const ItemId table = low_table_of(item); table.exists() && !seen.empty() && model_.items[seen[0]].is(Trait::kCoffeeTable))
    std::ranges::stable_partition(seen, [&](ItemId other) { return other == table || related(item, other); });
  // … and a visitor the bed that the chair is told to be at.
  if (self.is(Trait::kTableSeat)) std::ranges::stable_partition(seen, [&](ItemId other) { return related(item, other); });
  if (self.is(Trait::kTableSeat)) std::erase_if(seen, [&](ItemId other) { return !takes_seat(other, item) || waits_for(item, other); });
  return seen;
}

// Seats in rows look at the board or the screen of the room, whatever they are.
std::vector<ItemId> Habits::seen_by_crowd(ItemId item) const {
  std::vector<ItemId> seen = seen_from(item);
  const Item& self = model_.items[item];
  const ItemId board = self.has_front && (self.is(Trait::kSeat) || self.is(Trait::kEasySeat)) ? board_of_room() : ItemId();
  const auto shows = [&](ItemId other) { return model_.items[other].is(Trait::kScreen); };
  if (board.exists() && std::ranges::none_of(seen, shows)) seen.insert(seen.begin(), board);
  return seen;
}

// Its front to what it is for: sofas to screens, easy chairs to the table between. False: there is nothing of that.
bool Habits::look_at(ItemId item, bool leads, const std::vector<ItemId>& crowd) {
  const Item& self = model_.items[item];
  if (!self.has_front) return false;
  const std::vector<ItemId> seen = crowd.empty() ? seen_from(item) : seen_by_crowd(item);
  for (const ItemId seen_one : seen) {
    const ItemId other = stand_of_screen(seen_one);
    if (model_.items[other].mount != Mount::kFloor && model_.items[other].mount != Mount::kWall && seen.size() > 1 && seen_one != seen[0])
      continue;
    Formula f;
    crowd.empty() ? add_looks_at(f, model_, item, other, looking_side(model_, item)) : add_looks_with_group(f, model_, item, crowd, other);
    if (self.is(Trait::kEasySeat) && !related(item, other) && !model_.items[seen_one].is(Trait::kScreen) &&
        !model_.items[other].is(Trait::kCenterPiece)) {
      for (Case& c : f.cases) {  // near enough to put a cup down
        for (int axis = 0; axis < 2; ++axis) c.wish(mid2(item, axis) - mid2(other, axis), 60, 2);
      }
    }
    // Told to flank the fireplace, it looks at the table before the sofa only as far as that goes.
    const bool elsewhere = self.is(Trait::kEasySeat) && placed_besides_facing(item) && !related(item, other);
    const bool after = self.is(Trait::kEasySeat) || (leads && !comes_after_screen(other, item)) || comes_after_screen(item, other);
    habit("faces", item, elsewhere || leaves_screen_to_others(item, seen_one) ? kFaces / 3 : kFaces, std::move(f),
          after ? std::vector<ItemId>{other} : std::vector<ItemId>{});
    const bool at_ease = self.is(Trait::kEasySeat) && crowd.empty();
    if (model_.items[seen_one].is(Trait::kScreen)) stay_before_screen(item, other, at_ease);
    if (self.is(Trait::kCenterPiece) && !self.is(Trait::kBed)) {
      if (model_.items[seen_one].is(Trait::kScreen)) watch_from_near(item, other), have_screen_before(item, other);
      if (!model_.items[other].is(Trait::kCoffeeTable)) watch_past_tables(item, other);
    }
    return true;
  }
  return false;
}

// Guests wait before who serves: not behind a reception desk or a counter, and off its front and its ends.
void Habits::wait_before_counter(ItemId item) {
  constexpr int kGuests = 700;  // points a metre
  constexpr Mm kOffEnds = 600;
  const Item& self = model_.items[item];
  const bool sofa = self.is(Trait::kCenterPiece) && !self.is(Trait::kBed) && self.has_front;
  if (!self.is(Trait::kTableSeat) && !self.is(Trait::kSeat) && !self.is(Trait::kEasySeat) && !sofa) return;
  for (const ItemId host : model_.items.ids()) {
    const Item& desk = model_.items[host];
    if (host == item || !is_served_over(host) || related(item, host)) continue;
    if (desk.is(Trait::kDeskLike) && !waits_for(item, host)) continue;
    Formula f;
    for_each_turn(desk, [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      const Direction front = side_direction(desk, Side::kFront, turn);
      if (desk.is(Trait::kCounter)) {
        f.add().when(host, states).require(gap_towards(item, host, front) + Linear(desk.states[0].size.depth));
        return;
      }
      f.add().when(host, states).require(gap_towards(item, host, front) - Linear(measures().knees_free));
      for (const int sign : {1, -1}) {
        f.add()
            .when(host, states)
            .require(gap_towards(item, host, front) + Linear(desk.states[0].size.depth))
            .require(gap_towards(item, host, {across(front), sign}) - Linear(kOffEnds));
      }
    });
    habit("waits before the desk", item, kGuests, std::move(f));
  }
}

}  // namespace layoutbox::placement
