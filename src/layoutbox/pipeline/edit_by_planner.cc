#include "layoutbox/pipeline/edit_by_planner.h"

#include <algorithm>
#include <set>
#include <string>

#include "layoutbox/edit/changes.h"
#include "layoutbox/pipeline/repair.h"
#include "layoutbox/scene/layout_scene.h"

namespace layoutbox {
namespace {

// The room as it is, with where things stand.
SceneGraph scene_as_it_stands(const Layout& layout) {
  SceneGraph scene = scene_of(layout);
  for (SceneObject& object : scene.objects) {
    if (const PlacedObject* placed = layout.find_object(object.id)) object.hint = {placed->position, placed->rotation_deg, false};
  }
  return scene;
}

// Members that no planner writes come back from the earlier scene, for things that it left as they were.
void restore(const SceneGraph& before, SceneGraph& scene) {
  for (SceneObject& object : scene.objects) {
    const SceneObject* earlier = before.find_object(object.id);
    if (earlier == nullptr || earlier->category != object.category) continue;
    object.origin = earlier->origin;
    if (!object.mount) object.mount = earlier->mount;
    if (!object.used_sides) object.used_sides = earlier->used_sides;
    if (!object.size) object.size = earlier->size, object.size_source = earlier->size_source;
    const bool same_size = object.size == earlier->size;
    if (same_size && !object.spaces_given) object.spaces = earlier->spaces, object.spaces_given = earlier->spaces_given;
    if (object.mesh.empty()) object.mesh = earlier->mesh, object.mesh_front = earlier->mesh_front;
  }
  for (Opening& opening : scene.room.openings) {
    if (const Opening* earlier = before.find_opening(opening.id)) opening.origin = earlier->origin;
  }
  for (Relation& relation : scene.relations) {
    const auto same = [&](const Relation& r) {
      return r.type == relation.type && r.targets == relation.targets && r.references == relation.references;
    };
    const auto earlier = std::ranges::find_if(before.relations, same);
    if (earlier != before.relations.end()) relation.origin = earlier->origin;
  }
}

}  // namespace

Result<EditOutcome> edit_by_planner(std::string_view text, const Layout& layout, const Catalog& catalog, const Planner& planner,
                                    const GenerateOptions& options) {
  const SceneGraph before = scene_of(layout);
  GenerateOptions own = options;
  own.shell = before.room;
  own.plan.stop = options.stop;
  own.solve.from = &layout;
  own.solve.on_conflict = OnConflict::kFail;
  const auto planning = planner.begin_change(text, scene_as_it_stands(layout), own.plan, {{}, &*own.shell});
  if (planning == nullptr) return fail(ErrorCode::kUsage, "this planner changes no rooms", "planner", "use edit_layout()");
  RepairLoop loop(*planning, catalog, own);
  loop.adjust = [&before](SceneGraph& scene) { restore(before, scene); };
  LAYOUTBOX_ASSIGN(PlannedRoom room, loop.run());
  EditOutcome outcome;
  outcome.scene = std::move(room.scene);
  outcome.layout = std::move(room.layout);
  outcome.scene.prompt = outcome.layout.prompt = layout.prompt.empty() ? std::string(text) : layout.prompt + "\n" + std::string(text);
  std::set<std::string> all;  // which of the changes the text asks for, only the planner knows
  for (const PlacedObject& object : layout.objects) all.insert(object.id);
  for (const PlacedObject& object : outcome.layout.objects) all.insert(object.id);
  outcome.changes = changes_between(layout, outcome.layout, all);
  outcome.notes = outcome.scene.notes;
  return outcome;
}

}  // namespace layoutbox
