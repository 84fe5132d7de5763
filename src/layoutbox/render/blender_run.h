// What a run of Blender and a Blender that serves many rooms have in common: its surroundings, its words, what it leaves.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/process.h"
#include "layoutbox/base/result.h"
#include "layoutbox/render/render.h"

namespace layoutbox {

// What the script is told: the folder to write into and what is wished.
std::vector<std::string> script_words(const std::filesystem::path& folder, const RenderOptions& options, bool workbench);

// The words that start `blender` with a script; the script's own words follow.
std::vector<std::string> start_words(const Blender& blender, const std::filesystem::path& script);

// Blender writes caches and settings under HOME and TMPDIR: it gets its own.
std::map<std::string, std::string> blender_environment(const std::filesystem::path& home);

// Whether a picture is first tried with Workbench: a draft in an old Blender, which has no denoiser. That needs GL, and Blender aborts
// where there is none.
bool tries_workbench(const Blender& blender, const RenderOptions& options);

// The line of a log that says what went wrong: the last one with an error in it, else the last three.
std::string useful_lines(std::string_view log);

// Calls the user's progress and catches the version as the lines come.
class Listener {
 public:
  explicit Listener(const RenderOptions& options) : options_(options) {}
  void operator()(std::string_view line);
  std::string version;

 private:
  const RenderOptions& options_;
};

// Which error the end of a run is, or none. `what` happened is in `outcome`.
Status check_outcome(const ProcessOutcome& outcome, const RenderOptions& options);

// Brings what Blender made in `made` into the user's folder, each file whole or not at all.
Result<RenderOutputs> deliver_outputs(const std::filesystem::path& made, const std::filesystem::path& folder, const RenderOptions& options,
                                      std::string_view log);

}  // namespace layoutbox
