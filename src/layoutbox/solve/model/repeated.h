// Relations that a scene says more than once: they are solved once, and reported as often as they were said.
#pragma once

#include <optional>
#include <vector>

#include "layoutbox/scene/layout.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox::placement {

// The scene without its repeated relations; nothing where there are none.
std::optional<SceneGraph> without_repeats(const SceneGraph& scene);

// Puts the repeated relations back into a layout of that scene, each as the first of its kind went.
void add_repeats(const SceneGraph& scene, Layout& layout);

}  // namespace layoutbox::placement
