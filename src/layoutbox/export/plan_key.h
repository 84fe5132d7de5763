// The key of a floor plan: what its numbers mean.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "layoutbox/export/plan_ink.h"

namespace layoutbox {

constexpr double kNumberRadius = 1.6;  // millimetres on paper

// A number in its circle.
void draw_number(Canvas& page, PaperPoint at, int number);

struct KeyRow {
  std::string name, size;  // the size may be empty
  std::size_t count = 1;
};

// A row for each number from 1, from the box's top down; what does not fit is counted in the last row.
void draw_key(Canvas& page, const std::vector<KeyRow>& rows, const PaperBox& box);

}  // namespace layoutbox
