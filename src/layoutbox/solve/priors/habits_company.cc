// Habits towards other things: beside, round, before and facing what they belong to.
#include <bit>

#include "layoutbox/solve/model/slanted.h"
#include "layoutbox/solve/priors/formation.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {

// Several of a kind before or behind one thing stand abreast: chairs behind a news desk, cameras before it.
bool Habits::stand_abreast(int item) {
  for (const Relation& r : model_.scene->relations) {
    const Item& self = model_.items[item];
    const bool free = !self.is(Trait::kTableSeat) && !self.entry->back_to_wall;
    const bool abreast = r.type == RelationType::kInFrontOf || r.type == RelationType::kBehind ||
                         (r.type == RelationType::kOpposite && free) ||
                         (r.type == RelationType::kFacing && free && !placed_besides_facing(item));
    if (r.references.size() != 1 || !abreast) continue;
    const int host = model_.find_item(r.references[0]);
    if (host >= 0 && related_as_target(item, host, r.type) && stand_abreast_of(item, host, r.type)) return true;
  }
  return false;
}

bool Habits::stand_abreast_of(int item, int host, RelationType how) {
  constexpr Mm kApart = 100, kOff = 600, kSeatOff = 50, kTalkingOff = 1800;
  constexpr std::size_t kMostAbreast = 3;
  const bool across_from = how == RelationType::kOpposite || how == RelationType::kFacing;
  const Item &self = model_.items[item], &ref = model_.items[host];
  const bool seat = self.is(Trait::kTableSeat);
  const bool window = ref.is_opening() && how == RelationType::kFacing && !self.is(Trait::kTable);
  const bool sided =
      window || (!ref.is_opening() && (ref.has_front || (seat && how == RelationType::kBehind)));  // a table's back is that of the room
  if (!sided || (seat && how == RelationType::kInFrontOf)) return false;
  std::vector<int> peers;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const int other = static_cast<int>(i);
    if (model_.items[i].entry == self.entry && related_as_target(other, host, how) &&
        only_related_by(other, host, {how, RelationType::kFacing, RelationType::kCenteredOn, across_from ? RelationType::kDistance : how}))
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

// What is told to stand next to something that is used from its front stands at its side: a plant beside the television, a cabinet beside
// the bed. On a table too, and not so close that they touch.
void Habits::stand_at_side(int item) {
  const Item& self = model_.items[item];
  if (self.is(Trait::kTableSeat) || before_its_host(item)) return;
  for (const Relation& r : model_.scene->relations) {
    if (r.type != RelationType::kNextTo || r.references.size() != 1) continue;
    const int host = model_.find_item(r.references[0]);
    if (host >= 0 && self.is(Trait::kEasySeat) && !model_.items[host].is(Trait::kBed)) continue;
    if (host < 0 || !related_as_target(item, host, r.type) || !only_related_by(item, host, {RelationType::kNextTo, RelationType::kNear}))
      continue;
    const Item& ref = model_.items[host];
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
    return;
  }
}

// By one of the greater things it goes with: a seat at its table, a nightstand beside its bed, a table before its sofa.
// NOLINTNEXTLINE(readability-function-cognitive-complexity): to be parted
bool Habits::stand_beside(int item) {
  constexpr Mm kLowAtFoot = 650;  // a bench, a chest: close to the bed; not a wardrobe
  const Item& self = model_.items[item];
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const int host = static_cast<int>(i);
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
  std::vector<int> hosts = usual_hosts(item);
  for (std::size_t i = 0; i < model_.items.size() && self.is(Trait::kTableSeat); ++i) {  // a potter's wheel
    const int other = static_cast<int>(i);
    const bool known = std::ranges::find(hosts, other) != hosts.end();
    if (!known && other != item && model_.items[i].is(Trait::kDeskLike) && model_.items[i].has_front && related(item, other))
      hosts.push_back(other);
  }
  if (hosts.empty()) return false;
  bool told = false;  // whom it stands by
  for (const int h : hosts) {
    if (!related(item, h) || only_related_by(item, h, {RelationType::kBetween}) || only_turned_by(item, h)) continue;
    if (self.is(Trait::kEasySeat) && model_.items[h].is(Trait::kCoffeeTable) && only_near(item, h)) continue;
    if (leaves_usual_place(item, h)) {
      hosts = {h}, told = true;
      break;
    }
    come_near(item, h);
    sit_facing(item, h);
    return true;
  }
  if (self.is(Trait::kTableSeat) && !told && placed_besides_facing(item))
    return false;  // told to stand elsewhere: chairs along the walls, in rows
  if (self.is(Trait::kEasySeat) && !told) {
    if (told_away_from_group(item)) return false;  // two by the fire do not draw the sofa there
    const std::vector<int> seen = items_of_kinds(self.entry->faces, item);
    const auto low_table = std::find_if(seen.begin(), seen.end(), [&](int i) { return model_.items[i].is(Trait::kCoffeeTable); });
    if (low_table != seen.end() && only_near(item, *low_table)) {
      sit_round_low_table(item, *low_table);
      return true;
    }
  }
  // A stool goes to the counter where the tables have their chairs.
  const auto is_seated = [&](int h) {
    return std::ranges::any_of(model_.scene->relations, [&](const Relation& r) {
      const int seat = r.targets.empty() ? -1 : model_.find_item(r.targets[0]);
      return seat >= 0 && model_.items[seat].is(Trait::kTableSeat) && model_.items[seat].entry != self.entry &&
             std::ranges::find(r.references, model_.items[h].id) != r.references.end();
    });
  };
  if (self.is(Trait::kTableSeat) && !told && !std::ranges::all_of(hosts, is_seated)) std::erase_if(hosts, is_seated);
  // Hosts of the best kind only: a lamp by the sofa rather than by the desk.
  std::erase_if(hosts, [&](int h) { return model_.items[h].entry != model_.items[hosts[0]].entry; });
  const int host = hosts[rank_of(item) % static_cast<int>(hosts.size())];
  const Item& ref = model_.items[host];
  if (self.is(Trait::kTableSeat) && self.has_front && ref.is(Trait::kDeskLike) && is_served_over(host)) {
    sit_behind_served(item, host);
    return true;
  }
  Formula f;
  const std::vector<Side> used = used_sides(ref);
  const bool sat_before =
      used.size() == 1 && used[0] == Side::kFront && ref.has_front && (ref.entry->back_to_wall || ref.is(Trait::kDeskLike));
  if (self.is(Trait::kTableSeat) && (has_knee_room(ref) || sat_before)) {
    const std::vector<int> seats = seats_at(item, host, static_cast<int>(hosts.size()));
    const auto k = std::find(seats.begin(), seats.end(), item) - seats.begin();
    add_seat_place(f, model_, item, host, static_cast<int>(k), static_cast<int>(seats.size()), kBeside);
    habit("at table", item, kBeside, std::move(f), {host});
    return true;
  }
  if (self.is(Trait::kTableSeat) && ref.is(Trait::kCounter) && ref.has_front) {  // at its front; who serves is behind
    const std::vector<int> seats = seats_at(item, host, static_cast<int>(hosts.size()));
    const auto k = std::find(seats.begin(), seats.end(), item) - seats.begin();
    add_seat_place(f, model_, item, host, static_cast<int>(k), static_cast<int>(seats.size()), kBeside);
    habit("at the counter", item, kBeside, std::move(f), {host});
    return true;
  }
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
  if (ref.has_front && !before_its_host(item) && !self.is(Trait::kTableSeat)) flank(item, host, static_cast<int>(hosts.size()));
  return true;
}

// Who works at a reception desk sits behind it, where the room for the knees is, and looks over it.
void Habits::sit_behind_served(int item, int host) {
  constexpr Mm kBetween = 200;
  const std::vector<int> seats = seats_at(item, host, 1);
  const auto k = std::ranges::find(seats, item) - seats.begin(), n = std::ssize(seats);
  const Mm pitch = model_.items[item].states[0].size.width + kBetween;
  Formula f;
  for_each_turn(model_.items[host], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction back = side_direction(model_.items[host], Side::kBack, turn);
    Case& c = f.add().when(host, states).when(item, states_looking(model_.items[item], opposite(back)));
    c.wish(mid2(item, across(back)) - mid2(host, across(back)) - Linear((2 * k - (n - 1)) * pitch), kBeside, 2);
    c.wish(gap_towards(item, host, back), kBeside);
  });
  habit("behind the desk", item, kBeside, std::move(f), {host});
}

