// How much of the floor things must cover, and how much there is: the one sum behind "too much".
#pragma once

#include <cstdint>
#include <vector>

#include "layoutbox/solve/model/model.h"

namespace layoutbox::placement {

// Areas in mm².
struct FloorSum {
  std::vector<int> items;  // that stand on the floor and can stand nowhere else
  std::int64_t covered = 0;
  int door = -1;  // the one that wants the most free floor before it, if any
  std::int64_t before_door = 0;
  std::int64_t room = 0;

  std::int64_t missing() const { return covered + before_door - room; }
};

// Does it stand on the floor wherever it stands, and let nothing else stand there?
bool covers_floor(const Item& item);

// What it covers at its least size.
std::int64_t least_area(const Item& item);

// Without what is given up or left out; empty lists: nothing is.
FloorSum floor_sum(const PlacementModel& model, const std::vector<char>& given_up = {}, const std::vector<char>& left_out = {});

}  // namespace layoutbox::placement
