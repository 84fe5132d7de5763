// What people want to do somewhere, or want a place for: "somewhere to sit", "a place for her toys", "storage for shoes".
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Puts the thing that is there for it (`uses` of words_uses.json) in the place of such words, unless the text names what does it already.
// Words that say nothing then are marked in `skip`.
void read_uses(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
