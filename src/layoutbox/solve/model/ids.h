// What the solver counts: items (objects and openings) and constraints of a model, relations of its scene, walls of its room.
#pragma once

#include <cstdint>

#include "layoutbox/base/id.h"

namespace layoutbox::placement {

using ItemId = Id<struct ItemTag, std::int16_t>;  // forms are made of them by the million
using ConstraintId = Id<struct ConstraintTag>;
using RelationId = Id<struct RelationTag>;
using WallId = Id<struct WallTag>;

}  // namespace layoutbox::placement
