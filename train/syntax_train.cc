// syntax_train: learns the weights of plan/syntax from trees (docs/syntax.md).
//
//   syntax_train --words WORDS --output FILE [--recipe TEXT] [--epochs N] [--keep-tag N] [--keep-step N] [--keep-label N]
//                TREES[:TIMES] … [--test TREES …]
//   syntax_train --weights FILE --test TREES …          measures only
#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>

#include "layoutbox/plan/syntax/features.h"
#include "learner.h"
#include "measure.h"
#include "trees.h"
#include "weights_file.h"

namespace layoutbox::syntax {
namespace {

struct Options {
  std::string words, output, weights, recipe;
  int epochs = 8;
  std::array<std::size_t, kModels> keep = {60000, 150000, 40000};
  std::vector<std::string> trees, tests;
};

struct Example {
  const Tree* tree = nullptr;
  Sentence sentence;  // with tags as the tagger sees them
};

std::vector<std::string_view> views(const Tree& tree) { return {tree.words.begin(), tree.words.end()}; }

template <std::size_t N>
int best_of(const std::array<float, N>& scores) {
  return static_cast<int>(std::max_element(scores.begin(), scores.end()) - scores.begin());
}

// --- tags

void tag(const Learner& tagger, Sentence& sentence, Features& features) {
  sentence.tags.assign(sentence.words.size(), 0);
  for (int i = 0; i < sentence.size(); ++i) {
    std::array<float, kTags> scores{};
    tag_features(sentence, i, features);
    tagger.add(features, scores);
    sentence.tags[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(best_of(scores));
  }
  look_ahead(sentence);
}

void learn_tags(Learner& tagger, std::vector<Example*> examples, int epochs, const std::string& what) {
  std::mt19937 random(5);
  Features features;
  for (int epoch = 0; epoch < epochs; ++epoch) {
    std::shuffle(examples.begin(), examples.end(), random);
    std::int64_t right = 0, all = 0;
    for (Example* example : examples) {
      Sentence& sentence = example->sentence;
      sentence.tags.assign(sentence.words.size(), 0);
      for (int i = 0; i < sentence.size(); ++i) {
        const int gold = example->tree->tags[static_cast<std::size_t>(i)];
        std::array<float, kTags> scores{};
        tag_features(sentence, i, features);
        tagger.add(features, scores);
        const int best = best_of(scores);
        if (gold >= 0 && best != gold) tagger.update(features, gold, best);
        tagger.tick();
        right += best == gold;
        ++all;
        sentence.tags[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(best);
      }
    }
    std::cerr << what << " epoch " << epoch + 1 << ": " << 100.0 * static_cast<double>(right) / static_cast<double>(all) << " %\n";
  }
}

// A tagger with averaged weights, for tagging text that it has not seen.
Learner averaged_learner(const Learner& learner) {
  Learner result;
  for (const auto& [feature, weights] : learner.averaged()) {
    for (const auto& [label, weight] : weights) result.set(feature, label, weight);
  }
  return result;
}

// The parser learns on tags as they will be: each half of the text is tagged by what learned on the other.
void tag_by_halves(std::vector<Example>& examples, int epochs) {
  for (std::size_t half = 0; half < 2; ++half) {
    Learner tagger;
    std::vector<Example*> others;
    for (std::size_t i = 0; i < examples.size(); ++i) {
      if (i % 2 != half) others.push_back(&examples[i]);
    }
    learn_tags(tagger, others, epochs, "half " + std::to_string(half + 1));
    const Learner averaged = averaged_learner(tagger);
    Features features;
    for (std::size_t i = half; i < examples.size(); i += 2) tag(averaged, examples[i].sentence, features);
  }
}

// --- trees

// Arcs of the right tree that a step puts out of reach.
int cost(const State& state, const Tree& tree, Step step) {
  const auto head = [&](int word) { return tree.heads[static_cast<std::size_t>(word)]; };
  const int s0 = state.top(0), b0 = state.next(), n = tree.size();
  int lost = 0;
  if (step == Step::kShift) {
    for (int depth = 0; depth < state.depth(); ++depth) {
      const int word = state.top(depth);
      if (depth > 0 && head(b0) == word) ++lost;
      if (head(word) == b0) ++lost;
    }
    return lost;
  }
  for (int word = b0; word < n; ++word) lost += head(word) == s0;  // words to come that hang on s0
  if (step == Step::kLeft) {
    if (state.depth() > 1 && head(s0) == state.top(1)) ++lost;
    if (head(s0) > b0) ++lost;
  } else if (head(s0) >= b0) {
    ++lost;
  }
  return lost;
}

struct Parser {
  Learner steps, labels;
};

int best_step(const State& state, const std::array<float, kSteps>& scores, const std::array<int, kSteps>* costs, int allowed_cost) {
  int best = -1;
  for (int i = 0; i < kSteps; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (!state.allows(Step{static_cast<std::uint8_t>(i)}) || (costs != nullptr && (*costs)[at] > allowed_cost)) continue;
    if (best < 0 || scores[at] > scores[static_cast<std::size_t>(best)]) best = i;
  }
  return best;
}

struct Counts {
  std::int64_t steps = 0, wrong = 0;
};

void learn_tree(Parser& parser, const Example& example, bool explore, std::mt19937& random, Counts& counts) {
  const Tree& tree = *example.tree;
  const Sentence& sentence = example.sentence;
  State state(sentence.size());
  Features features;
  while (!state.done()) {
    std::array<float, kSteps> scores{};
    step_features(sentence, state, features);
    parser.steps.add(features, scores);
    std::array<int, kSteps> costs{};
    int least = 1 << 20;
    for (int i = 0; i < kSteps; ++i) {
      const Step step{static_cast<std::uint8_t>(i)};
      costs[static_cast<std::size_t>(i)] = state.allows(step) ? cost(state, tree, step) : 1 << 20;
      least = std::min(least, costs[static_cast<std::size_t>(i)]);
    }
    const int guess = best_step(state, scores, nullptr, 0), gold = best_step(state, scores, &costs, least);
    ++counts.steps;
    const bool wrong = costs[static_cast<std::size_t>(guess)] > least;
    if (wrong) {
      ++counts.wrong;
      parser.steps.update(features, gold, guess);
    }
    parser.steps.tick();
    const Step step{static_cast<std::uint8_t>(wrong && !(explore && random() % 10 != 0) ? gold : guess)};
    Arc arc = Arc::kDep;
    const int child = state.dependent(step), head = state.head(step);
    if (child >= 0 && head == sentence.size()) {
      arc = Arc::kRoot;
    } else if (child >= 0) {
      std::array<float, kArcs> label_scores{};
      label_features(sentence, state, step, features);
      parser.labels.add(features, label_scores);
      int label = best_of(label_scores);
      const int right = tree.arcs[static_cast<std::size_t>(child)];
      if (tree.heads[static_cast<std::size_t>(child)] == head && right >= 0) {
        if (label != right) parser.labels.update(features, right, label);
        parser.labels.tick();
      }
      arc = Arc{static_cast<std::uint8_t>(label)};
    }
    state.apply(step, arc);
  }
}

void learn_trees(Parser& parser, std::vector<Example>& examples, int epochs) {
  std::mt19937 random(11);
  std::vector<const Example*> order;
  for (const Example& example : examples) order.push_back(&example);
  for (int epoch = 0; epoch < epochs; ++epoch) {
    std::shuffle(order.begin(), order.end(), random);
    Counts counts;
    for (const Example* example : order) learn_tree(parser, *example, epoch > 0, random, counts);
    std::cerr << "trees epoch " << epoch + 1 << ": " << 100.0 * static_cast<double>(counts.wrong) / static_cast<double>(counts.steps)
              << " % of steps wrong\n";
  }
}

// The median of the words' margins.
float usual_margin(const Weights& weights, const std::vector<Example>& examples) {
  std::vector<float> margins;
  for (std::size_t i = 0; i < examples.size(); i += 20) {
    for (const TreeNode& node : parse_with(weights, views(*examples[i].tree))) margins.push_back(node.margin);
  }
  std::sort(margins.begin(), margins.end());
  return std::max(margins[margins.size() / 2], 1.0F);
}

std::string learn(const Options& options) {
  const std::string words = word_table(options.words);
  float unused = 0;
  const std::string none = model_table(WeightTable::kTag, {}, 0, unused);
  const std::string only_words = weights_file(words, {none, none, none}, {});
  const Weights known(only_words);
  std::vector<std::pair<std::vector<Tree>, int>> files;
  for (const std::string& file : options.trees) {
    const std::size_t colon = file.rfind(':');
    files.emplace_back(read_trees(file.substr(0, colon)), colon == std::string::npos ? 1 : std::stoi(file.substr(colon + 1)));
  }
  std::vector<Example> examples;
  for (const auto& [trees, times] : files) {
    for (const Tree& tree : trees) {
      for (int i = 0; i < times; ++i) examples.push_back({&tree, read_sentence(views(tree), known)});
    }
  }
  std::cerr << examples.size() << " sentences\n";
  Learner tagger;
  std::vector<Example*> all;
  for (Example& example : examples) all.push_back(&example);
  learn_tags(tagger, all, options.epochs, "tags");
  tag_by_halves(examples, std::max(2, options.epochs / 2));
  Parser parser;
  learn_trees(parser, examples, options.epochs);
  std::array<float, kModels> units{};
  const std::array<const Learner*, kModels> learners = {&tagger, &parser.steps, &parser.labels};
  std::array<std::string, kModels> tables;
  for (std::size_t i = 0; i < kModels; ++i) {
    tables[i] = model_table(WeightTable{static_cast<std::uint8_t>(i)}, learners[i]->averaged(), options.keep[i], units[i]);
    std::cerr << "model " << i << ": " << tables[i].size() << " bytes\n";
  }
  const std::string plain = weights_file(words, tables, {1, 1, 1});
  const float usual = usual_margin(Weights(plain), examples);
  return weights_file(words, tables, {1, 1 / usual, 1});
}

std::string read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Options read_options(const std::vector<std::string>& arguments) {
  Options options;
  bool tests = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    const auto next = [&] { return ++i < arguments.size() ? arguments[i] : std::string(); };
    if (word == "--words") {
      options.words = next();
    } else if (word == "--output") {
      options.output = next();
    } else if (word == "--weights") {
      options.weights = next();
    } else if (word == "--recipe") {
      options.recipe = next();
    } else if (word == "--epochs") {
      options.epochs = std::stoi(next());
    } else if (word == "--keep-tag" || word == "--keep-step" || word == "--keep-label") {
      options.keep[word == "--keep-tag" ? 0 : word == "--keep-step" ? 1 : 2] = std::stoul(next());
    } else if (word == "--test") {
      tests = true;
    } else {
      (tests ? options.tests : options.trees).push_back(word);
    }
  }
  return options;
}

}  // namespace
}  // namespace layoutbox::syntax

int main(int count, char** values) {
  using namespace layoutbox::syntax;
  const Options options = read_options({values + 1, values + count});
  const std::string bytes = options.weights.empty() ? learn(options) : read_bytes(options.weights);
  if (!options.output.empty()) std::ofstream(options.output, std::ios::binary) << bytes << options.recipe;
  const Weights weights(bytes);
  for (const std::string& test : options.tests) measure(test, weights);
}
