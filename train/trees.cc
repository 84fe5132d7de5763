#include "trees.h"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

namespace layoutbox::syntax {
namespace {

template <typename Kind>
int find_name(const std::string& text, int kinds) {
  for (int i = 0; i < kinds; ++i) {
    if (name(Kind{static_cast<std::uint8_t>(i)}) == text) return i;
  }
  return -1;
}

// A word whose arc crosses another, or -1.
int crossing(const Tree& tree) {
  for (int child = 0; child < tree.size(); ++child) {
    const int head = tree.heads[static_cast<std::size_t>(child)];
    const int low = std::min(child, head), high = std::max(child, head);
    for (int between = low + 1; between < high; ++between) {
      const int other = tree.heads[static_cast<std::size_t>(between)];
      if (other < low || other > high) return high == tree.size() ? between : child;
    }
  }
  return -1;
}

void mend(Tree& tree) {
  for (int rounds = 0; rounds < 50; ++rounds) {
    const int child = crossing(tree);
    if (child < 0) return;
    int& head = tree.heads[static_cast<std::size_t>(child)];
    head = head == tree.size() ? tree.size() : tree.heads[static_cast<std::size_t>(head)];
  }
}

}  // namespace

std::vector<Tree> read_trees(const std::string& path) {
  std::ifstream file(path);
  if (!file) {
    std::cerr << "cannot read " << path << '\n';
    std::exit(2);
  }
  std::vector<Tree> trees(1);
  std::string line;
  std::map<std::string, int> unknown;
  while (std::getline(file, line)) {
    Tree& tree = trees.back();
    if (line.empty()) {
      if (tree.size() > 0) trees.emplace_back();
      continue;
    }
    std::istringstream parts(line);
    std::string word, tag, head, label;
    if (!std::getline(parts, word, '\t') || !(parts >> tag >> head >> label)) {
      std::cerr << path << ": " << line << '\n';
      std::exit(2);
    }
    const int arc = find_name<Arc>(label, kArcs);
    if (arc < 0) ++unknown[label];
    tree.words.push_back(word);
    tree.tags.push_back(find_name<Tag>(tag, kTags));
    tree.heads.push_back(std::stoi(head) - 1);
    tree.arcs.push_back(arc);
  }
  if (trees.back().size() == 0) trees.pop_back();
  for (const auto& [label, count] : unknown) std::cerr << path << ": unknown label " << label << ", " << count << " times\n";
  for (Tree& tree : trees) {
    for (int& head : tree.heads) {
      if (head < 0) head = tree.size();
    }
    mend(tree);
  }
  std::erase_if(trees, [](const Tree& tree) { return crossing(tree) >= 0; });
  return trees;
}

}  // namespace layoutbox::syntax
