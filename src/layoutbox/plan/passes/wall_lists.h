// "The north and the east wall": a word left out that the next one has.
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

// Puts in the "wall" that the first of two walls shares with the second.
void complete_wall_lists(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
