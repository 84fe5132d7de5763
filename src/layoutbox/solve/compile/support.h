// What holds an object up: the floor, a wall, the ceiling, the top or a space of another object, a window's sill.
#pragma once

#include "layoutbox/solve/compile/compile.h"

namespace layoutbox::placement {

enum class Resting { kOn, kIn, kTop };

// Cases of "t rests on r": one per surface of r that carries (kIn: its spaces only, kTop: its top only). `space`: only the one of that
// name. The footprint of t lies within the surface where it can, else its centre does.
void add_resting(Formula& f, const PlacementModel& model, ItemId t, ItemId r, const std::string& space, Resting how);

// Cases of "t hangs on r": against one of its sides; of a hook, before it.
void add_hanging(Formula& f, const PlacementModel& model, ItemId t, ItemId r);

// The scene's relations have it on or in something else that rests, itself or by way of more, on or in the holder.
bool rests_by_way_of_others(const SceneGraph& scene, const std::string& id, const std::string& holder);

void add_on_sill(Formula& f, const PlacementModel& model, ItemId t, ItemId window);

}  // namespace layoutbox::placement
