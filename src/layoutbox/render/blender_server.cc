// One Blender for many rooms. It gets a line of JSON for each job, {"script": …, "words": […]}, and answers `layoutbox: done` or
// `layoutbox: failed …` (blender/serve.py).
#include <fmt/format.h>

#include <algorithm>

#include <nlohmann/json.hpp>
#include <optional>

#include "layoutbox/base/files.h"
#include "layoutbox/base/service.h"
#include "layoutbox/embedded/blender_scripts.h"
#include "layoutbox/render/blender_run.h"
#include "layoutbox/render/render.h"

namespace layoutbox {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDone = "layoutbox: done";
constexpr std::string_view kFailed = "layoutbox: failed ";

// A process and the home it lives in.
struct Running {
  TemporaryFolder home;
  ServiceProcess process;
  int jobs = 0;
};

Result<Running> start(const Blender& blender) {
  LAYOUTBOX_ASSIGN(auto home, TemporaryFolder::make("blender"));
  const fs::path script = home.path() / "serve.py";
  LAYOUTBOX_CHECK(write_file(script, embedded::serve_py));
  ProcessOptions options;
  options.environment = blender_environment(home.path());
  LAYOUTBOX_ASSIGN(auto process, ServiceProcess::start(start_words(blender, script), options));
  return Running{std::move(home), std::move(process), 0};
}

std::string order(const fs::path& script, const std::vector<std::string>& words) {
  const nlohmann::json line{{"script", script.string()}, {"words", words}};
  return line.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

}  // namespace

struct BlenderServer::State {
  // Draws into `made`; says in `died` whether the process went down with it.
  Status draw(const fs::path& script, const fs::path& made, const RenderOptions& render_options, Listener& listener, bool& died) {
    if (!running) {
      LAYOUTBOX_ASSIGN(running, start(blender));
      ++starts;
    }
    log.clear();
    std::string failed;
    const bool workbench = !no_workbench && tries_workbench(blender, render_options);
    WaitEnd end = WaitEnd::kGone;
    if (running->process.send(order(script, script_words(made, render_options, workbench)))) {
      end = running->process.wait(
          [&](std::string_view line) {
            listener(line);
            if (line.starts_with(kFailed)) failed = line.substr(kFailed.size());
            return line == kDone || line.starts_with(kFailed);
          },
          {render_options.time_limit_s, options.memory_limit_mb, render_options.stop});
    }
    log = running->process.take_log();
    ++running->jobs;
    if (end == WaitEnd::kAnswered) {
      const bool worn = running->process.memory_mb() > options.restart_above_mb || running->jobs >= options.restart_after_jobs;
      if (worn || !failed.empty()) close();
      if (failed.empty()) return {};
      return fail(ErrorCode::kRenderFailed, fmt::format("Blender failed: {}", failed));
    }
    const int status = running->process.exit_status();
    close();
    died = end == WaitEnd::kGone;
    if (died && workbench) no_workbench = true;
    if (end == WaitEnd::kTooLarge) {
      return fail(ErrorCode::kRenderFailed, fmt::format("Blender needed more than {:.0f} MB and was ended", options.memory_limit_mb), {},
                  "a smaller --size needs less");
    }
    ProcessOutcome outcome;
    outcome.exit_status = died ? std::max(1, status) : 0;
    outcome.timed_out = end == WaitEnd::kTimedOut;
    outcome.stopped = end == WaitEnd::kStopped;
    outcome.output = log;
    return check_outcome(outcome, render_options);
  }

  void close() {
    if (running) running->process.end();
    running.reset();
  }

  Blender blender;
  ServerOptions options;
  std::optional<Running> running;
  std::string log;
  int starts = 0;
  bool no_workbench = false;  // it was tried and brought the process down
};

BlenderServer::BlenderServer(Blender blender, const ServerOptions& options)
    : state_(std::make_unique<State>(State{std::move(blender), options, {}, {}, 0, false})) {}
BlenderServer::BlenderServer(BlenderServer&&) noexcept = default;
BlenderServer& BlenderServer::operator=(BlenderServer&&) noexcept = default;
BlenderServer::~BlenderServer() = default;

int BlenderServer::starts() const { return state_->starts; }
void BlenderServer::close() { state_->close(); }

Result<RenderOutputs> BlenderServer::render(const fs::path& script_file, const fs::path& folder, const RenderOptions& options) {
  if (state_->blender.command.empty()) return fail(ErrorCode::kNoBlender, "no Blender was given to render with");
  std::error_code error;
  const auto script = fs::absolute(script_file, error);
  if (error || !fs::exists(script, error)) return fail(ErrorCode::kIo, fmt::format("{} is not there", script_file.string()));
  LAYOUTBOX_CHECK(make_folder(folder));
  Listener listener(options);
  for (bool again = false;; again = true) {
    LAYOUTBOX_ASSIGN(const auto made, TemporaryFolder::make("picture"));
    bool died = false;
    const Status drawn = state_->draw(script, made.path(), options, listener, died);
    if (!drawn && died && !again) continue;
    if (!drawn) return Failure(drawn.error());
    LAYOUTBOX_ASSIGN(RenderOutputs outputs, deliver_outputs(made.path(), folder, options, state_->log));
    outputs.blender_version = listener.version.empty() ? state_->blender.version : listener.version;
    if (options.progress) options.progress(1.0);
    return outputs;
  }
}

}  // namespace layoutbox
