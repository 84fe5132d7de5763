// "desks in groups of four", "tables in pairs": how many of them stand together.
#pragma once

#include "layoutbox/plan/offline/document.h"

namespace layoutbox::offline {

// Marks the nouns (NounPhrase::together) and lets "the groups", "each pair" speak of them.
void settle_clusters(const Lexicon& lexicon, Document& document);

}  // namespace layoutbox::offline
