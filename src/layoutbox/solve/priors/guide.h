// An earlier layout that guides: what it has stays near its place there (a heavy wish), or exactly (a lock, hard). This is how layouts
// are mended and edited with the least movement.
#pragma once

#include <utility>
#include <vector>

#include "layoutbox/solve/model/model.h"

namespace layoutbox::placement {

// Puts the size and the turn an object had among those it may have, the size first. A size that its range no longer allows is left out
// unless the object is locked, which then has no other.
void add_earlier_pose(const ModelOptions& options, Item& item, std::vector<std::pair<Size, int>>& sizes, std::vector<int>& turns);

// Fills model.start, and marks what is locked. Errors: kReference: an id to be locked that is not in the scene or had no place.
Status find_starts(PlacementModel& model, const ModelOptions& options);

// States of one item; a mask holds so many.
inline constexpr std::size_t kMostStates = 64;

// The wishes and locks that keep things where model.start has them.
void add_stays(PlacementModel& model);

// Wishes that the largest things that stand on the floor stand elsewhere than in these layouts, or otherwise.
void add_differences(PlacementModel& model, const std::vector<const Layout*>& unlike);

// Its state and place are those of the earlier layout.
inline bool unmoved(const PlacementModel& model, ItemId item, const Placements& placements) {
  return !model.start.empty() && model.start[item].state >= 0 && placements[item] == model.start[item];
}

}  // namespace layoutbox::placement
