#include "layoutbox/base/process.h"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>

#include "layoutbox/base/spawn.h"

namespace layoutbox {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kWatchSeconds = 0.04;

// Reads until the child is gone; ends it when the time is up or the stop flag is set.
class Supervisor {
 public:
  Supervisor(pid_t child, int output, const ProcessOptions& options) : child_(child), output_(output), options_(options) {}

  ProcessOutcome run() {
    OutputReader reader(outcome_.output, options_.on_line);
    bool open = true;
    int status = 0;
    for (bool gone = false; !gone || open;) {
      if (!gone && ::waitpid(child_, &status, WNOHANG) == child_) {
        gone = true;
        // Whatever it started may still hold the pipe: nothing is left behind, and nobody is waited for.
        ::kill(-child_, SIGKILL);
      }
      if (open)
        open = read_some(reader, gone ? 0 : 50);
      else if (!gone)
        ::poll(nullptr, 0, 5);
      if (gone && !more_) break;
      if (!gone) consider_stopping();
    }
    reader.finish();
    outcome_.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return std::move(outcome_);
  }

 private:
  // False once the pipe is closed.
  bool read_some(OutputReader& reader, int wait_ms) {
    pollfd poll_output{output_, POLLIN, 0};
    more_ = ::poll(&poll_output, 1, wait_ms) > 0;
    if (!more_) return true;
    char buffer[1 << 14];
    const ssize_t count = ::read(output_, buffer, sizeof buffer);
    if (count > 0) reader.add({buffer, static_cast<std::size_t>(count)});
    more_ = count > 0;
    return count > 0 || (count < 0 && errno == EINTR);
  }

  void consider_stopping() {
    if (!ending_) {
      outcome_.timed_out = seconds_since(begin_) > options_.time_limit_s;
      outcome_.stopped = !outcome_.timed_out && options_.stop != nullptr && options_.stop->load();
      if (!outcome_.timed_out && !outcome_.stopped && !watch_ends_it()) return;
      ending_ = true;
      ended_ = Clock::now();
      ::kill(-child_, SIGTERM);
    } else if (seconds_since(ended_) > kGraceSeconds) {
      ::kill(-child_, SIGKILL);
    }
  }

  // What is watched does harm while it runs: it is ended without grace.
  bool watch_ends_it() {
    if (!options_.watch || seconds_since(watched_) < kWatchSeconds) return false;
    outcome_.ended = options_.watch(child_);
    watched_ = Clock::now();
    if (outcome_.ended.empty()) return false;
    ::kill(-child_, SIGKILL);
    return true;
  }

  pid_t child_;
  int output_;
  const ProcessOptions& options_;
  ProcessOutcome outcome_;
  Clock::time_point begin_ = Clock::now(), ended_{}, watched_{};
  bool ending_ = false, more_ = true;
};

}  // namespace

Result<ProcessOutcome> run_process(const std::vector<std::string>& command, const ProcessOptions& options) {
  LAYOUTBOX_ASSIGN(const Child child, spawn(command, options, false));
  return Supervisor(child.pid, child.output.get(), options).run();
}

}  // namespace layoutbox
