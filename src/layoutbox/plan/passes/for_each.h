// "A room for two girls: a bed and a desk for each", "a bed each": as many of a thing as there are people.
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

// For how many the room is, as said before the chunk at k: "two boys", "the twins"; 0: nobody says.
int people_before(const Lexicon& lexicon, const std::vector<Chunk>& chunks, std::size_t k);

// "for two girls: bed, desk and wardrobe for each", "a bed each".
void settle_for_each(const Lexicon& lexicon, Document& document);

}  // namespace layoutbox::offline
