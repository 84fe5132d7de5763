// Names in a floor plan: inside the object where there is room for them, else beside it, else a number that a key explains.
#pragma once

#include "layoutbox/export/export.h"
#include "layoutbox/export/plan_ink.h"
#include "layoutbox/export/plan_symbols.h"

namespace layoutbox {

// Labels keep clear of lines and of one another as `ink` has them; `page` must draw on `ink` too, whose owners are places in
// layout.objects. The key goes into `key`.
void draw_labels(Canvas& page, const PlanInk& ink, const PlanScale& scale, const Layout& layout, const FloorPlanOptions& options,
                 const PaperBox& key);

}  // namespace layoutbox
