// SceneEval's scene state: a room as walls with holes, objects as models with a transform (docs/judge.md).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "layoutbox/judge/readers/found_room.h"
#include "layoutbox/judge/readers/readers.h"
#include "layoutbox/scene/json_text.h"

namespace layoutbox::readers {
namespace {

using nlohmann::json;

const json& member(const json& value, const char* key) {
  static const json none;
  if (!value.is_object()) return none;
  const auto found = value.find(key);
  return found == value.end() ? none : *found;
}

void read_holes(const json& wall, FoundRoom& room) {
  const json& points = member(wall, "points");
  if (!points.is_array() || points.size() != 2) return;
  const auto a = point_of(points[0]), b = point_of(points[1]);
  const double length = a && b ? std::hypot((*b)[0] - (*a)[0], (*b)[1] - (*a)[1]) : 0;
  if (length <= 0) return;
  for (const json& hole : member(wall, "holes")) {
    const auto low = point_of(member(member(hole, "box"), "min")), high = point_of(member(member(hole, "box"), "max"));
    if (!low || !high) continue;
    const auto at = [&](double along) {
      return std::array<double, 2>{(*a)[0] + ((*b)[0] - (*a)[0]) * along / length, (*a)[1] + ((*b)[1] - (*a)[1]) * along / length};
    };
    const bool door = text_of(hole, "type") != "Window";
    room.openings.push_back({fmt::format("{}{}", door ? "door" : "window", room.openings.size() + 1),
                             door ? OpeningType::kDoor : OpeningType::kWindow, at((*low)[0]), at((*high)[0]), (*low)[1], (*high)[1]});
  }
}

void read_architecture(const json& elements, FoundRoom& room) {
  for (const json& element : elements) {
    const std::string type = text_of(element, "type");
    if (type == "Wall") {
      room.height = std::max(room.height, number(member(element, "height")).value_or(0));
      read_holes(element, room);
    }
    if (type != "Floor") continue;
    if (!room.polygon.empty()) {
      room.notes.push_back(
          {"ignored", fmt::format("there is more than one floor; the first is judged, not {}", text_of(element, "id")), {}});
      continue;
    }
    room.type = text_of(element, "roomId");
    for (const json& point : member(element, "points")) {
      if (const auto corner = point_of(point)) room.polygon.push_back({(*corner)[0], (*corner)[1]});
    }
  }
}

}  // namespace

bool is_scene_state(std::string_view bytes) {
  const auto document = parse_json(bytes);
  return document && document->is_object() && text_of(*document, "format") == "sceneState";
}

Result<RoomFile> read_scene_state(std::string_view bytes, const Catalog& catalog, const json& models) {
  LAYOUTBOX_ASSIGN(const json document, parse_json(bytes));
  const json& scene = member(document, "scene");
  FoundRoom room;
  room.name = text_of(scene, "id");
  read_architecture(member(member(scene, "arch"), "elements"), room);
  std::set<std::string> unknown;
  for (const json& object : member(scene, "object")) {
    const std::string model = text_of(object, "modelId");
    std::optional<ModelFacts> facts = model_facts(models, model);
    const json& data = member(member(object, "transform"), "data");
    if (!facts || !facts->size || facts->name.empty()) {
      unknown.insert(model);
      continue;
    }
    if (!data.is_array() || data.size() != 16) return fail(ErrorCode::kSchema, fmt::format("{} has no transform of 16 numbers", model));
    std::array<double, 16> m{};
    for (std::size_t i = 0; i < 16; ++i) m[i] = number(data[i]).value_or(0);
    // Columns: where the model's right, up and front (+z) point in the room. Models lie with y up; where theirs is z, the third is up.
    const auto length = [&](std::size_t column) { return std::hypot(m[4 * column], m[4 * column + 1], m[4 * column + 2]); };
    const bool y_up = std::abs(m[6]) >= std::abs(m[10]);
    const std::array<double, 3>& size = *facts->size;  // width, depth, height
    FoundObject found;
    found.id = text_of(object, "id").empty() ? text_of(object, "index") : text_of(object, "id");
    found.id = fmt::format("{}_{}", words_in(facts->name), found.id);
    std::replace(found.id.begin(), found.id.end(), ' ', '_');
    found.name = facts->name;
    found.size = {size[0] * length(0), size[1] * length(y_up ? 2 : 1), size[2] * length(y_up ? 1 : 2)};
    const double front_x = y_up ? m[8] : -m[4], front_y = y_up ? m[9] : -m[5];
    found.rotation_deg = std::atan2(front_x, -front_y) * 180 / kPi;
    found.position = {m[12], m[13], m[14]};
    room.objects.push_back(std::move(found));
  }
  if (!unknown.empty()) {
    return fail(ErrorCode::kReference,
                fmt::format("a scene state names models only, and the size or name of {} of them is not known, such as {}", unknown.size(),
                            *unknown.begin()),
                "/scene/object", R"(give --models FILE: {"MODEL": {"name": "chair", "size": [width, depth, height]}, …})");
  }
  room.notes.push_back({"guessed", "a model's origin is taken to be under its middle, its front to be +z of a model with y up", {}});
  return settle(std::move(room), catalog, "scenestate");
}

}  // namespace layoutbox::readers
