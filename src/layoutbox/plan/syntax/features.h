// Features: keys made of what is around a word or a state. Trainer and parser share them; a change asks for new weights.
#pragma once

#include <cstdint>
#include <vector>

#include "layoutbox/plan/syntax/sentence.h"

namespace layoutbox::syntax {

using Features = std::vector<std::uint64_t>;

// For the tag of a word, the words before it being tagged. `features` is cleared first, here and below.
void tag_features(const TaggedSentence& sentence, int word, Features& features);

// For the next step.
void step_features(const TaggedSentence& sentence, const ParserState& state, Features& features);

// For the label of the arc that a left or right step makes.
void label_features(const TaggedSentence& sentence, const ParserState& state, ParserStep step, Features& features);

// syntax::parse with other weights than the program's.
std::vector<TreeNode> parse_with(const Weights& weights, std::span<const std::string_view> words);

}  // namespace layoutbox::syntax