// Told to stand by something that is not what one talks round: by the fire, at the window.
bool Habits::told_away_from_group(int item) const {
  if (!placed_besides_facing(item)) return false;
  const auto in_group = [&](const std::string& id) {
    const int other = model_.find_item(id);
    if (other < 0 || model_.items[other].is_opening()) return false;
    const Item& ref = model_.items[other];
    return ref.is(Trait::kCenterPiece) || ref.is(Trait::kEasySeat) || ref.is(Trait::kCoffeeTable) || ref.thin;
  };
  return std::ranges::none_of(model_.scene->relations, [&](const Relation& r) {
    return std::ranges::find(r.targets, model_.items[item].id) != r.targets.end() && std::ranges::any_of(r.references, in_group);
  });
}

// Easy chairs make a talking group: at the ends of the coffee table, looking at it, two of them face to face.
void Habits::sit_round_low_table(int item, int table) {
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

void Habits::stand_before_middle(int item, int host) {
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

// Two of a kind by the same host stand one at each side: nightstands, speakers, plants.
void Habits::flank(int item, int host, int hosts) {
  const int rank = rank_of(item);
  if (rank / hosts % 2 == 0) return;
  int twin = 0;
  while (model_.items[twin].entry != model_.items[item].entry || rank_of(twin) != rank - hosts) ++twin;
  if (model_.items[twin].fixed || !only_near(twin, host)) return;
  Formula f;
  for_each_turn(model_.items[host], [&](int turn, std::uint64_t states) {
    const Direction right = side_direction(model_.items[host], Side::kRight, turn);
    for (const int sign : {1, -1}) {
      const auto beyond = [&](int one, int towards) { return towards * (mid2(one, right.axis) - mid2(host, right.axis)); };
      f.add().when(host, states).require(beyond(item, sign)).require(beyond(twin, -sign));
    }
  });
  habit("other side", item, kBeside, std::move(f), {host, twin});
}

bool Habits::before_its_host(int item) const { return model_.items[item].is(Trait::kStandsBefore); }

// Its front to what it is for: sofas to screens, easy chairs to the table between. False: there is nothing of that.
bool Habits::look_at(int item, bool leads, const std::vector<int>& crowd) {
  const Item& self = model_.items[item];
  if (!self.has_front) return false;
  std::vector<int> seen = items_of_kinds(self.entry->faces, item);
  // Each has its own mirror before all others.
  std::ranges::stable_partition(seen, [&](int other) { return related_as_target(item, other, RelationType::kFacing); });
  // … and a visitor the bed that the chair is told to be at.
  if (self.is(Trait::kTableSeat)) std::ranges::stable_partition(seen, [&](int other) { return related(item, other); });
  if (self.is(Trait::kTableSeat)) std::erase_if(seen, [&](int other) { return !takes_seat(other, item) || waits_for(item, other); });
  for (const int seen_one : seen) {
    const int other = stand_of_screen(seen_one);
    if (model_.items[other].mount != Mount::kFloor && model_.items[other].mount != Mount::kWall && seen.size() > 1 && seen_one != seen[0])
      continue;
    Formula f;
    crowd.empty() ? add_looks_at(f, model_, item, other, looking_side(model_, item)) : add_looks_with_group(f, model_, item, crowd, other);
    if (self.is(Trait::kEasySeat) && !related(item, other) && !model_.items[seen_one].is(Trait::kScreen)) {
      for (Case& c : f.cases) {  // near enough to put a cup down
        for (int axis = 0; axis < 2; ++axis) c.wish(mid2(item, axis) - mid2(other, axis), 60, 2);
      }
    }
    // Told to flank the fireplace, it looks at the table before the sofa only as far as that goes.
    const bool elsewhere = self.is(Trait::kEasySeat) && placed_besides_facing(item) && !related(item, other);
    const bool after = self.is(Trait::kEasySeat) || (leads && !comes_after_screen(other, item)) || comes_after_screen(item, other);
    habit("faces", item, elsewhere || leaves_screen_to_others(item, seen_one) ? kFaces / 3 : kFaces, std::move(f),
          after ? std::vector<int>{other} : std::vector<int>{});
    if (model_.items[seen_one].is(Trait::kScreen)) stay_before_screen(item, other);
    if (self.is(Trait::kCenterPiece) && !self.is(Trait::kBed)) {
      if (model_.items[seen_one].is(Trait::kScreen)) watch_from_near(item, other);
      if (!model_.items[other].is(Trait::kCoffeeTable)) watch_past_tables(item, other);
    }
    return true;
  }
  return false;
}

}  // namespace layoutbox::placement
