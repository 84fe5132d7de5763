// Sides of a room without their unit: "5 m wide and 9 deep", "12 wide, 28 long".
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

// Puts in the unit of the sides that stand beside it, metres where none has one.
void complete_bare_sides(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
