// What kind of seat a plain one is by the table that it is at.
#pragma once

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox::offline {

// Plain chairs round a table for children are such chairs.
void seat_children(const Catalog& catalog, SceneGraph& scene);

}  // namespace layoutbox::offline
