// Which wall a text gives its kitchen.
#pragma once

#include <string>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// "with a kitchen along the right wall", "… on the left": the wall, or empty.
std::string wall_of_kitchen(const Document& document);

}  // namespace layoutbox::offline
