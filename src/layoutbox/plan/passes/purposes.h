// What a text says besides the room and its things: whom and what they are for.
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// "a bedroom for a teenager with bed and desk", "a desk for homework with a lamp on it": a purpose of one noun that is no piece of
// furniture ends where "with" or a colon follows it, so that what comes then belongs to what has the purpose.
// So is the wheelchair that somebody uses.
void settle_purposes(const Lexicon& lexicon, Document& document);

}  // namespace layoutbox::offline
