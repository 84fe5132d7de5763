// Runs the script in a process of its own with a home, a time limit and a folder of its own; only whole files reach the user's folder.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "layoutbox/base/files.h"
#include "layoutbox/base/process.h"
#include "layoutbox/render/png_check.h"
#include "layoutbox/render/render.h"

namespace layoutbox {
namespace {

constexpr std::string_view kProgress = "layoutbox: progress ";
constexpr std::string_view kVersion = "layoutbox: blender ";

std::vector<std::string> command_line(const Blender& blender, const std::filesystem::path& script, const std::filesystem::path& folder,
                                      const RenderOptions& options, bool workbench) {
  std::vector<std::string> command = blender.command;
  if (!blender.is_python_module) {
    // A script that raises leaves status 0 unless the exit code is given before it.
    command.insert(command.end(), {"-b", "-noaudio", "--factory-startup", "--python-exit-code", "3", "--python"});
  }
  command.push_back(script.string());
  if (!blender.is_python_module) command.emplace_back("--");
  command.push_back(folder.string());
  if (options.object_mask) command.emplace_back("--mask");
  if (!options.save_blend) command.emplace_back("--no-blend");
  if (workbench) command.emplace_back("--engine=workbench");
  return command;
}

// Blender writes caches and settings under HOME and TMPDIR: it gets its own.
std::map<std::string, std::string> environment(const std::filesystem::path& home) {
  const std::string folder = home.string();
  return {{"HOME", folder},          {"TMPDIR", folder},          {"XDG_CACHE_HOME", folder}, {"XDG_CONFIG_HOME", folder},
          {"XDG_DATA_HOME", folder}, {"XDG_RUNTIME_DIR", folder}, {"PYTHONUNBUFFERED", "1"},  {"PYTHONDONTWRITEBYTECODE", "1"},
          {"PYTHONNOUSERSITE", "1"}};
}

// The lines of a log that say what went wrong: from the last traceback or error on, else the last three.
std::string useful_lines(std::string_view log) {
  std::vector<std::string_view> lines;
  while (!log.empty()) {
    const std::string_view line = log.substr(0, log.find('\n'));
    log.remove_prefix(std::min(log.size(), line.size() + 1));
    if (line.find_first_not_of(" \t\r") != std::string_view::npos && !line.starts_with(kProgress)) lines.push_back(line);
  }
  const auto tells = [](std::string_view line) {
    return line.find("Error") != std::string_view::npos || line.find("error:") != std::string_view::npos;
  };
  auto last = std::find_if(lines.rbegin(), lines.rend(), tells);
  if (last != lines.rend()) return std::string(*last);
  std::string text;
  for (auto line = lines.size() > 3 ? lines.end() - 3 : lines.begin(); line != lines.end(); ++line) {
    text += (text.empty() ? "" : " | ") + std::string(*line);
  }
  return text.empty() ? "it said nothing" : text;
}

// Calls the user's progress and catches the version as the lines come.
class Listener {
 public:
  explicit Listener(const RenderOptions& options) : options_(options) {}
  void operator()(std::string_view line) {
    if (line.starts_with(kVersion)) version = line.substr(kVersion.size());
    if (!line.starts_with(kProgress) || !options_.progress) return;
    const std::string share(line.substr(kProgress.size()));
    options_.progress(std::clamp(std::strtod(share.c_str(), nullptr), 0.0, 1.0));
  }
  std::string version;

 private:
  const RenderOptions& options_;
};

Status check_outcome(const ProcessOutcome& outcome, const RenderOptions& options) {
  if (outcome.stopped) return fail(ErrorCode::kInterrupted, "the rendering was stopped");
  if (outcome.timed_out) {
    return fail(ErrorCode::kRenderFailed, fmt::format("Blender did not finish within {} s and was ended", options.time_limit_s), {},
                "a smaller --size or a lower --quality takes less time; --time-limit allows more");
  }
  if (outcome.exit_status > 128) {
    return fail(ErrorCode::kRenderFailed,
                fmt::format("Blender crashed (signal {}): {}", outcome.exit_status - 128, useful_lines(outcome.output)));
  }
  if (outcome.exit_status != 0) {
    return fail(ErrorCode::kRenderFailed,
                fmt::format("Blender failed with status {}: {}", outcome.exit_status, useful_lines(outcome.output)));
  }
  return {};
}

// One file from Blender's folder into the user's.
Status deliver(const std::filesystem::path& made, const std::filesystem::path& wanted, bool is_picture, std::string_view log) {
  const auto bytes = read_file(made);
  if (!bytes || bytes->empty()) {
    return fail(ErrorCode::kRenderFailed,
                fmt::format("Blender ended without writing {}: {}", wanted.filename().string(), useful_lines(log)));
  }
  if (is_picture) {
    if (const auto whole = check_png(*bytes); !whole) return Failure(whole.error());
  }
  return write_file(wanted, *bytes);
}

}  // namespace

Result<RenderOutputs> run_blender(const Blender& blender, const std::filesystem::path& script_file, const std::filesystem::path& folder,
                                  const RenderOptions& options) {
  if (blender.command.empty()) return fail(ErrorCode::kNoBlender, "no Blender was given to render with");
  std::error_code error;
  const auto script = std::filesystem::absolute(script_file, error);
  if (error || !std::filesystem::exists(script, error)) return fail(ErrorCode::kIo, fmt::format("{} is not there", script_file.string()));
  LAYOUTBOX_CHECK(make_folder(folder));
  LAYOUTBOX_ASSIGN(const auto home, TemporaryFolder::make("layoutbox-blender"));
  LAYOUTBOX_ASSIGN(const auto made, TemporaryFolder::make("layoutbox-picture"));

  Listener listener(options);
  ProcessOptions process;
  process.environment = environment(home.path());
  process.time_limit_s = options.time_limit_s;
  process.stop = options.stop;
  process.on_line = [&](std::string_view line) { listener(line); };
  // A draft in an old Blender, which has no denoiser, is drawn by Workbench. That needs GL, and aborts where there is none.
  const bool try_workbench = options.quality == Quality::kDraft && !blender.is_python_module && std::atoi(blender.version.c_str()) < 4;
  LAYOUTBOX_ASSIGN(auto outcome, run_process(command_line(blender, script, made.path(), options, try_workbench), process));
  if (try_workbench && outcome.exit_status != 0 && !outcome.stopped && !outcome.timed_out) {
    LAYOUTBOX_ASSIGN(outcome, run_process(command_line(blender, script, made.path(), options, false), process));
  }
  LAYOUTBOX_CHECK(check_outcome(outcome, options));

  RenderOutputs outputs;
  outputs.blender_version = listener.version.empty() ? blender.version : listener.version;
  const auto bring = [&](std::filesystem::path& output, const char* name, bool is_picture) -> Status {
    LAYOUTBOX_CHECK(deliver(made.path() / name, folder / name, is_picture, outcome.output));
    output = folder / name;
    return {};
  };
  LAYOUTBOX_CHECK(bring(outputs.picture, "scene.png", true));
  if (options.save_blend) LAYOUTBOX_CHECK(bring(outputs.blend, "scene.blend", false));
  if (options.object_mask) {
    LAYOUTBOX_CHECK(bring(outputs.mask, "mask.png", true));
    LAYOUTBOX_CHECK(bring(outputs.mask_index, "mask.json", false));
  }
  if (options.progress) options.progress(1.0);
  return outputs;
}

}  // namespace layoutbox
