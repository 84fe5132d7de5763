#include "layoutbox/pipeline/edit.h"

#include <algorithm>

#include "layoutbox/pipeline/edit_changes.h"
#include "layoutbox/pipeline/edit_work.h"
#include "layoutbox/scene/layout_scene.h"

namespace layoutbox {

using R = RelationType;

Edit::Edit(const Layout& before, const Catalog& catalog, SolveOptions solve)
    : before_(before), catalog_(catalog), solve_(std::move(solve)), scene_(scene_of(before)), guide_(before) {
  for (std::size_t i = 0; i < before.relations.size() && i < scene_.relations.size(); ++i) {
    // What was given up before is no reason to refuse now.
    if (before.relations[i].relation.hard && !before.relations[i].held) soften(scene_.relations[i]);
  }
}

Result<EditOutcome> Edit::run(std::string_view text) {
  LAYOUTBOX_ASSIGN(EditPlan plan, plan_edit(text, before_, catalog_));
  for (const EditStep& step : plan.steps) {
    for (const std::string& id : step.targets) asked_.insert(id);
    for (const SceneObject& object : step.objects) asked_.insert(object.id);
    for (const Opening& opening : step.openings) asked_.insert(opening.id);
    LAYOUTBOX_CHECK(apply(step));
  }
  remove_what_stood_on_it();
  drop_relations_of_what_is_gone();
  if (!before_.prompt.empty()) scene_.prompt += "\n";
  scene_.prompt += text;
  number_relations();
  EditOutcome outcome;
  outcome.notes = std::move(plan.notes);
  LAYOUTBOX_ASSIGN(outcome.layout, place());
  settle(outcome);
  return outcome;
}

Status Edit::apply(const EditStep& step) {
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
    case EditKind::kKeep: solve_.locked.insert(solve_.locked.end(), step.targets.begin(), step.targets.end()); return {};
  }
  return {};
}

SceneObject* Edit::object(const std::string& id) {
  const auto found = std::find_if(scene_.objects.begin(), scene_.objects.end(), [&](const SceneObject& o) { return o.id == id; });
  return found == scene_.objects.end() ? nullptr : &*found;
}
PlacedObject* Edit::guide(const std::string& id) {
  const auto found = std::find_if(guide_.objects.begin(), guide_.objects.end(), [&](const PlacedObject& o) { return o.id == id; });
  return found == guide_.objects.end() ? nullptr : &*found;
}

void Edit::soften(Relation& relation) {
  if (relation.hard) softened_.insert(relation.id);
  relation.hard = false;
}

// A lamp goes with the table it stood on, unless the edit gives it another place.
void Edit::remove_what_stood_on_it() {
  for (bool found = true; found;) {
    found = false;
    for (const PlacedObject& placed : before_.objects) {
      const std::string& support = placed.supported_by;
      if (object(placed.id) == nullptr) continue;
      const bool thing_gone = before_.find_object(support) != nullptr && object(support) == nullptr;
      const bool sill_gone = before_.find_opening(support) != nullptr && opening(support) == nullptr;
      if (!thing_gone && !sill_gone) continue;
      const PlacedObject* now = guide(placed.id);
      const bool elsewhere = (now != nullptr && now->supported_by != support) || has_id(solve_.freed, placed.id);
      if (elsewhere) continue;
      static_cast<void>(remove({placed.id}));
      found = true;
    }
  }
}

void Edit::drop_relations_of_what_is_gone() {
  const auto gone = [&](const std::string& id) {
    return (before_.find_object(id) != nullptr && object(id) == nullptr) || (before_.find_opening(id) != nullptr && opening(id) == nullptr);
  };
  std::vector<Relation> kept;
  for (Relation& relation : scene_.relations) {
    const bool referred = !relation.references.empty();
    const Relation whole = relation;
    std::erase_if(relation.targets, gone);
    std::erase_if(relation.references, gone);
    const bool alone =
        relation.targets.size() < 2 && whole.targets.size() >= 2 && relation_row(relation.type).arity == RelationArity::kNone &&
        (relation.type == R::kRow || relation.type == R::kGrid || relation.type == R::kColumn || relation.type == R::kEvenlySpaced);
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
void Edit::number_relations() {
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

// What the outcome says: which wishes are dropped, what changed.
void Edit::settle(EditOutcome& outcome) {
  Layout& layout = outcome.layout;
  std::vector<PlacedRelation> kept;
  for (PlacedRelation& placed : layout.relations) {
    if (placed.relation.id.starts_with("turned_")) continue;
    const bool was_soft = softened_.contains(placed.relation.id);
    const auto before = std::find_if(before_.relations.begin(), before_.relations.end(),
                                     [&](const PlacedRelation& r) { return r.relation.id == placed.relation.id; });
    const bool given_up_before = before != before_.relations.end() && !before->held;
    if (was_soft && !placed.held && !given_up_before) {
      dropped_.push_back(placed.relation);
      continue;
    }
    if (was_soft) placed.relation.hard = true;
    kept.push_back(std::move(placed));
  }
  layout.relations = std::move(kept);
  for (const auto& [before, now] : {std::pair{&before_.relaxed, &layout.relaxed}, std::pair{&before_.gave_way, &layout.gave_way}}) {
    for (const Relaxation& relaxation : *before) {
      const auto still = std::find_if(layout.relations.begin(), layout.relations.end(),
                                      [&](const PlacedRelation& r) { return r.relation.id == relaxation.relation && !r.held; });
      if (still != layout.relations.end()) now->push_back(relaxation);
    }
  }
  if (!layout.relaxed.empty() && layout.status == LayoutStatus::kSolved) layout.status = LayoutStatus::kRelaxed;
  for (PlacedObject& placed : layout.objects) {
    const PlacedObject* was = before_.find_object(placed.id);
    placed.fixed = was != nullptr && was->fixed;
  }
  outcome.scene = outcome_scene_;
  outcome.scene.relations.clear();
  for (const PlacedRelation& placed : layout.relations) outcome.scene.relations.push_back(placed.relation);
  for (SceneObject& object : outcome.scene.objects) {
    const PlacedObject* was = before_.find_object(object.id);
    object.fixed = was != nullptr && was->fixed;
  }
  outcome.dropped = std::move(dropped_);
  outcome.changes = changes_between(before_, layout, asked_);
}

Result<EditOutcome> edit_layout(std::string_view text, const Layout& layout, const Catalog& catalog, SolveOptions solve) {
  return Edit(layout, catalog, std::move(solve)).run(text);
}

}  // namespace layoutbox
