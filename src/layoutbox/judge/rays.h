#pragma once

#include "layoutbox/judge/predicates.h"

namespace layoutbox::scoring {

// Rays from all over the target along `front` meet the reference in the plan, on average within 15 degrees (score = 1 − angle / 30).
Scored look_at(const Block& target, const Block& reference, Vec front);

}  // namespace layoutbox::scoring
