// What a model is put together from: its items, an object or an opening each.
#pragma once

#include <span>
#include <vector>

#include "layoutbox/solve/model/model.h"

namespace layoutbox::placement {

// An object's own box with its origin under the middle of the footprint; odd lengths put the extra millimetre on the high side.
GridBox own_box(const Size& size);
// A box in the object's frame as it lies in the turned box, from its low corner.
GridBox in_turned(const GridBox& own, const GridBox& box, double turn);
// An upright box within it, where it lies at an odd angle.
GridBox within_turned(const GridBox& own, const GridBox& box, double turn);
// Fills Item::odd_states and the constants about the turned footprint.
void note_odd_states(Item& item);
// Free floor at a side of an own box: `from` to `to` off it.
GridBox beside(const GridBox& own, Side side, Mm from, Mm to, Mm height);

RoomWall room_wall(const Wall& wall);
// The turn by which states at that angle are known: the nearest whole degree that is no quarter turn where the angle is none.
int nearest_turn(double angle);

Item object_item(const SceneGraph& scene, const SceneObject& object, const Catalog& catalog, const ModelOptions& options,
                 std::span<const RoomWall> walls);
Item opening_item(const Opening& opening, const Room& room, std::span<const RoomWall> walls);
// How deep the floor before it is to be free: a door's is as deep as it is wide.
Mm clear_depth(const Opening& opening);
// Where an opening may be: in one of the walls it fits, where it is when that is given.
Constraint opening_place(const PlacementModel& model, ItemId index);
Constraint opening_clearance(const Item& item);

// Fills PlacementModel::pairs. REQUIRES: all items are there.
void set_pair_rules(PlacementModel& model);

}  // namespace layoutbox::placement
