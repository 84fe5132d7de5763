// Shelves that belong to a thing and are spoken of by themselves.
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// "The rack's middle shelf holds four loaves", "its top shelf holds jars, its bottom shelf crocks", "a cabinet whose lower shelf carries a
// radio": on the middle shelf of the rack are four loaves, and so on. REQUIRES: one reading a token.
void turn_shelf_subjects(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
