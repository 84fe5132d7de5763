// Whose things are: "her bed …, his by the door", "at the foot of hers", "the other one" of two that belong to somebody.
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// A possessive that stands alone is followed by what is meant; where two of one kind have different owners each possessive says which.
// REQUIRES: one reading and one mark of `skip` a token; then so it is again.
void read_owners(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
