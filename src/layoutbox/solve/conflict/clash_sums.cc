// Sums that show at once that something cannot be.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/solve/conflict/clash_words.h"
#include "layoutbox/solve/conflict/conflict.h"
#include "layoutbox/solve/conflict/fixed.h"
#include "layoutbox/solve/conflict/floor_sum.h"
#include "layoutbox/solve/model/items.h"

namespace layoutbox::placement {
namespace {

// The least an object can measure along its width or depth.
Mm least_width(const Item& item) { return item.object->size->least.width; }

// Relations without a single case: left of itself, in a thing that has no inside.
void add_never(const PlacementModel& model, const Scope& scope, std::vector<Clash>& out) {
  for (const ConstraintId c : model.constraints.ids()) {
    const Constraint& constraint = model.constraints[c];
    if (!constraint.relation.exists() || constraint.firmness != Firmness::kHard || scope.gives_up(c)) continue;
    const auto never = [](const Formula& f) { return f.cases.empty() && f.exact; };
    if (std::none_of(constraint.formulas.begin(), constraint.formulas.end(), never)) continue;
    Clash clash;
    clash.demands.push_back(Demand::of(c));
    clash.sentence = fmt::format("it can never be that {}", relation_in_words(model, model.relation(constraint.relation)));
    out.push_back(std::move(clash));
  }
}

void add_too_large(const PlacementModel& model, const Scope& scope, std::vector<Clash>& out) {
  for (const ItemId i : model.items.ids()) {
    const Item& item = model.items[i];
    if (item.is_opening() || item.fixed || scope.leaves_out(i)) continue;
    const auto fits = [&](const State& s) {
      return s.extent[0] <= model.room.extent(0) && s.extent[1] <= model.room.extent(1) && s.extent[2] <= model.room.extent(2);
    };
    if (std::any_of(item.states.begin(), item.states.end(), fits)) continue;
    Clash clash;
    clash.demands.push_back(Demand::of_item(i));
    clash.sentence = fmt::format("{} measures at least {} and does not fit into the room, which measures {}", object_in_words(model, i),
                                 sizes_in_words(item), room_in_words(model));
    out.push_back(std::move(clash));
  }
}

// Do these things surely fit into the room side by side, wherever they please? Steinberg's theorem on packing rectangles.
bool surely_fit(const PlacementModel& model, const std::vector<ItemId>& items) {
  std::int64_t widest = 0, deepest = 0, area = 0;
  for (const ItemId i : items) {
    const State& state = model.items[i].states[0];
    widest = std::max<std::int64_t>(widest, state.extent[0]), deepest = std::max<std::int64_t>(deepest, state.extent[1]);
    area += std::int64_t{state.extent[0]} * state.extent[1];
  }
  const std::int64_t w = model.room.extent(0), d = model.room.extent(1);
  const std::int64_t lost = std::max<std::int64_t>(2 * widest - w, 0) * std::max<std::int64_t>(2 * deepest - d, 0);
  return model.outside.empty() && widest <= w && deepest <= d && 2 * area <= w * d - lost;
}

// What stands with its back to one wall because of a relation.
struct AtWall {
  ItemId item;
  ConstraintId constraint;
  Mm width;  // the least
};

// The relation that puts its targets at that wall and no other; null: that constraint is another or given up.
const Relation* puts_at_wall(const PlacementModel& model, ConstraintId constraint, WallId wall, const Scope& scope) {
  const Constraint& one = model.constraints[constraint];
  if (!one.relation.exists() || one.firmness != Firmness::kHard || scope.gives_up(constraint)) return nullptr;
  const Relation& relation = model.relation(one.relation);
  return traits_of(relation.type).back_to_wall && relation.references.size() == 1 && model.find_wall(relation.references[0]) == wall
             ? &relation
             : nullptr;
}

// The widest first.
std::vector<AtWall> things_at_wall(const PlacementModel& model, WallId wall, const Scope& scope) {
  std::vector<AtWall> things;
  for (const ConstraintId c : model.constraints.ids()) {
    const Relation* relation = puts_at_wall(model, c, wall, scope);
    if (relation == nullptr) continue;
    for (const std::string& id : relation->targets) {
      const ItemId item = model.find_item(id);
      if (!item.exists() || scope.leaves_out(item) || !covers_floor(model.items[item]) || !model.items[item].has_front) continue;
      const bool known = std::any_of(things.begin(), things.end(), [&](const AtWall& one) { return one.item == item; });
      if (!known) things.push_back({item, c, least_width(model.items[item])});
    }
  }
  std::stable_sort(things.begin(), things.end(), [](const AtWall& a, const AtWall& b) { return a.width > b.width; });
  return things;
}

Clash too_wide(const PlacementModel& model, const RoomWall& wall, const std::vector<AtWall>& things) {
  Clash clash;
  std::vector<std::string> words;
  std::vector<ItemId> items;
  for (const AtWall& one : things) items.push_back(one.item);
  clash.minimal = surely_fit(model, items);  // else the room may be too small for them whatever the wall
  for (const AtWall& one : things) {
    clash.demands.push_back(Demand::of_item(one.item));
    const Demand relation = Demand::of(one.constraint);
    if (std::find(clash.demands.begin(), clash.demands.end(), relation) == clash.demands.end()) clash.demands.push_back(relation);
    words.push_back(fmt::format("{} ({})", object_in_words(model, one.item), metres(one.width)));
  }
  const char* verb = things.size() == 1 ? "stands" : things.size() == 2 ? "both stand" : "all stand";
  const Mm sum = std::accumulate(things.begin(), things.end(), 0, [](Mm s, const AtWall& one) { return s + one.width; });
  const Mm missing = std::max(sum - (wall.hi - wall.lo), 10);
  clash.sentence = fmt::format("{} {} against {}, which is {} long, {} too little", listed(words), verb,
                               wall_in_words(wall, model.walls.size() == 4), metres(wall.hi - wall.lo), metres(missing));
  return clash;
}

// Backs against one wall side by side: the widths add up.
void add_too_wide(const PlacementModel& model, const Scope& scope, std::vector<Clash>& out) {
  for (const WallId w : model.walls.ids()) {
    const RoomWall& wall = model.walls[w];
    std::vector<AtWall> things = things_at_wall(model, w, scope);
    const auto length = static_cast<Mm>(std::ceil(std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y)));
    std::int64_t sum = 0;
    std::size_t needed = 0;
    while (needed < things.size() && sum <= length) sum += things[needed++].width;
    if (sum <= length) continue;
    things.resize(needed);
    out.push_back(too_wide(model, wall, things));
  }
}

// Of things that may stand under one another only the larger counts: what is left surely covers its outline alone.
void keep_apart(const PlacementModel& model, std::vector<std::pair<std::int64_t, ItemId>>& areas) {
  std::vector<std::pair<std::int64_t, ItemId>> apart;
  for (const auto& one : areas) {
    const auto shares = [&](const auto& other) { return model.pair(one.second, other.second) == PairRule::kSolids; };
    if (std::none_of(apart.begin(), apart.end(), shares)) apart.push_back(one);
  }
  areas = std::move(apart);
}

void add_too_much(const PlacementModel& model, const Scope& scope, std::vector<Clash>& out) {
  std::vector<std::pair<std::int64_t, ItemId>> areas;
  const FloorSum floor = floor_sum(model, scope);
  for (const ItemId i : floor.items) {
    if (!model.items[i].fixed) areas.push_back({least_area(model.items[i]), i});
  }
  std::stable_sort(areas.begin(), areas.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  keep_apart(model, areas);
  const std::int64_t room = floor.room;
  // In a rectangular room what is free before a door lies within the room wherever in its walls the door is.
  const bool rectangular = model.outside.empty();
  std::int64_t sum = 0, before_door = rectangular ? floor.before_door : 0;
  ItemId door = rectangular ? floor.door : ItemId();
  Clash clash;
  std::vector<ItemId> items;
  const std::int64_t all =
      std::accumulate(areas.begin(), areas.end(), std::int64_t{0}, [](std::int64_t s, const auto& a) { return s + a.first; });
  if (all > room) door = {}, before_door = 0;
  for (const auto& [area, item] : areas) {
    if (sum + before_door > room) break;
    sum += area;
    clash.demands.push_back(Demand::of_item(item));
    items.push_back(item);
  }
  if (sum + before_door <= room) return;
  clash.minimal = false;  // by the sum alone: it says nothing of how the rest would fit
  std::string door_words;
  if (door.exists()) {
    clash.demands.push_back(Demand::of_item(door));
    clash.demands.push_back(Demand::of(model.items[door].clearance_constraint));
    door_words = fmt::format(", {} keeps {:.2f} m² free before it", object_in_words(model, door), static_cast<double>(before_door) / 1e6);
  }
  clash.sentence = fmt::format("{} cover{} at least {:.2f} m² of floor{}, and the room has {:.2f} m², {:.2f} m² less",
                               things_in_words(model, items), items.size() == 1 ? "s" : "", static_cast<double>(sum) / 1e6, door_words,
                               static_cast<double>(room) / 1e6, std::max(static_cast<double>(sum + before_door - room) / 1e6, 0.01));
  out.push_back(std::move(clash));
}

}  // namespace

std::vector<Clash> clashes_by_sums(const PlacementModel& model, const Scope& scope) {
  std::vector<Clash> out = clashes_of_fixed(model, scope);
  add_never(model, scope, out);
  add_too_large(model, scope, out);
  add_too_wide(model, scope, out);
  if (out.empty()) add_too_much(model, scope, out);
  return out;
}

}  // namespace layoutbox::placement
