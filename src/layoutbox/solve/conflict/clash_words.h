// Pieces of the sentences that say what clashes.
#pragma once

#include <string>
#include <vector>

#include "layoutbox/solve/model/model.h"

namespace layoutbox::placement {

// "the back wall"; of a room of another shape "wall 5".
std::string wall_in_words(const RoomWall& wall, bool rectangle);
// "the bed, the desk and the chair".
std::string listed(const std::vector<std::string>& words);
// "1.60 × 2.00 × 0.50 m": what it is fixed to, else the least it may measure.
std::string sizes_in_words(const Item& item);
std::string room_in_words(const PlacementModel& model);

}  // namespace layoutbox::placement
