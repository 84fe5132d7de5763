// The colours that a prompt says of the whole room.
#pragma once

#include <string_view>
#include <vector>

#include "layoutbox/furnish/model.h"

namespace layoutbox {

// "pink and white", "in soft greens", "earth tones", "a blue and white bedroom"; none where all colours are of single things.
std::vector<Color> room_colors(std::string_view prompt);

}  // namespace layoutbox
