#include "layoutbox/base/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <system_error>

extern char** environ;

namespace layoutbox {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kKeptOutput = 64 << 10;
constexpr std::size_t kLongestLine = 16 << 10;  // a longer one is passed on in pieces
constexpr double kGraceSeconds = 2;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

struct Pipe {
  int ends[2] = {-1, -1};
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  bool open() { return ::pipe2(ends, O_CLOEXEC) == 0; }
  void close_end(int which) {
    if (ends[which] >= 0) ::close(std::exchange(ends[which], -1));
  }
};

// Everything the child needs between fork and exec, made before: nothing may be allocated there.
struct Launch {
  std::string program, folder;
  std::vector<std::string> words, environment;
  std::vector<char*> argv, envp;
};

Launch prepare(const std::vector<std::string>& command, const ProcessOptions& options, const fs::path& program) {
  Launch launch;
  launch.program = program.string();
  launch.folder = options.working_folder.string();
  launch.words = command;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text(*entry);
    if (!options.environment.contains(std::string(text.substr(0, text.find('='))))) launch.environment.emplace_back(text);
  }
  for (const auto& [name, value] : options.environment) launch.environment.push_back(name + "=" + value);
  for (std::string& word : launch.words) launch.argv.push_back(word.data());
  for (std::string& entry : launch.environment) launch.envp.push_back(entry.data());
  launch.argv.push_back(nullptr);
  launch.envp.push_back(nullptr);
  return launch;
}

// Runs in the child; reports errno through `failure` when exec does not happen.
[[noreturn]] void become(const Launch& launch, int output, int failure) {
  ::setpgid(0, 0);
  const int null = ::open("/dev/null", O_RDONLY);
  ::dup2(null, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::signal(SIGPIPE, SIG_DFL);
  ::signal(SIGINT, SIG_DFL);
  ::signal(SIGTERM, SIG_DFL);
  if (launch.folder.empty() || ::chdir(launch.folder.c_str()) == 0)
    ::execve(launch.program.c_str(), launch.argv.data(), launch.envp.data());
  const int error = errno;
  [[maybe_unused]] const ssize_t written = ::write(failure, &error, sizeof error);
  ::_exit(127);
}

// Collects what the child prints: the tail for the outcome, whole lines for the callback.
class OutputReader {
 public:
  OutputReader(std::string& kept, const std::function<void(std::string_view)>& on_line) : kept_(kept), on_line_(on_line) {}

  void add(std::string_view bytes) {
    kept_.append(bytes);
    if (kept_.size() > 2 * kKeptOutput) kept_.erase(0, kept_.size() - kKeptOutput);
    if (!on_line_) return;
    line_.append(bytes);
    std::size_t begin = 0;
    for (std::size_t end; (end = line_.find('\n', begin)) != std::string::npos; begin = end + 1) {
      pass_on(std::string_view(line_).substr(begin, end - begin));
    }
    line_.erase(0, begin);
    if (line_.size() > kLongestLine) finish_line();
  }

  void finish() {
    if (!line_.empty()) finish_line();
    if (kept_.size() > kKeptOutput) kept_.erase(0, kept_.size() - kKeptOutput);
  }

 private:
  void finish_line() {
    pass_on(line_);
    line_.clear();
  }
  void pass_on(std::string_view line) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    on_line_(line);
  }

  std::string& kept_;
  const std::function<void(std::string_view)>& on_line_;
  std::string line_;
};

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
      if (!outcome_.timed_out && !outcome_.stopped) return;
      ending_ = true;
      ended_ = Clock::now();
      ::kill(-child_, SIGTERM);
    } else if (seconds_since(ended_) > kGraceSeconds) {
      ::kill(-child_, SIGKILL);
    }
  }

  pid_t child_;
  int output_;
  const ProcessOptions& options_;
  ProcessOutcome outcome_;
  Clock::time_point begin_ = Clock::now(), ended_{};
  bool ending_ = false, more_ = true;
};

}  // namespace

fs::path find_program(std::string_view name) {
  const auto runs = [](const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0;
  };
  if (name.empty()) return {};
  if (name.find('/') != std::string_view::npos) return runs(name) ? fs::path(name) : fs::path{};
  const char* variable = std::getenv("PATH");
  std::string_view rest = variable != nullptr ? variable : "/usr/local/bin:/usr/bin:/bin";
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    const fs::path folder = rest.substr(0, colon);
    if (const fs::path candidate = (folder.empty() ? fs::path(".") : folder) / name; runs(candidate)) return candidate;
    rest = colon == std::string_view::npos ? std::string_view{} : rest.substr(colon + 1);
  }
  return {};
}

Result<ProcessOutcome> run_process(const std::vector<std::string>& command, const ProcessOptions& options) {
  if (command.empty()) return fail(ErrorCode::kIo, "there is no command to run");
  const auto not_started = [&](int error) {
    return fail(ErrorCode::kIo, fmt::format("cannot start {}: {}", command[0], std::generic_category().message(error)), command[0]);
  };
  fs::path program = find_program(command[0]);
  if (program.empty()) return not_started(ENOENT);
  if (program.is_relative()) program = fs::absolute(program);

  Launch launch = prepare(command, options, program);
  Pipe output, failure;
  if (!output.open() || !failure.open()) return not_started(errno);
  const pid_t child = ::fork();
  if (child < 0) return not_started(errno);
  if (child == 0) become(launch, output.ends[1], failure.ends[1]);
  ::setpgid(child, child);  // in both, so that neither has to wait for the other
  output.close_end(1);
  failure.close_end(1);

  int error = 0;
  ssize_t count = 0;
  while ((count = ::read(failure.ends[0], &error, sizeof error)) < 0 && errno == EINTR) {
  }
  if (count > 0) {
    ::waitpid(child, nullptr, 0);
    return not_started(error);
  }
  return Supervisor(child, output.ends[0], options).run();
}

}  // namespace layoutbox
