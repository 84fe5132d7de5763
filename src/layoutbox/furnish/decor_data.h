// What rooms look like, as data: catalog/decor.json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace layoutbox {

const nlohmann::json& decor_data();

// Whether the words, parted by spaces, have that one.
bool lists(std::string_view words, std::string_view word);

}  // namespace layoutbox
