#include <nlohmann/json.hpp>

#include "layoutbox/scene/json_parts.h"

namespace layoutbox {

using nlohmann::json;

namespace {

double mm_from(const json& metres) { return metres.get<double>() * 1000; }

std::optional<Mm> optional_length(const json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? std::nullopt : std::optional(mm_from_m(found->get<double>()));
}

}  // namespace

std::string text_at(const json& object, const char* key) { return object.value(key, std::string()); }
Mm length_at(const json& object, const char* key, Mm missing) { return optional_length(object, key).value_or(missing); }
bool flag_at(const json& object, const char* key, bool missing) { return object.value(key, missing); }

Origin origin_at(const json& object) {
  return origin_from_name(text_at(object, "origin")).value_or(flag_at(object, "assumed", false) ? Origin::kAssumed : Origin::kAsked);
}

std::vector<std::string> texts_at(const json& object, const char* key) { return object.value(key, std::vector<std::string>()); }

Point point_from(const json& value) { return {mm_from_m(value.at(0).get<double>()), mm_from_m(value.at(1).get<double>())}; }

std::array<double, 3> vector_from(const json& value) { return {mm_from(value.at(0)), mm_from(value.at(1)), mm_from(value.at(2))}; }

std::vector<Point> polygon_from(const json& value) {
  std::vector<Point> polygon;
  for (const json& corner : value) polygon.push_back(point_from(corner));
  return polygon;
}

std::vector<Space> spaces_from(const json& value) {
  std::vector<Space> spaces;
  for (const json& item : value) {
    spaces.push_back({text_at(item, "name"), vector_from(item.at("min")), vector_from(item.at("max")), flag_at(item, "carries", true)});
  }
  return spaces;
}

std::vector<Side> sides_from(const json& value) {
  std::vector<Side> sides;
  for (const json& item : value) {
    if (const auto side = side_from_name(item.get<std::string>())) sides.push_back(*side);
  }
  return sides;
}

Opening opening_from(const json& value) {
  Opening opening;
  opening.id = text_at(value, "id");
  const bool window_by_id = opening.id.find("indow") != std::string::npos;
  const bool raised = value.contains("sill") && value.at("sill").get<double>() > 0.2;
  opening.type =
      opening_type_from_name(text_at(value, "type")).value_or(window_by_id || raised ? OpeningType::kWindow : OpeningType::kDoor);
  const bool window = opening.type == OpeningType::kWindow;
  opening.wall = text_at(value, value.contains("wallId") ? "wallId" : "wall");
  opening.offset = optional_length(value, "offset");
  opening.width = length_at(value, "w", window ? 1200 : 900);
  opening.height = length_at(value, "h", window ? 1200 : 2000);
  opening.sill = length_at(value, "sill", window ? 900 : 0);
  opening.sill_depth = length_at(value, "sillDepth", Opening{}.sill_depth);
  opening.swing = swing_from_name(text_at(value, "swing")).value_or(opening.type == OpeningType::kDoor ? Swing::kInLeft : Swing::kNone);
  opening.attributes = texts_at(value, "attributes");
  opening.origin = origin_at(value);
  return opening;
}

Relation relation_from(const json& value) {
  Relation relation;
  relation.id = text_at(value, "id");
  if (const RelationRow* row = find_relation(text_at(value, "type"))) relation.type = row->type;
  relation.targets = texts_at(value, "targets");
  if (const auto to = value.find("relativeTo"); to != value.end()) {
    if (to->is_string())
      relation.references = {to->get<std::string>()};
    else
      relation.references = to->get<std::vector<std::string>>();
  }
  RelationParameters& p = relation.parameters;
  const char* axis = value.contains("axis") ? "axis" : "alignAxis";
  p.axis = axis_from_name(text_at(value, axis));
  p.distance = optional_length(value, "distance");
  p.min = optional_length(value, "min");
  p.max = optional_length(value, "max");
  p.gap = optional_length(value, "gap");
  p.depth = optional_length(value, "depth");
  p.width = optional_length(value, "width");
  p.height = optional_length(value, "height");
  p.side = side_from_name(text_at(value, "side"));
  p.part = ThingPart(text_at(value, "part"));
  p.edge = edge_from_words(text_at(value, "edge"));
  p.region = region_from_words(text_at(value, "region"));
  if (const auto columns = value.find("columns"); columns != value.end()) p.columns = columns->get<int>();
  relation.hard = flag_at(value, "hard", true);
  relation.weight = value.value("weight", relation.weight);
  relation.why = text_at(value, "why");
  relation.origin = origin_at(value);
  return relation;
}

std::vector<Material> materials_from(const json& value) {
  std::vector<Material> materials;
  for (const json& item : value) {
    Material material;
    material.id = text_at(item, "id");
    if (const auto color = item.find("color"); color != item.end()) {
      material.color = Color{color->at(0).get<double>(), color->at(1).get<double>(), color->at(2).get<double>()};
    }
    material.texture = text_at(item, "tex");
    if (const auto roughness = item.find("roughness"); roughness != item.end()) material.roughness = roughness->get<double>();
    if (const auto scale = item.find("scaleUV"); scale != item.end()) material.uv_scale = scale->get<std::array<double, 2>>();
    materials.push_back(std::move(material));
  }
  return materials;
}

}  // namespace layoutbox
