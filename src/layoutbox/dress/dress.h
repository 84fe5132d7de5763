// Dresses a finished room: what a person would have drawn besides, where it is free. Nothing that stands is touched; pictures,
// posters and strings of lights of which nothing says where they hang, and that nobody would see, are hung where they are seen.
#pragma once

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/plan/spoken.h"
#include "layoutbox/scene/layout.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

// Adds to a solved layout, and to the scene that it was solved from, what catalog/dress.json has for such a room: origin "added", exact
// places, in the scene as hints. Never of a kind that the text speaks of, nor where it wants an empty or a plain room; and nothing for
// which verify() would find anything that it did not find before. The same bytes each time. Returns how many things were added or
// hung elsewhere.
// REQUIRES: a normalised scene and its layout.
std::size_t dress(SceneGraph& scene, Layout& layout, const Catalog& catalog, const Spoken& spoken);

}  // namespace layoutbox
