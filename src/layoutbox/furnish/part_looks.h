// What a text says of the look of parts that are no things of their own: the fronts and worktops of a kitchen, what a bed is made up with
// (catalog/decor.json, "parts").
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/furnish/palette.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

struct PartLook {
  std::vector<Color> colors;               // in the order of the text
  const NamedSurface* material = nullptr;  // null: none was named
};
using PartLooks = std::map<std::string, PartLook, std::less<>>;

// Parts of single things, by the thing's name in lower case: "coffee table" has a top of marble, legs of brass.
using ThingParts = std::map<std::string, PartLooks, std::less<>>;

// By the part's name. "Sage green cabinets", "counters of oak", "fronts: matt black"; what is said first holds.
PartLooks part_looks(std::string_view prompt);

// "A marble top coffee table with brass legs", "a velvet headboard in emerald": of the things of the layout.
ThingParts thing_parts(const Layout& layout);

}  // namespace layoutbox
