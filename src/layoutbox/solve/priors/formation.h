// Things that come in numbers stand in order: rows of desks, tables of a restaurant, mats; and seats spread over the sides of a table.
#pragma once

#include <vector>

#include "layoutbox/solve/model/model.h"

namespace layoutbox::placement {

// How many stand side by side, and how far the middles of neighbours are apart along the rows and from row to row; and the aisle in the
// middle that parts the rows.
struct Formation {
  int columns = 1;
  Mm across = 0;
  Mm deep = 0;
  Mm aisle = 0;
};

inline constexpr Mm kWayAround = 600;
inline constexpr Mm kBetweenDesks = 20;

// Columns that are asked for, 0: as suits the room; what is left free before the walls beside the rows, and before and behind them; from
// how many columns an aisle parts them, 0: never.
struct FormationWays {
  int columns = 0;
  Mm sides = kWayAround, ends = kWayAround;
  int parted_from = 0;
  Mm in_view = 0;  // so far apart the first and the last of a row may be, to see the same thing straight ahead; 0: any
};

// The part of the room, along one axis, that a formation has where others share it; no axis: all of it is its own.
struct PartOfRoom {
  int axis = -1;
  Mm lo = 0, hi = 0;
};

// Where along an axis such a part begins and ends.
inline Mm lo_of(const PlacementModel& model, const PartOfRoom& part, int axis) { return part.axis == axis ? part.lo : model.room.lo[axis]; }
inline Mm hi_of(const PlacementModel& model, const PartOfRoom& part, int axis) { return part.axis == axis ? part.hi : model.room.hi[axis]; }

// The parts of several formations, in their order: the longer side is shared out by the floor that each wants.
std::vector<PartOfRoom> parts_of_room(const PlacementModel& model, const std::vector<std::vector<ItemId>>& groups);

// The formation of n things of that size with at least those gaps that fits the room's shape best; 0 columns where none fits.
// `room_across` and `room_deep` are the room's extents along and across the rows.
Formation formation_of(int n, const Size& size, Mm gap_across, Mm gap_deep, Mm room_across, Mm room_deep, const FormationWays& ways = {});

// Whose place in a formation is wished for: group[k]'s.
struct FormationOf {
  const std::vector<ItemId>& group;
  int k = 0;
  int columns = 0;              // 0: as suits the room
  bool spread = false;          // over all of the room's length, in one line
  int weight = 0, in_line = 0;  // of the place in the room, and of that beside its neighbour
  Mm before = 0;                // floor left free before the first row, for what all look at
  Mm seats = 0;                 // behind each, for the seat of who looks over it
  Mm in_view = 0;               // as wide is what each of them is told to look at; 0: one looks for all
  int leader = -1;              // the one of them who has to see it straight ahead
  ItemId counter = {};          // what they stand before, and not behind or where its own place is
  PartOfRoom part = {};
};

// Wishes for that place in a formation about the middle of the room, whichever way the first of the group looks.
void add_formation_place(Formula& f, const PlacementModel& model, const FormationOf& of);

// The same for desks in islands: two rows back to back, those who sit there looking at each other.
void add_island_place(Formula& f, const PlacementModel& model, const FormationOf& of);

// Over which sides of a table seats are shared out: all round it, or the side where a desk is used; its two long ones; its two ends.
enum class SeatSides { kUsed, kLong, kEnds };

// Wishes for seat k of n at a table.
void add_seat_place(Formula& f, const PlacementModel& model, ItemId seat, ItemId table, int k, int n, int weight,
                    SeatSides sides = SeatSides::kUsed);

}  // namespace layoutbox::placement
