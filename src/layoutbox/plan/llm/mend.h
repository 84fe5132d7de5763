// Mends the small faults of a scene as models write it. What is changed is noted; what is wrong beyond that is left for validation.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox::llm {

using Notes = std::vector<Note>;

// All of the below, in order.
void mend_scene(nlohmann::json& scene, const Catalog& catalog, Notes& notes);

// Wrappers taken off ({"scene": {…}}), members under other names, lists that are objects, lengths in other units.
void mend_form(nlohmann::json& scene, Notes& notes);
// Members no schema knows, numbers that are texts, values nearly of a list, optional values of a wrong type or out of range.
void mend_by_schema(nlohmann::json& scene, Notes& notes);
// Ids missing, used twice or with odd characters; categories missing; names cleaned; files named; sizes that cannot be.
void mend_objects(nlohmann::json& scene, const Catalog& catalog, Notes& notes);
// Openings that are things, half a size, texts of room, materials and metadata. After mend_objects.
void mend_room(nlohmann::json& scene, Notes& notes);
// Names of things and walls that were nearly right, references too many or none, relations of a thing to itself, said twice.
void mend_relations(nlohmann::json& scene, Notes& notes);
// Edges and regions in other words ("the back-left corner"); before the schema looks for the nearest of the right names.
void mend_edges_and_regions(nlohmann::json& scene, Notes& notes);
// Parts that nothing of that kind has. After mend_objects and mend_relations.
void mend_parts(nlohmann::json& scene, const Catalog& catalog, Notes& notes);

}  // namespace layoutbox::llm
