// What is listed first and placed afterwards.
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// "Items: desk, lamp, 4 pillows. Layout: lamp on desk, 2 pillows on …": what is placed later is what was listed.
void settle_inventory(Document& document);

}  // namespace layoutbox::offline
