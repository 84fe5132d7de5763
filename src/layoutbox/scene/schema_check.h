// Checks a document against one of the JSON Schemas in schema/, and says in words what is wrong.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"

namespace layoutbox {

enum class SchemaName { kScene, kLayout, kCatalog };

// Every violation, with its JSON pointer, in the document's order; empty when the document is valid.
// `at` checks against a definition instead of the whole schema: "room" with kScene checks a room alone.
std::vector<Error> check_against_schema(const nlohmann::json& document, SchemaName schema, std::string_view at = {});

}  // namespace layoutbox
