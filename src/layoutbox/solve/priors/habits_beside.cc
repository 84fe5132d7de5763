// The habit of standing by the greater thing one goes with: a seat at its table, a nightstand beside its bed, a table before its sofa.
#include <bit>
#include <optional>

#include "layoutbox/solve/model/slanted.h"
#include "layoutbox/solve/priors/formation.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {

bool Habits::stand_beside(ItemId item) {
  if (stand_as_told_by(item)) return true;
  std::vector<ItemId> hosts = hosts_beside(item);
  if (hosts.empty()) return false;
  const Item &self = model_.items[item], &first = model_.items[hosts[0]];
  const bool served_over = self.has_front && self.is(Trait::kOpenToRoom) && !self.is(Trait::kCounter);
  if (served_over && first.has_front && first.is(Trait::kCounter)) turn_as(item, hosts[0]);  // in one line with it
  if (const std::optional<ItemId> told = told_host(item, hosts)) {
    if (!leaves_usual_place(item, *told)) {
      come_near(item, *told);
      sit_facing(item, *told);
      return true;
    }
    hosts = {*told};
  } else {
    if (told_to_sit_elsewhere(item)) return false;
    if (sit_near_low_table(item)) return true;
    leave_seated_to_their_seats(hosts, item);
  }
  // Hosts of the best kind only: a lamp by the sofa rather than by the desk.
  std::erase_if(hosts, [&](ItemId h) { return model_.items[h].entry != model_.items[hosts[0]].entry; });
  const ItemId host = hosts[rank_of(item) % static_cast<int>(hosts.size())];
  const int number = static_cast<int>(hosts.size());
  if (!sit_at(item, host, number) && !sit_round_sofa(item, host)) stand_at(item, host, number);
  return true;
}

// What a relation says of it and a greater thing, and what that leaves open. True: nothing is.
bool Habits::stand_as_told_by(ItemId item) {
  constexpr Mm kLowAtFoot = 650;  // a bench, a chest: close to the bed; not a wardrobe
  const Item& self = model_.items[item];
  for (const ItemId host : model_.items.ids()) {
    for (const RelationType how : {RelationType::kInFrontOf, RelationType::kAlongSide}) {
      if (related_as_target(item, host, how) && sit_in_row(item, host, how)) return true;
    }
    if (related_as_target(item, host, RelationType::kAtFootOf) && self.states[0].size.height <= kLowAtFoot) {
      come_near(item, host);
      if (self.has_front && model_.items[host].has_front) turn_as(item, host);  // its back to the bed
    }
    // Who sits behind a bench or a counter looks over it.
    const Item& desk = model_.items[host];
    const bool sat_behind =
        self.is(Trait::kEasySeat) && desk.has_front && (desk.is(Trait::kTable) || desk.is(Trait::kDeskLike) || desk.is(Trait::kCounter));
    if (sat_behind && related_as_target(item, host, RelationType::kBehind)) turn_as(item, host);
  }
  return false;
}

// The host that a relation says it stands by, not only looks at.
std::optional<ItemId> Habits::told_host(ItemId item, const std::vector<ItemId>& hosts) const {
  for (const ItemId h : hosts) {
    if (!related(item, h) || only_related_by(item, h, RelationSet(RelationType::kBetween)) || only_turned_by(item, h)) continue;
    if (related_as_target(item, h, RelationType::kFar)) continue;
    if (model_.items[item].is(Trait::kEasySeat) && model_.items[h].is(Trait::kCoffeeTable) && only_near(item, h)) continue;
    return h;
  }
  return std::nullopt;
}

// Chairs along the walls or in rows; two easy chairs by the fire do not draw the sofa there.
bool Habits::told_to_sit_elsewhere(ItemId item) const {
  const Item& self = model_.items[item];
  return (self.is(Trait::kTableSeat) && placed_besides_facing(item)) || (self.is(Trait::kEasySeat) && told_away_from_group(item));
}

