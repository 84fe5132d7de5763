// "A cart shall carry four towels": as "a cart carries four towels".
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

// What a thing shall, must or will have or carry is said in the present tense, where only that is known of the verb.
void read_modals(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
