// Which parts of a thing `part` of a relation may name: words for where on its top, and the names of its spaces.
#pragma once

#include <set>
#include <string>

#include "layoutbox/catalog/catalog.h"

namespace layoutbox {

// The spaces of an entry in all its variants, by name.
std::set<std::string, std::less<>> space_names(const CatalogEntry& entry);

// Is it a part of a thing with those spaces? What is in it is not on its top.
bool is_part(RelationType type, const ThingPart& part, const std::set<std::string, std::less<>>& spaces);

}  // namespace layoutbox
