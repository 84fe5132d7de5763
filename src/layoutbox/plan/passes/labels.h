// What is written on a text rather than said of the room: quoted names, prices, codes such as "3B", and how a letter ends.
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Marks in `skip` the tokens of quoted names of several words most of which are capitalised ("Gallery 3, \"Bronze Age Traders\""), of
// sums of money with what leads to them ("for under 200 dollars"), of codes ("an A3 poster", "flat 3B"), and all that follows a closing
// ("Best regards, Tom", "Sent from my phone").
void read_labels(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
