// The readers of the single formats, for room_file.cc. Each pair: does it look like that, and what is in it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "layoutbox/judge/room_file.h"

namespace layoutbox::readers {

bool is_layout(std::string_view bytes);
Result<RoomFile> read_own_layout(std::string_view bytes, const Catalog& catalog, const nlohmann::json& models);
bool is_scene(std::string_view bytes);
Result<RoomFile> read_positions(std::string_view bytes, const Catalog& catalog, const nlohmann::json& models);
bool is_scene_state(std::string_view bytes);
Result<RoomFile> read_scene_state(std::string_view bytes, const Catalog& catalog, const nlohmann::json& models);
bool is_layoutvlm(std::string_view bytes);
Result<RoomFile> read_layoutvlm(std::string_view bytes, const Catalog& catalog, const nlohmann::json& models);
bool is_holodeck(std::string_view bytes);
Result<RoomFile> read_holodeck(std::string_view bytes, const Catalog& catalog, const nlohmann::json& models);
bool is_gltf(std::string_view bytes);
Result<RoomFile> read_named_nodes(std::string_view bytes, const Catalog& catalog, const nlohmann::json& models);

}  // namespace layoutbox::readers
