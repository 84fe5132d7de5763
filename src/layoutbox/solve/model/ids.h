// What the solver counts: constraints of a model, relations of its scene, walls of its room.
#pragma once

#include "layoutbox/base/id.h"

namespace layoutbox::placement {

using ConstraintId = Id<struct ConstraintTag>;
using RelationId = Id<struct RelationTag>;
using WallId = Id<struct WallTag>;

}  // namespace layoutbox::placement
