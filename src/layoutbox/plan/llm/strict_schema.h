// The form of schema/scene.schema.json that a language model is given, derived from it: every member required and null allowed where it
// may be missing, nothing added, lists and texts bounded, references resolved, without the members that no model is asked for (x-model).
#pragma once

#include <cstddef>
#include <string>

namespace layoutbox::llm {

// As JSON text; made once.
const std::string& strict_scene_schema();

// The same with room for about twice as many objects as a text names (0: not known), so that a weak model that repeats itself comes to
// an end. In few steps, as servers prepare each schema once.
std::string strict_scene_schema_for(std::size_t objects);

// Of a list of changes (RFC 6902) to a scene.
const std::string& patch_schema();

}  // namespace layoutbox::llm
