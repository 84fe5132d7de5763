// How many, said apart from the thing or once more: "qty 4", "four pieces", "so four chairs in all".
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Forms' quantities become "x 4", the words beside a number behind its noun are marked in `skip`, and so is a sum of what was counted
// before.
void read_said_counts(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
