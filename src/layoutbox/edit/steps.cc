// The steps of an edit in order, and what they leave behind.
#include <algorithm>

#include "layoutbox/edit/stepper.h"
#include "layoutbox/scene/layout_scene.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox {

using R = RelationType;

EditState begin_edit(const Layout& before) {
  EditState state;
  state.scene = scene_of(before);
  state.guide = before;
  for (std::size_t i = 0; i < before.relations.size() && i < state.scene.relations.size(); ++i) {
    Relation& relation = state.scene.relations[i];
    // What was given up before is no reason to refuse now.
    if (!before.relations[i].relation.hard || before.relations[i].held) continue;
    if (relation.hard) state.softened.insert(relation.id);
    relation.hard = false;
  }
  return state;
}

Result<EditState> apply_edit_step(EditState state, const EditStep& step, const Layout& before, const Catalog& catalog) {
  LAYOUTBOX_CHECK(EditStepper(state, before, catalog).apply(step));
  return state;
}

Result<EditState> finish_edit(EditState state, const Layout& before, const Catalog& catalog) {
  EditStepper(state, before, catalog).finish();
  return state;
}

void EditStepper::finish() {
  remove_what_stood_on_it();
  drop_relations_of_what_is_gone();
  number_relations();
}

Status EditStepper::apply(const EditStep& step) {
  if (is_of_room(step)) return apply_to_room(step);
  switch (step.kind) {
    case EditKind::kAdd: return add(step);
    case EditKind::kRemove: return remove(step.targets);
    case EditKind::kMove: return move(step);
    case EditKind::kShift: return shift(step);
    case EditKind::kSwap: return swap(step.targets[0], step.targets[1]);
    case EditKind::kReplace: return replace(step);
    case EditKind::kTurn: return step.relations.empty() ? turn(step) : face(step);
    case EditKind::kResize: return resize(step);
    case EditKind::kRecolor: return recolor(step);
    case EditKind::kRename:
      if (SceneObject* named = object(step.targets[0])) named->name = step.name;
      return {};
    case EditKind::kKeep: locked_.insert(locked_.end(), step.targets.begin(), step.targets.end()); return {};
  }
  return {};
}

SceneObject* EditStepper::object(const std::string& id) {
  const auto found = std::find_if(scene_.objects.begin(), scene_.objects.end(), [&](const SceneObject& o) { return o.id == id; });
  return found == scene_.objects.end() ? nullptr : &*found;
}
PlacedObject* EditStepper::guide(const std::string& id) {
  const auto found = std::find_if(guide_.objects.begin(), guide_.objects.end(), [&](const PlacedObject& o) { return o.id == id; });
  return found == guide_.objects.end() ? nullptr : &*found;
}

void EditStepper::soften(Relation& relation) {
  if (relation.hard) softened_.insert(relation.id);
  relation.hard = false;
}

// A lamp goes with the table it stood on, unless the edit gives it another place.
void EditStepper::remove_what_stood_on_it() {
  for (bool found = true; found;) {
    found = false;
    for (const PlacedObject& placed : before_.objects) {
      const std::string& support = placed.supported_by;
      if (object(placed.id) == nullptr) continue;
      const bool thing_gone = before_.find_object(support) != nullptr && object(support) == nullptr;
      const bool sill_gone = before_.find_opening(support) != nullptr && opening(support) == nullptr;
      if (!thing_gone && !sill_gone) continue;
      const PlacedObject* now = guide(placed.id);
      const bool elsewhere = (now != nullptr && now->supported_by != support) || has_id(freed_, placed.id);
      if (elsewhere) continue;
      static_cast<void>(remove({placed.id}));
      found = true;
    }
  }
}

void EditStepper::drop_relations_of_what_is_gone() {
  const auto gone = [&](const std::string& id) {
    return (before_.find_object(id) != nullptr && object(id) == nullptr) || (before_.find_opening(id) != nullptr && opening(id) == nullptr);
  };
  std::vector<Relation> kept;
  for (Relation& relation : scene_.relations) {
    const bool referred = !relation.references.empty();
    const Relation whole = relation;
    std::erase_if(relation.targets, gone);
    std::erase_if(relation.references, gone);
    const bool alone = relation.targets.size() < 2 && whole.targets.size() >= 2 && traits_of(relation.type).order_only;
    if (relation.targets.empty() || (referred && relation.references.empty()) || alone) {
      if (whole.asked()) dropped_.push_back(whole);
      softened_.erase(whole.id);
      continue;
    }
    kept.push_back(std::move(relation));
  }
  scene_.relations = std::move(kept);
}

// New relations get ids that no earlier one has.
void EditStepper::number_relations() {
  std::set<std::string> ids;
  for (const Relation& relation : scene_.relations) ids.insert(relation.id);
  int number = 0;
  for (Relation& relation : scene_.relations) {
    if (!relation.id.empty()) continue;
    do {
      relation.id = "e" + std::to_string(++number);
    } while (ids.contains(relation.id));
    ids.insert(relation.id);
  }
}

}  // namespace layoutbox