// The low table that an easy chair sits at where words put it at none: of several its share of them; none: there is no such table.
ItemId Habits::low_table_of(ItemId item) const {
  if (!model_.items[item].is(Trait::kEasySeat)) return {};
  std::vector<ItemId> tables = items_of_kinds(model_.items[item].entry->faces, item);
  std::erase_if(tables, [&](ItemId other) { return !model_.items[other].is(Trait::kCoffeeTable); });
  if (tables.empty()) return {};
  int seats = 0;
  for (const Item& other : model_.items) seats += other.entry == model_.items[item].entry;
  return tables[static_cast<std::size_t>(rank_of(item)) * tables.size() / static_cast<std::size_t>(seats)];
}

bool Habits::sit_near_low_table(ItemId item) {
  const ItemId table = low_table_of(item);
  if (!table.exists() || !only_near(item, table)) return false;
  sit_round_low_table(item, table);
  return true;
}

// A stool goes to the counter where the tables have their chairs.
void Habits::leave_seated_to_their_seats(std::vector<ItemId>& hosts, ItemId item) const {
  const Item& self = model_.items[item];
  const auto is_seated = [&](ItemId h) {
    return std::ranges::any_of(model_.scene->relations, [&](const Relation& r) {
      const ItemId seat = r.targets.empty() ? ItemId() : model_.find_item(r.targets[0]);
      return seat.exists() && model_.items[seat].is(Trait::kTableSeat) && model_.items[seat].entry != self.entry &&
             std::ranges::find(r.references, model_.items[h].id) != r.references.end();
    });
  };
  if (self.is(Trait::kTableSeat) && !std::ranges::all_of(hosts, is_seated)) std::erase_if(hosts, is_seated);
}

// Its share of the places at one of so many tables or counters. False: it is no seat, or nobody sits there.
bool Habits::sit_at(ItemId item, ItemId host, int hosts) {
  const Item &self = model_.items[item], &ref = model_.items[host];
  if (!self.is(Trait::kTableSeat)) return false;
  if (self.has_front && ref.is(Trait::kDeskLike) && is_served_over(host)) {
    sit_behind_served(item, host);
    return true;
  }
  const std::vector<Side> used = used_sides(ref);
  const bool sat_before =
      used.size() == 1 && used[0] == Side::kFront && ref.has_front && (ref.entry->back_to_wall || ref.is(Trait::kDeskLike));
  const bool at_counter = ref.is(Trait::kCounter) && ref.has_front;  // at its front; who serves is behind
  if (!has_knee_room(ref) && !sat_before && !at_counter) return false;
  Formula f;
  const std::vector<ItemId> seats = seats_at(item, host, hosts);
  const auto k = std::ranges::find(seats, item) - seats.begin();
  add_seat_place(f, model_, item, host, static_cast<int>(k), static_cast<int>(seats.size()), kBeside);
  habit("at table", item, kBeside, std::move(f), {host});
  return true;
}

// What is long and hangs beside something that is deeper than wide (a rail by a toilet) hangs along that one's side, on the wall there:
// flat on the wall behind it nobody reaches it. False: it is no such thing.
bool Habits::hang_along_side(ItemId item) {
  constexpr Mm kNear = 300;
  constexpr int kOnBackWall = 250, kSlim = 4;
  const Item& self = model_.items[item];
  const Size& size = self.states[0].size;
  std::vector<ItemId> hosts = usual_hosts(item);
  std::erase_if(hosts, [&](ItemId h) { return !related(item, h) && placed_by_relation_besides_walls(item); });
  if (hosts.empty() || size.width < kSlim * size.depth) return false;
  const ItemId host = hosts[rank_of(item) % static_cast<int>(std::ranges::count(hosts, hosts[0]))];
  const Item& ref = model_.items[host];
  if (!ref.has_front || !ref.entry->back_to_wall || ref.states[0].size.depth <= ref.states[0].size.width) return false;
  Formula f;
  for_each_turn(ref, [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(ref, Side::kFront, turn);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const Direction out = side_direction(ref, side, turn);
      Case& beside = f.add().when(host, states).when(item, states_looking(self, opposite(out)));
      beside.require(gap_towards(item, host, out)).wish(gap_towards(item, host, out) - Linear(kNear), kBeside);
      beside.wish(mid2(item, front.axis) - mid2(host, front.axis), kBeside, 2);
      Case& behind = f.add().when(host, states).when(item, states_looking(self, front));
      behind.require(gap_towards(item, host, out)).wish(gap_towards(item, host, out), kBeside).price = kOnBackWall;
    }
  });
  habit("along its side", item, kBeside, std::move(f), {host});
  return true;
}

