// What a text names though it is not in the room: sold, still to come, next door, seen through the window.
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Passes over the clauses that say so by the phrases of `absent`, `replaced` and `absent_yet` in words_grammar.json; the last only where
// the text says what is there for now.
void settle_absent(const Lexicon& lexicon, Document& document);

}  // namespace layoutbox::offline
