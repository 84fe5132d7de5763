// Which item refers to which, and in what order they are placed: hosts before what refers to them.
#pragma once

#include <vector>

#include "layoutbox/solve/model/model.h"
#include "layoutbox/solve/model/scope.h"

namespace layoutbox::placement {

// Nobody moves it: fixed, locked, or an opening whose place the scene gives.
bool stays(const Item& item);

struct Dependencies {
  explicit Dependencies(const PlacementModel& model);
  ById<ItemId, std::vector<ItemId>> hosts;    // what it refers to
  ById<ItemId, std::vector<ItemId>> tenants;  // what refers to it
};

// Fixed ones, then the ones with the most `bonus`, what a relation ties to a wall, openings, the rest by size, things on things, rugs.
std::vector<ItemId> placing_order(const PlacementModel& model, const Dependencies& dependencies, const Scope& scope,
                                  const ById<ItemId, int>& bonus);

// The item and everything placed that hangs on it, hosts first.
void group_of(const Dependencies& dependencies, const Placements& placements, ItemId item, std::vector<ItemId>& group);

}  // namespace layoutbox::placement
