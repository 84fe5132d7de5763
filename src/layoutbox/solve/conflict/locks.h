// What is to stay where it was and cannot.
#pragma once

#include <vector>

#include "layoutbox/solve/conflict/conflict.h"

namespace layoutbox::placement {

// Locked or fixed things that overlap each other or stick out of the room: clashes that need no proof.
std::vector<Clash> clashes_of_locks(const PlacementModel& model, const Scope& scope);

}  // namespace layoutbox::placement
