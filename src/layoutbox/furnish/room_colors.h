// The colours that a prompt says of the whole room.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/furnish/model.h"

namespace layoutbox {

// Colours, woods and a metal that are said in a row: "sage, cream and oak".
struct ColorScheme {
  std::vector<Color> colors;
  std::vector<std::string> woods;  // surfaces of wood, as materials.json names them
  std::string metal;               // empty: none was said
  std::size_t size() const { return colors.size() + woods.size() + (metal.empty() ? 0 : 1); }
};

// "pink and white", "in soft greens", "earth tones", "a blue and white bedroom", "light wood and mint"; empty where all looks are of single
// things.
ColorScheme room_scheme(std::string_view prompt);

}  // namespace layoutbox
