// The ways in which places are looked for, one for each "place" of catalog/dress.json. Each adds what its row wants where it finds room.
#pragma once

#include <string_view>

#include "layoutbox/catalog/dressing.h"
#include "layoutbox/dress/dresser.h"

namespace layoutbox::dressing {

using PlaceFiller = void (*)(Dresser&, const Dressing&);

// "kitchen run": the free wall between the units of a kitchen and on from them, round the corner where there is room.
void fill_kitchen_run(Dresser& dresser, const Dressing& row);
// "over stove": centred over a stove or hob.
void hang_over_stove(Dresser& dresser, const Dressing& row);
// "over run": the wall over a run of kitchen units.
void hang_over_run(Dresser& dresser, const Dressing& row);
// "window": before a window.
void hang_at_windows(Dresser& dresser, const Dressing& row);
// "window top": before the upper part of a window.
void hang_on_window_tops(Dresser& dresser, const Dressing& row);
// "over": on the wall over things that stand at it.
void hang_over_things(Dresser& dresser, const Dressing& row);
// "wall": in the middle of a blank stretch of wall.
void hang_on_walls(Dresser& dresser, const Dressing& row);
// "corner": on the floor in an empty corner.
void stand_in_corners(Dresser& dresser, const Dressing& row);
// "beside": on the floor at the side of a thing, its back in line.
void stand_beside(Dresser& dresser, const Dressing& row);
// "free wall": on the floor, at a long empty wall.
void stand_at_free_wall(Dresser& dresser, const Dressing& row);
// "under": on the floor under a table or the foot of a bed.
void lie_under(Dresser& dresser, const Dressing& row);
// "before": on the floor before the front of a thing, so far off as the row says.
void lie_before(Dresser& dresser, const Dressing& row);
// "middle": on the floor where much of it is free, nearest to the middle of the room.
void lie_in_middle(Dresser& dresser, const Dressing& row);
// "below": on the wall under what hangs there.
void hang_below(Dresser& dresser, const Dressing& row);
// "on": on the top of a thing where nothing stands.
void stand_on(Dresser& dresser, const Dressing& row);
// "at seats": on the edge of a table before each of its seats, where nothing stands.
void lay_before_seats(Dresser& dresser, const Dressing& row);
// "ceiling": in the middle of the room.
void hang_from_ceiling(Dresser& dresser, const Dressing& row);

// Null: there is no such place.
PlaceFiller find_place(std::string_view name);

}  // namespace layoutbox::dressing
