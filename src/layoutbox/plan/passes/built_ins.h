// What is built of things that the text names itself: a kitchenette with its hob and sink.
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// "white cupboards, oak worktop": the units have it; it is no unit besides.
void settle_worktops(Document& document);

// "a fireplace with a marble mantel": what has a thing's name and is said to be one's own part is no second one; nor is what makes it a
// special one of its kind.
void settle_namesakes(Document& document);

// "a swing (jhoola)", "a trinchador (sideboard)": another word for the same thing; of the two the one that is known says what it is.
void settle_glosses(Document& document);

// Where parts of such a thing are named (`built_of` of words_kinds.json), it is the plain thing that carries them, and has them all.
void settle_built_ins(const Lexicon& lexicon, Document& document);

}  // namespace layoutbox::offline
