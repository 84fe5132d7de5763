// "A candle on every table; there are five tables": how many there are is said later.
#pragma once

#include "layoutbox/plan/offline/document.h"

namespace layoutbox::offline {

// Gives things that are first spoken of as "each" their number, and makes the later mention one of the same things.
void settle_forward_counts(Document& document);

}  // namespace layoutbox::offline
