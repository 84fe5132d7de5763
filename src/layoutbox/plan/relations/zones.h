// "A reading corner with a rug and beanbags", "a play area": parts of the room whose things stand together.
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Finds the zones that the text names, and which of its things are theirs; one of which nothing is named gets what is usual there
// (concluded). REQUIRES: read_document() has been.
void find_zones(const Lexicon& lexicon, Document& document);

}  // namespace layoutbox::offline
