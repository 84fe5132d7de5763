// What is asked for in a roundabout way, said plainly: "would it be possible for the TV to sit there", "find a spot for the plant".
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Marks the words that say nothing of what is where in `skip`, and puts a plain word for one that does.
void read_requests(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
