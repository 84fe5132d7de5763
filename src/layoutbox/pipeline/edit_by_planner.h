// A layout changed by words that a planner answers with another scene, as one by model does (words alone have a way of their own: edit/).
#pragma once

#include <string_view>

#include "layoutbox/edit/edit.h"
#include "layoutbox/pipeline/generate.h"
#include "layoutbox/plan/planner.h"

namespace layoutbox {

// The planner is given the scene of `layout` with the places of things, and the text as a change to it; its answer is mended, validated
// and, where it has no layout, repaired as for a new room (options.repair, options.solve). The room stays; all that the planner leaves as
// it was stays as near to its place as can be. `options.solve.from`, `on_conflict` and `shell` are set here. Errors: those of Planning;
// kInfeasible and kNotFound where what it asks for cannot be; kUsage where the planner changes no scenes.
Result<EditOutcome> edit_by_planner(std::string_view text, const Layout& layout, const Catalog& catalog, const Planner& planner,
                                    const GenerateOptions& options = {});

}  // namespace layoutbox
