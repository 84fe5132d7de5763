// Layout to meshes and materials: furnish().
#pragma once

#include "layoutbox/furnish/furnish.h"
