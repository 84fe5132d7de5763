// A scene file for tests, and what is read of it.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "layoutbox/scene/scene_json.h"

namespace layoutbox {

// As the paper's authors write a scene.
inline nlohmann::json paper_scene() {
  return nlohmann::json::parse(R"({
    "metadata": {"projectId": "bedroom_001", "roomType": "bedroom", "units": "m", "axes": {"right": "X+", "forward": "Y+", "up": "Z+"}},
    "room": {
      "dims": {"w": 4.0, "d": 3.2, "h": 3.0},
      "walls": [
        {"id": "wall1", "start": [0, 0, 0], "end": [4, 0, 0], "thickness": 0.1, "mat": "paint"},
        {"id": "wall2", "start": [4, 0, 0], "end": [4, 3.2, 0], "thickness": 0.1, "mat": "paint", "mesh": null},
        {"id": "wall3", "start": [4, 3.2, 0], "end": [0, 3.2, 0], "thickness": 0.1, "mat": "paint", "mesh": {}},
        {"id": "wall4", "start": [0, 3.2, 0], "end": [0, 0, 0], "thickness": 0.1, "mat": "paint"}
      ],
      "openings": [{"id": "door1", "wallId": "Wall1", "offset": 2.9, "w": 0.9, "h": 2.0, "sill": 0}],
      "floorMat": "oak"
    },
    "furniture": [
      {"id": "bed", "catalogId": "BED-QUEEN", "category": "bed", "dims": {"w": 1.6, "d": 2.0, "h": 0.5, "source": "catalog"},
       "xform": {"pos": [1.0, 1.5, 0.25], "rot": [0, 0, 90], "scale": [1, 1, 1]}, "mesh": null, "matOverride": "blue", "tags": ["sleeping"]},
      {"id": "desk", "catalogId": "DESK-1", "category": "desk", "dims": null, "xform": {"pos": [3.0, 1.5, 0], "rot": [0, 0, 0], "scale": [1, 1, 1]}}
    ],
    "constraints": [
      {"id": "bed_left", "type": "offset", "targets": ["bed"], "axis": "X", "distance": 0, "relativeTo": "Wall4"},
      {"id": "desk_align", "type": "align", "targets": ["desk"], "alignAxis": "Y", "relativeTo": "bed"},
      {"id": "all_in", "type": "inside", "targets": ["bed", "desk"], "relativeTo": "room"}
    ],
    "materials": [{"id": "oak", "color": [0.6, 0.45, 0.3], "tex": null, "roughness": null, "scaleUV": 1}]
  })");
}

inline SceneGraph read(const nlohmann::json& document, std::string_view units = {}) {
  auto scene = read_scene(document.dump(), units);
  if (!scene) ADD_FAILURE() << scene.error().pointer << ": " << scene.error().message;
  return scene.value_or(SceneGraph{});
}

}  // namespace layoutbox
