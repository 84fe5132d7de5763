// The size of a room as people write it.
#pragma once

#include <string_view>

#include "layoutbox/base/result.h"
#include "layoutbox/base/units.h"

namespace layoutbox {

// "4x3.2x3", "4.0 × 3.2 × 3.0 m", "400 by 320 cm", "13ft x 11ft x 8ft", "12'6\" x 10'", "4,0 x 3,2 m", "4, 3.2, 3": width, depth and,
// where there is a third number, height (else 0). A number without a unit takes that of the numbers after it, then `units`, then metres.
// Errors: kParse (not two or three numbers), kUsage (an unknown unit), kGeometry (a room of 0 m or of more than 100 m).
Result<Size> parse_room_size(std::string_view text, std::string_view units = {});

}  // namespace layoutbox
