// The pictures of a run: of its room, and of each further layout under names of its own.
#pragma once

#include <string>

#include "layoutbox/pipeline/generate.h"
#include "layoutbox/pipeline/run_folder.h"

namespace layoutbox {

struct Drawn {
  std::string summary;  // "scene.png 1920×1080, Blender 5.0.1"
  std::string blender_version;
};

// Draws what blender.py of the layout (0: the first; blender-2.py: 1) says, into the folder. Errors: those of run_blender().
Result<Drawn> draw_pictures(RunFolder& folder, std::size_t variant, const GenerateOptions& options);

}  // namespace layoutbox
