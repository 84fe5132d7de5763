// What is said of a value that does not follow its schema.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace layoutbox {

// The types that a schema allows: "a whole number or null".
std::string type_words(const nlohmann::json& type);

// A value as it stands, cut where it is long: "[1,2]", "a list of 12 items".
std::string value_words(const nlohmann::json& value);

// What may be given instead of a number out of range.
std::string range_hint(const nlohmann::json& schema);

// How many there may be: `what` is the end of the keywords min… and max… ("Items"), `noun` what is counted.
std::string count_hint(const nlohmann::json& schema, const std::string& what, std::string_view noun);

}  // namespace layoutbox
