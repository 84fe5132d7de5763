// At which side a door hangs, where nobody said it.
#pragma once

#include <cstddef>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/layout.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

// A leaf that opens into the room stands, once open, at right angles to its wall, and what is beside it there is behind the door: it is
// hung at the side where less is, of two alike at the corner that is near. The floor that it sweeps stays the same square. In the scene
// as in the layout; returns how many doors now hang at the other side.
// REQUIRES: the scene's doors are as the text has them, which says no side.
std::size_t hang_doors_clear(SceneGraph& scene, Layout& layout, const Catalog& catalog);

}  // namespace layoutbox
