// The layout: the room with everything placed, which relations hold and what was given up; and layout.json, read and written.
#pragma once

#include "layoutbox/scene/layout.h"
#include "layoutbox/scene/scene_json.h"
