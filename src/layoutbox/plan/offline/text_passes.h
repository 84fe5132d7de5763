// What is done to a text before its phrases are read: passes in the order in which they run, each with an example.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Over the words, before phrases are looked for: puts plain words in the place of others, or marks in `skip` what needs no reading.
// `run` REQUIRES: one reading and one mark of `skip` a token; then so it is again.
struct WordPass {
  std::string_view name;
  void (*run)(const Lexicon&, Document&, std::vector<bool>& skip);
  std::string_view example, plain;  // a text that needs it, and one that says the same without
};

// Over the phrases, before they are read into things and links.
struct PhrasePass {
  std::string_view name;
  void (*run)(const Lexicon&, Document&);
  std::string_view example, plain;
};

std::span<const WordPass> word_passes();
std::span<const PhrasePass> phrase_passes();

}  // namespace layoutbox::offline
