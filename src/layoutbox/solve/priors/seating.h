// Who sits where round a table: how many at each side, and where along it.
#pragma once

#include <array>
#include <vector>

#include "layoutbox/solve/compile/compile.h"

namespace layoutbox::placement {

constexpr Mm kTucked = 200;  // how far a seat goes under its table

// Seats at the front, back, left and right of a table.
using Seats = std::array<int, 4>;

// The ways to seat n things `seat_width` wide at a table of that size, the most even first; at most `limit`.
std::vector<std::pair<Seats, int>> seatings(int n, Mm width, Mm depth, Mm seat_width, bool circle, std::size_t limit = 10);

// Seats on a circle at multiples of 15°, turned to the middle; the circle as small as the seats' boxes allow. Who comes first takes the
// smallest: one on which another would stand in the table is offered only where all are so.
void add_circle(Formula& f, Compilation& c, ItemId r, Mm most);

// Adds "the targets stand around r": one case per seating and turn of r.
void add_seating(Compilation& c, ItemId r, Mm most, bool circle);

}  // namespace layoutbox::placement
