#include "layoutbox/judge/room_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "layoutbox/judge/readers/readers.h"
#include "layoutbox/render/foreign.h"
#include "layoutbox/scene/json_text.h"

namespace layoutbox {
namespace {

using namespace readers;  // NOLINT(google-build-using-namespace): the table below is what the namespace is for

// What Blender reads of it is glTF; this is never called with the bytes themselves.
Result<RoomFile> read_blend_as_gltf(std::string_view bytes, const Catalog& catalog, const nlohmann::json& models) {
  LAYOUTBOX_ASSIGN(RoomFile room, read_named_nodes(bytes, catalog, models));
  room.format = "blend";
  return room;
}

constexpr std::array kFormats{
    RoomFormat{"blend", "a scene of Blender's with named objects", &is_blend, &read_blend_as_gltf},
    RoomFormat{"gltf", "glTF or GLB with named nodes", &is_gltf, &read_named_nodes},
    RoomFormat{"scenestate", "SceneEval's scene state", &is_scene_state, &read_scene_state},
    RoomFormat{"layoutvlm", "LayoutVLM's layout with its scene configuration", &is_layoutvlm, &read_layoutvlm},
    RoomFormat{"holodeck", "Holodeck's (ProcTHOR's) house", &is_holodeck, &read_holodeck},
    RoomFormat{"layout", "layoutbox/layout@1, also by hand", &is_layout, &read_own_layout},
    RoomFormat{"scene", "a scene with positions, ours or the paper's", &is_scene, &read_positions},
};

}  // namespace

std::span<const RoomFormat> room_formats() { return kFormats; }

const RoomFormat* find_room_format(std::string_view name) {
  const auto found = std::find_if(kFormats.begin(), kFormats.end(), [&](const RoomFormat& format) { return format.name == name; });
  return found == kFormats.end() ? nullptr : &*found;
}

Result<RoomFile> read_room_file(std::string_view bytes, const Catalog& catalog, const RoomFileOptions& options) {
  const RoomFormat* format = options.format.empty() ? nullptr : find_room_format(options.format);
  if (!options.format.empty() && format == nullptr) {
    std::string names;
    for (const RoomFormat& row : kFormats) names += fmt::format("{}{}", names.empty() ? "" : ", ", row.name);
    return fail(ErrorCode::kUsage, fmt::format("there is no format \"{}\"", options.format), {}, "use one of " + names);
  }
  if (format == nullptr) {
    const auto found = std::find_if(kFormats.begin(), kFormats.end(), [&](const RoomFormat& row) { return row.is_it(bytes); });
    if (found == kFormats.end()) {
      return fail(ErrorCode::kParse, "this is no room in a form that is known", {},
                  "layout.json, a scene with positions, a scene state, LayoutVLM's or Holodeck's JSON, glTF");
    }
    format = &*found;
  }
  nlohmann::json models = nlohmann::json::object();
  if (!options.models.empty()) {
    LAYOUTBOX_ASSIGN(models, parse_json(options.models));
  }
  std::string of_blend;
  if (is_blend(bytes)) {
    LAYOUTBOX_ASSIGN(const Blender blender, find_blender());
    ForeignOptions foreign;
    foreign.without_walls = options.without_walls;
    LAYOUTBOX_ASSIGN(of_blend, gltf_of_blend(blender, bytes, foreign));
    bytes = of_blend;
  }
  try {
    return format->read(bytes, catalog, models);
  } catch (const nlohmann::json::exception& error) {
    return fail(ErrorCode::kSchema, fmt::format("the {} file is not as it should be: {}", format->name, error.what()));
  }
}

}  // namespace layoutbox
