// Lengths that groups of furniture are placed and read by: how near a chair is to its table, where a picture hangs over a sofa. Each
// stands with its source in catalog/groups.json.
#pragma once

#include "layoutbox/base/units.h"

namespace layoutbox {

struct Measures {
#define LAYOUTBOX_MEASURE(field, key) Mm field = 0;
#include "layoutbox/catalog/measure_list.inc"
#undef LAYOUTBOX_MEASURE
};

const Measures& measures();

}  // namespace layoutbox
