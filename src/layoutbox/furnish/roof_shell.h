// Rooms under a sloping roof: the walls end where it comes down.
#pragma once

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/furnish/openings.h"
#include "layoutbox/furnish/palette.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

// A wall is no higher than `height`, and nowhere above the lines that rise from a knee wall at one of its ends. In the wall's frame,
// metres.
struct RoofLine {
  double low_x = 0, low_z = 0, high_x = 0, high_z = 0;
};
struct RoofEdge {
  double height = 0;
  std::vector<RoofLine> lines;
};
RoofEdge roof_over(const Layout& layout, const Catalog& catalog, const WallFrame& wall, double height);

// Takes off what is above the lines, and closes the edge.
Mesh cut_under(Mesh mesh, const std::vector<RoofLine>& lines, double thickness);

// What is over the rafters of each slope. Left out of pictures with the ceiling.
void add_roof_panels(const Layout& layout, const Catalog& catalog, int surface, Model& model);

}  // namespace layoutbox
