// Sides and ends of a thing of which a sentence says where they are.
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// "…, above it on the wall a clock": above it.
// "The long side of the bed is against the wall", "the bed's head is against the wall": the bed is, long side against the wall.
// REQUIRES: one reading a token.
void turn_side_subjects(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
