// What is fixed where it cannot be.
#pragma once

#include <vector>

#include "layoutbox/solve/conflict/conflict.h"

namespace layoutbox::placement {

// Fixed things that reach out of the room, overlap one another, or hang in the air. Nothing that a search could settle.
std::vector<Clash> clashes_of_fixed(const PlacementModel& model, const Scope& scope);

}  // namespace layoutbox::placement
