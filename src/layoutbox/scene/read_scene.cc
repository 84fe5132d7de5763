#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "layoutbox/scene/json_documents.h"
#include "layoutbox/scene/json_parts.h"
#include "layoutbox/scene/json_text.h"
#include "layoutbox/scene/quirks.h"
#include "layoutbox/scene/scene_check.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/scene/schema_check.h"

namespace layoutbox {
namespace {

using nlohmann::json;

void set_side(SizeRange& range, Mm Size::*side, const json& dims, const json& ranges, const char* key) {
  const Mm usual = length_at(dims, key);
  range.least.*side = range.usual.*side = range.greatest.*side = usual;
  const auto found = ranges.find(key);
  if (found == ranges.end()) return;
  range.least.*side = mm_from_m(found->at(0).get<double>());
  range.usual.*side = mm_from_m(found->at(1).get<double>());
  range.greatest.*side = mm_from_m(found->at(2).get<double>());
}

std::optional<SizeRange> size_from(const json& object) {
  static const json kNothing = json::object();
  const json& dims = object.contains("dims") ? object.at("dims") : kNothing;
  const json& ranges = object.contains("dimsRange") ? object.at("dimsRange") : kNothing;
  SizeRange range;
  set_side(range, &Size::width, dims, ranges, "w");
  set_side(range, &Size::depth, dims, ranges, "d");
  set_side(range, &Size::height, dims, ranges, "h");
  return range == SizeRange{} ? std::nullopt : std::optional(range);
}

SceneObject object_from(const json& value, bool own) {
  SceneObject object;
  object.id = text_at(value, "id");
  object.category = text_at(value, "category");
  object.name = text_at(value, "name");
  object.catalog_id = text_at(value, "catalogId");
  object.attributes = texts_at(value, "attributes");
  object.size = size_from(value);
  if (value.contains("dims"))
    object.size_source = size_source_from_name(text_at(value.at("dims"), "source")).value_or(SizeSource::kUnknown);
  object.mount = mount_from_name(text_at(value, "mount"));
  object.mount_assumed = flag_at(value, "mountAssumed", false);
  if (const auto sides = value.find("usedSides"); sides != value.end()) object.used_sides = sides_from(*sides);
  if (const auto spaces = value.find("spaces"); spaces != value.end()) {
    object.spaces = spaces_from(*spaces);
    object.spaces_given = true;
  }
  if (const auto xform = value.find("xform"); xform != value.end()) {
    if (const auto pos = xform->find("pos"); pos != xform->end()) {
      object.hint.position = vector_from(*pos);
      object.hint.z_may_be_centre = !own;
    }
    if (const auto rot = xform->find("rot"); rot != xform->end()) object.hint.rotation_deg = normalized_degrees(rot->at(2).get<double>());
    if (const auto scale = xform->find("scale"); scale != xform->end()) object.scale = scale->get<std::array<double, 3>>();
  }
  object.fixed = flag_at(value, "fixed", false);
  object.mesh = text_at(value, "mesh");
  object.mesh_front = text_at(value, "meshFront");
  object.material = text_at(value, "matOverride");
  object.tags = texts_at(value, "tags");
  object.origin = origin_at(value);
  return object;
}

// A rectangle needs both sides; a height alone is fine, the rest comes from the polygon, the walls or what the room holds.
void check_room_dims(const json& room, const std::string& pointer, std::vector<Error>& errors) {
  const auto dims = room.find("dims");
  if (dims == room.end() || dims->contains("w") == dims->contains("d")) return;
  const char* missing = dims->contains("w") ? "d" : "w";
  errors.push_back({ErrorCode::kSchema,
                    fmt::format("{}/dims has no \"{}\"", pointer, missing),
                    pointer + "/dims",
                    fmt::format("add \"{}\": metres", missing),
                    {}});
}

Room room_from(const json& value) {
  Room room;
  if (const auto polygon = value.find("polygon"); polygon != value.end()) room.polygon = polygon_from(*polygon);
  room.height = length_at(value, "height");
  if (const auto dims = value.find("dims"); dims != value.end()) {
    const Mm w = length_at(*dims, "w"), d = length_at(*dims, "d");
    if (room.polygon.empty() && w > 0) room.polygon = {{0, 0}, {w, 0}, {w, d}, {0, d}};
    if (room.height == 0) room.height = length_at(*dims, "h");
  }
  if (const auto area = value.find("area"); area != value.end()) room.area_m2 = area->get<double>();
  room.size_word = text_at(value, "sizeWord");
  room.shape = text_at(value, "shape");
  if (room.shape == "rectangle") room.shape.clear();
  if (const auto walls = value.find("walls"); walls != value.end()) {
    for (const json& item : *walls) {
      Wall wall;
      wall.id = text_at(item, "id");
      wall.start = point_from(item.at("start"));
      wall.end = point_from(item.at("end"));
      wall.thickness = length_at(item, "thickness", wall.thickness);
      wall.material = text_at(item, "mat");
      wall.mesh = text_at(item, "mesh");
      room.walls.push_back(std::move(wall));
    }
  }
  if (const auto openings = value.find("openings"); openings != value.end()) {
    room.openings_given = true;
    for (const json& item : *openings) room.openings.push_back(opening_from(item));
  }
  room.floor_material = text_at(value, "floorMat");
  room.ceiling_material = text_at(value, "ceilingMat");
  room.wall_material = text_at(value, "wallMat");
  return room;
}

// Ids of constraints and of objects in relations are settled here, so that nobody later has to compare without regard to case.
void settle_names(SceneGraph& scene) {
  const auto settle = [&](std::string& name, const std::string& pointer) {
    if (scene.find_object(name) != nullptr || scene.find_opening(name) != nullptr) return;
    std::string id;
    for (const SceneObject& object : scene.objects) {
      if (same_name(object.id, name)) id = object.id;
    }
    if (id.empty()) {
      if (const Wall* wall = scene.find_wall(name)) id = wall->id;
    }
    if (id.empty() || id == name) return;
    scene.notes.push_back({"converted", fmt::format("\"{}\" is read as \"{}\"", name, id), pointer});
    name = id;
  };
  for (std::size_t i = 0; i < scene.relations.size(); ++i) {
    Relation& relation = scene.relations[i];
    for (std::string& target : relation.targets) settle(target, fmt::format("/constraints/{}/targets", i));
    for (std::string& reference : relation.references) settle(reference, fmt::format("/constraints/{}/relativeTo", i));
  }
  for (std::size_t i = 0; i < scene.room.openings.size(); ++i) {
    std::string& wall = scene.room.openings[i].wall;
    if (wall.empty()) continue;
    if (const Wall* found = scene.find_wall(wall); found != nullptr && found->id != wall) {
      scene.notes.push_back(
          {"converted", fmt::format("the wall \"{}\" is read as \"{}\"", wall, found->id), fmt::format("/room/openings/{}", i)});
      wall = found->id;
    }
  }
}

SceneGraph scene_from(const json& document, bool own) {
  SceneGraph scene;
  if (const auto metadata = document.find("metadata"); metadata != document.end()) {
    scene.project_id = text_at(*metadata, "projectId");
    scene.name = text_at(*metadata, "name");
    scene.prompt = text_at(*metadata, "prompt");
    scene.room.type = text_at(*metadata, "roomType");
  }
  std::string type = std::move(scene.room.type);
  scene.room = room_from(document.at("room"));
  scene.room.type = std::move(type);
  for (const json& item : document.at("furniture")) scene.objects.push_back(object_from(item, own));
  if (const auto constraints = document.find("constraints"); constraints != document.end()) {
    for (const json& item : *constraints) scene.relations.push_back(relation_from(item));
  }
  if (const auto materials = document.find("materials"); materials != document.end()) scene.materials = materials_from(*materials);
  if (const auto notes = document.find("notes"); notes != document.end()) {
    for (const json& item : *notes) scene.notes.push_back({text_at(item, "code"), text_at(item, "message"), text_at(item, "pointer")});
  }
  return scene;
}

Status check_units(std::string_view units) {
  if (metres_per_unit(units)) return {};
  return fail(ErrorCode::kUsage, fmt::format("\"{}\" is no unit of length", units), {}, "give m, cm, mm, ft or in");
}

}  // namespace

Result<SceneGraph> scene_from_json(json document, std::string_view units) {
  LAYOUTBOX_CHECK(check_units(units));
  try {
    const bool own = document.is_object() && document.contains("format");
    std::vector<Note> notes;
    const Status formed = bring_into_form(document, own ? std::string_view() : units, notes);
    std::vector<Error> errors = check_against_schema(document, SchemaName::kScene);
    if (!formed) errors.push_back(formed.error());
    if (errors.empty()) check_room_dims(document.at("room"), "/room", errors);
    if (!errors.empty()) return Failure(combined(std::move(errors)));
    SceneGraph scene = scene_from(document, own);
    scene.notes.insert(scene.notes.end(), notes.begin(), notes.end());
    settle_names(scene);
    if (errors = check_scene(scene); !errors.empty()) return Failure(combined(std::move(errors)));
    return scene;
  } catch (const std::exception& error) {
    return fail(ErrorCode::kInternal, fmt::format("the scene cannot be read: {}", error.what()));
  }
}

Result<Room> room_from_json(json document, std::string_view units) {
  LAYOUTBOX_CHECK(check_units(units));
  try {
    // A whole scene or layout file gives its room.
    if (document.is_object() && document.contains("room")) document = json(document.at("room"));
    std::vector<Note> notes;
    bring_room_into_form(document, units, notes);
    std::vector<Error> errors = check_against_schema(document, SchemaName::kScene, "room");
    if (errors.empty()) check_room_dims(document, "", errors);
    if (!errors.empty()) return Failure(combined(std::move(errors)));
    SceneGraph scene;
    scene.room = room_from(document);
    settle_names(scene);
    if (errors = check_scene(scene); !errors.empty()) return Failure(combined(std::move(errors)));
    return scene.room;
  } catch (const std::exception& error) {
    return fail(ErrorCode::kInternal, fmt::format("the room cannot be read: {}", error.what()));
  }
}

Result<SceneGraph> read_scene(std::string_view text, std::string_view units) {
  LAYOUTBOX_ASSIGN(json document, parse_json(text));
  return scene_from_json(std::move(document), units);
}

Result<Room> read_room(std::string_view text, std::string_view units) {
  LAYOUTBOX_ASSIGN(json document, parse_json(text));
  return room_from_json(std::move(document), units);
}

}  // namespace layoutbox
