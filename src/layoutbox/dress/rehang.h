// What was asked for on a wall, and hangs where nobody sees it.
#pragma once

#include <cstddef>

#include "layoutbox/dress/dresser.h"

namespace layoutbox::dressing {

// Hangs what is flat, and of which nothing says where on which wall, into full view on a wall that the usual picture shows, where it is
// not and there is room. Returns how many were moved. The layout is the dresser's.
std::size_t rehang(const Dresser& dresser, Layout& layout);

}  // namespace layoutbox::dressing
