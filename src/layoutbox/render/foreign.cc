#include "layoutbox/render/foreign.h"

#include <fmt/format.h>

#include "layoutbox/base/files.h"
#include "layoutbox/base/png_check.h"
#include "layoutbox/embedded/blender_scripts.h"
#include "layoutbox/render/blender_run.h"

namespace layoutbox {
namespace {

namespace fs = std::filesystem;

constexpr int kNoPython = 4, kRaised = 5;  // exit statuses of foreign.py
constexpr std::string_view kFault = "layoutbox: fault ";
constexpr std::size_t kLargestBlend = 256u << 20;
constexpr std::size_t kLargestPicture = 128u << 20;
constexpr std::size_t kLargestRoom = 32u << 20;

// Where a Blender's files are, and nothing beside them: a Python's programs and libraries, or the folder of a blender.
std::vector<fs::path> folders_of(const Blender& blender) {
  std::error_code error;
  const fs::path program =
      blender.command[0].find('/') == std::string::npos ? find_program(blender.command[0]) : fs::path(blender.command[0]);
  const fs::path real = fs::canonical(program, error);
  if (!blender.is_python_module) return {real.parent_path()};
  std::vector<fs::path> folders;
  for (const fs::path& python : {program, real}) {
    const fs::path prefix = python.parent_path().parent_path();
    for (const char* part : {"bin", "lib", "lib64", "pyvenv.cfg"}) folders.push_back(prefix / part);
  }
  return folders;
}

std::string fault_in(const ProcessOutcome& process) {
  const std::size_t at = process.output.rfind(kFault);
  if (at == std::string::npos) return {};
  const std::size_t begin = at + kFault.size();
  return process.output.substr(begin, process.output.find('\n', begin) - begin);
}

// Runs foreign.py in `folder`, which holds what it reads.
Result<sandbox::Outcome> run_foreign(const Blender& blender, const fs::path& folder, const char* word, const ForeignOptions& options) {
  if (blender.command.empty()) return fail(ErrorCode::kNoBlender, "no Blender was given");
  LAYOUTBOX_CHECK(write_file(folder / "foreign.py", embedded::foreign_py));
  sandbox::Job job;
  job.command = start_words(blender, fs::path(sandbox::kFolder) / "foreign.py");
  if (!blender.is_python_module) {
    const fs::path program = find_program(job.command[0]);
    job.command[0] = fs::canonical(program).string();
    job.command.insert(job.command.begin() + 1, "--disable-autoexec");
  }
  job.command.emplace_back(word);
  job.folder = folder;
  job.readable = folders_of(blender);
  job.environment = {{"PYTHONUNBUFFERED", "1"}, {"PYTHONDONTWRITEBYTECODE", "1"}, {"PYTHONNOUSERSITE", "1"}};
  job.limits = options.limits;
  job.without_walls = options.without_walls;
  job.stop = options.stop;
  return sandbox::run(job);
}

std::string words_for(const sandbox::Outcome& outcome) {
  const std::string fault = fault_in(outcome.process);
  if (!fault.empty()) return fault;
  if (outcome.process.exit_status > 128) return fmt::format("it took Blender down (signal {})", outcome.process.exit_status - 128);
  return fmt::format("it ended Blender with status {}: {}", outcome.process.exit_status, useful_lines(outcome.process.output));
}

}  // namespace

std::string_view name_of(ScriptEnd end) {
  switch (end) {
    case ScriptEnd::kSyntax: return "syntax";
    case ScriptEnd::kRunTime: return "run-time";
    case ScriptEnd::kLimit: return "limit";
    default: return "done";
  }
}

Result<ForeignRun> run_foreign_script(const Blender& blender, const std::string& script, const ForeignOptions& options) {
  LAYOUTBOX_ASSIGN(const auto folder, TemporaryFolder::make("script"));
  LAYOUTBOX_CHECK(write_file(folder.path() / "script.py", script));
  if (const auto& wanted = options.picture) {
    LAYOUTBOX_CHECK(write_file(folder.path() / "picture.json", fmt::format(R"({{"width": {}, "height": {}, "samples": {}}})", wanted->width,
                                                                           wanted->height, wanted->samples)));
  }
  LAYOUTBOX_ASSIGN(const sandbox::Outcome outcome, run_foreign(blender, folder.path(), options.picture ? "draw" : "script", options));
  if (!outcome.ended.empty()) return ForeignRun{ScriptEnd::kLimit, outcome.ended, {}, {}};
  const int status = outcome.process.exit_status;
  if (status == kNoPython) return ForeignRun{ScriptEnd::kSyntax, words_for(outcome), {}, {}};
  if (status != 0) return ForeignRun{ScriptEnd::kRunTime, words_for(outcome), {}, {}};
  auto blend = sandbox::take_file(folder.path(), "room.blend", kLargestBlend);
  if (!blend) return ForeignRun{ScriptEnd::kRunTime, "it ended before its scene was saved: " + blend.error().message, {}, {}};
  ForeignRun done{ScriptEnd::kDone, {}, *std::move(blend), {}};
  if (!options.picture) return done;
  auto picture = sandbox::take_file(folder.path(), "scene.png", kLargestPicture);
  if (!picture || !check_png(*picture)) return ForeignRun{ScriptEnd::kRunTime, "it left no whole picture", {}, {}};
  done.picture = *std::move(picture);
  return done;
}

Result<std::string> gltf_of_blend(const Blender& blender, std::string_view blend, const ForeignOptions& options) {
  if (blend.size() > kLargestBlend) return fail(ErrorCode::kTooLarge, fmt::format("a .blend of more than {} MB", kLargestBlend >> 20));
  LAYOUTBOX_ASSIGN(const auto folder, TemporaryFolder::make("blend"));
  LAYOUTBOX_CHECK(write_file(folder.path() / "room.blend", blend));
  LAYOUTBOX_ASSIGN(const sandbox::Outcome outcome, run_foreign(blender, folder.path(), "read", options));
  if (!outcome.ended.empty()) return fail(ErrorCode::kParse, "the .blend could not be read: " + outcome.ended);
  if (outcome.process.exit_status != 0) return fail(ErrorCode::kParse, "the .blend could not be read: " + words_for(outcome));
  return sandbox::take_file(folder.path(), "room.gltf", kLargestRoom);
}

bool is_blend(std::string_view bytes) {
  return bytes.starts_with("BLENDER") || bytes.starts_with("\x28\xb5\x2f\xfd") || bytes.starts_with("\x1f\x8b");
}

}  // namespace layoutbox
