// JSON as models write it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox::llm {

// Strict JSON first; else the outermost object of a text with words or a code fence around it, with comments, trailing commas, Python's
// True, False and None, NaN as null, single quotes and line feeds in texts. What was passed over is noted. Errors: kParse, kTooLarge.
Result<nlohmann::json> parse_loose_json(std::string_view text, std::vector<Note>& notes);

// Of a text that was cut off within its outermost object: the members and items of lists that are whole. Errors: kParse where there are
// none, or where it was not cut off.
Result<nlohmann::json> parse_cut_json(std::string_view text);

}  // namespace layoutbox::llm
