#include "layoutbox/render/blender_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "layoutbox/base/files.h"
#include "layoutbox/base/png_check.h"

namespace layoutbox {
namespace {

constexpr std::string_view kProgress = "layoutbox: progress ";
constexpr std::string_view kVersion = "layoutbox: blender ";

// One file from Blender's folder into the user's.
Status deliver(const std::filesystem::path& made, const std::filesystem::path& wanted, bool is_picture, std::string_view log) {
  const auto bytes = read_file(made);
  if (!bytes || bytes->empty()) {
    return fail(ErrorCode::kRenderFailed,
                fmt::format("Blender ended without writing {}: {}", wanted.filename().string(), useful_lines(log)));
  }
  if (is_picture) {
    if (const auto whole = check_png(*bytes); !whole) return fail(ErrorCode::kRenderFailed, whole.error().message);
  }
  return write_file(wanted, *bytes);
}

}  // namespace

std::vector<std::string> script_words(const std::filesystem::path& folder, const RenderOptions& options, bool workbench) {
  std::vector<std::string> words{folder.string()};
  if (options.object_mask) words.emplace_back("--mask");
  if (options.overlay) words.emplace_back("--overlay");
  if (!options.save_blend) words.emplace_back("--no-blend");
  if (options.thumbnail) words.emplace_back("--thumbnail");
  if (!options.turntable.empty()) words.push_back("--turntable=" + options.turntable);
  if (workbench) words.emplace_back("--engine=workbench");
  return words;
}

std::vector<std::string> start_words(const Blender& blender, const std::filesystem::path& script) {
  std::vector<std::string> command = blender.command;
  if (!blender.is_python_module) {
    // A script that raises leaves status 0 unless the exit code is given before it.
    command.insert(command.end(), {"-b", "-noaudio", "--factory-startup", "--python-exit-code", "3", "--python"});
  }
  command.push_back(script.string());
  if (!blender.is_python_module) command.emplace_back("--");
  return command;
}

bool tries_workbench(const Blender& blender, const RenderOptions& options) {
  return options.quality == Quality::kDraft && !blender.is_python_module && std::atoi(blender.version.c_str()) < 4;
}

std::map<std::string, std::string> blender_environment(const std::filesystem::path& home) {
  const std::string folder = home.string();
  return {{"HOME", folder},          {"TMPDIR", folder},          {"XDG_CACHE_HOME", folder}, {"XDG_CONFIG_HOME", folder},
          {"XDG_DATA_HOME", folder}, {"XDG_RUNTIME_DIR", folder}, {"PYTHONUNBUFFERED", "1"},  {"PYTHONDONTWRITEBYTECODE", "1"},
          {"PYTHONNOUSERSITE", "1"}};
}

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
  const auto last = std::find_if(lines.rbegin(), lines.rend(), tells);
  if (last != lines.rend()) return std::string(*last);
  std::string text;
  for (auto line = lines.size() > 3 ? lines.end() - 3 : lines.begin(); line != lines.end(); ++line) {
    text += (text.empty() ? "" : " | ") + std::string(*line);
  }
  return text.empty() ? "it said nothing" : text;
}

void Listener::operator()(std::string_view line) {
  if (line.starts_with(kVersion)) version = line.substr(kVersion.size());
  if (!line.starts_with(kProgress) || !options_.progress) return;
  const std::string share(line.substr(kProgress.size()));
  options_.progress(std::clamp(std::strtod(share.c_str(), nullptr), 0.0, 1.0));
}

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

std::vector<std::filesystem::path> RenderOutputs::files() const {
  std::vector<std::filesystem::path> all;
  for (const auto* file : {&blend, &mask, &mask_index, &turntable, &thumbnail}) {
    if (!file->empty()) all.push_back(*file);
  }
  all.insert(all.end(), pictures.begin(), pictures.end());
  return all;
}

Result<RenderOutputs> deliver_outputs(const std::filesystem::path& made, const std::filesystem::path& folder, const RenderOptions& options,
                                      std::string_view log) {
  RenderOutputs outputs;
  const auto bring = [&](const std::string& name, bool is_picture) -> Result<std::filesystem::path> {
    LAYOUTBOX_CHECK(deliver(made / name, folder / name, is_picture, log));
    return folder / name;
  };
  for (const View view : options.views) {
    LAYOUTBOX_ASSIGN(outputs.pictures.emplace_back(), bring(picture_name(view), true));
  }
  if (!outputs.pictures.empty()) outputs.picture = outputs.pictures.front();
  if (options.overlay) {
    LAYOUTBOX_ASSIGN(outputs.pictures.emplace_back(), bring("scene-overlay.png", true));
  }
  if (options.thumbnail) {
    LAYOUTBOX_ASSIGN(outputs.thumbnail, bring("scene-small.jpg", false));
  }
  if (!options.turntable.empty()) {
    LAYOUTBOX_ASSIGN(outputs.turntable, bring("scene-turntable." + options.turntable, false));
  }
  if (options.save_blend) {
    LAYOUTBOX_ASSIGN(outputs.blend, bring("scene.blend", false));
  }
  if (options.object_mask) {
    LAYOUTBOX_ASSIGN(outputs.mask, bring("mask.png", true));
    LAYOUTBOX_ASSIGN(outputs.mask_index, bring("mask.json", false));
  }
  return outputs;
}

}  // namespace layoutbox
