// What the text names and the scene does not have.
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Notes every noun of the text that is neither an object of the scene nor a part, a material, a place or listed as no thing; and a room
// in which nothing stands.
void note_left_out(const Lexicon& lexicon, const Document& document, SceneGraph& scene);

}  // namespace layoutbox::offline
