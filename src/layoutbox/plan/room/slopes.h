// Ceilings that come down along a wall: attics, lofts under the roof, "the ceiling slopes on both sides".
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// "the ceiling slopes down on one side", "under the slope": as a sloped ceiling. Before phrases are looked for.
void read_slopes(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

// Each slope gets its wall (its turn), rooms under the roof theirs, roof windows their slope. Afterwards nothing places a slope.
void settle_slopes(const Lexicon& lexicon, const Document& document, SceneGraph& scene);

}  // namespace layoutbox::offline
