// Model to picture: the Blender script and what runs it.
#pragma once

#include "layoutbox/render/render.h"
