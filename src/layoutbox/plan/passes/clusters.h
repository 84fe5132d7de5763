// "desks in groups of four", "tables in pairs": how many of them stand together.
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Marks the nouns (NounPhrase::together) and lets "the groups", "each pair" speak of them.
void settle_clusters(const Lexicon& lexicon, Document& document);

// "desks for two in four rows of three", "pews in three rows": so many make the rows.
void settle_grid_counts(Document& document);

// "24 pupils in six groups of four": how many of the people sit together; 0: nobody says so.
int people_together(const Lexicon& lexicon, const Document& document);

}  // namespace layoutbox::offline
