#include "layoutbox/solve/model/to_layout.h"
#include "layoutbox/scene/relation_traits.h"

#include <cmath>

#include "layoutbox/solve/objective/cost.h"
#include "layoutbox/solve/priors/guide.h"

namespace layoutbox::placement {
namespace {

// It speaks of something that is not there.
bool option_missing(const SupportOption& option, const Placements& placements) {
  const bool other = option.kind == SupportOption::Kind::kItem || option.kind == SupportOption::Kind::kSill;
  return other && placements[option.item].state < 0;
}

// Do the scene's words say that it is held by that?
bool is_said(const PlacementModel& model, const std::string& id, const std::string& holder) {
  return std::any_of(model.scene->relations.begin(), model.scene->relations.end(), [&](const Relation& r) {
    const bool holds = traits_of(r.type).supports || r.type == RelationType::kOnWall;
    const auto has = [](const std::vector<std::string>& ids, const std::string& one) {
      return std::find(ids.begin(), ids.end(), one) != ids.end();
    };
    return holds && has(r.targets, id) && has(r.references, holder);
  });
}

std::string name_of_support(const PlacementModel& model, const SupportOption& option) {
  switch (option.kind) {
    case SupportOption::Kind::kFloor: return "floor";
    case SupportOption::Kind::kCeiling: return "ceiling";
    case SupportOption::Kind::kWall: return model.walls[option.wall].id;
    default: return model.items[option.item].id;
  }
}

// What was not moved keeps the very numbers it had: the solver's are whole millimetres and degrees.
void keep_exactly(const PlacementModel& model, ItemId index, const Placements& placements, PlacedObject& out) {
  if (!unmoved(model, index, placements)) return;
  if (const PlacedObject* earlier = model.from ? model.from->find_object(out.id) : nullptr) {
    if (earlier->size != out.size) return;
    for (int k = 0; k < 2; ++k) out.position[k] = earlier->position[k];
    out.rotation_deg = earlier->rotation_deg;
  }
}

// What holds a thing is one thing: where words name two that both could, one of them is not so.
bool support_agrees(const PlacementModel& model, const Relation& relation, const Layout& layout) {
  const auto holder_of = [&](const std::string& id) {
    const PlacedObject* object = layout.find_object(id);
    return object ? object->supported_by : std::string();
  };
  const auto held_by = [&](const std::string& id, const std::string& reference) {
    const ItemId item = model.find_item(reference);
    const bool floor = reference == "room" || (item.exists() && model.items[item].thin);
    if (floor) return holder_of(id) == "floor";
    std::string holder = holder_of(id);  // itself, or by way of what it stands on
    for (std::size_t storeys = 0; holder != reference && layout.find_object(holder) && storeys < layout.objects.size(); ++storeys)
      holder = holder_of(holder);
    return holder == reference;
  };
  const auto all_by = [&](const std::string& id) {
    return std::all_of(relation.references.begin(), relation.references.end(), [&](const std::string& r) { return held_by(id, r); });
  };
  const std::vector<std::string>& targets = relation.targets;
  switch (relation.type) {
    case RelationType::kOn: return std::all_of(targets.begin(), targets.end(), all_by);
    case RelationType::kIn:
      return std::all_of(targets.begin(), targets.end(), [&](const std::string& t) {
        return std::all_of(relation.references.begin(), relation.references.end(),
                           [&](const std::string& r) { return !model.find_item(r).exists() || held_by(t, r); });
      });
    case RelationType::kOnWall:
      return std::all_of(targets.begin(), targets.end(), [&](const std::string& t) {
        const WallId holder = model.find_wall(holder_of(t));
        const auto is_holder = [&](const std::string& r) { return model.find_wall(r) == holder; };
        const auto& named = relation.references;
        const bool any = std::all_of(named.begin(), named.end(), [&](const std::string& r) { return !model.find_wall(r).exists(); });
        return holder.exists() && (any || std::any_of(named.begin(), named.end(), is_holder));
      });
    case RelationType::kStacked:
      for (std::size_t i = 1; i < targets.size(); ++i) {
        if (holder_of(targets[i]) != targets[i - 1]) return false;
      }
      return targets.empty() || all_by(targets[0]);
    default: return true;
  }
}

// Which of the item's supports holds where it is, that of which words speak before others; the nearest to holding where none does exactly.
SupportOption support_of(const PlacementModel& model, ItemId index, const Placements& placements) {
  const Item& item = model.items[index];
  const Formula& formula = model.constraints[item.support_constraint].formulas[0];
  std::size_t best = 0;
  std::pair<std::int64_t, bool> least{std::numeric_limits<std::int64_t>::max(), true};
  for (std::size_t k = 0; k < formula.cases.size(); ++k) {
    if (option_missing(item.supports[k], placements)) continue;
    Formula one;
    one.cases.push_back(formula.cases[k]);
    const std::pair miss{miss_of(model, one, placements), !is_said(model, item.id, name_of_support(model, item.supports[k]))};
    if (miss < least) least = miss, best = k;
  }
  return item.supports[best];
}

PlacedObject placed_object(const PlacementModel& model, ItemId index, const Placements& placements) {
  const Item& item = model.items[index];
  const SceneObject& object = *item.object;
  const Placement& p = placements[index];
  const State& state = item.states[p.state];
  PlacedObject out;
  out.id = object.id, out.category = object.category, out.name = object.name, out.catalog_id = object.catalog_id;
  out.attributes = object.attributes;
  out.origin = object.origin;
  out.size = state.size;
  for (int k = 0; k < 2; ++k) out.position[k] = p.at[k] + state.extent[k] / 2.0;
  out.position[2] = p.at[2];
  out.rotation_deg = state.angle;
  keep_exactly(model, index, placements, out);
  const SupportOption support = support_of(model, index, placements);
  out.supported_by = name_of_support(model, support);
  out.mount = item.mount;
  const bool on_item = model.find_item(out.supported_by).exists();
  if (out.supported_by == "floor") {
    out.mount = Mount::kFloor;
  } else if (on_item && (item.mount != Mount::kHung || support.rests)) {
    out.mount = Mount::kSurface;
  }
  out.used_sides = object.used_sides.value_or(item.entry->used_sides);
  out.spaces = spaces_of(object, *item.entry, state.size);
  out.mesh = object.mesh, out.mesh_front = object.mesh_front, out.material = object.material;
  out.fixed = object.fixed;
  return out;
}

// The opening with the wall and offset it got.
Opening placed_opening(const PlacementModel& model, ItemId index, const Placements& placements) {
  const Item& item = model.items[index];
  Opening out = *item.opening;
  const GridBox box = box_of(item, placements[index]);
  for (const RoomWall& wall : model.walls) {
    const bool here = wall.straight && wall.turn == item.states[placements[index].state].turn && box.lo[wall.normal()] == wall.at &&
                      box.lo[wall.along] >= wall.lo && box.hi[wall.along] <= wall.hi && (out.wall.empty() || out.wall == wall.id);
    if (!here) continue;
    out.wall = wall.id;
    out.offset = wall.runs_up ? box.lo[wall.along] - wall.lo : wall.hi - box.hi[wall.along];
    return out;
  }
  // In a wall at an angle: where it was said, else in the middle of the wall that it is nearest to.
  if (!out.offset || out.wall.empty()) {
    double nearest = std::numeric_limits<double>::max();
    const double x = (box.lo[0] + box.hi[0]) / 2.0, y = (box.lo[1] + box.hi[1]) / 2.0;
    for (const Wall& wall : model.scene->room.walls) {
      if (!out.wall.empty() && item.opening->wall != wall.id && !item.opening->wall.empty()) continue;
      const double off = std::hypot((wall.start.x + wall.end.x) / 2.0 - x, (wall.start.y + wall.end.y) / 2.0 - y);
      if (off >= nearest) continue;
      nearest = off;
      out.wall = wall.id;
      const double length = std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y);
      out.offset = std::max<Mm>(0, static_cast<Mm>(std::lround((length - out.width) / 2)));
    }
  }
  return out;
}

}  // namespace

Layout to_layout(const PlacementModel& model, const Placements& placements) {
  const SceneGraph& scene = *model.scene;
  Layout layout;
  layout.prompt = scene.prompt, layout.name = scene.name;
  layout.room = scene.room;
  layout.room.openings.clear();
  layout.materials = scene.materials;
  for (const ItemId index : model.items.ids()) {
    if (placements[index].state < 0) continue;
    if (model.items[index].is_opening()) {
      layout.room.openings.push_back(placed_opening(model, index, placements));
    } else {
      layout.objects.push_back(placed_object(model, index, placements));
    }
  }
  for (const Constraint& constraint : model.constraints) {
    if (!constraint.relation.exists()) continue;
    const bool placed = all_placed(constraint, placements);
    const bool reached = std::all_of(constraint.reach.begin(), constraint.reach.end(),
                                     [&](const auto& r) { return reachable(model, r.first, r.second, placements); });
    const Relation& relation = model.relation(constraint.relation);
    const bool held = placed && reached && miss_of(model, constraint, placements) == 0 && support_agrees(model, relation, layout);
    layout.relations.push_back({relation, held});
  }
  return layout;
}

}  // namespace layoutbox::placement
