// What the meanings of relations are made of: being beside, looking at, standing against, keeping a distance.
#pragma once

#include <functional>

#include "layoutbox/solve/compile.h"

namespace layoutbox::placement {

inline Direction opposite(Direction d) { return {d.axis, -d.sign}; }
inline int across(Direction d) { return 1 - d.axis; }

// The turns an item can take, each with the states that have it.
void for_each_turn(const Item& item, const std::function<void(int turn, std::uint64_t states)>& visit);

// Distance along `d` from the edge of r to the nearer edge of t; negative where t reaches back over it.
Linear gap_towards(int t, int r, Direction d);

// gap(t, r) ≤ most, as cases of a formula that begin like `base`: straight across exactly, else an octagon within the circle.
void add_within(Formula& f, Case base, const Model& model, int t, int r, Mm most);
void require_within_wall(Case& c, int t, const RoomWall& wall, Mm most);
// gap(t, r) ≥ least, as cases of a formula (an octagon around the circle).
void add_apart(Formula& f, int t, int r, Mm least);
void add_apart_from_wall(Formula& f, int t, const RoomWall& wall, Mm least);

// Adds the cases of "all of t lies beyond that side of r, in line with it, at most `most` off", one per turn of r.
// `wished_gap`: the distance that looks best.
void add_beyond(Formula& f, const Model& model, int t, int r, Side side, Mm most, Mm wished_gap);
// The same, but t may be pushed under r up to its middle.
void add_at_side(Formula& f, const Model& model, int t, int r, Side side, Mm most, Mm wished_gap,
                 std::uint64_t ref_states = ~std::uint64_t{0});

// "The front of t looks at r."
void add_looks_at(Formula& f, const Model& model, int t, int r);
void add_looks_at_wall(Formula& f, const Model& model, int t, const RoomWall& wall);
void add_looks_at_point(Formula& f, const Model& model, int t, Point point);

// "That side of t stands against the wall", at most `gap` off; within the wall's length.
void add_against(Formula& f, const Model& model, int t, const RoomWall& wall, Side side, Mm gap);

// In line along an axis: the middle of t within the extent of r.
void require_in_line(Case& c, int t, int r, int axis);
// t covers r (or is covered) in plan well enough for "under" and "above".
void require_cover(Case& c, const Model& model, int t, int r, Mm grow);

// A low thing before a window, below its sill.
void add_under_window(Formula& f, const Model& model, int t, int window, Mm most);

// A seat at one side of a table: it looks at it, stands within the side's length, and reaches under it by at least `under`.
void add_tucked(Formula& f, const Model& model, int t, int r, Side side, Mm under, Mm wished_under);

// The turn states that make the width of the item run along an axis.
std::uint64_t states_with_width_along(const Item& item, int axis);

}  // namespace layoutbox::placement
