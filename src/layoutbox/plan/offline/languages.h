// Texts in other languages: which one it is, and its words in English.
#pragma once

#include <optional>
#include <string>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// The name of the other language whose small words make up much of the text; none for English, and for texts too short to tell.
std::optional<std::string> foreign_language(const Document& document);

// Puts English words in the place of those that the glossary of that language has (catalog/words_languages.json), the longest phrases
// first; false, and nothing is changed, where there is no glossary. What is made of several words keeps the place of the first.
bool translate(const std::string& language, Document& document);

}  // namespace layoutbox::offline
