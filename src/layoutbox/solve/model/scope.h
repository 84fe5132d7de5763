// What a question about a model is asked of: all of it but what is given up and left out.
#pragma once

#include <cstddef>
#include <vector>

#include "layoutbox/solve/model/ids.h"

namespace layoutbox::placement {

// What is past the end of a list is not in it.
struct Scope {
  ById<ConstraintId, char> given_up;  // they need not hold
  ById<ItemId, char> left_out;        // not there at all; what speaks of them cannot hold

  bool gives_up(ConstraintId constraint) const { return given_up.has(constraint) && given_up[constraint] != 0; }
  bool leaves_out(ItemId item) const { return left_out.has(item) && left_out[item] != 0; }
};

}  // namespace layoutbox::placement
