// What pictures show, by words: of the picture itself, and of the text that describes its room (catalog/decor.json).
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace layoutbox {

// Names of what a picture may show, parted by spaces, by its own words: `says` tells whether it has one. Empty where they do not say.
std::string picture_subject(const std::function<bool(std::string_view)>& says);

// The same for all pictures of a room of which nothing is said: "a dinosaur bedroom", "who loves horses".
std::string picture_theme(std::string_view prompt, bool for_children = false);

// The names by themselves.
std::vector<std::string> names_in(std::string_view names);

}  // namespace layoutbox
