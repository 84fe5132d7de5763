// "with four chairs each, placed in two rows": "each" stands behind what it shares out.
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

// Where a participle follows, which could be said of "each", it comes before the having: "each with four chairs, placed in two rows".
void read_each_after(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
