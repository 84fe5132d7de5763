// "A lathe stands against the wall, and so does a band saw": what the clause before said is said of another thing.
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

// The words of the clause before are said again after whoever does likewise.
void read_likewise(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
