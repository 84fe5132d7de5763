// "A candle on every table; there are five tables": how many there are is said later; "littered with cans": or by what they do.
#pragma once

#include "layoutbox/plan/offline/document.h"
#include "layoutbox/plan/offline/lexicon.h"

namespace layoutbox::offline {

// Gives things that are first spoken of as "each" their number, and makes the later mention one of the same things.
void settle_forward_counts(Document& document);

// "littered with bottles", "stars all over the ceiling": small things without a number that fill something are
// more than two.
void settle_filling_counts(const Lexicon& lexicon, Document& document);

}  // namespace layoutbox::offline
