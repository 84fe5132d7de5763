// What syntax says of a sentence's units: which noun a place, a having or a listed noun belongs to, and how sure that is.
#pragma once

#include <vector>

#include "layoutbox/plan/reading/units.h"

namespace layoutbox::offline {

class SentenceTree {
 public:
  SentenceTree() = default;
  SentenceTree(const Document& document, const Sentence& sentence);

  // How much syntax is for the noun `noun` as what the unit `u` belongs to: 1 if it is that, −1 if it is another one, 0 if nothing is
  // known; less where the parse was close.
  double for_noun(int u, int noun) const {
    if (u >= static_cast<int>(owner_.size()) || owner_[static_cast<std::size_t>(u)] < 0) return 0;
    const double sure = sure_[static_cast<std::size_t>(u)];
    return owner_[static_cast<std::size_t>(u)] == noun ? sure : -sure / 2;
  }

  // Whether syntax takes what is a bare noun by its look for a verb: "a stool that rolls", "… and swings with every wave".
  bool is_verb(std::size_t u) const { return verb_[u]; }

 private:
  std::vector<int> owner_;
  std::vector<double> sure_;
  std::vector<bool> verb_;
};

// Takes out of the sentence what only looks like a noun; whether there was any.
bool pass_verbs(Document& document, const SentenceTree& tree, Sentence& sentence);

}  // namespace layoutbox::offline
