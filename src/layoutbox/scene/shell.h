// The room's shell in the plan: walls that close, polygons that do not cross themselves, openings within their walls.
#pragma once

#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

// Wall ends nearer than this are the same corner; written files round to centimetres.
inline constexpr Mm kCornerToleranceMm = 10;

Mm length_of(const Wall& wall);

// Twice the area, positive when the polygon runs counter-clockwise.
std::int64_t doubled_area(const std::vector<Point>& polygon);

// The polygon counter-clockwise, from the corner nearest the front (then the left), without corners given twice.
// Errors: kGeometry with the corners in question (fewer than three corners, no area, edges that cross or touch).
Result<std::vector<Point>> tidy_polygon(std::vector<Point> polygon, std::string_view pointer = "/room/polygon");

// Walls in any order and direction, put into one counter-clockwise ring from the front-left corner; ends that nearly meet are joined.
// The offset of an opening in a wall that was turned is turned too. Errors: kGeometry: a wall of no length, the gap between two walls that
// do not meet, a ring that is open, crosses itself or leaves walls over; one error in `details` for each.
Result<std::vector<Wall>> walls_in_ring(std::vector<Wall> walls, std::vector<Opening>& openings);

// Adds the sides that are missing where the listed walls are whole sides of one rectangle, the room's polygon or the box round the walls.
// True when walls were added.
bool complete_rectangle(Room& room);

// Walls along the edges of the polygon: wall1, wall2… (front, right, back, left of a rectangle).
std::vector<Wall> walls_along(const std::vector<Point>& polygon);

// One error per opening that names no wall, does not fit into its wall or the height of the room (0: not checked), or overlaps another.
std::vector<Error> check_openings(const Room& room);

}  // namespace layoutbox
