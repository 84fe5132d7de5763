// The form of schema/scene.schema.json that a language model is given, derived from it: every member required and null allowed where it
// may be missing, nothing added, lists and texts bounded, references resolved, without the members that no model is asked for (x-model).
#pragma once

#include <string>

namespace layoutbox::llm {

// As JSON text; made once.
const std::string& strict_scene_schema();

// Of a list of changes (RFC 6902) to a scene.
const std::string& patch_schema();

}  // namespace layoutbox::llm
