// The functions that a model may call.
#pragma once

#include <string_view>

#include "layoutbox/chat/chat.h"
#include "layoutbox/plan/llm/strict_schema.h"

namespace layoutbox::llm {

inline constexpr std::string_view kCreateScene = "create_scene";
inline constexpr std::string_view kPatchScene = "patch_scene";

inline chat::Function create_scene_function(const SchemaWanted& wanted) {
  return {std::string(kCreateScene), "Hands over the scene graph of the room.", scene_schema(wanted), !wanted.brief};
}

inline chat::Function patch_scene_function() {
  return {std::string(kPatchScene), "Changes the scene as it was sent, by a JSON Patch (RFC 6902).", patch_schema(), false};
}

}  // namespace layoutbox::llm
