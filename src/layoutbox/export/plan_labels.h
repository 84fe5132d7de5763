// Names in a floor plan: inside the object where they fit, else beside the room with a line to it.
#pragma once

#include "layoutbox/export/export.h"
#include "layoutbox/export/plan_symbols.h"

namespace layoutbox {

// The part of the page beside the room that labels may use.
struct LabelArea {
  double left = 0, right = 0;            // outer edges
  double room_left = 0, room_right = 0;  // the room with its dimension lines lies between
  double top = 0, bottom = 0;
};

void draw_labels(Canvas& page, const PlanScale& scale, const Layout& layout, const FloorPlanOptions& options, const LabelArea& area);

}  // namespace layoutbox
