// Terse wishes leave out articles, and nouns that were just said: "behind counter wooden shelves", "one chair by the door, two opposite".
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

// Puts them in. REQUIRES: one reading and one mark of `skip` a token.
void complete_bare_starts(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
