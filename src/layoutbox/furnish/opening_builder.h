// One opening's parts while they are made (openings.cc, door_leaves.cc, window_panes.cc).
#pragma once

#include <string_view>
#include <utility>

#include "layoutbox/catalog/opening_look.h"
#include "layoutbox/furnish/openings.h"

namespace layoutbox {

inline constexpr double kLining = 0.02;  // metres: thickness of the boards within an opening

// Frame: x along the wall from the opening's near edge, y into the room, z up from the floor.
struct OpeningBuilder {
  const Layout& layout;
  const Opening& opening;
  OpeningLook look;
  WallFrame wall;
  Palette& palette;
  Node node;
  double w, h, sill;  // metres
  int wall_surface;   // of the wall that it is in

  void add(int surface, Mesh mesh) {
    if (!mesh.indices.empty()) node.parts.push_back({std::move(mesh), surface});
  }
  void add(std::string_view surface, Mesh mesh) { add(palette.named(surface), std::move(mesh)); }
  // What its wood or metal is of: as the text says ("red", "oak", "black-framed"), else as the look has it, else `usual`.
  int body(std::string_view usual);
};

// The leaves of a door, in the place where they stand.
void add_leaves(OpeningBuilder& builder);
// Frame, panes and sill of a window.
void add_window(OpeningBuilder& builder);

}  // namespace layoutbox
