#include "layoutbox/base/service.h"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <fstream>

#include "layoutbox/base/spawn.h"

namespace layoutbox {
namespace {

using Clock = std::chrono::steady_clock;
}  // namespace

struct ServiceProcess::State {
  explicit State(Child started) : child(std::move(started)), reader(log, on_line) {}

  // Whether it still runs; collects its status when it does not, and ends what it may have started.
  bool runs() {
    if (gone) return false;
    int raw = 0;
    if (::waitpid(child.pid, &raw, WNOHANG) != child.pid) return true;
    gone = true;
    ::kill(-child.pid, SIGKILL);
    status = WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
    return false;
  }

  // False when nothing more can come.
  bool read_some(int wait_ms) {
    pollfd ready{child.output.get(), POLLIN, 0};
    if (::poll(&ready, 1, wait_ms) <= 0) return true;
    char buffer[1 << 14];
    const ssize_t count = ::read(child.output.get(), buffer, sizeof buffer);
    if (count > 0) reader.add({buffer, static_cast<std::size_t>(count)});
    return count > 0 || (count < 0 && errno == EINTR);
  }

  Child child;
  std::string log;
  std::function<void(std::string_view)> on_line;
  OutputReader reader;
  bool gone = false;
  int status = 0;
};

ServiceProcess::ServiceProcess(std::unique_ptr<State> state) : state_(std::move(state)) {}
ServiceProcess::ServiceProcess(ServiceProcess&&) noexcept = default;
ServiceProcess& ServiceProcess::operator=(ServiceProcess&& other) noexcept {
  end();
  state_ = std::move(other.state_);
  return *this;
}
ServiceProcess::~ServiceProcess() { end(); }

Result<ServiceProcess> ServiceProcess::start(const std::vector<std::string>& command, const ProcessOptions& options) {
  LAYOUTBOX_ASSIGN(Child child, spawn(command, options, true));
  return ServiceProcess(std::make_unique<State>(std::move(child)));
}

bool ServiceProcess::send(std::string_view line) {
  std::string bytes(line);
  bytes += '\n';
  std::string_view rest = bytes;
  while (!rest.empty() && state_->runs()) {
    const ssize_t count = ::send(state_->child.input.get(), rest.data(), rest.size(), MSG_NOSIGNAL);
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
  }
  return rest.empty();
}

WaitEnd ServiceProcess::wait(const std::function<bool(std::string_view)>& is_last, const WaitLimits& limits) {
  const auto begin = Clock::now();
  bool answered = false;
  state_->on_line = [&](std::string_view line) { answered = answered || is_last(line); };
  const auto end_of_wait = [&](WaitEnd end) {
    state_->on_line = nullptr;
    return end;
  };
  while (true) {
    const bool runs = state_->runs();  // asked before reading: what it said last is still there to be read
    bool more = true;
    do more = state_->read_some(runs ? 50 : 0);
    while (!runs && more && !answered && [&] {
      pollfd ready{state_->child.output.get(), POLLIN, 0};
      return ::poll(&ready, 1, 0) > 0;
    }());
    if (answered) return end_of_wait(WaitEnd::kAnswered);
    if (!runs) return end_of_wait(WaitEnd::kGone);
    if (!more) ::poll(nullptr, 0, 5);  // it closed its stdout and will be gone soon
    if (limits.stop != nullptr && limits.stop->load()) return end_of_wait(WaitEnd::kStopped);
    if (seconds_since(begin) > limits.time_limit_s) return end_of_wait(WaitEnd::kTimedOut);
    if (limits.memory_limit_mb > 0 && memory_mb() > limits.memory_limit_mb) return end_of_wait(WaitEnd::kTooLarge);
  }
}

double ServiceProcess::memory_mb() const {
  std::ifstream file(fmt::format("/proc/{}/statm", state_->child.pid));
  double all = 0, resident = 0;
  if (!(file >> all >> resident)) return 0;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1 << 20);
}

int ServiceProcess::exit_status() const { return state_->status; }

std::string ServiceProcess::take_log() { return std::exchange(state_->log, {}); }

void ServiceProcess::end(double patience_s) {
  if (!state_ || state_->gone) return;
  state_->child.input.close();
  const auto begin = Clock::now();
  bool asked = false;
  while (state_->runs()) {
    const double waited = seconds_since(begin);
    if (waited >= patience_s && !asked) {
      ::kill(-state_->child.pid, SIGTERM);
      asked = true;
    }
    if (waited > patience_s + kGraceSeconds) ::kill(-state_->child.pid, SIGKILL);
    if (!state_->read_some(20)) ::poll(nullptr, 0, 5);
  }
}

}  // namespace layoutbox
