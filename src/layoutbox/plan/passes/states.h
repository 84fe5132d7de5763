// How things are that stand about: "a chair tipped over", "the dishwasher is open", "six beds, two of them overturned".
#pragma once

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

// Gives the things their states as attributes (words_attributes.json: states). REQUIRES: the document is read.
void settle_states(const Lexicon& lexicon, Document& document);

}  // namespace layoutbox::offline
