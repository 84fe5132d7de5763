// Several layouts of one scene: their file names, and how they differ in words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/scene/layout.h"

namespace layoutbox {

// "layout.json" for the first, "layout-2.json" for the second; the same with any path.
std::string variant_name(const std::string& path, std::size_t index);

// Is this such a name, of a file that each variant has (pipeline/artefacts.h)?
bool is_variant_name(std::string_view name);

// "score 0.71, 1.20 m from the nearest of the others on average, 3 of 8 objects at another wall". REQUIRES: index > 0.
std::string variant_in_words(const std::vector<Layout>& layouts, std::size_t index);

}  // namespace layoutbox
