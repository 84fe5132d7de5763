// Corners of which only the two sides are said: "a desk back right", "in the front left"; walls and sides without a place word: "sofa left
// wall, desk right side"; things right behind such a place: "on the left wall wardrobe".
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Puts the words in that such a place leaves out: "a desk in the back right corner", "sofa on the left wall".
void complete_bare_corners(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
