#include "measure.h"

#include <algorithm>
#include <ctime>
#include <iostream>

#include "layoutbox/plan/syntax/features.h"
#include "trees.h"

namespace layoutbox::syntax {

void measure(const std::string& path, const Weights& weights) {
  std::int64_t words = 0, tags = 0, heads = 0, both = 0, preps = 0, right_preps = 0, subjects = 0, right_subjects = 0, joined = 0,
               right_joined = 0;
  const auto trees = read_trees(path);
  const std::clock_t begin = std::clock();
  std::int64_t whole = 0;
  for (const Tree& tree : trees) {
    const auto nodes = parse_with(weights, std::vector<std::string_view>(tree.words.begin(), tree.words.end()));
    bool perfect = true;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (Tag{static_cast<std::uint8_t>(tree.tags[i])} == Tag::kPunct) continue;
      ++words;
      tags += static_cast<int>(nodes[i].tag) == tree.tags[i];
      const int head = nodes[i].head < 0 ? tree.size() : nodes[i].head;
      const bool same = head == tree.heads[i], label = static_cast<int>(nodes[i].arc) == tree.arcs[i];
      heads += same;
      both += same && label;
      perfect &= same;
      const Arc gold{static_cast<std::uint8_t>(tree.arcs[i])};
      if (gold == Arc::kPrep || gold == Arc::kAcl || gold == Arc::kRelcl || gold == Arc::kAdvcl) ++preps, right_preps += same;
      if (gold == Arc::kNsubj || gold == Arc::kNsubjpass || gold == Arc::kDobj || gold == Arc::kPobj)
        ++subjects, right_subjects += same && label;
      if (gold == Arc::kConj) ++joined, right_joined += same && label;
    }
    whole += perfect;
  }
  const double time = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  const auto share = [](std::int64_t part, std::int64_t all) {
    return 100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::int64_t>(all, 1));
  };
  std::cout << path << ": " << trees.size() << " sentences, " << words << " words; tags " << share(tags, words) << ", heads "
            << share(heads, words) << ", heads and labels " << share(both, words) << ", whole trees "
            << share(whole, static_cast<std::int64_t>(trees.size())) << "; prepositions and clauses " << share(right_preps, preps)
            << ", subjects and objects " << share(right_subjects, subjects) << ", members of lists " << share(right_joined, joined)
            << " %; " << time / static_cast<double>(std::max<std::int64_t>(words, 1)) * 15e3 << " ms for 15 words\n";
}

}  // namespace layoutbox::syntax
