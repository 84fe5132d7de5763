// The parts that scene and layout files share, both ways; lengths in the document are metres, in the types millimetres.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

// ---- writing
double json_length(double mm);                                    // metres
nlohmann::ordered_json json_of(Point point);                      // [x, y]
nlohmann::ordered_json json_of(const std::array<double, 3>& mm);  // [x, y, z]
nlohmann::ordered_json json_of(const Size& size);                 // [w, d, h]
nlohmann::ordered_json json_of(const std::vector<Point>& polygon);
nlohmann::ordered_json json_of(const std::vector<Space>& spaces);
nlohmann::ordered_json json_of(const std::vector<Side>& sides);
nlohmann::ordered_json json_of(const Relation& relation);  // one item of `constraints` or `relations`
nlohmann::ordered_json json_of(const std::vector<Material>& materials);
void add_origin(nlohmann::ordered_json& item, Origin origin);  // and `assumed`, for readers of older files

// ---- reading. REQUIRES: a document that the schema accepts, with null members taken out.
Point point_from(const nlohmann::json& value);                   // of [x, y] or [x, y, z]
std::array<double, 3> vector_from(const nlohmann::json& value);  // [x, y, z] → mm
std::vector<Point> polygon_from(const nlohmann::json& value);
std::vector<Space> spaces_from(const nlohmann::json& value);
std::vector<Side> sides_from(const nlohmann::json& value);
Opening opening_from(const nlohmann::json& value);
Relation relation_from(const nlohmann::json& value);
std::vector<Material> materials_from(const nlohmann::json& value);

std::string text_at(const nlohmann::json& object, const char* key);  // "" where it is missing
Mm length_at(const nlohmann::json& object, const char* key, Mm missing = 0);
bool flag_at(const nlohmann::json& object, const char* key, bool missing);
Origin origin_at(const nlohmann::json& object);  // of older files: assumed, where they say no more
std::vector<std::string> texts_at(const nlohmann::json& object, const char* key);

}  // namespace layoutbox
