// Looks of doors and windows that stand behind them: "a window full height on the east wall", "a door, sliding, to the garden".
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Puts them before the noun, where they are read: "a full height window on the east wall".
void put_looks_before(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
