// Fewer triangles for meshes of the user's own: scans and sculptures come with hundreds of thousands.
#pragma once

#include <cstddef>

#include "layoutbox/furnish/furnish.h"
#include "layoutbox/furnish/mesh_file.h"

namespace layoutbox {

// How many triangles a mesh of the user's own keeps at that level of detail.
std::size_t most_triangles(Detail detail);

// Brings the mesh to at most so many triangles, each part its share, by edges that collapse where the shape changes least (quadric error
// metrics, Garland and Heckbert 1997, by meshoptimizer). The shape moves by at most 2 % of its part's size: what would have to move more
// keeps more triangles. A mesh that has few enough is left as it is.
void simplify(MeshFile& mesh, std::size_t most);

}  // namespace layoutbox
