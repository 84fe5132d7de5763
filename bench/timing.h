// What parts of the figures ask the solver for, and how they time it.
#pragma once

#include <functional>

#include "layoutbox/solve/solver.h"
#include "rooms.h"

namespace layoutbox::bench {

// Any layout that is legal, the first that is found.
inline SolveOptions first_legal(double limit) {
  SolveOptions options;
  options.improve = false;
  options.effort = 400'000;
  options.time_limit_s = limit;
  options.on_conflict = OnConflict::kFail;
  return options;
}

// Seconds of processor time.
inline double timed(const std::function<void()>& what) {
  const double start = cpu_seconds();
  what();
  return cpu_seconds() - start;
}

}  // namespace layoutbox::bench
