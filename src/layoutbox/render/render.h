// Model to pictures by Blender: writes the script, finds a Blender, runs it, checks what it made.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/furnish/model.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

enum class Quality { kDraft, kPreview, kFinal };

struct RenderOptions {
  Quality quality = Quality::kPreview;
  int width = 1920, height = 1080;  // pixels. REQUIRES: 16…16384
  double azimuth_deg = 45;          // camera at the front right (+x, −y), looking to the back left
  double elevation_deg = 65;
  bool orthographic = true;
  bool save_blend = true;
  // Also write an object mask (PNG, each object a flat colour) and its index (JSON), for visibility checks. DEFAULT: false.
  bool object_mask = false;
  double time_limit_s = 600;
  const std::atomic<bool>* stop = nullptr;
  // Called with a share done in [0, 1]; may be empty.
  std::function<void(double)> progress;
};

// The self-contained script: readable Python on top, the meshes in one compressed block at its end. Runs by itself:
//   blender -b --python blender.py            (writes scene.blend and scene.png beside itself, or into the folder after `--`)
//   python3 blender.py                        (a Python with the module bpy)
std::string write_blender_script(const Model& model, const Layout& layout, const RenderOptions& options);

// A Blender that works: how it is started and what it is.
struct Blender {
  std::vector<std::string> command;  // {"blender"} or {"/…/python3"} with bpy
  bool is_python_module = false;
  std::string version;  // "5.0.1"
};

// Looks at LAYOUTBOX_BLENDER, `blender` on the PATH, a Python with `bpy`, the private environment of setup.sh. Error kNoBlender with
// what was tried and how to get one.
Result<Blender> find_blender();

struct RenderOutputs {
  std::filesystem::path picture, blend, mask, mask_index;  // mask empty unless asked for
  std::string blender_version;
};

// Runs script_file (as written above) and puts scene.png and scene.blend into `folder`, each under a temporary name first and renamed only
// when it is whole. Errors: kNoBlender, kRenderFailed (with the last lines of Blender's log), kInterrupted, kIo.
Result<RenderOutputs> run_blender(const Blender& blender, const std::filesystem::path& script_file, const std::filesystem::path& folder,
                                  const RenderOptions& options);

}  // namespace layoutbox
