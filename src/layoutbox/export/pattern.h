// The textures of glTF files: small repeating patterns, each compressed once, in the colours of any surface.
#pragma once

#include <string>

#include "layoutbox/furnish/model.h"

namespace layoutbox {

// One repeat of a procedure of furnish/model.h as pixels: 0 is `base`, 255 is `second`; and how far one repeat reaches.
struct PatternSize {
  double u = 1, v = 1;  // in units of Surface::scale
  bool turned = false;  // the pattern lies at 45° to the uvs
};

// Is there a pattern of that name?
bool has_pattern(const std::string& texture);

PatternSize pattern_size(const std::string& texture);

// A PNG of one repeat in the surface's colours. REQUIRES: has_pattern(surface.texture).
std::string pattern_png(const Surface& surface);

}  // namespace layoutbox
