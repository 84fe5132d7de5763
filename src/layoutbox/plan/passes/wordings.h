// Wordings of people's wishes that say something plain in other words: pictures of rooms, "besides", "a 3 seater", halves and ends of
// rooms.
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Replaces the words of `document` by plain ones; those that say nothing are marked in `skip`.
void read_wordings(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
