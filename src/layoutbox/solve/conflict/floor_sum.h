// How much of the floor things must cover, and how much there is: the one sum behind "too much".
#pragma once

#include <cstdint>
#include <vector>

#include "layoutbox/solve/model/model.h"
#include "layoutbox/solve/model/scope.h"

namespace layoutbox::placement {

// Areas in mm².
struct FloorSum {
  std::vector<ItemId> items;  // that stand on the floor and can stand nowhere else
  std::int64_t covered = 0;
  ItemId door;  // the one that wants the most free floor before it, if any
  std::int64_t before_door = 0;
  std::int64_t room = 0;

  std::int64_t missing() const { return covered + before_door - room; }
};

// Does it stand on the floor wherever it stands, and let nothing else stand there?
bool covers_floor(const Item& item);

// What it covers at its least size.
std::int64_t least_area(const Item& item);

FloorSum floor_sum(const PlacementModel& model, const Scope& scope);

}  // namespace layoutbox::placement
