// What the use of the named things needs and the text leaves out: a desk's chair, chairs at a dining table, a lamp by a bed; in a bare
// room of a known kind some of what is usual there. Marked as ours, soft, and the first to give way.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

// Adds them to a scene planned from text, never of a kind that it names, counts or wants none of (`excluded`: Plan::unwanted).
// REQUIRES: `sized` is the same scene normalised (sizes of its things and of the room). Returns how many were added.
std::size_t add_companions(SceneGraph& scene, const SceneGraph& sized, const std::vector<std::string>& excluded, const Catalog& catalog);

}  // namespace layoutbox
