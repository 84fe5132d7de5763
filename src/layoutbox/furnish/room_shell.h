// The room itself: floor, walls with real openings, skirtings, ceiling, doors and windows.
#pragma once

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/furnish/decor.h"
#include "layoutbox/furnish/palette.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

// Appends the nodes "floor", one per wall (mitred at the corners; its frame: x along the wall, y into the room), one per opening (frame,
// leaf or panes; origin at its near edge on the floor) and "ceiling". A door stands ajar as its swing says, as far as nothing is in its
// way. REQUIRES: a normalised room (polygon, walls with start and end, openings with wall and offset).
void add_room_shell(const Layout& layout, const Catalog& catalog, const Decor& decor, Palette& palette, Model& model);

}  // namespace layoutbox
