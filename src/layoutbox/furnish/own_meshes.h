// Meshes and pictures of the user's own in a model: what the scene's `mesh` of objects and walls and its materials name.
#pragma once

#include <string_view>

#include "layoutbox/furnish/furnish.h"
#include "layoutbox/furnish/palette.h"

namespace layoutbox {

// The scene's material of that id, or null.
const Material* scene_material(const Layout& layout, std::string_view id);

// An object's own mesh, as a node in its frame; where `material` has a colour, that wins over the file's.
// Errors: those of read_mesh_file() and fit_mesh(), with the object's id.
Result<Node> own_mesh_node(const PlacedObject& object, const Material* material, Palette& palette, const FurnishOptions& options);

// Draws the walls that name a mesh by it: stretched to the wall's length and height, its front into the room, within the wall's thickness
// where it is thicker. Openings are its own affair. Without folders the walls stay as they are. Errors: as above, with the wall's id.
Status replace_walls_by_own_meshes(const Layout& layout, Palette& palette, const FurnishOptions& options, Model& model);

// Reads the image files that surfaces name. Without folders they stay names.
Status read_own_images(std::vector<Surface>& surfaces, const FurnishOptions& options);

}  // namespace layoutbox
