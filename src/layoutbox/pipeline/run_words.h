// What a run says of its stages, a line each.
#pragma once

#include <string>

#include "layoutbox/scene/layout.h"
#include "layoutbox/scene/scene_graph.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox {

std::string scene_in_words(const SceneGraph& scene);  // "6 objects, 2 relations"
std::string solved_in_words(const Layout& layout);    // "2 of 3 relations held, 1 given up (search)"
std::string verified_in_words(const Report& report);  // "all 62 checks passed or warned"

}  // namespace layoutbox
