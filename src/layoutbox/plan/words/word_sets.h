// Sets of words that say the same to the reader: what one lies on, what daylight is called, how heaps are. They stand in
// catalog/words_sets.json, each with what it is; a test compares the two.
#pragma once

#include <cstdint>
#include <string_view>

namespace layoutbox::offline {

enum class WordSet : std::uint8_t {
#define LAYOUTBOX_WORD_SET(name, key) k##name,
#include "layoutbox/plan/words/word_sets.inc"
#undef LAYOUTBOX_WORD_SET
};

// The word as the set has it, for as long as the program runs; empty where it has not.
std::string_view word_of(WordSet set, std::string_view word);
inline bool one_of(std::string_view word, WordSet set) { return !word_of(set, word).empty(); }

}  // namespace layoutbox::offline
