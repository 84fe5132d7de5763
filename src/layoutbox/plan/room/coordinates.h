// Where a text says by coordinates that a thing, a door or a window is: "centred at x=3.0", "a lamp at (5.6, 0.4)", "a door in the west
// wall at y = 3.5", "a door 0.3 m from the west corner". They are metres from the room's left (x) and front (y) wall, of the thing's
// middle.
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Takes the words out before phrases are looked for, and keeps what they say.
void read_coordinates(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);
// Hands it to the noun that it is said of: the last one before it, else the first behind it; to doors and windows also how far off a
// corner.
void settle_coordinates(const Lexicon& lexicon, Document& document);

}  // namespace layoutbox::offline
