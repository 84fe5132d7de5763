// What speaks for and against a reading; the values stand in weights.inc.
#pragma once

namespace layoutbox::offline::weight {

// Variables only where they are tuned (train/tune_reading.cc).
#ifdef LAYOUTBOX_TUNED_WEIGHTS
#define WEIGHT(name, value) inline double name = value;
#else
#define WEIGHT(name, value) inline constexpr double name = value;
#endif
#include "layoutbox/plan/reading/weights.inc"
#undef WEIGHT

}  // namespace layoutbox::offline::weight
