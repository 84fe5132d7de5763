// "Flanked by a table on the left and by a chest on the right": as "… and flanked by a chest".
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

// Where "and by" goes on with what the sentence said to be done by something else, the participle is said again.
void read_agents(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
