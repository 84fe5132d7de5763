// Habits of seats at desks, tables and counters, and what a relation leaves open between things that belong together.
#include "layoutbox/catalog/measures.h"
#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/solve/priors/formation.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {

bool Habits::only_turned_by(ItemId item, ItemId host) const {
  return only_related_by(item, host, relations_that<&RelationTraits::turns>());
}

bool Habits::only_near(ItemId item, ItemId host) const {
  return only_related_by(item, host, RelationSet(RelationType::kNear) | relations_that<&RelationTraits::turns>());
}

// Does one sit there on such a seat? Not on a chair at a children's table, nor at a coffee table, where nobody says so.
bool Habits::takes_seat(ItemId host, ItemId seat) const {
  const Item &table = model_.items[host], &self = model_.items[seat];
  if (related(seat, host) || !table.is(Trait::kTable)) return true;
  return table.states[0].size.height >= measures().sat_at_from || self.states[0].size.height <= measures().low_seat_to;
}

// The greater things that it usually stands by.
std::vector<ItemId> Habits::usual_hosts(ItemId item) const {
  const Item& self = model_.items[item];
  std::vector<ItemId> hosts = items_of_kinds(self.entry->beside, item);
  std::erase_if(hosts, [&](ItemId h) { return model_.items[h].thin || area_of(model_.items[h]) <= area_of(self); });
  if (!self.is(Trait::kTableSeat)) return hosts;
  std::erase_if(hosts, [&](ItemId h) { return !takes_seat(h, item) || waits_for(item, h); });
  // Rather where there is room for the knees: at the desk, not at the table that one stands round.
  const auto no_knees = [&](ItemId h) { return model_.items[h].is(Trait::kTable) && !has_knee_room(model_.items[h]) && !related(item, h); };
  if (!std::ranges::all_of(hosts, no_knees)) std::erase_if(hosts, no_knees);
  return hosts;
}

// … and what words put it at, or have it look at from a seat.
std::vector<ItemId> Habits::hosts_beside(ItemId item) const {
  const Item& self = model_.items[item];
  std::vector<ItemId> hosts = usual_hosts(item);
  for (const ItemId other : model_.items.ids()) {
    if (!self.is(Trait::kTableSeat)) break;
    const Item& ref = model_.items[other];
    if (other == item || ref.is_opening() || std::ranges::find(hosts, other) != hosts.end()) continue;
    const bool worked_at = ref.is(Trait::kDeskLike) && ref.has_front && related(item, other);  // a potter's wheel
    // "A swivel chair faces the table": whoever looks at a table from such a seat sits at it.
    const bool faced = ref.is(Trait::kTable) && has_knee_room(ref) && related_as_target(item, other, RelationType::kFacing) &&
                       only_turned_by(item, other) && !ref.is(Trait::kCoffeeTable);
    if (worked_at || faced) hosts.push_back(other);
  }
  return hosts;
}

// Do the relations between these two only say that it is by the host, so that it may stand where its kind usually does? "Near the desk"
// a chair stands before it; "to the left of the bed" a nightstand stands beside the pillow.
bool Habits::leaves_usual_place(ItemId item, ItemId host) const {
  const Item& self = model_.items[item];
  if (self.is(Trait::kEasySeat) || model_.items[host].is_opening()) return false;
  const RelationSet by_it = relations_that<&RelationTraits::close_by>() | relations_that<&RelationTraits::turns>();
  if (self.is(Trait::kTableSeat) || before_its_host(item)) return only_related_by(item, host, by_it);
  return only_related_by(item, host, by_it | relations_that<&RelationTraits::sideways>() | RelationSet(RelationType::kEachSideOf));
}

// What a relation leaves open between things that belong together: a chair stands close to its desk, a bench along the bed's foot.
void Habits::come_near(ItemId item, ItemId host) {
  const Item &self = model_.items[item], &ref = model_.items[host];
  const bool at_desk = self.is(Trait::kTableSeat) && has_knee_room(ref) && ref.has_front && used_side(ref) == Side::kFront &&
                       only_related_by(item, host, RelationSet(RelationType::kInFrontOf, RelationType::kFacing, RelationType::kCenteredOn));
  const bool at_foot = only_related_by(item, host, RelationSet(RelationType::kAtFootOf, RelationType::kParallel));
  const bool before = before_its_host(item) && ref.has_front &&
                      only_related_by(item, host, RelationSet(RelationType::kInFrontOf, RelationType::kCenteredOn));
  if (!at_desk && !at_foot && !before) return;
  const Mm wished = before ? measures().footstool_before : at_foot ? measures().bench_at_foot : measures().chair_at_desk;
  Formula f;
  for_each_turn(ref, [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(ref, Side::kFront, turn);
    Case& c = f.add().when(host, states).wish(gap_towards(item, host, front) - Linear(wished), kBeside);
    if (at_foot || before) c.when(item, states_with_width_along(self, across(front)));
    if (at_foot) c.wish(mid2(item, across(front)) - mid2(host, across(front)), kBeside, 2);
  });
  if (ref.spans >= 0 && ref.odd_states != 0) {
    const std::size_t known = f.cases.size();
    add_beside(f, model_, item, host, Side::kFront, {.most = 1500, .wished_gap = wished, .ref_states = ref.odd_states});
    for (std::size_t i = known; i < f.cases.size(); ++i) f.cases[i].wishes[0].weight = kBeside;
  }
  habit("near", item, kBeside, std::move(f), {host});
}

