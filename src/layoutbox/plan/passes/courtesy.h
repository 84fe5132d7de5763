// What people say to whom they ask: who they are, and please.
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

// Marks in `skip` the words of "if you could also …" and of "I'm a nurse on a dialysis unit and want to show what I mean: …", where these
// name no room. What is asked for is what is left.
void read_courtesies(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
