#include <nlohmann/json.hpp>

#include "layoutbox/scene/json_parts.h"
#include "layoutbox/scene/json_text.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox {
namespace {

using nlohmann::ordered_json;

ordered_json metadata_json(const SceneGraph& scene) {
  ordered_json out = ordered_json::object();
  const auto add = [&](const char* key, const std::string& text) {
    if (!text.empty()) out[key] = text;
  };
  add("projectId", scene.project_id);
  add("name", scene.name);
  add("roomType", scene.room.type);
  out["units"] = "m";
  add("prompt", scene.prompt);
  return out;
}

ordered_json opening_json(const Opening& opening) {
  ordered_json out{{"id", opening.id}, {"type", name_of(opening.type)}};
  if (!opening.wall.empty()) out["wallId"] = opening.wall;
  if (opening.offset) out["offset"] = json_length(*opening.offset);
  out["w"] = json_length(opening.width);
  out["h"] = json_length(opening.height);
  out["sill"] = json_length(opening.sill);
  if (opening.type == OpeningType::kWindow) out["sillDepth"] = json_length(opening.sill_depth);
  if (opening.type == OpeningType::kDoor) out["swing"] = name_of(opening.swing);
  if (!opening.attributes.empty()) out["attributes"] = opening.attributes;
  add_origin(out, opening.origin);
  return out;
}

ordered_json room_json(const Room& room) {
  ordered_json out = ordered_json::object();
  if (!room.polygon.empty()) out["polygon"] = json_of(room.polygon);
  if (room.height > 0) out["height"] = json_length(room.height);
  if (room.area_m2) out["area"] = *room.area_m2;
  if (!room.size_word.empty()) out["sizeWord"] = room.size_word;
  if (!room.shape.empty()) out["shape"] = room.shape;
  if (!room.walls.empty()) {
    ordered_json& walls = out["walls"] = ordered_json::array();
    for (const Wall& wall : room.walls) {
      const auto end_json = [](Point p) { return ordered_json{json_length(p.x), json_length(p.y), 0}; };
      ordered_json item{
          {"id", wall.id}, {"start", end_json(wall.start)}, {"end", end_json(wall.end)}, {"thickness", json_length(wall.thickness)}};
      if (!wall.material.empty()) item["mat"] = wall.material;
      if (!wall.mesh.empty()) item["mesh"] = wall.mesh;
      walls.push_back(std::move(item));
    }
  }
  if (room.openings_given || !room.openings.empty()) {
    ordered_json& openings = out["openings"] = ordered_json::array();
    for (const Opening& opening : room.openings) openings.push_back(opening_json(opening));
  }
  if (!room.floor_material.empty()) out["floorMat"] = room.floor_material;
  if (!room.ceiling_material.empty()) out["ceilingMat"] = room.ceiling_material;
  if (!room.wall_material.empty()) out["wallMat"] = room.wall_material;
  return out;
}

// A side of 0 is not known and left out.
ordered_json dims_json(const Size& size) {
  ordered_json out = ordered_json::object();
  if (size.width > 0) out["w"] = json_length(size.width);
  if (size.depth > 0) out["d"] = json_length(size.depth);
  if (size.height > 0) out["h"] = json_length(size.height);
  return out;
}

ordered_json range_json(const SizeRange& range) {
  ordered_json out = ordered_json::object();
  const auto add = [&](const char* key, Mm Size::*side) {
    if (range.greatest.*side > 0) {
      out[key] = {json_length(range.least.*side), json_length(range.usual.*side), json_length(range.greatest.*side)};
    }
  };
  add("w", &Size::width);
  add("d", &Size::depth);
  add("h", &Size::height);
  return out;
}

ordered_json object_json(const SceneObject& object) {
  ordered_json out{{"id", object.id}};
  if (!object.catalog_id.empty()) out["catalogId"] = object.catalog_id;
  out["category"] = object.category;
  if (!object.name.empty()) out["name"] = object.name;
  if (!object.attributes.empty()) out["attributes"] = object.attributes;
  if (object.size) {
    ordered_json& dims = out["dims"] = dims_json(object.size->usual);
    if (object.size_source != SizeSource::kUnknown) dims["source"] = name_of(object.size_source);
    if (object.size->least != object.size->usual || object.size->greatest != object.size->usual)
      out["dimsRange"] = range_json(*object.size);
  }
  ordered_json xform = ordered_json::object();
  if (object.hint.position) xform["pos"] = json_of(*object.hint.position);
  if (object.hint.rotation_deg) xform["rot"] = {0, 0, *object.hint.rotation_deg};
  if (object.scale != std::array<double, 3>{1, 1, 1}) xform["scale"] = object.scale;
  if (!xform.empty()) out["xform"] = std::move(xform);
  if (object.mount) out["mount"] = name_of(*object.mount);
  if (object.mount && object.mount_assumed) out["mountAssumed"] = true;
  if (object.used_sides) out["usedSides"] = json_of(*object.used_sides);
  if (object.spaces_given) out["spaces"] = json_of(object.spaces);
  if (!object.mesh.empty()) out["mesh"] = object.mesh;
  if (!object.mesh_front.empty()) out["meshFront"] = object.mesh_front;
  if (!object.material.empty()) out["matOverride"] = object.material;
  if (!object.tags.empty()) out["tags"] = object.tags;
  if (object.fixed) out["fixed"] = true;
  add_origin(out, object.origin);
  return out;
}

}  // namespace

std::string write_scene(const SceneGraph& scene) {
  ordered_json out{{"format", "layoutbox/scene@1"}, {"metadata", metadata_json(scene)}, {"room", room_json(scene.room)}};
  ordered_json& furniture = out["furniture"] = ordered_json::array();
  for (const SceneObject& object : scene.objects) furniture.push_back(object_json(object));
  ordered_json& constraints = out["constraints"] = ordered_json::array();
  for (const Relation& relation : scene.relations) constraints.push_back(json_of(relation));
  if (!scene.materials.empty()) out["materials"] = json_of(scene.materials);
  if (!scene.notes.empty()) {
    ordered_json& notes = out["notes"] = ordered_json::array();
    for (const Note& note : scene.notes) {
      ordered_json item{{"code", note.code}, {"message", note.message}};
      if (!note.pointer.empty()) item["pointer"] = note.pointer;
      notes.push_back(std::move(item));
    }
  }
  return format_json(out);
}

}  // namespace layoutbox
