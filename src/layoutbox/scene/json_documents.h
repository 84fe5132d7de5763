// Scenes and layouts that stand inside larger JSON documents, such as a request: the checks and errors of scene_json.h, without a text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "layoutbox/scene/scene_json.h"

namespace layoutbox {

// REQUIRES: parsed by parse_json() (no key given twice). Pointers of errors begin at the document itself.
Result<SceneGraph> scene_from_json(nlohmann::json document, std::string_view units = {});
Result<Layout> layout_from_json(nlohmann::json document);
Result<Room> room_from_json(nlohmann::json document, std::string_view units = {});

}  // namespace layoutbox
