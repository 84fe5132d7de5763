// Texts of a model made fit for files, pages and scripts. Internal to plan/llm.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "layoutbox/plan/llm/mend.h"

namespace layoutbox::llm {

// What was mended, and where (a JSON pointer).
void note(Notes& notes, std::string message, std::string pointer = {});

// The member as text; empty where it is missing or no text.
std::string text_of(const nlohmann::json& object, const char* key);

// An id becomes a name in files, in Blender and in HTML: letters, digits, underscores.
std::string clean_id(std::string_view written);

// Words for people: no control characters, none that turn or hide text, no signs that mean something to a shell, to HTML or to a path.
std::string clean_name(std::string_view written);

// The same of a member, where it is a text; what is left empty is erased.
void clean_text(nlohmann::json& owner, const char* key, const std::string& at, Notes& notes);

}  // namespace layoutbox::llm
