// Lists of examples: "five objects (mugs, bowls, bottles)", "some props such as a suitcase".
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// What is listed behind a word for any things ("objects", "items", "props") is what they are: the word and what leads to the list go, and
// a number before it is shared out among those that are listed. REQUIRES: one reading a token.
void read_examples(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
