// Typing errors: words that no list and no dictionary has, and the word that was meant.
#pragma once

#include <vector>

#include "layoutbox/plan/words/lexicon.h"
#include "layoutbox/plan/words/stop.h"

namespace layoutbox::offline {

// Replaces words that are misspelt by the nearest known one; what is near nothing stays as it is. Places in the text stay.
void correct_spelling(const Lexicon& lexicon, std::vector<Token>& tokens, StopFlag stop = nullptr);

}  // namespace layoutbox::offline
