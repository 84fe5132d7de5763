// "a sofa or two armchairs", "either a desk, a table or a bench": the first of them is taken.
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

// Marks in `skip` all things but the first of those of which the text wants one, and says so in a note.
void read_alternatives(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
