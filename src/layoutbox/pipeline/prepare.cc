// What every way to a room shares: a scene made ready for the solver, and whether a room is as asked.
#include "layoutbox/base/words.h"
#include "layoutbox/dress/dress.h"
#include "layoutbox/dress/hinges.h"
#include "layoutbox/pipeline/generate.h"
#include "layoutbox/plan/companions.h"
#include "layoutbox/plan/open_rows.h"

namespace layoutbox {

Result<SceneGraph> prepare_scene(SceneGraph scene, const Catalog& catalog, const GenerateOptions& options) {
  if (options.shell) {
    std::string type = options.shell->type.empty() ? scene.room.type : options.shell->type;
    scene.room = *options.shell;
    scene.room.type = std::move(type);
  }
  return normalize_scene(std::move(scene), catalog, options.normalize);
}

bool comes_with_more(const Plan& plan, const GenerateOptions& options) { return options.companions && !plan.by_model; }

Result<SceneGraph> prepare_plan(const Plan& plan, const Catalog& catalog, const GenerateOptions& options) {
  LAYOUTBOX_ASSIGN(SceneGraph scene, prepare_scene(plan.scene, catalog, options));
  if (!comes_with_more(plan, options)) return scene;
  SceneGraph more = plan.scene;
  const std::size_t relations = more.relations.size();
  const std::size_t in_rows = fill_rows(more, scene, plan.linings, catalog);
  if (in_rows > 0) more.notes.push_back({"filled", counted(in_rows, "thing") + " fill the walls that the text says are lined", "prompt"});
  const std::size_t added = add_companions(more, scene, plan.unwanted, catalog);
  if (added == 0 && more.relations.size() == relations) return scene;
  if (added > 0)
    more.notes.push_back({"filled", counted(added, "thing") + " that the use of the room needs came with what is named", "prompt"});
  return prepare_scene(std::move(more), catalog, options);
}

std::size_t dress_room(const Plan& plan, SceneGraph& scene, Layout& layout, const Catalog& catalog, const GenerateOptions& options) {
  if (!comes_with_more(plan, options)) return 0;
  hang_doors_clear(scene, layout, catalog);
  const std::size_t added = dress(scene, layout, catalog, Spoken(scene, plan.unwanted, catalog));
  if (added > 0) scene.notes.push_back({"filled", counted(added, "thing") + " dress the finished room where it was free", "prompt"});
  return added;
}

bool as_asked(const GenerateOutcome& outcome) { return as_asked(outcome.layout, outcome.report); }

bool as_asked(const Layout& layout, const Report& report) {
  return layout.status == LayoutStatus::kSolved && layout.relaxed.empty() && report.passed;
}

std::string_view program_version() { return LAYOUTBOX_VERSION; }

}  // namespace layoutbox
