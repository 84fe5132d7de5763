// The paper's formulation of a room of boxes, for comparison: through the same CP-SAT library, and as a mixed integer programme through
// HiGHS from the same package.
#pragma once

#include <string>

#include "rooms.h"

namespace layoutbox::bench {

enum class OtherModel {
  kPaperCentres,  // four Booleans and four inequalities a pair, 1 cm grid, only the middles kept in the room, as in the authors' code
  kPaperBoxes,    // the same with whole boxes kept in the room, as in their text
  kBigM,          // the same inequalities with a big M, in HiGHS
};

struct Outcome {
  bool found = false;
  double seconds = 0;
  std::string trouble;  // why it could not be asked at all
};

// Builds the model and solves it with the solver's default options on one worker, at most `limit` seconds.
Outcome solve_otherwise(OtherModel model, const PlainRoom& room, double limit);

}  // namespace layoutbox::bench
