// What several people have, one each.
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// "An office for four programmers. Their desks …": as many as there are people.
void settle_their_own(const Lexicon& lexicon, Document& document);

}  // namespace layoutbox::offline
