// Is a PNG whole? A stopped or full run leaves truncated ones.
#pragma once

#include <string_view>

#include "layoutbox/base/result.h"

namespace layoutbox {

struct PngSize {
  int width = 0, height = 0;
};

// Reads every chunk with its checksum, unpacks all pixels and asks for the end mark. Errors: kParse, saying what is wrong.
Result<PngSize> check_png(std::string_view bytes);

}  // namespace layoutbox
