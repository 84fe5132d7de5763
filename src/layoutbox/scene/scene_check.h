// What a schema cannot say about a scene or a layout: one Error for each fault, with its JSON pointer.
#pragma once

#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/scene/layout.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

// Ids used twice, relations to nobody or without what they need, walls that do not meet, openings outside their walls, fixed objects
// without a place. REQUIRES: read from a document in schema order (pointers count the items).
std::vector<Error> check_scene(const SceneGraph& scene);

// The same for a layout, where every wall, opening and support must be there; relations may name what it lists as left out.
std::vector<Error> check_layout(const Layout& layout);

// All faults as one Error: the first, with all of them in `details` where there are several.
Error combined(std::vector<Error> errors);

}  // namespace layoutbox
