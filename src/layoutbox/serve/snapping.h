// Where a hand meant to put a thing that it let go near a wall.
#pragma once

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox::serve {

// A thing within 15 cm of a wall, or beyond it, is put flush with the nearest; one that usually has its back to a wall is turned so. A
// second wall at a corner pulls as well.
void snap_to_walls(PlacedObject& object, const Room& room, const CatalogEntry& entry);

// A door or window put at the place of its wall, of any wall, that is nearest to (x, y); millimetres.
void snap_opening(Opening& opening, const Room& room, double x, double y);

}  // namespace layoutbox::serve
