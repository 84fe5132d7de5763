// What becomes of things: added, removed, moved, turned, resized, recoloured.
#include <fmt/format.h>

#include <cmath>

#include "layoutbox/edit/changes.h"
#include "layoutbox/edit/stepper.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox {

using R = RelationType;

namespace {

constexpr Mm kThin = 30;  // rugs and mats

// What a factor or a new length makes of a side. A height that is said loosely keeps to what things of the kind have.
Result<Size> resized(const Size& size, const EditResize& resize, const CatalogEntry& entry, const std::string& id) {
  Size made = size;
  const bool swapped = resize.longer_side && size.depth > size.width;
  const std::array<Mm*, 3> sides = {swapped ? &made.depth : &made.width, swapped ? &made.width : &made.depth, &made.height};
  for (std::size_t i = 0; i < 3; ++i) {
    const EditResize::Side& side = resize.sides[i];
    const Mm before = *sides[i];
    *sides[i] = side.exact ? *side.exact : static_cast<Mm>(std::lround(before * side.factor)) + side.more;
    const bool loosely = resize.sides[0].factor != 1 && resize.sides[1].factor != 1;
    if (i == 2 && loosely) {
      *sides[i] = std::clamp(*sides[i], std::min(before, entry.size.least.height), std::max(before, entry.size.greatest.height));
    }
    if (*sides[i] < 5 || *sides[i] > 20'000) {
      return fail(ErrorCode::kGeometry, fmt::format("{} would have a side of {:.2f} m", id, m_from_mm(*sides[i])), "text",
                  "sides lie between 0.005 m and 20 m");
    }
  }
  return made;
}

}  // namespace

