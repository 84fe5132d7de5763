// The units of a kitchen along its walls.
#pragma once

#include <vector>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/dress/dresser.h"

namespace layoutbox::dressing {

// mm between units that stand side by side.
inline constexpr double kTouching = 15;

struct KitchenUnit {
  const PlacedObject* object;  // until something is added
  Span span;                   // along its wall
};

// The kitchen units that stand with their backs to a wall, in order along it.
std::vector<KitchenUnit> units_at(const Dresser& dresser, const DressedWall& wall);

}  // namespace layoutbox::dressing
