// "A candle on every table; there are five tables": how many there are is said later; "littered with cans": or by what they do.
#pragma once

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

// Gives things that are first spoken of as "each" their number, and makes the later mention one of the same things.
void settle_forward_counts(Document& document);

// "Both sofas have cushions. There are two sofas.": how many "both" or "the two rows of" are, where only a later mention brings them in.
void settle_forward_wholes(const Lexicon& lexicon, Document& document);

// "sofas, chairs and lamps, one of each": so many of each thing that is listed without a number.
void settle_counts_of_each(const Lexicon& lexicon, Document& document);

// "8 beds as bunks": four bunk beds.
void settle_bunks(const Lexicon& lexicon, Document& document);

// "A brass balance … to the left of the balance": what was named is meant, though its word alone names no thing.
void settle_named_again(Document& document);

// "leave space round the bed. A single bed, …": what is first spoken of by "the" is what the later mention brings in.
void settle_forward_names(Document& document);

// "littered with bottles", "a shelf full of cans", "stars all over the ceiling", "plants of all sizes": small things without a
// number that fill something are as many as look like it; and which come in all sizes.
void settle_filling_counts(const Lexicon& lexicon, Document& document);

}  // namespace layoutbox::offline
