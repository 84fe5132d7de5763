// Lists without commas: "shower toilet sink washing machine".
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Puts commas into rows of things that no word joins: three pieces of furniture or more one after the other, or two that are a clause of
// their own. Names of the lexicon ("desk lamp") are one thing. REQUIRES: one reading a token.
void part_runs(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
