#include "layoutbox/scene/layout_scene.h"

#include <algorithm>

#include "layoutbox/scene/relation_traits.h"

namespace layoutbox {
namespace {

SceneObject object_of(const PlacedObject& placed) {
  SceneObject object;
  object.id = placed.id, object.category = placed.category, object.name = placed.name, object.catalog_id = placed.catalog_id;
  object.attributes = placed.attributes;
  object.size = SizeRange{placed.size, placed.size, placed.size};
  object.size_source = SizeSource::kUser;
  object.mount = placed.mount;
  if (!placed.used_sides.empty()) object.used_sides = placed.used_sides;
  object.spaces = placed.spaces;
  object.spaces_given = !placed.spaces.empty();
  object.mesh = placed.mesh, object.mesh_front = placed.mesh_front, object.material = placed.material;
  object.fixed = placed.fixed;
  object.origin = placed.origin;
  if (placed.fixed) object.hint = {placed.position, placed.rotation_deg, false};
  return object;
}

bool names(const std::vector<std::string>& ids, const std::string& id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); }

// What it stands on, where no relation says so.
void add_support(const Layout& layout, const PlacedObject& placed, SceneGraph& scene) {
  const bool on_object = layout.find_object(placed.supported_by) != nullptr, on_sill = layout.find_opening(placed.supported_by) != nullptr;
  if (placed.fixed || (!on_object && !on_sill)) return;
  const auto says_so = [&](const Relation& r) {
    return traits_of(r.type).supports && names(r.targets, placed.id) &&
           (r.type == RelationType::kStacked || names(r.references, placed.supported_by));
  };
  if (std::any_of(scene.relations.begin(), scene.relations.end(), says_so)) return;
  Relation relation;
  relation.id = placed.id + "_on_" + placed.supported_by;
  relation.type = RelationType::kOn;
  relation.targets = {placed.id};
  relation.references = {placed.supported_by};
  relation.why = "the layout has it there";
  relation.origin = Origin::kAssumed;
  scene.relations.push_back(std::move(relation));
}

// Ids that relations name and that the layout lists as left out.
std::vector<std::string> left_out_of(const Layout& layout) {
  std::vector<std::string> ids;
  for (const auto* list : {&layout.relaxed, &layout.gave_way}) {
    for (const Relaxation& item : *list) {
      if (layout.find_object(item.relation) == nullptr) ids.push_back(item.relation);
    }
  }
  return ids;
}

}  // namespace

SceneGraph scene_of(const Layout& layout) {
  SceneGraph scene;
  scene.prompt = layout.prompt, scene.name = layout.name;
  scene.room = layout.room;
  scene.room.openings_given = true;
  scene.materials = layout.materials;
  for (const PlacedObject& placed : layout.objects) scene.objects.push_back(object_of(placed));
  const std::vector<std::string> left_out = left_out_of(layout);
  for (const PlacedRelation& placed : layout.relations) {
    Relation relation = placed.relation;
    if (take_out(relation, left_out)) scene.relations.push_back(std::move(relation));
  }
  for (const PlacedObject& placed : layout.objects) add_support(layout, placed, scene);
  return scene;
}

}  // namespace layoutbox
