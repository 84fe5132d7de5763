// Sentences with known trees, as teach.py and room_sentences.py write them: word, tag, head (1 = first, 0 = none), label; an empty line
// after each.
#pragma once

#include <string>
#include <vector>

#include "layoutbox/plan/syntax/syntax.h"

namespace layoutbox::syntax {

struct Tree {
  std::vector<std::string> words;
  std::vector<int> tags, heads, arcs;  // heads: the number of words for none; tags, heads and arcs: -1 where nobody knows

  int size() const { return static_cast<int>(words.size()); }
};

// Reads a file; crossing arcs are mended by hanging the word higher. Ends the program with a message where a line is wrong.
std::vector<Tree> read_trees(const std::string& path);

}  // namespace layoutbox::syntax
