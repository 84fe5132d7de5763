#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/llm/mend.h"
#include "layoutbox/plan/llm/mend_text.h"
#include "layoutbox/scene/quirks.h"

namespace layoutbox::llm {
namespace {

using nlohmann::json;

// {"scene": {…}}, {"name": "create_scene", "arguments": {…}} → {…}
void unwrap(json& scene, Notes& notes) {
  for (int depth = 0; depth < 4; ++depth) {
    if (!scene.is_object() || scene.contains("furniture") || scene.contains("room")) return;
    bool found = false;
    for (const char* key : {"scene", "arguments", "parameters", "scene_graph", "sceneGraph", "create_scene", "result", "layout"}) {
      const auto inner = scene.find(key);
      if (inner == scene.end()) continue;
      json taken = *inner;
      if (taken.is_string()) taken = json::parse(taken.get<std::string>(), nullptr, false);
      if (!taken.is_object()) continue;
      scene = std::move(taken);
      note(notes, fmt::format("the scene was wrapped into \"{}\"", key));
      found = true;
      break;
    }
    if (!found) return;
  }
}

struct OtherName {
  const char *from, *to;
};

void rename_all(json& object, std::initializer_list<OtherName> names, const std::string& at, Notes& notes) {
  if (!object.is_object()) return;
  for (const auto& [from, to] : names) {
    if (rename_member(object, from, to)) note(notes, fmt::format("\"{}\" is read as \"{}\"", from, to), at);
  }
}

// {"bed_1": {…}, "desk_1": {…}} → [{"id": "bed_1", …}, …]
void make_list(json& scene, const char* key, Notes& notes) {
  const auto found = scene.find(key);
  if (found == scene.end() || !found->is_object()) return;
  json list = json::array();
  for (auto& [id, value] : found->items()) {
    if (!value.is_object()) continue;
    if (!value.contains("id")) value["id"] = id;
    list.push_back(std::move(value));
  }
  *found = std::move(list);
  note(notes, "an object was read as a list", fmt::format("/{}", key));
}

double largest_number(const json& value) {
  if (value.is_number()) return std::abs(value.get<double>());
  double largest = 0;
  if (!value.is_structured()) return 0;
  for (const json& child : value) largest = std::max(largest, largest_number(child));
  return largest;
}

// A room of 400 is one of 400 cm; one of 4 "cm" is one of 4 m.
void settle_units(json& scene, Notes& notes) {
  if (!scene.contains("room") || !scene["room"].is_object()) return;
  const json& room = scene["room"];
  double largest = 0;
  for (const char* key : {"dims", "polygon"}) {
    if (room.contains(key)) largest = std::max(largest, largest_number(room[key]));
  }
  if (largest <= 0) return;
  json& metadata = scene["metadata"];
  if (!metadata.is_object()) metadata = json::object();
  const auto written = metadata.find("units");
  const std::string units = written != metadata.end() && written->is_string() ? written->get<std::string>() : "m";
  const double metres = largest * metres_per_unit(units).value_or(1);
  if (metres >= 1 && metres <= 60) return;
  const char* const meant = largest <= 60 ? "m" : largest <= 3000 ? "cm" : "mm";
  if (units == meant) return;
  metadata["units"] = meant;
  note(notes, fmt::format("a room of {:g} is measured in {}, so lengths are read as {}", largest, meant, meant), "/room");
}

// {"width": 4, "depth": 3, "height": 2.5}
void gather_dims(json& room, Notes& notes) {
  if (!room.is_object() || room.contains("dims")) return;
  json dims = json::object();
  for (const char* key : {"w", "width", "d", "depth", "l", "length", "h"}) {
    if (room.contains(key)) dims[key] = room[key], room.erase(key);
  }
  if (dims.empty()) return;
  if (room.contains("height")) dims["h"] = room["height"], room.erase("height");
  room["dims"] = std::move(dims);
  note(notes, "the room's size is read as \"dims\"", "/room");
}

void mend_room_form(json& scene, Notes& notes) {
  json& room = scene["room"];
  rename_all(room, {{"dimensions", "dims"}, {"size", "dims"}}, "/room", notes);
  gather_dims(room, notes);
  if (room.is_object() && room.contains("type") && room["type"].is_string()) {
    json& metadata = scene["metadata"];
    if (!metadata.is_object()) metadata = json::object();
    rename_all(metadata, {}, "", notes);
    if (!metadata.contains("roomType")) metadata["roomType"] = room["type"];
    room.erase("type");
  }
  if (scene.contains("metadata")) rename_all(scene["metadata"], {{"room_type", "roomType"}, {"type", "roomType"}}, "/metadata", notes);
}

void mend_object_form(json& object, const std::string& at, Notes& notes) {
  rename_all(object,
             {{"type", "category"},
              {"class", "category"},
              {"dimensions", "dims"},
              {"size", "dims"},
              {"transform", "xform"},
              {"catalog_id", "catalogId"}},
             at, notes);
  if (!object.is_object() || !(object.contains("position") || object.contains("rotation"))) return;
  json& xform = object["xform"];
  if (!xform.is_object()) xform = json::object();
  for (const auto& [from, to] : {std::pair{"position", "pos"}, std::pair{"rotation", "rot"}}) {
    if (object.contains(from)) xform[to] = object[from], object.erase(from);
  }
  note(notes, "position and rotation are read as \"xform\"", at);
}

void mend_relation_form(json& relation, const std::string& at, Notes& notes) {
  if (!relation.is_object()) return;
  rename_all(relation,
             {{"relation", "type"},
              {"source", "targets"},
              {"subject", "targets"},
              {"object", "targets"},
              {"objects", "targets"},
              {"item", "targets"}},
             at, notes);
  if (relation.contains("targets") && relation.contains("target")) rename_all(relation, {{"target", "relativeTo"}}, at, notes);
  rename_all(relation,
             {{"relative_to", "relativeTo"},
              {"reference", "relativeTo"},
              {"references", "relativeTo"},
              {"anchor", "relativeTo"},
              {"to", "relativeTo"},
              {"wall", "relativeTo"}},
             at, notes);
}

void mend_each(json& scene, const char* list, void (*mend_one)(json&, const std::string&, Notes&), Notes& notes) {
  if (!scene.contains(list) || !scene[list].is_array()) return;
  std::size_t i = 0;
  for (json& one : scene[list]) mend_one(one, fmt::format("/{}/{}", list, i++), notes);
}

}  // namespace

void mend_form(json& scene, Notes& notes) {
  unwrap(scene, notes);
  if (!scene.is_object()) return;
  rename_all(scene, {{"objects", "furniture"}, {"items", "furniture"}, {"relations", "constraints"}, {"relationships", "constraints"}}, "",
             notes);
  for (const char* key : {"furniture", "constraints", "materials"}) make_list(scene, key, notes);
  if (!scene.contains("room") || scene["room"].is_null()) scene["room"] = json::object();
  if (scene.contains("metadata") && !scene["metadata"].is_object()) scene.erase("metadata");
  mend_room_form(scene, notes);
  mend_each(scene, "furniture", mend_object_form, notes);
  mend_each(scene, "constraints", mend_relation_form, notes);
  settle_units(scene, notes);
  // Directions of axes are not asked for, and a model that writes them seldom means them.
  if (scene.contains("metadata") && scene["metadata"].is_object() && scene["metadata"].erase("axes") > 0)
    note(notes, "axes are left out", "/metadata");
  (void)bring_into_form(scene, {}, notes);  // axes are all that could be wrong
}

}  // namespace layoutbox::llm
