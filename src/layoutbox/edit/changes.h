// Small geometry of editing: ways, places taken over, and what changed between two layouts.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "layoutbox/edit/edit.h"

namespace layoutbox {

// How far, in millimetres along x, y and z, a thing goes by `shift`: a little (0.3 m) where the distance is not said, half of what lies
// between where it goes towards something. Errors: kGeometry (up from the floor, towards itself), kReference.
Result<std::array<double, 3>> way_of(const PlacedObject& placed, const EditShift& shift, const Layout& layout, bool placed_before);

// Puts `placed` where `other` is: the backs on one line, the same turn, the same support.
void take_place(PlacedObject& placed, const PlacedObject& other);

// The side of the room that the front looks at, for quarter turns.
std::optional<Side> side_looked_at(double rotation_deg);

// What differs: the room, its doors and windows, then object by object in the order of the later layout, then what is gone.
std::vector<ObjectChange> changes_between(const Layout& before, const Layout& after, const std::set<std::string>& asked);

}  // namespace layoutbox
