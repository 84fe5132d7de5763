// The scene graph: room, openings, objects with ranges of sizes, relations; and scene.json, read and written.
#pragma once

#include "layoutbox/scene/scene_graph.h"
#include "layoutbox/scene/scene_json.h"
