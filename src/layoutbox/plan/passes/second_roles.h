// One thing that is two: "a bed that is also the sofa", "a sofa that turns into a bed", "a table that doubles as a desk".
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// What it is besides is no second thing: where the catalogue has a kind of both names ("sofa bed") it is one of those, else what it is
// first.
void read_second_roles(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
