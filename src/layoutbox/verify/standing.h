// What of verify() does not depend on where people walk, which takes longest: for who asks many times a second.
#pragma once

#include "layoutbox/verify/verify.h"

namespace layoutbox {

// All that verify() finds but navigability and accessibility. Never fails on a readable layout.
Report verify_standing(const Layout& layout, const Catalog& catalog, const VerifyOptions& options = {});

}  // namespace layoutbox
