// Seats that are counted and then shared out: "eight chairs: three on each long side and one at each end".
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

// Where the shares make up the number they are read in its place: "three chairs on each long side and one at each end".
void read_side_shares(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
