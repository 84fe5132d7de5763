// The wall along which the ceiling comes down.
#pragma once

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

// Of a slope of the roof the wall that it has its back to: it is in the picture where that is. Null: it is none, or stands at no wall.
const Wall* wall_of_slope(const Layout& layout, const PlacedObject& object, const Catalog& catalog);

}  // namespace layoutbox
