#include <nlohmann/json.hpp>

#include "layoutbox/scene/json_parts.h"
#include "layoutbox/scene/json_text.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox {
namespace {

using nlohmann::ordered_json;

ordered_json placed_room_json(const Room& room) {
  ordered_json out{{"polygon", json_of(room.polygon)}, {"height", json_length(room.height)}};
  ordered_json& walls = out["walls"] = ordered_json::array();
  for (const Wall& wall : room.walls) {
    ordered_json item{
        {"id", wall.id}, {"start", json_of(wall.start)}, {"end", json_of(wall.end)}, {"thickness", json_length(wall.thickness)}};
    if (!wall.material.empty()) item["mat"] = wall.material;
    if (!wall.mesh.empty()) item["mesh"] = wall.mesh;
    walls.push_back(std::move(item));
  }
  ordered_json& openings = out["openings"] = ordered_json::array();
  for (const Opening& opening : room.openings) {
    ordered_json item{{"id", opening.id}, {"type", name_of(opening.type)}};
    item["wall"] = opening.wall;
    if (opening.offset) item["offset"] = json_length(*opening.offset);
    item["w"] = json_length(opening.width);
    item["h"] = json_length(opening.height);
    item["sill"] = json_length(opening.sill);
    if (opening.type == OpeningType::kWindow) item["sillDepth"] = json_length(opening.sill_depth);
    if (opening.type == OpeningType::kDoor) item["swing"] = name_of(opening.swing);
    if (!opening.attributes.empty()) item["attributes"] = opening.attributes;
    add_origin(item, opening.origin);
    openings.push_back(std::move(item));
  }
  if (!room.floor_material.empty()) out["floorMat"] = room.floor_material;
  if (!room.ceiling_material.empty()) out["ceilingMat"] = room.ceiling_material;
  if (!room.wall_material.empty()) out["wallMat"] = room.wall_material;
  return out;
}

ordered_json object_json(const PlacedObject& object) {
  ordered_json out{{"id", object.id}, {"category", object.category}, {"name", object.name}};
  if (!object.catalog_id.empty()) out["catalogId"] = object.catalog_id;
  if (!object.attributes.empty()) out["attributes"] = object.attributes;
  out["size"] = json_of(object.size);
  out["pos"] = json_of(object.position);
  out["rotation"] = object.rotation_deg;
  out["mount"] = name_of(object.mount);
  out["supportedBy"] = object.supported_by;
  out["usedSides"] = json_of(object.used_sides);
  if (!object.spaces.empty()) out["spaces"] = json_of(object.spaces);
  if (!object.mesh.empty()) out["mesh"] = object.mesh;
  if (!object.mesh_front.empty()) out["meshFront"] = object.mesh_front;
  if (!object.material.empty()) out["matOverride"] = object.material;
  if (object.fixed) out["fixed"] = true;
  add_origin(out, object.origin);
  return out;
}

ordered_json relaxations_json(const std::vector<Relaxation>& relaxations) {
  ordered_json out = ordered_json::array();
  for (const Relaxation& item : relaxations) {
    ordered_json entry{{"relation", item.relation}, {"by", item.by}};
    if (!item.unit.empty()) entry["unit"] = item.unit;
    entry["why"] = item.why;
    out.push_back(std::move(entry));
  }
  return out;
}

}  // namespace

std::string write_layout(const Layout& layout) {
  ordered_json out{{"format", "layoutbox/layout@1"}, {"prompt", layout.prompt}};
  if (!layout.name.empty()) out["name"] = layout.name;
  out["roomType"] = layout.room.type;
  out["status"] = name_of(layout.status);
  out["room"] = placed_room_json(layout.room);
  ordered_json& objects = out["objects"] = ordered_json::array();
  for (const PlacedObject& object : layout.objects) objects.push_back(object_json(object));
  ordered_json& relations = out["relations"] = ordered_json::array();
  for (const PlacedRelation& placed : layout.relations) {
    ordered_json item = json_of(placed.relation);
    item["held"] = placed.held;
    relations.push_back(std::move(item));
  }
  out["relaxed"] = relaxations_json(layout.relaxed);
  if (!layout.gave_way.empty()) out["gaveWay"] = relaxations_json(layout.gave_way);
  ordered_json& conflicts = out["conflicts"] = ordered_json::array();
  for (const Conflict& item : layout.conflicts) {
    ordered_json entry{{"relations", item.relations}};
    if (!item.objects.empty()) entry["objects"] = item.objects;
    entry["sentence"] = item.sentence;
    if (!item.minimal) entry["minimal"] = false;
    conflicts.push_back(std::move(entry));
  }
  if (!layout.materials.empty()) out["materials"] = json_of(layout.materials);
  out["score"] = {{"total", layout.score}, {"terms", layout.score_terms}};
  ordered_json& stats = out["stats"] = {
      {"solver", layout.stats.solver}, {"seed", layout.stats.seed}, {"seconds", layout.stats.seconds}, {"proven", layout.stats.proven}};
  if (layout.stats.stopped_by_clock) stats["stoppedByClock"] = true;
  return format_json(out);
}

}  // namespace layoutbox
