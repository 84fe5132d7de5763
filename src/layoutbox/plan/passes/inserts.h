// Words between a place and its thing, and qualities that look like places: nothing stands differently for them.
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// "Behind the chair, humming, is a cabinet", "balls in sherbet colours", "the only seat is a stool", "muddy to the axle".
void settle_inserts(Document& document);

}  // namespace layoutbox::offline
