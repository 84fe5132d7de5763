// British spellings of single words that the word lists have in American ones.
#pragma once

#include <string>

namespace layoutbox::offline {

// The word as the lists have it; others stay as they are.
std::string american_spelling(std::string word);

}  // namespace layoutbox::offline
