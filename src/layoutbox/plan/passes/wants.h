// What somebody wants to be able to do in a room: "We need to cook, wash up and eat here", "a bathroom where I can bathe and iron".
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// The things that are there for it become `Document::wanted`; of such words only the furniture that they name is left to read.
void read_wants(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
