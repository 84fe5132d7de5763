// What furnish makes of a layout, as the verifier measures it.
#pragma once

#include <vector>

#include "layoutbox/furnish/model.h"
#include "layoutbox/verify/drawn.h"

namespace layoutbox {

// The objects' triangles, in the room's frame. What furnish shows in free spaces (books in a shelf) is part of its holder.
std::vector<DrawnObject> drawn_objects(const Model& model);

// verify() and verify_drawn() of a layout and what furnish made of it.
Report verify_with_furniture(const Layout& layout, const Model& model, const Catalog& catalog, const VerifyOptions& options = {});

}  // namespace layoutbox
