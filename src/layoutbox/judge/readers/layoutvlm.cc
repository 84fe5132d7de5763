// LayoutVLM: positions of assets by name, with the configuration (boundary, assets) in the same file or beside it.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "layoutbox/judge/readers/found_room.h"
#include "layoutbox/judge/readers/readers.h"
#include "layoutbox/scene/json_text.h"

namespace layoutbox::readers {
namespace {

using nlohmann::json;

const json* find_member(const json& value, const char* key) {
  if (!value.is_object()) return nullptr;
  const auto found = value.find(key);
  return found == value.end() ? nullptr : &*found;
}

bool is_placement(const json& value) { return find_member(value, "position") != nullptr && find_member(value, "rotation") != nullptr; }

const json* placements_in(const json& document) {
  const json* layout = find_member(document, "layout");
  if (layout == nullptr) layout = &document;
  if (!layout->is_object() || layout->empty()) return nullptr;
  for (const auto& [name, value] : layout->items()) {
    if (value.is_object() && !is_placement(value)) return nullptr;
  }
  return is_placement(layout->begin().value()) ? layout : nullptr;
}

}  // namespace

bool is_layoutvlm(std::string_view bytes) {
  const auto document = parse_json(bytes);
  return document && placements_in(*document) != nullptr;
}

Result<RoomFile> read_layoutvlm(std::string_view bytes, const Catalog& catalog, const json& models) {
  LAYOUTBOX_ASSIGN(const json document, parse_json(bytes));
  const json* layout = placements_in(document);
  if (layout == nullptr) return fail(ErrorCode::kSchema, "there are no placements with position and rotation");
  const json* configuration = find_member(document, "scene_config");
  if (configuration == nullptr) configuration = &models;
  const json* boundary = find_member(*configuration, "boundary");
  const json* vertices = boundary ? find_member(*boundary, "floor_vertices") : nullptr;
  if (vertices == nullptr) {
    return fail(ErrorCode::kReference, "a layout of LayoutVLM alone says nothing of the room and of sizes", "/boundary/floor_vertices",
                "give its scene configuration by --models FILE");
  }
  FoundRoom room;
  room.prompt = text_of(*configuration, "task_description");
  for (const json& vertex : *vertices) {
    if (const auto corner = point_of(vertex)) room.polygon.push_back({(*corner)[0], (*corner)[1]});
  }
  if (const json* height = find_member(*boundary, "wall_height")) room.height = number(*height).value_or(0);
  for (const auto& [id, placement] : layout->items()) {
    if (!is_placement(placement)) continue;
    const std::optional<ModelFacts> facts = model_facts(*configuration, id);
    const auto at = point_of(placement.at("position"));
    if (!facts || !facts->size || !at) {
      return fail(ErrorCode::kReference, fmt::format("the size or the place of {} is not known", id), "/" + id);
    }
    const json& rotation = placement.at("rotation");
    const double turn = rotation.is_number()                       ? rotation.get<double>()
                        : rotation.is_array() && !rotation.empty() ? number(rotation.back()).value_or(0)
                                                                   : 0;
    // Its assets look along +x at rotation 0: their x is our depth.
    room.objects.push_back({id,
                            facts->name.empty() ? id : facts->name,
                            {(*facts->size)[1], (*facts->size)[0], (*facts->size)[2]},
                            {(*at)[0], (*at)[1], (*at)[2] - (*facts->size)[2] / 2},
                            turn + 90,
                            {}});
  }
  room.notes.push_back({"guessed", "an asset's position is its middle, its rotation is in degrees, and it looks along +x at 0", {}});
  return settle(std::move(room), catalog, "layoutvlm");
}

}  // namespace layoutbox::readers
