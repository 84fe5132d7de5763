#pragma once

#include "layoutbox/judge/predicates.h"

namespace layoutbox::scoring {

// Rays from all over the target along `front` meet the reference in the plan, on average within 15 degrees (score = 1 − angle / 30).
Scored look_at(const Block& target, const Block& reference, Vec2d front);
// Its front looks at the reference; of a desk and the like also who sits there does.
Scored faces(const Block& target, const Block& reference);

}  // namespace layoutbox::scoring
