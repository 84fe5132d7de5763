// What a text says besides the room and its things: whom and what they are for, and what it is called.
#pragma once

#include "layoutbox/plan/offline/document.h"

namespace layoutbox::offline {

// "a bedroom for a teenager with bed and desk", "a desk for homework with a lamp on it": a purpose of one noun that is no piece of
// furniture ends where "with" or a colon follows it, so that what comes then belongs to what has the purpose.
// So is the wheelchair that somebody uses.
void settle_purposes(const Lexicon& lexicon, Document& document);

// "Gallery 3, \"Bronze Age Traders\"": marks quoted names of several words, most of them capitalised, in `skip`.
void read_titles(Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
