// Rooms with a fault that geometry is sure of, to judge a judge by.
#pragma once

#include <string>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox::vlm {

struct PlantedFault {
  std::string kind;    // "turned", "swapped", "moved into another", "through a wall", "hung in the air"
  std::string object;  // what it was done to
  std::string why;     // what the verifier says of it
  Layout layout;
};

// One of each kind where the room has an object on which the verifier sees it; none in a room that it does not pass. The same seed plants
// the same ones.
std::vector<PlantedFault> plant_faults(const Layout& sound, const Catalog& catalog, std::uint64_t seed);

}  // namespace layoutbox::vlm
