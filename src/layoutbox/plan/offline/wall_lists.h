// "The north and the east wall": a word left out that the next one has.
#pragma once

#include <vector>

#include "layoutbox/plan/offline/document.h"
#include "layoutbox/plan/offline/lexicon.h"

namespace layoutbox::offline {

// Puts in the "wall" that the first of two walls shares with the second.
void complete_wall_lists(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
