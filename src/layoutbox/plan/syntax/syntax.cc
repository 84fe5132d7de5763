#include "layoutbox/plan/syntax/syntax.h"

#include <algorithm>
#include <array>
#include <limits>

#include "layoutbox/plan/syntax/features.h"

namespace layoutbox::syntax {
namespace {

void find_tags(TaggedSentence& sentence, const Weights& weights, Features& features) {
  sentence.tags.assign(sentence.words.size(), 0);
  for (int i = 0; i < sentence.size(); ++i) {
    std::array<int, kTags> scores{};
    tag_features(sentence, i, features);
    weights.add(WeightTable::kTag, features, scores);
    sentence.tags[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::max_element(scores.begin(), scores.end()) - scores.begin());
  }
  look_ahead(sentence);
}

struct StepChoice {
  ParserStep step = ParserStep::kShift;
  float margin = 0;  // how much better than the next best; large where nothing else is allowed
};

StepChoice choose_step(const TaggedSentence& sentence, const ParserState& state, const Weights& weights, Features& features) {
  std::array<int, kSteps> scores{};
  step_features(sentence, state, features);
  weights.add(WeightTable::kStep, features, scores);
  constexpr int kLowest = std::numeric_limits<int>::min() / 2;
  int best = -1, first = kLowest, second = kLowest;
  for (int i = 0; i < kSteps; ++i) {
    if (!state.allows(ParserStep{static_cast<std::uint8_t>(i)})) continue;
    const int score = scores[static_cast<std::size_t>(i)];
    if (best < 0 || score > first) {
      second = first;
      first = score;
      best = i;
    } else {
      second = std::max(second, score);
    }
  }
  constexpr float kSure = 1e6F;
  return {ParserStep{static_cast<std::uint8_t>(best)},
          second == kLowest ? kSure : static_cast<float>(first - second) * weights.scale(WeightTable::kStep)};
}

Arc choose_label(const TaggedSentence& sentence, const ParserState& state, ParserStep step, const Weights& weights, Features& features) {
  if (state.head(step) == sentence.size()) return Arc::kRoot;
  std::array<int, kArcs> scores{};
  label_features(sentence, state, step, features);
  weights.add(WeightTable::kLabel, features, scores);
  scores[static_cast<std::size_t>(Arc::kRoot)] = std::numeric_limits<int>::min();
  return Arc{static_cast<std::uint8_t>(std::max_element(scores.begin(), scores.end()) - scores.begin())};
}

}  // namespace

std::vector<TreeNode> parse(std::span<const std::string_view> words) { return parse_with(built_in_weights(), words); }

std::vector<TreeNode> parse_with(const Weights& weights, std::span<const std::string_view> words) {
  Features features;
  TaggedSentence sentence = read_sentence(words, weights);
  find_tags(sentence, weights, features);
  ParserState state(sentence.size());
  std::vector<TreeNode> nodes(words.size());
  std::vector<float> margins(words.size(), std::numeric_limits<float>::max());
  while (!state.done()) {
    const StepChoice choice = choose_step(sentence, state, weights, features);
    const int child = state.dependent(choice.step);
    // A shift decides for the word before it too: that word stays open.
    for (const int about : {state.top(0), child}) {
      if (about >= 0) margins[static_cast<std::size_t>(about)] = std::min(margins[static_cast<std::size_t>(about)], choice.margin);
    }
    const Arc arc = child < 0 ? Arc::kDep : choose_label(sentence, state, choice.step, weights, features);
    state.apply(choice.step, arc);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const int head = state.head_of(static_cast<int>(i));
    nodes[i] = {Tag{sentence.tags[i]}, state.arc_of(static_cast<int>(i)), head == sentence.size() ? -1 : head, margins[i]};
  }
  return nodes;
}

}  // namespace layoutbox::syntax
