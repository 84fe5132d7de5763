// Which Blender there is. Each candidate is asked for its version only: starting Blender for real costs seconds.
#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <regex>
#include <vector>

#include "layoutbox/base/process.h"
#include "layoutbox/render/render.h"

namespace layoutbox {
namespace {

constexpr std::string_view kHowToGet =
    "run scripts/setup.sh, which puts one into build/deps; or install Blender, or set LAYOUTBOX_BLENDER to a blender or to a python with "
    "the module bpy";

// What `command` prints, or empty where it does not start, fails or takes too long.
std::string answer_of(const std::vector<std::string>& command) {
  ProcessOptions options;
  options.time_limit_s = 30;
  const auto outcome = run_process(command, options);
  return outcome && outcome->exit_status == 0 && !outcome->timed_out ? outcome->output : std::string{};
}

std::string first_line(const std::string& text) { return text.substr(0, std::min<std::size_t>(text.find('\n'), 100)); }

// Is it a Python with bpy? Its true path is asked for too: launchers that look into HOME must not stand between.
std::optional<Blender> as_python(const std::string& program) {
  const std::string answer =
      answer_of({program, "-c", "import sys, importlib.metadata as m; print('bpy', m.version('bpy')); print('at', sys.executable)"});
  std::smatch match;
  if (!std::regex_search(answer, match, std::regex("bpy ([0-9][0-9.]*)[\\s\\S]*\nat ([^\n]+)"))) return std::nullopt;
  return Blender{{match[2]}, true, match[1]};
}

std::optional<Blender> as_blender(const std::string& program, const std::string& version_answer) {
  std::smatch match;
  if (!std::regex_search(version_answer, match, std::regex("Blender ([0-9]+\\.[0-9.]*[0-9])"))) return std::nullopt;
  return Blender{{program}, false, match[1]};
}

Result<Blender> named_by_user(const std::string& name) {
  const std::filesystem::path program = name.find('/') == std::string::npos ? find_program(name) : std::filesystem::path(name);
  const auto wrong = [&](std::string_view why) {
    return fail(ErrorCode::kNoBlender, fmt::format("LAYOUTBOX_BLENDER is \"{}\", {}", name, why), {},
                "set it to a blender or to a python with the module bpy, or unset it");
  };
  std::error_code ignored;
  if (program.empty() || !std::filesystem::exists(program, ignored)) return wrong("which is not there");
  if (std::filesystem::is_directory(program, ignored)) return wrong("which is a folder");
  const std::string answer = answer_of({program.string(), "--version"});
  if (const auto blender = as_blender(program.string(), answer)) return *blender;
  if (answer.starts_with("Python")) {
    if (const auto python = as_python(program.string())) return *python;
    return wrong("a Python without the module bpy");
  }
  return wrong(answer.empty() ? "which does not start" : fmt::format("which is no Blender: it answers \"{}\"", first_line(answer)));
}

// The environment that setup.sh makes, seen from the program in build/<preset>/src/layoutbox.
std::filesystem::path private_python() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return {};
  const auto python = (program.parent_path() / "../../../deps/bpy/bin/python").lexically_normal();
  return std::filesystem::exists(python, error) ? python : std::filesystem::path{};
}

// Builds from 4.0 on bring the denoiser and the newer colour management, as a rule.
bool is_recent(const Blender& blender) { return std::atoi(blender.version.c_str()) >= 4; }

}  // namespace

Result<Blender> find_blender() {
  if (const char* named = std::getenv("LAYOUTBOX_BLENDER"); named != nullptr && *named != '\0') return named_by_user(named);
  std::string tried;
  std::optional<Blender> old;
  if (const auto program = find_program("blender"); !program.empty()) {
    auto blender = as_blender(program.string(), answer_of({program.string(), "--version"}));
    if (blender && is_recent(*blender)) return *blender;
    tried += blender ? "" : fmt::format("; {} does not answer like a Blender", program.string());
    old = std::move(blender);
  } else {
    tried += "; no blender on the PATH";
  }
  for (const auto& python : {private_python(), find_program("python3")}) {
    if (python.empty()) continue;
    if (auto found = as_python(python.string())) return *found;
    tried += fmt::format("; {} has no bpy", python.string());
  }
  if (old) return *old;
  return fail(ErrorCode::kNoBlender, "no Blender was found: LAYOUTBOX_BLENDER is not set" + tried, {}, std::string(kHowToGet));
}

}  // namespace layoutbox
