// Relative clauses that begin with a place, in the middle of a sentence, become sentences of their own.
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// "The desk, on which a lamp stands, is in the corner": the desk is in the corner; on it a lamp stands. REQUIRES: one reading a token.
void part_relatives(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
