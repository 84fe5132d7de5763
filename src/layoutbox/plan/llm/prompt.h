// What a model is told: made from the relation table, the room, the catalogue and the text.
#pragma once

#include <string>
#include <string_view>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox::llm {

// The whole of what is sent with a first question stays below this, by estimate; where it cannot, less of the catalogue is shown.
inline constexpr int kMostPromptTokens = 6000, kMostBriefTokens = 2000;

struct PromptInput {
  std::string_view text;           // the user's
  const SceneGraph* read_offline;  // how the offline planner read it, or null: tells which entries matter
  Size room_size;                  // given by the user; 0: not
  const Room* shell = nullptr;     // the user's own room, or null
  std::size_t fixed_tokens = 0;    // of what is sent beside it: the schema
  bool brief = false;              // as short as can be, for models that hold little
};

struct SystemPrompt {
  std::string text;
  std::size_t entries_shown = 0, articles_left_out = 0;
};

SystemPrompt make_system_prompt(const Catalog& catalog, const PromptInput& input);

// The user's text between marks that it cannot close.
std::string quoted_request(std::string_view text);

}  // namespace layoutbox::llm