// Before its host or at its sides, close to it.
void Habits::stand_at(ItemId item, ItemId host, int hosts) {
  const Item &self = model_.items[item], &ref = model_.items[host];
  Formula f;
  const std::vector<Side> used = used_sides(ref);
  if (self.is(Trait::kTableSeat) && used.size() == 1 && ref.has_front) {  // a drummer's stool
    add_beside(f, model_, item, host, used[0], {.most = 500, .wished_gap = 0});
  } else if (before_its_host(item)) {
    add_beside(f, model_, item, host, Side::kFront, {.most = 600, .wished_gap = self.is(Trait::kCoffeeTable) ? 400 : 100});
  } else {
    add_beside(f, model_, item, host, Side::kLeft, {.most = 500, .wished_gap = 60});
    add_beside(f, model_, item, host, Side::kRight, {.most = 500, .wished_gap = 60});
    if (!ref.has_front) {
      add_beside(f, model_, item, host, Side::kFront, {.most = 500, .wished_gap = 60});
      add_beside(f, model_, item, host, Side::kBack, {.most = 500, .wished_gap = 60});
    }
  }
  // Near is what makes them belong together; the free floor wanted at the host's sides would push them off.
  for (Case& c : f.cases) {
    if (!c.wishes.empty()) c.wishes[0].weight = kBeside;
  }
  habit("beside", item, kBeside, std::move(f), {host});
  if (before_its_host(item)) stand_before_middle(item, host);
  stand_edge_on(item, host);
  if (ref.has_front && !before_its_host(item) && !self.is(Trait::kTableSeat)) flank(item, host, hosts);
}

// A pane or a screen beside something goes on from the wall as that one's side does.
void Habits::stand_edge_on(ItemId item, ItemId host) {
  constexpr int kFlat = 8;
  const Item &self = model_.items[item], &ref = model_.items[host];
  const Size& size = self.states[0].size;
  if (self.mount != Mount::kFloor || self.has_front || size.width < kFlat * size.depth || !ref.entry->back_to_wall || !ref.has_front)
    return;
  Formula f;
  for_each_turn(ref, [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    f.add().when(host, states).when(item, states_with_width_along(self, side_direction(ref, Side::kFront, turn).axis));
  });
  if (!f.cases.empty()) habit("edge on", item, kBeside, std::move(f), {host});
}

// Seats in a row along the side of what all of them look at, its middle before that side's, each in the place of its rank.
void Habits::sit_in_row(ItemId item, ItemId at, const SeatRow& row) {
  const auto k = std::ranges::find(row.seats, item) - row.seats.begin(), n = std::ssize(row.seats);
  const Mm pitch = model_.items[item].states[0].size.width + row.between;
  Formula f;
  for_each_turn(model_.items[at], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction out = side_direction(model_.items[at], row.side, turn);
    Case& c = f.add().when(at, states).when(item, states_looking(model_.items[item], opposite(out)));
    c.wish(mid2(item, across(out)) - mid2(at, across(out)) - Linear((2 * k - (n - 1)) * pitch), kBeside, 2);
    c.wish(gap_towards(item, at, out) - Linear(row.off), kBeside);
  });
  habit(row.name, item, kBeside, std::move(f), {at});
}

// Who works at a reception desk sits behind it, where the room for the knees is, and looks over it.
void Habits::sit_behind_served(ItemId item, ItemId host) {
  sit_in_row(item, host, {.name = "behind the desk", .side = Side::kBack, .seats = seats_at(item, host, 1), .between = 200});
}

