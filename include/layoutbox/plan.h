// Text to scene graph: make_offline_planner(), or a planner of one's own.
#pragma once

#include "layoutbox/plan/planner.h"
