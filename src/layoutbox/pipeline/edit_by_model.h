// A layout changed by words that a language model reads (the planner of words alone has a way of its own).
#pragma once

#include <string>
#include <string_view>

#include "layoutbox/chat/chat_client.h"
#include "layoutbox/pipeline/generate.h"

namespace layoutbox {

struct ModelEdit {
  SceneGraph scene;  // normalised
  Layout layout;
  std::string model_requests;  // what was asked and answered, as in run.json
};

// The model is given the scene of `layout` with the places of things, and the text as a change to it; its answer is mended, validated and,
// where it has no layout, repaired as for a new room (options.repair, options.solve). The room stays; all that the model leaves as it was
// stays as near to its place as can be. `options.solve.from` and `shell` are set here.
// Errors: those of a conversation with a model and of solve().
Result<ModelEdit> edit_by_model(std::string_view text, const Layout& layout, const Catalog& catalog, chat::ChatOptions chat,
                                const GenerateOptions& options = {});

}  // namespace layoutbox
