// What speaks for and against a reading; the values stand in weights.inc.
#pragma once

namespace layoutbox::offline::weight {

#define WEIGHT(name, value) inline constexpr double name = value;
#include "layoutbox/plan/reading/weights.inc"
#undef WEIGHT

}  // namespace layoutbox::offline::weight
