#include "layoutbox/export/gltf_extras.h"

#include <algorithm>
#include <array>

namespace layoutbox {
namespace {

using tinygltf::Value;

// The room's corners [x, y] in metres, y to the back as in the layout: of an L the mesh alone says no corners.
Value::Array polygon(const Layout& layout) {
  Value::Array corners;
  for (const Point& corner : layout.room.polygon) {
    corners.emplace_back(Value::Array{Value(m_from_mm(corner.x)), Value(m_from_mm(corner.y))});
  }
  return corners;
}

// The relations that place this object.
Value::Array relations(const Layout& layout, const std::string& id) {
  Value::Array list;
  for (const PlacedRelation& placed : layout.relations) {
    const Relation& relation = placed.relation;
    if (std::find(relation.targets.begin(), relation.targets.end(), id) == relation.targets.end()) continue;
    Value::Array references;
    for (const std::string& reference : relation.references) references.emplace_back(reference);
    list.emplace_back(Value::Object{{"id", Value(relation.id)},
                                    {"type", Value(std::string(relation_row(relation.type).name))},
                                    {"relativeTo", Value(std::move(references))},
                                    {"held", Value(placed.held)}});
  }
  return list;
}

}  // namespace

Value gltf_extras(const Node& node, const Layout& layout) {
  constexpr std::array kKinds{"floor", "wall", "ceiling", "opening", "object"};
  Value::Object values{{"kind", Value(std::string(kKinds.at(static_cast<std::size_t>(node.kind))))}};
  const auto add = [&](const char* key, const std::string& text) {
    if (!text.empty()) values[key] = Value(text);
  };
  add("wall", node.parent);
  if (const Opening* opening = node.kind == NodeKind::kOpening ? layout.find_opening(node.id) : nullptr) {
    add("category", std::string(name_of(opening->type)));
    add("swing", std::string(name_of(opening->swing)));
    Value::Array size;
    for (const Mm length : {opening->width, opening->height, opening->sill}) size.emplace_back(m_from_mm(length));
    values["size"] = Value(std::move(size));
  }
  if (node.kind == NodeKind::kFloor) values["polygon"] = Value(polygon(layout));
  const PlacedObject* object = node.kind == NodeKind::kObject ? layout.find_object(node.id) : nullptr;
  if (object == nullptr) return Value(std::move(values));
  add("category", object->category);
  add("name", object->name);
  add("supportedBy", object->supported_by);
  Value::Array size;
  for (const Mm length : {object->size.width, object->size.depth, object->size.height}) size.emplace_back(m_from_mm(length));
  values["size"] = Value(std::move(size));
  values["relations"] = Value(relations(layout, node.id));
  return Value(std::move(values));
}

}  // namespace layoutbox
