// Runs the script in a process of its own with a home, a time limit and a folder of its own; only whole files reach the user's folder.
#include <fmt/format.h>

#include "layoutbox/base/files.h"
#include "layoutbox/base/process.h"
#include "layoutbox/render/blender_run.h"
#include "layoutbox/render/render.h"

namespace layoutbox {

Result<RenderOutputs> run_blender(const Blender& blender, const std::filesystem::path& script_file, const std::filesystem::path& folder,
                                  const RenderOptions& options) {
  if (blender.command.empty()) return fail(ErrorCode::kNoBlender, "no Blender was given to render with");
  std::error_code error;
  const auto script = std::filesystem::absolute(script_file, error);
  if (error || !std::filesystem::exists(script, error)) return fail(ErrorCode::kIo, fmt::format("{} is not there", script_file.string()));
  LAYOUTBOX_CHECK(make_folder(folder));
  LAYOUTBOX_ASSIGN(const auto home, TemporaryFolder::make("blender"));
  LAYOUTBOX_ASSIGN(const auto made, TemporaryFolder::make("picture"));

  Listener listener(options);
  ProcessOptions process;
  process.environment = blender_environment(home.path());
  process.time_limit_s = options.time_limit_s;
  process.stop = options.stop;
  process.on_line = [&](std::string_view line) { listener(line); };
  const auto run = [&](bool workbench) {
    std::vector<std::string> command = start_words(blender, script);
    for (std::string& word : script_words(made.path(), options, workbench)) command.push_back(std::move(word));
    return run_process(command, process);
  };
  const bool try_workbench = tries_workbench(blender, options);
  LAYOUTBOX_ASSIGN(auto outcome, run(try_workbench));
  if (try_workbench && outcome.exit_status != 0 && !outcome.stopped && !outcome.timed_out) {
    LAYOUTBOX_ASSIGN(outcome, run(false));
  }
  LAYOUTBOX_CHECK(check_outcome(outcome, options));
  LAYOUTBOX_ASSIGN(RenderOutputs outputs, deliver_outputs(made.path(), folder, options, outcome.output));
  outputs.blender_version = listener.version.empty() ? blender.version : listener.version;
  if (options.progress) options.progress(1.0);
  return outputs;
}

}  // namespace layoutbox
