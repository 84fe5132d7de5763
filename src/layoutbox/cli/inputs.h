// What several subcommands read and how their shared options become the stages' option structs.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "layoutbox/base/result.h"
#include "layoutbox/pipeline/generate.h"

namespace layoutbox::cli {

// Options of planning and of the room: --planner, --room, --units.
struct PlanFlags {
  std::string planner = "offline";
  std::string room;
  std::string units;
  void add_to(CLI::App& command);
  Status apply(GenerateOptions& options) const;
};

// Options of the solver: --seed, --effort, --time-limit, --on-conflict.
struct SolveFlags {
  std::string on_conflict;
  void add_to(CLI::App& command, SolveOptions& options);
  Status apply(SolveOptions& options) const;
};

// Options of pictures: --quality, --size.
struct RenderFlags {
  std::string quality = "preview";
  std::string size = "1920x1080";
  void add_to(CLI::App& command);
  Status apply(RenderOptions& options) const;
};

// A prompt as given, or all of stdin for "-".
Result<std::string> read_prompt(const std::string& argument);

// A file's text, or all of stdin for "-".
Result<std::string> read_input(const std::string& path);
Result<Layout> read_layout_file(const std::string& path);
Result<SceneGraph> read_scene_file(const std::string& path, const std::string& units = {});

// Writes to a file, or to stdout for "-" or an empty path.
Status write_output(const std::string& path, std::string_view bytes);

}  // namespace layoutbox::cli