// Who sits beside a bed, a bookcase or a machine does not have it before the knees: the visitor's chair looks past the bed, or stands off
// it.
void Habits::keep_nose_free(ItemId item) {
  constexpr int kFree = 300;  // points a metre
  const Item& self = model_.items[item];
  if (!self.has_front || (!self.is(Trait::kSeat) && !self.is(Trait::kEasySeat))) return;
  const RelationSet beside_it =
      relations_that<&RelationTraits::close_by>() | relations_that<&RelationTraits::sideways>() | RelationSet(RelationType::kAtFootOf);
  for (const ItemId host : model_.items.ids()) {
    const Item& ref = model_.items[host];
    if (host == item || ref.is_opening() || ref.mount != Mount::kFloor || ref.thin || has_knee_room(ref)) continue;
    if (!ref.entry->back_to_wall || ref.is(Trait::kTable) || ref.is(Trait::kDeskLike) || ref.is(Trait::kCounter)) continue;
    const bool beside = related_by_any(item, host, beside_it);
    // … and the visitor by the window has the bed before them that such chairs look at.
    const bool faced =
        ref.is(Trait::kBed) && std::ranges::any_of(self.entry->faces, [&](const std::string& kind) { return model_.is_a(host, kind); });
    if (!beside && !faced) continue;
    Formula f;
    for_each_turn(self, [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      const Direction front = side_direction(self, Side::kFront, turn);
      f.add().when(item, states).require(gap_towards(host, item, front) - Linear(measures().knees_free));
      for (const Direction past : {opposite(front), Direction{across(front), 1}, Direction{across(front), -1}})
        f.add().when(item, states).require(gap_towards(host, item, past));
    });
    habit("room for the knees", item, kFree, std::move(f));
  }
}

// … nor a wall, be it that what one sits at is between.
void Habits::keep_nose_off_walls(ItemId item) {
  constexpr int kFree = 1000;  // points a metre; more than the free floor that is wanted behind a chair
  const Item& self = model_.items[item];
  if (!self.has_front || (!self.is(Trait::kSeat) && !self.is(Trait::kEasySeat))) return;
  const bool told_to_look = std::ranges::any_of(said_of(item), [&](const Relation* r) {
    const ItemId other = r->references.size() == 1 ? model_.find_item(r->references[0]) : ItemId();
    return traits_of(r->type).turns && (!other.exists() || model_.items[other].is_opening());
  });
  if (told_to_look) return;
  const std::vector<ItemId> hosts = hosts_beside(item);
  const ItemId host = hosts.empty() ? ItemId() : told_host(item, hosts).value_or(hosts[0]);
  Formula f;
  for_each_turn(self, [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(self, Side::kFront, turn);
    const Mm edge = front.sign > 0 ? model_.room.hi[front.axis] : model_.room.lo[front.axis];
    f.add().when(item, states).require(Linear(std::int64_t{front.sign} * edge) - reach(item, front) - Linear(measures().knees_free));
    if (host.exists()) f.add().when(item, states).require(reach(host, front) - reach(item, front) - Linear(1));
  });
  if (!f.cases.empty()) habit("nose off the wall", item, kFree, std::move(f));
}

// Seats with a table between them draw up to it.
bool Habits::sit_by_between(ItemId item) {
  const Item& self = model_.items[item];
  if (!self.is(Trait::kSeat) && !self.is(Trait::kEasySeat)) return false;
  for (const Relation& r : model_.scene->relations) {
    if (r.type != RelationType::kBetween || r.references.size() != 2 || std::ranges::find(r.references, self.id) == r.references.end())
      continue;
    const ItemId middle = r.targets.empty() ? ItemId() : model_.find_item(r.targets[0]);
    if (!middle.exists() || model_.items[middle].mount != Mount::kFloor || model_.items[middle].thin) continue;
    Formula f;
    for (const int axis : {0, 1}) {
      for (const int sign : {1, -1}) {
        f.add()
            .wish(gap_towards(item, middle, {axis, sign}) -
                      Linear(self.is(Trait::kTableSeat) ? measures().chair_to_table : measures().easy_seat_to_table),
                  kBeside)
            .wish(mid2(item, 1 - axis) - mid2(middle, 1 - axis), kBeside / 2, 2)
            .require(gap_towards(item, middle, {axis, sign}));
      }
    }
    habit("by what is between", item, kBeside, std::move(f));
    return true;
  }
  return false;
}