// Told to stand by something that is not what one talks round: by the fire, at the window.
bool Habits::told_away_from_group(ItemId item) const {
  if (!placed_besides_facing(item)) return false;
  const auto in_group = [&](const std::string& id) {
    const ItemId other = model_.find_item(id);
    if (!other.exists() || model_.items[other].is_opening()) return false;
    const Item& ref = model_.items[other];
    return ref.is(Trait::kCenterPiece) || ref.is(Trait::kEasySeat) || ref.is(Trait::kCoffeeTable) || ref.thin;
  };
  return std::ranges::none_of(model_.scene->relations, [&](const Relation& r) {
    return std::ranges::find(r.targets, model_.items[item].id) != r.targets.end() && std::ranges::any_of(r.references, in_group);
  });
}

// Easy chairs make a talking group: at the ends of the coffee table, looking at it, two of them face to face.
void Habits::sit_round_low_table(ItemId item, ItemId table) {
  Formula f;
  add_beside(f, model_, item, table, Side::kLeft, {.most = 700, .wished_gap = 350});
  add_beside(f, model_, item, table, Side::kRight, {.most = 700, .wished_gap = 350});
  const std::size_t ends = f.cases.size();
  add_beside(f, model_, item, table, Side::kFront, {.most = 700, .wished_gap = 350});
  add_beside(f, model_, item, table, Side::kBack, {.most = 700, .wished_gap = 350});
  for (std::size_t i = ends; i < f.cases.size(); ++i) f.cases[i].price += 150;  // there it may stand before the television
  for (Case& c : f.cases) {
    if (!c.wishes.empty()) c.wishes[0].weight = kBeside;
  }
  habit("round the low table", item, kBeside, std::move(f), {table});
  flank(item, table, 1);
}

void Habits::stand_before_middle(ItemId item, ItemId host) {
  Formula f;
  for_each_turn(model_.items[host], [&](int turn, std::uint64_t states) {
    const int along = side_direction(model_.items[host], Side::kRight, turn).axis;
    const double angle = model_.items[host].states[static_cast<std::size_t>(std::countr_zero(states))].angle;
    const auto heading = turn % 90 == 0 ? std::nullopt : signed_heading(model_, angle);
    if (const std::uint64_t turned = heading ? states_at_angle(model_.items[item], angle, 180) : 0) {
      f.add()
          .when(host, states)
          .when(item, turned)
          .wish(along2(model_, item, heading->heading) - along2(model_, host, heading->heading), kBeside, 2 * kHeading);
      return;
    }
    f.add()
        .when(host, states)
        .when(item, states_with_width_along(model_.items[item], along))
        .wish(mid2(item, along) - mid2(host, along), kBeside, 2);
  });
  habit("before the middle", item, kBeside, std::move(f), {host});
}

// Two of a kind by the same host stand one at each side, as far from its middle: nightstands, speakers, plants.
void Habits::flank(ItemId item, ItemId host, int hosts) {
  constexpr int kEven = 200;  // points a metre
  const int rank = rank_of(item);
  if (rank / hosts % 2 == 0) return;
  const auto is_twin = [&](ItemId one) { return model_.items[one].entry == model_.items[item].entry && rank_of(one) == rank - hosts; };
  const auto all = model_.items.ids();
  const ItemId twin = *std::ranges::find_if(all, is_twin);
  if (model_.items[twin].fixed || !only_near(twin, host)) return;
  Formula f;
  for_each_turn(model_.items[host], [&](int turn, std::uint64_t states) {
    const Direction right = side_direction(model_.items[host], Side::kRight, turn);
    for (const int sign : {1, -1}) {
      const auto beyond = [&](ItemId one, int towards) { return towards * (mid2(one, right.axis) - mid2(host, right.axis)); };
      Case& c = f.add().when(host, states).require(beyond(item, sign)).require(beyond(twin, -sign));
      c.wish(mid2(item, right.axis) + mid2(twin, right.axis) - 2 * mid2(host, right.axis), kEven, 2);
    }
  });
  habit("other side", item, kBeside, std::move(f), {host, twin});
}

}  // namespace layoutbox::placement
