// What the meanings of relations are made of: being beside, looking at, standing against, keeping a distance.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/solve/compile/compile.h"

namespace layoutbox::placement {

inline Direction opposite(Direction d) { return {d.axis, -d.sign}; }
inline int across(Direction d) { return 1 - d.axis; }

inline bool quarter(int turn) { return turn % 90 == 0; }

// The turns an item can take, each with the states that have it.
void for_each_turn(const Item& item, const std::function<void(int turn, std::uint64_t states)>& visit);

Place place_of(ItemId item);
Place place_of(const PlacementModel& model, const RoomWall& wall);

// Distance along `d` from the edge of r to the nearer edge of t; negative where t reaches back over it.
Linear gap_towards(const Place& t, const Place& r, Direction d);
Linear gap_towards(ItemId t, const Place& r, Direction d);
inline Linear gap_towards(ItemId t, ItemId r, Direction d) { return gap_towards(t, place_of(r), d); }

// Places that lie within the body of an item, whatever its turn: the item's box in the states at quarter turns, an upright box within the
// turned body and its corners in the others. A thing is at most as far from the body as from one of these.
struct PartPlace {
  Place place;
  std::uint64_t states;  // in these
  bool corner = false;
};
std::vector<PartPlace> parts_of(const PlacementModel& model, ItemId item);
// The states of an item at quarter turns.
inline std::uint64_t quarter_states(const Item& item) { return item.all_states & ~item.odd_states; }

// The states at that angle, or at one that differs by multiples of `period` degrees.
std::uint64_t states_at_angle(const Item& item, double angle, double period);
// One of the model's headings or its opposite.
struct SignedHeading {
  int heading = 0, sign = 1;
};
std::optional<SignedHeading> signed_heading(const PlacementModel& model, double degrees);

// The item stands on the floor and nowhere else.
bool floor_only(const Item& item);

// Has it room for knees (a free space that carries nothing)? The side it is used from, the first where there are several.
bool has_knee_room(const Item& item);
Side used_side(const Item& item);

// What the distance in height leaves of a distance for the plan; no value: heights are not known beforehand.
struct Heights {
  bool known = false;
  Mm gap = 0;                                // for proving the least, for placing of the states below
  std::uint64_t states = ~std::uint64_t{0};  // of t
};
Heights heights_between(const PlacementModel& model, ItemId t, const Place& r, Mm most, Purpose purpose);

// gap(t, r) ≤ most, as cases that begin like `base`: straight across exactly, else an octagon within (or around) the circle. `t_states`:
// when placing, for t in these states only.
void add_within(std::vector<Case>& cases, Case base, const PlacementModel& model, ItemId t, const Place& r, Mm most, Purpose purpose,
                std::uint64_t t_states = ~std::uint64_t{0});
// gap(t, r) ≥ least, as cases (an octagon around, or within, the circle).
void add_apart(std::vector<Case>& cases, const PlacementModel& model, ItemId t, const Place& r, Mm least, Purpose purpose);
// least ≤ gap(t, r) ≤ most. `wished`: which distance the middles would best have; no `most`: any distance beyond `least`.
void add_band(Formula& f, const PlacementModel& model, ItemId t, const Place& r, Mm least, std::optional<Mm> most, Mm wished);

// Adds the cases of "all of t lies beyond that side of r, in line with it, at most `most` off", one per turn of r.
struct Beside {
  Mm most = 0;
  Mm wished_gap = 0;             // the distance that looks best
  bool may_reach_under = false;  // t may be pushed under r up to its middle
  bool in_plan_only = false;     // whatever the heights
  ItemId frame = {};             // the item in whose frame the side is meant; none: r
  std::uint64_t ref_states = ~std::uint64_t{0};
};
// In whose frame left, right, before and behind r are meant: its own, or, where it has no front, that of the one thing with a front that it
// is said to stand on; none: its own.
ItemId frame_host(const PlacementModel& model, ItemId r);
void add_beside(Formula& f, const PlacementModel& model, ItemId t, ItemId r, Side side, const Beside& how);

inline void add_beyond(Formula& f, const PlacementModel& model, ItemId t, ItemId r, Side side, Mm most, Mm wished_gap) {
  add_beside(f, model, t, r, side, {.most = most, .wished_gap = wished_gap});
}

// The side that is meant by "facing": the front; of what one sits or stands at to work, where its user looks, which is its back unless it
// is used from there or a seat is told to be behind it.
Side looking_side(const PlacementModel& model, ItemId item);
// "The front of t looks at r", or another side of it.
void add_looks_at(Formula& f, const PlacementModel& model, ItemId t, ItemId r, Side eyes = Side::kFront);
void add_looks_at_wall(Formula& f, const PlacementModel& model, ItemId t, const RoomWall& wall, Side eyes = Side::kFront);
void add_looks_at_point(Formula& f, const PlacementModel& model, ItemId t, Point point, Side eyes = Side::kFront);
// "The front of t looks at r, or the way in which the middle of the group would look at it."
void add_looks_with_group(Formula& f, const PlacementModel& model, ItemId t, const std::vector<ItemId>& group, ItemId r);

// "In one of these states t stands against the wall", at most `gap` off; `whole`: within the wall's length, else at least half of it is.
void add_against(Formula& f, const PlacementModel& model, ItemId t, std::uint64_t states, const RoomWall& wall, Mm gap, bool whole = false);
// The states in which the item has its back to the wall; any quarter turn where it has no front.
std::uint64_t states_with_back_to(const Item& item, const RoomWall& wall);
// The states in which that side of the item (also long, short: either of the two) looks at the wall. No front: any side, long and short
// as it then stands.
std::uint64_t states_with_side_to(const Item& item, const RoomWall& wall, Side side);
// The states of r in which its side `one` is one of those meant: a name, or the longer or shorter ones as it then stands.
std::uint64_t states_where(const Item& r, Side one, Side meant);

// gap(t, wall) ≤ most, before the wall.
void require_near_wall(Case& c, const PlacementModel& model, ItemId t, const RoomWall& wall, Mm most);
void require_near_slanted_wall(Case& c, const PlacementModel& model, ItemId t, const RoomWall& wall, Mm most);
// The middle of t wishes to be at the middle of the wall, or where the middle of r is along it, and near.
void wish_middle_of_wall(Case& c, const PlacementModel& model, ItemId t, const RoomWall& wall, int weight);
void wish_beside_on_wall(Case& c, const PlacementModel& model, ItemId t, ItemId r, const RoomWall& wall, int weight);
// gap(t, wall) ≥ least for a wall at an angle: beyond its line, or past one of its ends.
std::vector<Case> away_from_angled(const PlacementModel& model, ItemId t, const RoomWall& wall, Mm least);

// Three fifths of the shorter face the longer (its middle: half of it), as one or two cases like `base` each.
enum class Facing { kWell, kHalf };
std::vector<Case> in_line(const Case& base, const PlacementModel& model, ItemId t, const Place& r, int axis, Facing facing = Facing::kWell);
// t covers r (or is covered) in plan well enough for "under" and "above"; r is taken `grow` longer at either end.
std::vector<Case> cover(const Case& base, const PlacementModel& model, ItemId t, ItemId r, Mm grow);

// A low thing before a window, below its sill.
void add_under_window(Formula& f, const PlacementModel& model, ItemId t, ItemId window, Mm most);

// A seat at one side of a table: it looks at it, stands within the side's length, and reaches under it by at least `under`.
void add_tucked(Formula& f, const PlacementModel& model, ItemId t, ItemId r, Side side, Mm under, Mm wished_under);

// The states in which the width of the item runs along an axis.
std::uint64_t states_with_width_along(const Item& item, int axis);

// "The targets stand opposite r, as a group."
void add_opposite_group(Compilation& c, ItemId r, Mm least, Mm most);

// Well beyond what the meanings of rows, columns and spacings allow.
inline constexpr Mm kSurelyUneven = 50;

// All orders of a few things that matter: one where they are alike in all that is said of them. Empty: too many.
std::vector<std::vector<ItemId>> orders_of(const PlacementModel& model, const Relation& relation, std::vector<ItemId> things);

}  // namespace layoutbox::placement
