// Scene files as others write them, brought into the one form that schema/scene.schema.json describes: metres, x to the right, y away
// from the viewer, z up, members named as there, nothing null.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

// Takes members that are null out of all objects.
void drop_nulls(nlohmann::json& value);

// Lets a member be found under another name: {"length": 2} → {"d": 2}. Only where the right name is not there; says whether it did.
bool rename_member(nlohmann::json& object, std::string_view from, std::string_view to);

// Rewrites what can be rewritten and notes it; what is wrong is left as it is, for the schema to name. `units` overrides metadata.units.
// Errors: kSchema for what no schema can say: axes that do not make a frame (they are then taken as usual).
Status bring_into_form(nlohmann::json& scene, std::string_view units, std::vector<Note>& notes);

// The same for a room alone (the `room` member).
void bring_room_into_form(nlohmann::json& room, std::string_view units, std::vector<Note>& notes);

// Writes the edge and the region of a relation by their names ("the back-left corner": "back left"); one that says nothing for its type
// and is none is left out. What is none of them stays, for the schema to name.
void settle_edge_and_region(nlohmann::json& relation, const std::string& at, std::vector<Note>& notes);

// 1 for "m", 0.01 for "cm"…; empty for a unit that is not known. "" is metres.
std::optional<double> metres_per_unit(std::string_view unit);

}  // namespace layoutbox
