// What gives way when not everything can hold: what each demand is worth, and the scene less what is left out.
#pragma once

#include <string>
#include <vector>

#include "layoutbox/solve/conflict/conflict.h"

namespace layoutbox::placement {

// The price of giving a demand up; the cheapest goes. Nothing that was asked for goes before what was not. In this order: relations that
// are assumed or added, the free floor before windows, objects that are assumed or added, the free floor before doors, what is concluded;
// then what was asked for: relations by their weight, objects (the last of many before the only one), locks, and what is fixed.
std::int64_t price_of(const PlacementModel& model, const Demand& demand);

// Did nobody ask for it? So it is with free floor before openings.
bool is_assumption(const PlacementModel& model, const Constraint& constraint);

// Objects that may be left out, the one that is missed least first: those that were not asked for, the later ones of several of a kind,
// small ones, the last said. Nothing fixed or locked.
std::vector<ItemId> least_missed_first(const PlacementModel& model, std::vector<ItemId> items);

// The objects of a clash in which nothing but objects and the floor before openings take part; empty: relations do.
std::vector<ItemId> objects_to_blame(const PlacementModel& model, const Clash& clash);

struct LessScene {
  SceneGraph scene;
  std::vector<std::string> lost;  // relations that have nobody left to hold them
};
// The scene without these objects; relations keep the members that are left.
LessScene without_objects(const SceneGraph& scene, const std::vector<std::string>& ids);

// The companions (what came unasked for) that have lost all that they came with once `gone` are left out.
std::vector<std::string> companions_left_alone(const SceneGraph& scene, const Catalog& catalog, std::vector<std::string> gone);

// Nothing was found for all of these, and nothing proven: how much there is, and how much room.
std::string too_much_in_words(const PlacementModel& model, const Scope& scope);

}  // namespace layoutbox::placement
