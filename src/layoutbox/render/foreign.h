// Scripts and .blend files of others in Blender, in the sandbox (docs/sandbox.md).
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/render/render.h"
#include "layoutbox/sandbox/sandbox.h"

namespace layoutbox {

struct ForeignOptions {
  sandbox::Limits limits;
  bool without_walls = false;  // see sandbox::Job
  const std::atomic<bool>* stop = nullptr;
  // A picture of what a script built, through its own camera. Empty: none.
  struct Picture {
    int width = 1920, height = 1080, samples = 10;
  };
  std::optional<Picture> picture;
};

// How a script ended, in the classes that are counted.
enum class ScriptEnd {
  kDone,
  kSyntax,   // it is no Python
  kRunTime,  // it raised, or took Blender down
  kLimit,    // it passed a limit of the sandbox
};
std::string_view name_of(ScriptEnd end);

struct ForeignRun {
  ScriptEnd end = ScriptEnd::kDone;
  std::string message;  // of a script that failed: "NameError: name 'x' is not defined (line 3)"
  std::string blend;    // bytes of the scene it made; only where it is done
  std::string picture;  // a whole PNG, where one was wanted and it is done
};

// Runs a script in an empty scene. Errors: kNoBlender, that of sandbox::describe_walls(), kInterrupted, kIo. That it fails is none.
Result<ForeignRun> run_foreign_script(const Blender& blender, const std::string& script, const ForeignOptions& options = {});

// What stands in a .blend as glTF without meshes: a node for everything that is drawn, with its name, place and box. Scripts and drivers in
// the file are not run. Errors: as above; kParse where Blender cannot open it, kTooLarge.
Result<std::string> gltf_of_blend(const Blender& blender, std::string_view blend, const ForeignOptions& options = {});

// Looks like one: plain or packed.
bool is_blend(std::string_view bytes);

}  // namespace layoutbox
