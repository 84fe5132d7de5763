// What the files that read changes share.
#pragma once

#include "layoutbox/plan/edit/changes.h"
#include "layoutbox/plan/phrases/knowledge.h"

namespace layoutbox::edit {

inline bool is_at(const Tokens& tokens, std::size_t at, std::string_view word) { return at < tokens.size() && tokens[at].text == word; }

inline void erase(Tokens& tokens, std::size_t first, std::size_t last) {
  tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(first),
               tokens.begin() + static_cast<std::ptrdiff_t>(std::min(last, tokens.size())));
}

// The length that begins at `at` ("20 cm", "half a meter"), and how many tokens it is.
std::optional<offline::Measure> length_at(const offline::Lexicon& lexicon, const Tokens& tokens, std::size_t at);

// How many words of degree stand at `at`: "a bit", "slightly", "a little", "some more", "further".
std::size_t degree_words(const Tokens& tokens, std::size_t at);
// Whether these are such as "a bit", "slightly".
bool says_little(const Tokens& tokens, std::size_t first, std::size_t last);

}  // namespace layoutbox::edit
