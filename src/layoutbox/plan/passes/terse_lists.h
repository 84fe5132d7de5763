// How lists are typed in a hurry: "24 kids.", "table center", "a plant, desk should face the door".
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Completes what such a list leaves out, and parts what only its commas join. How many people are named on their own is how many the room
// is for (`Document::people`).
void read_terse_lists(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
