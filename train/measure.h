// How well weights do on trees that are known.
#pragma once

#include <string>

#include "layoutbox/plan/syntax/weights.h"

namespace layoutbox::syntax {

// Prints a line for a file of trees, signs left out: shares of right tags, heads, heads with labels, whole trees, and by kinds of arcs; the
// time.
void measure(const std::string& path, const Weights& weights);

}  // namespace layoutbox::syntax
