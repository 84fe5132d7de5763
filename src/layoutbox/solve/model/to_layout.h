// Placements back to the public Layout: positions, supports, relations held, openings with their places.
#pragma once

#include "layoutbox/scene/layout.h"
#include "layoutbox/solve/model/model.h"

namespace layoutbox::placement {

// Everything but status, relaxations, conflicts and statistics. Items that are not placed are left out.
Layout to_layout(const PlacementModel& model, const Placements& placements);

}  // namespace layoutbox::placement
