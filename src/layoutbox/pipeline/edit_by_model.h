// A layout changed by words that a language model reads (the planner of words alone has a way of its own).
#pragma once

#include <string_view>

#include "layoutbox/chat/chat_client.h"
#include "layoutbox/edit/edit.h"
#include "layoutbox/pipeline/generate.h"

namespace layoutbox {

// The model is given the scene of `layout` with the places of things, and the text as a change to it; its answer is mended, validated and,
// where it has no layout, repaired as for a new room (options.repair, options.solve). The room stays; all that the model leaves as it was
// stays as near to its place as can be. `options.solve.from`, `on_conflict` and `shell` are set here.
// Errors: those of a conversation with a model; kInfeasible and kNotFound where what it asks for cannot be.
Result<EditOutcome> edit_by_model(std::string_view text, const Layout& layout, const Catalog& catalog, chat::ChatOptions chat,
                                  const GenerateOptions& options = {});

}  // namespace layoutbox
