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

 private:
  std::vector<int> owner_;
  std::vector<double> sure_;
};

}  // namespace layoutbox::offline
