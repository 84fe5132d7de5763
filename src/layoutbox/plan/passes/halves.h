// Halves and ends of the room that have things: "the left half is an office with a desk", "front of shop: a counter".
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Says it as a place: "in the left half of the room is a desk".
void read_halves(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
