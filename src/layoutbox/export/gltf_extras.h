// What a node of a glTF file says of its thing besides its mesh: kind, category, size, relations; of the floor its corners.
#pragma once

#include "layoutbox/furnish/model.h"
#include "layoutbox/furnish/tinygltf_quietly.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

tinygltf::Value gltf_extras(const Node& node, const Layout& layout);

}  // namespace layoutbox