void EditStepper::remove_support(const std::string& id) {
  for (std::size_t i = 0; i < scene_.relations.size();) {
    Relation& relation = scene_.relations[i];
    if (!is_support(relation.type) || !has_id(relation.targets, id) || relation.references.empty()) {
      ++i;
      continue;
    }
    std::erase(relation.targets, id);
    if (!relation.targets.empty()) {
      ++i;
      continue;
    }
    if (relation.asked()) dropped_.push_back(scene_.relations[i]), dropped_.back().targets = {id};
    scene_.relations.erase(scene_.relations.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

Status EditStepper::add(const EditStep& step) {
  scene_.objects.insert(scene_.objects.end(), step.objects.begin(), step.objects.end());
  scene_.relations.insert(scene_.relations.end(), step.relations.begin(), step.relations.end());
  return {};
}

Status EditStepper::remove(const Ids& ids) {
  for (const std::string& id : ids) {
    std::erase_if(scene_.objects, [&](const SceneObject& o) { return o.id == id; });
    std::erase_if(guide_.objects, [&](const PlacedObject& o) { return o.id == id; });
  }
  return {};
}

Status EditStepper::move(const EditStep& step) {
  const bool carried = std::any_of(step.relations.begin(), step.relations.end(), [](const Relation& r) { return is_support(r.type); });
  const bool on_wall = std::any_of(step.relations.begin(), step.relations.end(), [](const Relation& r) { return r.type == R::kOnWall; });
  const bool turns = std::any_of(step.relations.begin(), step.relations.end(), [](const Relation& r) { return is_turn(r.type); });
  const bool only_turns = std::all_of(step.relations.begin(), step.relations.end(), [](const Relation& r) { return is_turn(r.type); });
  if (only_turns) return face(step);
  const bool stays = keep_at_distance(step);
  for (const std::string& id : step.targets) {
    SceneObject* moved = object(id);
    if (moved == nullptr) continue;
    soften_targets(id, [turns](R type) { return says_where(type) || (turns && is_turn(type)); });
    if (carried) {
      remove_support(id);
      moved->mount = Mount::kSurface;
    } else if (moved->mount == Mount::kSurface) {
      stand_beside(*moved, step.relations);
    }
    if (on_wall) moved->mount = Mount::kWall;
    if (!stays) freed_.push_back(id);
  }
  scene_.relations.insert(scene_.relations.end(), step.relations.begin(), step.relations.end());
  return {};
}

// "50 cm away from the wall": as far from it as that, and otherwise where it is. Whether that is all that the step says.
bool EditStepper::keep_at_distance(const EditStep& step) {
  const auto wall_of = [&](const Relation& relation) -> const Wall* {
    const bool from_one = relation.type == R::kDistance && relation.targets.size() == 1 && relation.references.size() == 1;
    return from_one ? scene_.find_wall(relation.references.front()) : nullptr;
  };
  for (const Relation& relation : step.relations) {
    if (wall_of(relation) == nullptr || guide(relation.targets.front()) == nullptr) return false;
  }
  for (const Relation& relation : step.relations) {
    const Wall& wall = *wall_of(relation);
    PlacedObject& placed = *guide(relation.targets.front());
    const double dx = wall.end.x - wall.start.x, dy = wall.end.y - wall.start.y, length = std::max(std::hypot(dx, dy), 1.0);
    const double nx = -dy / length, ny = dx / length;  // inwards: walls run counter-clockwise
    const double turn = radians_from_degrees(placed.rotation_deg);
    const double across = std::abs(nx * std::cos(turn) + ny * std::sin(turn)), along = std::abs(ny * std::cos(turn) - nx * std::sin(turn));
    const double half = (placed.size.width * across + placed.size.depth * along) / 2;
    const double gap = (placed.position[0] - wall.start.x) * nx + (placed.position[1] - wall.start.y) * ny - half;
    const RelationParameters& said = relation.parameters;
    const double least = said.min ? *said.min : said.distance.value_or(0), most = said.max ? *said.max : said.distance.value_or(least);
    const double wanted = std::max(least, said.min && !said.max ? gap : std::min(gap, most));
    placed.position[0] += nx * (wanted - gap);
    placed.position[1] += ny * (wanted - gap);
  }
  return true;
}

// "Move the lamp next to the clock": on what the clock stands on; beside a thing on the floor it stands on the floor.
void EditStepper::stand_beside(SceneObject& moved, const std::vector<Relation>& relations) {
  for (const Relation& relation : relations) {
    if (!has_id(relation.targets, moved.id) || relation.references.empty()) continue;
    const PlacedObject* neighbour = guide(relation.references.front());
    if (neighbour == nullptr || neighbour->id == before_support(moved.id)) continue;
    remove_support(moved.id);
    if (guide(neighbour->supported_by) != nullptr) {
      Relation on;
      on.type = R::kOn;
      on.targets = {moved.id};
      on.references = {neighbour->supported_by};
      on.origin = Origin::kAssumed;
      on.why = relation.why;
      scene_.relations.push_back(std::move(on));
    } else {
      moved.mount = Mount::kFloor;
    }
    return;
  }
}

std::string EditStepper::before_support(const std::string& id) const {
  const PlacedObject* placed = before_.find_object(id);
  return placed == nullptr ? std::string() : placed->supported_by;
}

Status EditStepper::face(const EditStep& step) {
  for (const std::string& id : step.targets) {
    soften_targets(id, [](R type) { return is_turn(type) || traits_of(type).back_to_wall; });
  }
  scene_.relations.insert(scene_.relations.end(), step.relations.begin(), step.relations.end());
  return {};
}

Status EditStepper::shift(const EditStep& step) {
  for (const std::string& id : step.targets) {
    const PlacedObject* placed = guide(id);
    if (placed == nullptr) continue;
    LAYOUTBOX_ASSIGN(const auto way, way_of(*placed, *step.shift, guide_, before_.find_object(id) != nullptr));
    soften_targets(id, [](R type) { return says_where(type) && !is_support(type); });
    pins_.push_back({id, placed->position, way, placed->rotation_deg, !step.shift->distance});
  }
  return {};
}

Status EditStepper::turn(const EditStep& step) {
  for (const std::string& id : step.targets) {
    const PlacedObject* placed = guide(id);
    if (placed == nullptr) continue;
    if (placed->mount == Mount::kWall) {
      return fail(ErrorCode::kGeometry, fmt::format("{} hangs on a wall and looks away from it", id), "text", "move it to another wall");
    }
    soften_targets(id, [](R type) { return is_turn(type) || traits_of(type).back_to_wall || type == R::kSideAgainstWall; });
    pins_.push_back({id, placed->position, {0, 0, 0}, normalized_degrees(placed->rotation_deg + step.degrees), false});
    pins_.back().may_move = true;
  }
  return {};
}

Status EditStepper::resize(const EditStep& step) {
  for (const std::string& id : step.targets) {
    SceneObject* changed = object(id);
    if (changed == nullptr || !changed->size) continue;
    LAYOUTBOX_ASSIGN(const Size size, resized(changed->size->usual, step.resize, catalog_.entry_or_nearest(changed->category), id));
    changed->size = SizeRange{size, size, size};
    changed->size_source = SizeSource::kUser;
    changed->spaces.clear();
    changed->spaces_given = false;
    if (PlacedObject* placed = guide(id)) {  // its back stays where it is
      PlacedObject grown = *placed;
      grown.size = size;
      grown.spaces.clear();
      if (size.height > kThin) take_place(grown, *placed);  // a rug grows about its middle
      *placed = grown;
    }
  }
  return {};
}

Status EditStepper::recolor(const EditStep& step) {
  for (const std::string& id : step.targets) {
    std::string words;
    for (const std::string& attribute : step.attributes) words += (words.empty() ? "" : " ") + attribute;
    if (id == kEditWalls) {
      scene_.room.wall_material = words;
      for (Wall& wall : scene_.room.walls) wall.material.clear();
    } else if (id == kEditFloor) {
      scene_.room.floor_material = words + " floor";
    } else if (id == kEditCeiling) {
      scene_.room.ceiling_material = words;
    }
    for (Wall& wall : scene_.room.walls) {
      if (wall.id == id) wall.material = words;
    }
    SceneObject* changed = object(id);
    if (changed == nullptr) continue;
    std::erase_if(changed->attributes, [&](const std::string& a) { return has_id(step.dropped_attributes, a); });
    for (std::size_t i = 0; i < step.attributes.size(); ++i) {
      if (!has_id(changed->attributes, step.attributes[i])) changed->attributes.push_back(step.attributes[i]);
      if (step.attribute_class[i] == "size") {
        changed->size.reset();  // by its words, from the catalogue
        changed->size_source = SizeSource::kUnknown;
        changed->spaces.clear();
        changed->spaces_given = false;
      } else {
        changed->material.clear();
      }
    }
  }
  return {};
}

}  // namespace layoutbox
