// Drawing the patterns of pattern.h: done by cmake/bake_patterns.cc when the program is built.
#pragma once

#include <string>
#include <vector>

#include "layoutbox/export/pattern.h"

namespace layoutbox {

// A pixel is mix · kPatternShades + dark.
constexpr int kPatternMixes = 32, kPatternShades = 8;

// The names of all patterns.
std::vector<std::string> pattern_names();

// The edge of the square that is one repeat, in pixels. REQUIRES: a name of pattern_names().
int pattern_pixels(const std::string& texture);

// One repeat as the lines of an 8-bit PNG, deflated. REQUIRES: a name of pattern_names().
std::string draw_pattern(const std::string& texture);

}  // namespace layoutbox
