#include <nlohmann/json.hpp>

#include "layoutbox/scene/json_parts.h"

namespace layoutbox {

using nlohmann::ordered_json;

double json_length(double mm) { return mm / 1000; }

void add_origin(ordered_json& item, Origin origin) {
  item["origin"] = name_of(origin);
  if (origin != Origin::kAsked) item["assumed"] = true;
}

ordered_json json_of(Point point) { return {json_length(point.x), json_length(point.y)}; }
ordered_json json_of(const std::array<double, 3>& mm) { return {json_length(mm[0]), json_length(mm[1]), json_length(mm[2])}; }
ordered_json json_of(const Size& size) { return {json_length(size.width), json_length(size.depth), json_length(size.height)}; }

ordered_json json_of(const std::vector<Point>& polygon) {
  ordered_json out = ordered_json::array();
  for (const Point corner : polygon) out.push_back(json_of(corner));
  return out;
}

ordered_json json_of(const std::vector<Space>& spaces) {
  ordered_json out = ordered_json::array();
  for (const Space& space : spaces) {
    ordered_json item{{"name", space.name}, {"min", json_of(space.min)}, {"max", json_of(space.max)}};
    if (!space.carries) item["carries"] = false;
    out.push_back(std::move(item));
  }
  return out;
}

ordered_json json_of(const std::vector<Side>& sides) {
  ordered_json out = ordered_json::array();
  for (const Side side : sides) out.push_back(name_of(side));
  return out;
}

ordered_json json_of(const Relation& relation) {
  const RelationParameters& p = relation.parameters;
  ordered_json out = ordered_json::object();
  if (!relation.id.empty()) out["id"] = relation.id;
  out["type"] = relation_row(relation.type).name;
  out["targets"] = relation.targets;
  if (relation.references.size() == 1) out["relativeTo"] = relation.references.front();
  if (relation.references.size() > 1) out["relativeTo"] = relation.references;
  if (p.axis) out["axis"] = name_of(*p.axis);
  const auto add_length = [&](const char* key, std::optional<Mm> length) {
    if (length) out[key] = json_length(*length);
  };
  add_length("distance", p.distance);
  add_length("min", p.min);
  add_length("max", p.max);
  add_length("gap", p.gap);
  add_length("depth", p.depth);
  add_length("width", p.width);
  add_length("height", p.height);
  if (p.side) out["side"] = name_of(*p.side);
  if (!p.part.empty()) out["part"] = p.part.text();
  if (p.edge) out["edge"] = name_of(*p.edge);
  if (p.region) out["region"] = name_of(*p.region);
  if (p.columns) out["columns"] = *p.columns;
  out["hard"] = relation.hard;
  if (relation.weight != Relation{}.weight) out["weight"] = relation.weight;
  if (!relation.why.empty()) out["why"] = relation.why;
  add_origin(out, relation.origin);
  return out;
}

ordered_json json_of(const std::vector<Material>& materials) {
  ordered_json out = ordered_json::array();
  for (const Material& material : materials) {
    ordered_json item{{"id", material.id}};
    if (material.color) item["color"] = {material.color->r, material.color->g, material.color->b};
    if (!material.texture.empty()) item["tex"] = material.texture;
    if (material.roughness) item["roughness"] = *material.roughness;
    if (material.uv_scale != std::array<double, 2>{1, 1}) item["scaleUV"] = material.uv_scale;
    out.push_back(std::move(item));
  }
  return out;
}

}  // namespace layoutbox
