// Things along walls: those of which the text leaves open how many they are, and those that are shared out over several walls.
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/planner.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

// REQUIRES: the scene's objects begin with the document's items, in their order; the relations are built.
std::vector<Lining> find_linings(const Lexicon& lexicon, const Document& document, const SceneGraph& scene);

}  // namespace layoutbox::offline
