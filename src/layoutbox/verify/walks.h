// Where somebody gets who walks in by the doors (quality.md: reachability of used sides).
#pragma once

#include <cstdint>
#include <vector>

#include "layoutbox/verify/walkability.h"

namespace layoutbox::checks {

// Where a person `width` metres wide gets from the doors (from anywhere, if there is none).
class Walks {
 public:
  // REQUIRES: view outlives it.
  Walks(const RoomView& view, double width);
  // Those of the sides that the person can stand at; what belongs to the body (a chair tucked under it) is in nobody's way to it.
  std::vector<Side> reached(const Body& body, const std::vector<Side>& sides) const;

 private:
  struct Floor {
    FloorPixels plan;
    std::vector<std::uint8_t> walked;  // by pixel: whether the person gets there
  };
  Floor floor_for(const Body* body) const;
  void walk_from_doors(Floor& floor) const;

  const RoomView& view_;
  double width_;
  FloorPixels bare_;  // without furniture
  Floor usual_;       // with all of it
};

// Can a person `width` metres wide walk from a door to a used side of the body, to any side where none is known?
bool reachable(const RoomView& view, const Body& body, double width);

}  // namespace layoutbox::checks
