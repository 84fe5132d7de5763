// Corners of which only the two sides are said: "a desk back right", "in the front left".
#pragma once

#include "layoutbox/plan/offline/document.h"

namespace layoutbox::offline {

// Puts the words in that such a corner leaves out: "a desk in the back right corner".
void complete_bare_corners(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
