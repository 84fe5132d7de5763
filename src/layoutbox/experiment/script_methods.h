// Ways without a scene graph: the model writes Blender's Python, and what stands in the scene afterwards is the room.
#pragma once

#include "layoutbox/experiment/methods.h"

namespace layoutbox::experiment {

// One request, no solver, no repair, no rerun: the paper's baseline. Of a script that fails the class stands in `failure`.
// Errors: those of ChatClient::ask, kNoBlender, kIo (no sandbox).
Result<MethodResult> one_step(const MethodInput& input, const Catalog& catalog);

// The same with solve() afterwards, by the least movement (the paper's wish).
Result<MethodResult> one_step_cleaned(const MethodInput& input, const Catalog& catalog);

// The model hears what failed in its script or in its room, and writes it anew; as many answers as RepairOptions::max_attempts.
Result<MethodResult> one_step_again(const MethodInput& input, const Catalog& catalog);

// `result`'s room as the solver would have it with the least movement.
Status clean_up(MethodResult& result, const MethodInput& input, const Catalog& catalog);

}  // namespace layoutbox::experiment