// A seat told to stand somewhere by its desk or table looks at it, where nothing is said of that.
void Habits::sit_facing(ItemId item, ItemId host) {
  const Item& self = model_.items[item];
  if (!self.is(Trait::kTableSeat) || !self.has_front || model_.items[host].is_opening()) return;
  const bool told = std::any_of(model_.scene->relations.begin(), model_.scene->relations.end(), [&](const Relation& r) {
    const RelationTraits& traits = traits_of(r.type);
    const bool turns = traits.turns || traits.around || r.type == RelationType::kTuckedUnder || r.type == RelationType::kOpposite;
    return turns && std::find(r.targets.begin(), r.targets.end(), self.id) != r.targets.end();
  });
  if (told) return;
  Formula f;
  add_looks_at(f, model_, item, host);
  // Behind it one sits to work: sideways there, for want of room, nobody does.
  habit("faces", item, related_as_target(item, host, RelationType::kBehind) ? 2 * kFaces : kFaces, std::move(f), {host});
}

bool Habits::told_short_side(ItemId item, ItemId host) const {
  const auto names = [](const std::vector<std::string>& ids, const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  return std::any_of(model_.scene->relations.begin(), model_.scene->relations.end(), [&](const Relation& r) {
    return r.type == RelationType::kAlongSide && names(r.targets, model_.items[item].id) && names(r.references, model_.items[host].id) &&
           or_default(r, &RelationParameters::side) != Side::kLong;
  });
}

// Several seats before a counter or a long desk share its width out. False: it is the only one.
bool Habits::sit_in_row(ItemId item, ItemId host, RelationType how) {
  const RelationSet in_front(how, RelationType::kFacing, RelationType::kCenteredOn, RelationType::kEachSideOf);
  const bool along = how == RelationType::kAlongSide;
  if (model_.items[host].is_opening()) return false;
  if (!model_.items[item].is(Trait::kTableSeat) || (!along && !model_.items[host].has_front)) return false;
  const bool at_end = along && told_short_side(item, host);
  std::vector<ItemId> seats;
  for (const ItemId other : model_.items.ids()) {
    if (model_.items[other].entry == model_.items[item].entry && related_as_target(other, host, how) &&
        only_related_by(other, host, in_front) && !(along && told_short_side(other, host) != at_end))
      seats.push_back(other);
  }
  const auto k = std::find(seats.begin(), seats.end(), item) - seats.begin();
  if (seats.size() < 2 || k == static_cast<std::ptrdiff_t>(seats.size())) return false;
  Formula f;
  // What stands free has seats at both of its long sides, though one mostly works at its front.
  const bool both = along && (!model_.items[host].has_front || (told_to_stand_free(host) && !model_.items[host].is(Trait::kCounter)));
  const SeatSides sides = at_end ? SeatSides::kEnds : both ? SeatSides::kLong : SeatSides::kUsed;
  add_seat_place(f, model_, item, host, static_cast<int>(k), static_cast<int>(seats.size()), kBeside, sides);
  habit("in a row before it", item, kBeside, std::move(f), {host});
  return true;
}

// All of the item's kind that no relation ties to the host, nor to another such one, and that share it.
std::vector<ItemId> Habits::seats_at(ItemId item, ItemId host, int hosts) const {
  const auto told_elsewhere = [&](ItemId seat) {
    const std::optional<ItemId> told = told_host(seat, hosts_beside(seat));
    return told && *told != host;
  };
  std::vector<ItemId> seats;
  for (const ItemId other : model_.items.ids()) {
    if (other != item && model_.items[other].entry == model_.items[item].entry && told_elsewhere(other)) continue;
    const bool alike = model_.items[other].entry == model_.items[item].entry && rank_of(other) % hosts == rank_of(item) % hosts;
    if (other == item || (alike && (!related(other, host) || leaves_usual_place(other, host)))) seats.push_back(other);
  }
  return seats;
}

// The seat that words put by it; of several each has its screen.
ItemId Habits::seat_told_to_be_at(ItemId host, int rank) const {
  std::vector<ItemId> seats;
  for (const ItemId other : model_.items.ids()) {
    if (other != host && model_.items[other].is(Trait::kTableSeat) && model_.items[other].has_front && related(other, host))
      seats.push_back(other);
  }
  return seats.empty() ? ItemId() : seats[static_cast<std::size_t>(rank) % seats.size()];
}

// Is a seat, be it a stool without a front, told to be behind it?
bool Habits::is_sat_behind(ItemId host) const {
  for (const ItemId i : model_.items.ids()) {
    const bool seat = model_.items[i].is(Trait::kSeat) || model_.items[i].is(Trait::kTableSeat);
    if (seat && related_as_target(i, host, RelationType::kBehind)) return true;
  }
  return false;
}

// A screen looks at who sits before it, whichever side of the desk that is.
void Habits::look_at_user(ItemId item, ItemId user) {
  Formula f;
  for_each_turn(model_.items[user], [&](int turn, std::uint64_t states) {
    const int square = turn / 90 * 90;
    if (const std::uint64_t facing = model_.items[item].states_at((square + 180) % 360)) f.add().when(user, states).when(item, facing);
  });
  if (!f.cases.empty()) habit("looks at its user", item, kFaces, std::move(f), {user});
}

}  // namespace layoutbox::placement
