// Who writes as they speak corrects themselves: "one bookcase, actually make that two", "No wait, put it under the window instead".
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

// Gives what was counted before "make that two" that number, and marks the correction's own words in `skip`.
void read_corrected_counts(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

// "Put the desk in the middle. No wait, put it under the window": the place said last is the one; the one before is not read.
void settle_corrected_places(Document& document);

}  // namespace layoutbox::offline
