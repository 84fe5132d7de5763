// Meshes of the user's own: glTF, GLB and OBJ files, read and fitted to an object.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/furnish/kit.h"
#include "layoutbox/furnish/model.h"

namespace layoutbox {

// A file's shape in our frame: metres of the file, z up, its front to −y where it is as glTF has it (+z).
struct MeshFile {
  std::vector<Surface> surfaces;
  std::vector<Part> parts;  // their surfaces are places in `surfaces`
};

struct MeshLimits {
  std::size_t most_bytes = 64u << 20;  // of one file
  std::size_t most_triangles = 400'000;
};

// The file of that name in the first of `folders` that has it. Nothing outside these folders is read, neither the file itself nor what it
// names (buffers, materials, images). Errors, each with the file's name: kUsage (outside), kIo (missing), kParse (broken, or of a kind
// that is not known), kTooLarge.
Result<MeshFile> read_mesh_file(std::span<const std::filesystem::path> folders, const std::string& name, const MeshLimits& limits = {});

// The bytes of a PNG or JPEG file in one of the folders, with the same errors.
Result<std::string> read_image_file(std::span<const std::filesystem::path> folders, const std::string& name,
                                    std::size_t most_bytes = 16u << 20);

// Turns the mesh so that `front` (an axis of the file: "+z", "-x", …; "": glTF's +z; "±y": the file's z is up) looks to −y, and scales it
// evenly until it fills the size in one direction at least; exactly, where the proportions are the same within 3 %. It stands on the
// underside, in the middle; what hangs is brought to the top or to the back. Error: kSchema for another front.
Status fit_mesh(MeshFile& mesh, kit::Vec size, std::string_view front, Mount mount);

// Stretches the mesh to a wall's length (size.x) and height (size.z), at most as thick as the wall (size.y), in the wall's frame: x along
// the wall from its start, the room at +y from 0 on. The file's +z looks into the room.
void fit_wall_mesh(MeshFile& mesh, kit::Vec size);

}  // namespace layoutbox
