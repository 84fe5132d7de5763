// A layout as the scene it could have come from, for those who have only the layout.
#pragma once

#include "layoutbox/scene/layout.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

// The layout's room with its openings where they are, its objects with exactly their sizes, its relations (without what it lists as left
// out), and what stands on what.
// Places are left out: give the layout itself as SolveOptions::from. Not yet normalised.
SceneGraph scene_of(const Layout& layout);

}  // namespace layoutbox
