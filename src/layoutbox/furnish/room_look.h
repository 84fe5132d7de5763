// What a prompt says of the look of the whole room: colours, woods, and what it is not to have.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/furnish/model.h"

namespace layoutbox {

struct RoomLook {
  std::vector<Color> colors;                 // of cloth and walls
  std::vector<std::string> woods;            // surfaces of wood, as materials.json names them
  std::string metal;                         // "navy and brass"; empty: none was said
  std::vector<Color> unwanted;               // "nothing beige"
  std::vector<std::string> unwanted_stuffs;  // "no walnut"
  bool all = false;                          // "everything in black": the furniture as well, where nothing was said of it
};

// "All in dark blue and oak", "pale wood throughout", "in pink and gold with a bed", "no grey please"; empty where all looks are of single
// things.
RoomLook room_look(std::string_view prompt);

// As near as a person would call by the same name.
bool is_much_like(const Color& a, const Color& b);

}  // namespace layoutbox
