// Dimension lines of a floor plan: the room's lengths, and along walls with openings the pieces between, in metres.
#pragma once

#include "layoutbox/export/canvas.h"
#include "layoutbox/export/plan_room.h"
#include "layoutbox/export/plan_symbols.h"

namespace layoutbox {

// How far from the room its dimension lines reach, in millimetres on paper.
constexpr double kDimensionReach = 12;

void draw_dimensions(Canvas& page, const PlanScale& scale, const Layout& layout, const PlanRoom& room);

}  // namespace layoutbox
