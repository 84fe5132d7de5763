#include "layoutbox/edit/edit.h"

#include <algorithm>

#include "layoutbox/edit/changes.h"
#include "layoutbox/edit/placer.h"

namespace layoutbox {
namespace {

// What the outcome says: which wishes are dropped, what changed.
void settle(EditOutcome& outcome, EditState& state, EditPlacer& placer, const Layout& before, const std::set<std::string>& asked) {
  Layout& layout = outcome.layout;
  std::vector<PlacedRelation> kept;
  for (PlacedRelation& placed : layout.relations) {
    if (placer.is_aid(placed.relation)) continue;
    const bool was_soft = state.softened.contains(placed.relation.id);
    const auto earlier = std::find_if(before.relations.begin(), before.relations.end(),
                                      [&](const PlacedRelation& r) { return r.relation.id == placed.relation.id; });
    const bool given_up_before = earlier != before.relations.end() && !earlier->held;
    if (was_soft && !placed.held && !given_up_before) {
      state.dropped.push_back(placed.relation);
      continue;
    }
    if (was_soft) placed.relation.hard = true;
    kept.push_back(std::move(placed));
  }
  layout.relations = std::move(kept);
  for (const auto& [was, now] : {std::pair{&before.relaxed, &layout.relaxed}, std::pair{&before.gave_way, &layout.gave_way}}) {
    for (const Relaxation& relaxation : *was) {
      const auto still = std::find_if(layout.relations.begin(), layout.relations.end(),
                                      [&](const PlacedRelation& r) { return r.relation.id == relaxation.relation && !r.held; });
      if (still != layout.relations.end()) now->push_back(relaxation);
    }
  }
  if (!layout.relaxed.empty() && layout.status == LayoutStatus::kSolved) layout.status = LayoutStatus::kRelaxed;
  for (PlacedObject& placed : layout.objects) {
    const PlacedObject* was = before.find_object(placed.id);
    placed.fixed = was != nullptr && was->fixed;
  }
  outcome.scene = placer.scene();
  outcome.scene.relations.clear();
  for (const PlacedRelation& placed : layout.relations) outcome.scene.relations.push_back(placed.relation);
  for (SceneObject& object : outcome.scene.objects) {
    const PlacedObject* was = before.find_object(object.id);
    object.fixed = was != nullptr && was->fixed;
  }
  outcome.dropped = std::move(state.dropped);
  outcome.changes = changes_between(before, layout, asked);
}

}  // namespace

Result<EditOutcome> edit_layout(std::string_view text, const Layout& layout, const Catalog& catalog, SolveOptions solve) {
  LAYOUTBOX_ASSIGN(EditPlan plan, plan_edit(text, layout, catalog));
  EditState state = begin_edit(layout);
  std::set<std::string> asked;
  for (const EditStep& step : plan.steps) {
    asked.insert(step.targets.begin(), step.targets.end());
    for (const SceneObject& object : step.objects) asked.insert(object.id);
    for (const Opening& opening : step.openings) asked.insert(opening.id);
    LAYOUTBOX_ASSIGN(state, apply_edit_step(std::move(state), step, layout, catalog));
  }
  LAYOUTBOX_ASSIGN(state, finish_edit(std::move(state), layout, catalog));
  if (!layout.prompt.empty()) state.scene.prompt += "\n";
  state.scene.prompt += text;
  EditOutcome outcome;
  outcome.notes = std::move(plan.notes);
  EditPlacer placer(state, layout, catalog, std::move(solve));
  LAYOUTBOX_ASSIGN(outcome.layout, placer.place());
  settle(outcome, state, placer, layout, asked);
  return outcome;
}

}  // namespace layoutbox
