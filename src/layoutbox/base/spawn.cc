#include "layoutbox/base/spawn.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

extern char** environ;

namespace layoutbox {
namespace {

namespace fs = std::filesystem;

#ifdef __GLIBC__
using Resource = __rlimit_resource_t;
#else
using Resource = int;
#endif

constexpr std::size_t kKeptOutput = 64 << 10;
constexpr int kDescriptors = 4096;
constexpr std::size_t kLongestLine = 16 << 10;  // a longer one is passed on in pieces

// Everything the child needs between fork and exec, made before: nothing may be allocated there.
struct Launch {
  std::string program, folder;
  std::vector<std::string> words, environment;
  std::vector<char*> argv, envp;
  std::vector<ResourceLimit> limits;
  std::vector<int> inherited;
  bool alone = false;
  const std::function<void()>* before_exec = nullptr;  // null: nothing
  pid_t parent = ::getpid();
#ifdef __linux__
  bool from_main_thread = ::gettid() == ::getpid();
#endif
};

Launch prepare(const std::vector<std::string>& command, const ProcessOptions& options, const fs::path& program) {
  Launch launch;
  launch.program = program.string();
  launch.folder = options.working_folder.string();
  launch.words = command;
  launch.limits = options.limits;
  launch.inherited = options.inherited;
  launch.alone = options.own_environment;
  if (options.before_exec) launch.before_exec = &options.before_exec;
  for (char** entry = environ; *entry != nullptr && !options.own_environment; ++entry) {
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
[[noreturn]] void become(const Launch& launch, int input, int output, int failure) {
  ::setpgid(0, 0);
#ifdef __linux__
  // Who is killed takes it along. Only of the main thread, since it is the end of the thread that counts.
  if (launch.from_main_thread) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != launch.parent) ::_exit(127);
  }
#endif
  ::dup2(input >= 0 ? input : ::open("/dev/null", O_RDONLY), STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  for (const ResourceLimit& limit : launch.limits) {
    const rlimit both{limit.most, limit.most};
    ::setrlimit(static_cast<Resource>(limit.resource), &both);
  }
  // Who started this program may have left descriptors open that are nobody's business.
  for (int other = 3; launch.alone && other < kDescriptors; ++other) ::fcntl(other, F_SETFD, FD_CLOEXEC);
  for (const int kept : launch.inherited) ::fcntl(kept, F_SETFD, 0);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int number : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM, SIGHUP, SIGQUIT}) ::signal(number, SIG_DFL);
  if (launch.folder.empty() || ::chdir(launch.folder.c_str()) == 0) {
    if (launch.before_exec != nullptr) (*launch.before_exec)();
    ::execve(launch.program.c_str(), launch.argv.data(), launch.envp.data());
  }
  const int error = errno;
  [[maybe_unused]] const ssize_t written = ::write(failure, &error, sizeof error);
  ::_exit(127);
}

}  // namespace

void OutputReader::add(std::string_view bytes) {
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

void OutputReader::finish() {
  if (!line_.empty()) finish_line();
  if (kept_.size() > kKeptOutput) kept_.erase(0, kept_.size() - kKeptOutput);
}

void OutputReader::finish_line() {
  pass_on(line_);
  line_.clear();
}

void OutputReader::pass_on(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (on_line_) on_line_(line);
}

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

Result<Child> spawn(const std::vector<std::string>& command, const ProcessOptions& options, bool with_input) {
  if (command.empty()) return fail(ErrorCode::kIo, "there is no command to run");
  const auto not_started = [&](int error) {
    return fail(ErrorCode::kIo, fmt::format("cannot start {}: {}", command[0], std::generic_category().message(error)), command[0]);
  };
  fs::path program = find_program(command[0]);
  if (program.empty()) return not_started(ENOENT);
  if (program.is_relative()) program = fs::absolute(program);

  Launch launch = prepare(command, options, program);
  int output[2], failure[2], input[2] = {-1, -1};
  if (::pipe2(output, O_CLOEXEC) != 0) return not_started(errno);
  Descriptor output_read(output[0]), output_write(output[1]);
  if (::pipe2(failure, O_CLOEXEC) != 0) return not_started(errno);
  Descriptor failure_read(failure[0]), failure_write(failure[1]);
  // A socket, not a pipe: writing to a child that is gone is an error then, and no signal.
  if (with_input && ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, input) != 0) return not_started(errno);
  Descriptor input_write(input[0]), input_read(input[1]);

  const pid_t pid = ::fork();
  if (pid < 0) return not_started(errno);
  if (pid == 0) become(launch, input_read.get(), output_write.get(), failure_write.get());
  ::setpgid(pid, pid);  // in both, so that neither has to wait for the other
  output_write.close();
  failure_write.close();

  int error = 0;
  ssize_t count = 0;
  while ((count = ::read(failure_read.get(), &error, sizeof error)) < 0 && errno == EINTR) {
  }
  if (count > 0) {
    ::waitpid(pid, nullptr, 0);
    return not_started(error);
  }
  return Child{pid, std::move(output_read), std::move(input_write)};
}

}  // namespace layoutbox
