// How finely the kit makes round things: one level for all that a piece is made of, so that families need not know of it.
#pragma once

#include <algorithm>

#include "layoutbox/furnish/furnish.h"

namespace layoutbox::kit {

// The level on this thread while it lives; before and after it kUsual.
class DetailScope {
 public:
  explicit DetailScope(Detail detail);
  ~DetailScope();
  DetailScope(const DetailScope&) = delete;
  DetailScope& operator=(const DetailScope&) = delete;
};

Detail detail();

// Sides of a round body that usually has `sides`. What is changed is a multiple of four, so that it still reaches as far along both axes.
int sides_at_detail(int sides);
// Facets of a quarter turn or of a line, at least `least`.
int steps_at_detail(int steps, int least = 1);
// Edges are not broken at the low level.
double bevel_at_detail(double bevel);

}  // namespace layoutbox::kit
