// How many small things there are where no number is said.
#pragma once

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

// "books on the desk" are three, "lots of mugs" six, as a person would draw them; what comes in twos (lamps, speakers) stays two, and so
// does what its carrier has no room for.
void settle_amounts(const Lexicon& lexicon, Document& document);

}  // namespace layoutbox::offline
