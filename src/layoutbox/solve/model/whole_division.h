// Division of whole numbers that rounds one way, whatever the signs.
#pragma once

#include <cstdint>

namespace layoutbox::placement {

// REQUIRES: b != 0.
inline std::int64_t floor_div(std::int64_t a, std::int64_t b) { return a / b - ((a % b != 0) && ((a < 0) != (b < 0))); }
inline std::int64_t ceil_div(std::int64_t a, std::int64_t b) { return -floor_div(-a, b); }

}  // namespace layoutbox::placement
