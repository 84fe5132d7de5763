// Which triangles of a model a glTF file has: walls and ceiling are seen from within only, so that a viewer looks into the room.
#pragma once

#include <cstdint>
#include <vector>

#include "layoutbox/furnish/model.h"

namespace layoutbox {

// Indices of the part's triangles that are exported. Ceilings keep what looks down; walls what looks into the room and the reveals of
// their openings, but not their outer, upper and lower faces and ends, which would hang in the air before the room.
std::vector<std::uint32_t> exported_triangles(const Mesh& mesh, const Node& node);

}  // namespace layoutbox
