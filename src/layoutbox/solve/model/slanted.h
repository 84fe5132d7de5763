// Walls at an angle, and what is turned with them: whole-number directions, how far things reach along them, and what keeps things
// before such walls and apart from one another.
#pragma once

#include "layoutbox/solve/model/model.h"

namespace layoutbox::placement {

// Length of a heading: its two whole numbers are a direction in so many parts.
inline constexpr std::int32_t kHeading = 40'000;

// Fills model.headings from its walls: the directions along and across each that runs along neither x nor y.
void add_headings(PlacementModel& model);

// The constants of an item about how far its box or turned body reaches along each heading; REQUIRES: model.headings is filled.
void add_spans(const PlacementModel& model, Item& item);

// Twice the middle of an item along a heading, and how far it reaches along it from end to end; in parts of a millimetre (kHeading).
Linear along2(const PlacementModel& model, ItemId item, int heading);
Linear span(const PlacementModel& model, ItemId item, int heading);

// 2 · kHeading · the gap between the item and the line of a slanted wall; negative: beyond it.
Linear slanted_gap2(const PlacementModel& model, ItemId item, const RoomWall& wall);
// 2 · kHeading · how far the middle of the item is from the wall's start, along the wall.
Linear along_wall2(const PlacementModel& model, ItemId item, const RoomWall& wall);

// The item is before all slanted walls: beyond none of their lines, where it is beside the wall at all.
Constraint within_walls(const PlacementModel& model, ItemId item);

// The rest of the floor's bounding box that is not room, whole boxes only.
std::vector<GridBox> off_limits_of(const PlacementModel& model);

// Two bodies in those states, each by a part of it, are apart along one of the headings.
struct BodyPart {
  const Item* item = nullptr;
  const Placement* placement = nullptr;
  int solid = -1;  // of the state's solids; −1: the whole
};
bool apart_along_headings(const PlacementModel& model, const BodyPart& a, const BodyPart& b);
// The same of a whole body and an upright box of the room.
bool apart_along_headings(const PlacementModel& model, const BodyPart& a, const GridBox& box);

// Twice the middle of a part of an item along a heading where its low corner is at the origin, and its span; in parts of a millimetre.
struct Reach {
  std::int64_t middle2 = 0, span = 0;
};
Reach reach_of(const PlacementModel& model, const Item& item, int state, int solid, int heading);
Reach reach_of(const GridBox& box, const Heading& heading);

}  // namespace layoutbox::placement
