// What the catalogue knows of good rooms: who has which habits, and what several of them ask.
#include <cmath>

#include "layoutbox/solve/priors/habits.h"

#include "layoutbox/catalog/measures.h"

namespace layoutbox::placement {
namespace {

// Does it speak of the two together?
bool ties(const Relation& relation, const std::string& one, const std::string& other) {
  const auto has = [](const std::vector<std::string>& ids, const std::string& id) { return std::ranges::find(ids, id) != ids.end(); };
  return (has(relation.targets, one) && has(relation.references, other)) || (has(relation.targets, other) && has(relation.references, one));
}

}  // namespace

Habits::Habits(PlacementModel& model) : model_(model), said_of_(model.items.size()) {
  for (const Relation& relation : model.scene->relations) {
    for (const auto* ids : {&relation.targets, &relation.references}) {
      for (const std::string& id : *ids) {
        const ItemId item = model.find_item(id);
        if (!item.exists()) continue;
        auto& said = said_of_[item];
        if (said.empty() || said.back() != &relation) said.push_back(&relation);
      }
    }
  }
}

void Habits::add(ItemId index) {
  const Item& item = model_.items[index];
  if (item.is_opening()) {
    open_well(index);
    return;
  }
  if (item.fixed) return;
  keep_hint(index);
  switch (item.mount) {
    case Mount::kCeiling: hang_from_ceiling(index); return;
    case Mount::kWall:
      hang_on_wall(index);
      if (index == board_of_room() && !placed_by_relation(index)) hang_on_blank_wall(index);
      return;
    case Mount::kSurface: sit_on_host(index), stand_at_side(index); return;
    case Mount::kHung: return;
    case Mount::kFloor: break;
  }
  if (item.thin) {
    lie_lengthwise(index);
    lie_beside(index);
    if (!stand_in_formation(index) && !placed_by_relation(index)) lie_under(index);
    return;
  }
  stand(index);
}

void Habits::stand(ItemId index) {
  const Item& item = model_.items[index];
  sit_on_host(index);
  lie_straight(index);
  lie_along_window(index);
  stand_near_door(index);
  stand_at_back_of_seat(index);
  keep_before_counter(index);
  wait_before_counter(index);
  face_entrance(index);
  keep_off_play(index);
  keep_off_sofas(index);
  keep_off_other_tables(index);
  keep_off_beds(index);
  keep_hall_free(index);
  keep_off_sitters_rug(index);
  stand_across(index);
  stay_under_loft(index);
  share_wall_out(index);
  lie_alike(index);
  if (sit_before_mirror(index) && !placed_by_relation(index)) return;
  if (stand_in_formation(index) || stand_abreast(index) || sit_by_fire(index) || sit_to_talk(index)) return;
  stand_at_side(index);
  if (stand_before_waiting(index)) return;
  const bool with_host = sit_by_between(index) || stand_beside(index);
  const bool looks = (!with_host || !item.is(Trait::kTableSeat)) && look_at(index);
  // Nobody sits with the nose to a wall.
  if (item.is(Trait::kSeat) && !looks && !(with_host && item.is(Trait::kTableSeat))) open_to_room(index);
  stand_abreast_in_row(index);
  const bool manned = leave_room_behind(index);
  if (manned) {
    // Who sits behind it has the wall behind.
  } else if (is_window_bar(index)) {
    stand_at_window(index);
  } else if (item.entry->back_to_wall) {
    // The nightstands of a bed in the middle of the room stay beside it.
    const std::vector<ItemId> hosts = with_host ? usual_hosts(index) : std::vector<ItemId>{};
    const bool by_free = std::ranges::any_of(hosts, [&](ItemId host) { return related(index, host) && told_to_stand_free(host); });
    if (!by_free && !told_to_stand_free(index)) back_to_wall(index, kBackToWall);
    stand_in_run(index);
    stand_in_table_axis(index);
    if (!stand_behind_server(index) && !stand_as_twin(index) && !with_host) stand_in_wall_row(index);
  } else if (!with_host && only_told_opening(index) && !item.is(Trait::kSeat) && !item.is(Trait::kEasySeat) && !has_sitters(index)) {
    stand_at_wall(index);
  } else if (!with_host && !placed_by_relation(index)) {
    stand_by_itself(index, looks);
  }
  if (looks && item.is(Trait::kEasySeat) && !with_host && !placed_by_relation(index) && !item.entry->back_to_wall &&
      only_sees_screen(index))
    back_to_wall(index, kAtWall);
  if (!item.entry->back_to_wall && item.is(Trait::kSeat) && item.has_front && !with_host) stand_in_wall_row(index);
  keep_nose_free(index);
  keep_nose_off_walls(index);
  const bool is_worked_at = item.is(Trait::kTable) || item.is(Trait::kCounter) || item.is(Trait::kDeskLike);
  if (!item.entry->back_to_wall && item.is(Trait::kOpenToRoom) && !is_window_bar(index) && !(is_worked_at && stand_along_run(index)))
    open_to_room(index, is_worked_at ? kAtWall : kFaces), leave_seat_behind(index);
  if (item.is(Trait::kDesk) && !item.is(Trait::kOpenToRoom)) near_light(index);
}

// What goes with nothing, and is told no place.
void Habits::stand_by_itself(ItemId index, bool looks) {
  const Item& item = model_.items[index];
  const bool alone = is_sat_at_alone(index);
  const bool all_round = used_sides(item).size() >= 4 && !item.is(Trait::kSeat) && rank_of(index) == 0 && !alone;
  if (all_round && (has_sitters(index) || (!middle_is_taken(index) && !is_low_aside(index)))) {
    if (!middle_is_taken(index)) stand_in_middle(index);
  } else if (item.is(Trait::kSeat) && item.has_front && !looks && !item.object->hint.position) {
    back_to_wall(index, kSeatToWall);
  } else {
    stand_at_wall(index);
    if (alone) near_light(index);
  }
}

Constraint& Habits::habit(const std::string& what, ItemId item, int weight, Formula formula, std::vector<ItemId> hosts) {
  Constraint& c = model_.constraints.emplace_back();
  c.name = what + ": " + model_.items[item].id;
  c.firmness = Firmness::kSoft;
  c.weight = weight;
  c.formulas.push_back(std::move(formula));
  c.hosts = std::move(hosts);
  return c;
}

std::vector<ItemId> Habits::items_of_kinds(const std::vector<std::string>& kinds, ItemId except) const {
  std::vector<ItemId> found;
  for (const std::string& kind : kinds) {
    for (const ItemId index : model_.items.ids()) {
      if (index != except && model_.is_a(index, kind) && std::find(found.begin(), found.end(), index) == found.end())
        found.push_back(index);
    }
  }
  return found;
}

// The how-manieth of its kind this is.
int Habits::rank_of(ItemId item) const {
  int rank = 0;
  for (const ItemId i : ids_before(item)) rank += model_.items[i].entry == model_.items[item].entry;
  return rank;
}

// Does a relation of the scene already say how these two stand to each other?
bool Habits::related(ItemId a, ItemId b) const {
  return std::ranges::any_of(said_of(a), [&](const Relation* r) { return ties(*r, model_.items[a].id, model_.items[b].id); });
}

bool Habits::related_by_any(ItemId a, ItemId b, RelationSet types) const {
  return std::ranges::any_of(said_of(a),
                             [&](const Relation* r) { return types.has(r->type) && ties(*r, model_.items[a].id, model_.items[b].id); });
}

bool Habits::only_related_by(ItemId a, ItemId b, RelationSet types) const {
  return std::ranges::none_of(said_of(a),
                              [&](const Relation* r) { return !types.has(r->type) && ties(*r, model_.items[a].id, model_.items[b].id); });
}

bool Habits::related_as_target(ItemId item, ItemId reference, RelationType type) const {
  const std::string &x = model_.items[item].id, &y = model_.items[reference].id;
  return std::ranges::any_of(said_of(item), [&](const Relation* r) {
    return r->type == type && std::ranges::find(r->targets, x) != r->targets.end() &&
           std::ranges::find(r->references, y) != r->references.end();
  });
}

bool Habits::placed_by_relation(ItemId item) const {
  return std::ranges::any_of(said_of(item),
                             [&](const Relation* r) { return std::ranges::find(r->targets, model_.items[item].id) != r->targets.end(); });
}

// A table for children or toys that nobody there sits at, beside the sofa's group: not in the middle of it.
bool Habits::is_low_aside(ItemId item) const {
  const Item& self = model_.items[item];
  return self.is(Trait::kTable) && !self.is(Trait::kCoffeeTable) && self.states[0].size.height < measures().sat_at_from;
}

// Is a door or window all that it is told to be by? Then it stands at the wall there, a coat stand or a cat tree, not in the way.
bool Habits::only_told_opening(ItemId item) const {
  bool told = false;
  for (const Relation& r : model_.scene->relations) {
    if (std::ranges::find(r.targets, model_.items[item].id) == r.targets.end()) continue;
    const bool opening = std::ranges::all_of(r.references, [&](const std::string& id) {
      const ItemId other = model_.find_item(id);
      return other.exists() && model_.items[other].is_opening();
    });
    if (!traits_of(r.type).close_by || !opening) return false;
    told = true;
  }
  return told;
}

// Told to be in the middle or off the walls, or to part two groups.
bool Habits::told_to_stand_free(ItemId item) const {
  if (divided_by(item)) return true;
  return std::ranges::any_of(model_.scene->relations, [&](const Relation& r) {
    return (r.type == RelationType::kCenterOfRoom || r.type == RelationType::kAwayFromWall) &&
           std::ranges::find(r.targets, model_.items[item].id) != r.targets.end();
  });
}

void Habits::keep_hint(ItemId item) {
  const SceneObject& object = *model_.items[item].object;
  if (!model_.start.empty() && model_.start[item].state >= 0) return;  // an earlier layout says more
  if (object.hint.rotation_deg) keep_turn(item, *object.hint.rotation_deg);
  if (!object.hint.position) return;
  Formula f;
  Case& c = f.add();
  for (int axis = 0; axis < 2; ++axis) {
    c.wish(mid2(item, axis) - Linear(std::lround(2 * (*object.hint.position)[axis])), kHint, 2);
  }
  habit("hint", item, kHint, std::move(f));
}

// The scene's own turn holds before everything that makes rooms good, unless what is asked for says otherwise; it is no part of the score.
void Habits::keep_turn(ItemId item, double degrees) {
  const Item& self = model_.items[item];
  const bool square = self.states[0].size.width == self.states[0].size.depth;
  std::uint64_t states = 0;
  for (std::size_t s = 0; s < self.states.size(); ++s) {
    const double off = std::remainder(self.states[s].angle - degrees, self.has_front ? 360 : square ? 90 : 180);
    if (std::abs(off) < 0.5) states |= std::uint64_t{1} << s;
  }
  if (!states) return;
  Formula f;
  f.add().when(item, states);
  habit("hint of turn", item, kHintOfTurn, std::move(f)).stay = true;
}

void add_habits(PlacementModel& model) {
  Habits habits(model);
  for (const ItemId i : model.items.ids()) habits.add(i);
  habits.spread();
}

}  // namespace layoutbox::placement
