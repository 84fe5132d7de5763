#include "layoutbox/sandbox/sandbox.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <optional>

#include "layoutbox/base/descriptor.h"
#include "layoutbox/sandbox/namespaces.h"
#include "layoutbox/sandbox/seccomp_filter.h"
#include "layoutbox/sandbox/watch.h"

namespace layoutbox::sandbox {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHome = "/home/nobody";
constexpr double kScratchMb = 256;  // of /tmp; memory, as /dev/shm and the home
constexpr const char* kHint =
    "install bubblewrap 0.7 or newer (scripts/setup.sh does) on a system that lets users make namespaces; or, for code that you trust, say "
    "--unsafe-scripts";

struct Walls {
  std::string program, version;  // of bubblewrap; without a program they are the kernel's own (namespaces.h)
  bool forbids_users = false;    // knows --disable-userns
  bool own() const { return program.empty(); }
};

// What is there of the system, besides /usr.
constexpr const char* kSystemFolders[] = {"/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32"};
constexpr const char* kSystemFiles[] = {"/etc/ld.so.cache", "/etc/alternatives", "/etc/fonts"};
constexpr std::string_view kScratch[] = {"/dev/shm", "/tmp", kHome};

std::string mb(double value) { return fmt::format("{:.0f}", value * kMb); }

void add(std::vector<std::string>& words, std::initializer_list<std::string> more) { words.insert(words.end(), more); }

// Everything of its own but the files: those come after.
std::vector<std::string> isolation(const Walls& walls) {
  std::vector<std::string> words{walls.program,
                                 "--unshare-user",
                                 "--unshare-ipc",
                                 "--unshare-pid",
                                 "--unshare-net",
                                 "--unshare-uts",
                                 "--unshare-cgroup-try",
                                 "--die-with-parent",
                                 "--new-session",
                                 "--cap-drop",
                                 "ALL"};
  if (walls.forbids_users) words.emplace_back("--disable-userns");
  add(words, {"--uid", "65534", "--gid", "65534", "--hostname", "sandbox", "--clearenv"});
  return words;
}

// The system's programs and libraries, without its users, their files, or what runs.
void add_system(std::vector<std::string>& words) {
  add(words, {"--ro-bind", "/usr", "/usr"});
  for (const char* name : kSystemFolders) {
    std::error_code error;
    if (fs::is_symlink(name, error)) {
      add(words, {"--symlink", fs::read_symlink(name, error).string(), name});
    } else {
      add(words, {"--ro-bind-try", name, name});
    }
  }
  for (const char* name : kSystemFiles) add(words, {"--ro-bind-try", name, name});
  add(words, {"--proc", "/proc", "--dev", "/dev"});
  for (const std::string_view name : kScratch) {
    add(words, {"--size", mb(kScratchMb), "--tmpfs", std::string(name)});
  }
}

// Of all that has been mounted only the job's folder and the scratch ones stay writable. /proc too: root without any rights is still the
// owner of the kernel's settings in /proc/sys.
void add_seal(std::vector<std::string>& words) {
  for (const char* name : {"/dev", "/proc", "/"}) add(words, {"--remount-ro", name});
}

// The same by the kernel alone.
NamespaceWalls own_walls() {
  NamespaceWalls walls;
  walls.show("/usr");
  for (const char* name : kSystemFolders) {
    std::error_code error;
    if (fs::is_symlink(name, error)) {
      walls.link(fs::read_symlink(name, error).string(), name);
    } else {
      walls.show(name);
    }
  }
  for (const char* name : kSystemFiles) walls.show(name);
  walls.give_memory("/dev", 1);
  for (const char* name : {"/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom"}) walls.show_device(name);
  walls.link("/proc/self/fd", "/dev/fd");
  for (const int number : {0, 1, 2}) {
    walls.link(fmt::format("/proc/self/fd/{}", number),
               fmt::format("/dev/{}", std::array{"stdin", "stdout", "stderr"}[static_cast<std::size_t>(number)]));
  }
  for (const std::string_view name : kScratch) walls.give_memory(std::string(name), kScratchMb);
  walls.filter(seccomp_filter());
  return walls;
}

std::optional<Walls> try_own_walls(std::string& why) {
  const NamespaceWalls walls = own_walls();
  ProcessOptions options;
  options.time_limit_s = 20;
  options.own_environment = true;
  options.before_exec = [&walls] { walls.enter(); };
  const auto outcome = run_process({"/usr/bin/true"}, options);
  if (outcome && outcome->exit_status == 0) return Walls{{}, "namespaces of the kernel", false};
  why = outcome ? outcome->output : outcome.error().message;
  return std::nullopt;
}

std::optional<Walls> try_walls(const Walls& walls, std::string& why) {
  std::vector<std::string> words = isolation(walls);
  add_system(words);
  add_seal(words);
  add(words, {"--", "/usr/bin/true"});
  ProcessOptions options;
  options.time_limit_s = 20;
  const auto outcome = run_process(words, options);
  if (outcome && outcome->exit_status == 0) return walls;
  why = outcome ? outcome->output : outcome.error().message;
  while (!why.empty() && why.back() == '\n') why.pop_back();
  return std::nullopt;
}

Result<Walls> find_walls() {
  const auto none = [](const std::string& why) {
    return fail(ErrorCode::kIo, "there is no sandbox for code of others: " + why, {}, kHint);
  };
  if (seccomp_filter().empty()) return none("its filter of system calls is not written for this machine");
  Walls walls;
  std::string why = "bubblewrap is not installed";
  walls.program = find_program("bwrap").string();
  if (!walls.program.empty()) {
    const auto answer = run_process({walls.program, "--version"});
    if (answer) walls.version = answer->output.substr(0, answer->output.find('\n'));
    for (const bool forbids : {true, false}) {
      walls.forbids_users = forbids;
      if (const auto found = try_walls(walls, why)) return *found;
    }
    why = fmt::format("{} does not work here ({})", walls.version, why);
  }
  std::string why_not_own;
  if (const auto found = try_own_walls(why_not_own)) return *found;
  while (!why_not_own.empty() && why_not_own.back() == '\n') why_not_own.pop_back();
  return none(fmt::format("{}, nor do namespaces without it ({})", why, why_not_own));
}

const Result<Walls>& walls() {
  static const Result<Walls> found = find_walls();
  return found;
}

// A file in memory with the filter, to be read by bwrap.
Result<Descriptor> filter_file() {
  const std::string filter = seccomp_filter();
  Descriptor file(::memfd_create("filter", MFD_CLOEXEC));
  if (file.get() < 0 || ::write(file.get(), filter.data(), filter.size()) != static_cast<ssize_t>(filter.size()) ||
      ::lseek(file.get(), 0, SEEK_SET) != 0) {
    return fail(ErrorCode::kIo, "the filter of the sandbox cannot be handed over");
  }
  return file;
}

std::map<std::string, std::string> environment_of(const Job& job, const std::string& home) {
  std::map<std::string, std::string> all{
      {"HOME", home}, {"TMPDIR", home == kHome ? "/tmp" : home}, {"PATH", "/usr/bin:/bin"}, {"LANG", "C.UTF-8"}};
  for (const auto& [name, value] : job.environment) all[name] = value;
  return all;
}

std::vector<std::string> walled(const Job& job, const Walls& walls, int filter) {
  std::vector<std::string> words = isolation(walls);
  for (const auto& [name, value] : environment_of(job, std::string(kHome))) add(words, {"--setenv", name, value});
  add_system(words);
  for (const fs::path& path : job.readable) add(words, {"--ro-bind-try", path.string(), path.string()});
  add(words, {"--bind", job.folder.string(), std::string(kFolder)});
  add_seal(words);
  add(words, {"--chdir", std::string(kFolder), "--seccomp", std::to_string(filter), "--"});
  words.insert(words.end(), job.command.begin(), job.command.end());
  return words;
}

// Without walls the folder has its own name.
std::vector<std::string> unwalled(const Job& job) {
  std::vector<std::string> words = job.command;
  for (std::string& word : words) {
    if (word.starts_with(std::string(kFolder) + "/") || word == kFolder) word.replace(0, kFolder.size(), job.folder.string());
  }
  return words;
}

std::vector<ResourceLimit> limits_of(const Limits& limits) {
  const auto bytes = [](double megabytes) { return static_cast<std::uint64_t>(megabytes * kMb); };
  const auto seconds = static_cast<std::uint64_t>(limits.time_s) + 1;
  return {{RLIMIT_FSIZE, bytes(limits.file_mb)},
          {RLIMIT_CORE, 0},
          {RLIMIT_NOFILE, 1024},
          {RLIMIT_CPU, seconds * 64},                    // of all threads together
          {RLIMIT_AS, bytes(limits.memory_mb + 8192)}};  // Blender asks for far more than it uses
}

}  // namespace

Result<std::string> describe_walls() {
  if (!walls()) return Failure(walls().error());
  return walls()->version;
}

Result<Outcome> run(const Job& job) {
  if (job.command.empty()) return fail(ErrorCode::kIo, "there is no command to run");
  if (!walls() && !job.without_walls) return Failure(walls().error());
  ProcessOptions options;
  options.own_environment = true;
  options.time_limit_s = job.limits.time_s;
  options.limits = limits_of(job.limits);
  options.stop = job.stop;
  options.on_line = job.on_line;
  options.watch = [&](pid_t child) { return passed_limit(child, job.folder, job.limits); };
  std::vector<std::string> words;
  Descriptor filter;
  NamespaceWalls own;
  if (walls() && walls()->own()) {
    own = own_walls();
    for (const fs::path& path : job.readable) own.show(path);
    own.give(job.folder, std::string(kFolder));
    own.start_in(std::string(kFolder));
    options.before_exec = [&own] { own.enter(); };
    options.environment = environment_of(job, std::string(kHome));
    words = job.command;
  } else if (walls()) {
    LAYOUTBOX_ASSIGN(filter, filter_file());
    options.inherited = {filter.get()};
    words = walled(job, *walls(), filter.get());
    // What starts the sandbox shows its own environment in /proc/1: it has none either.
    options.environment = {{"PATH", "/usr/bin:/bin"}};
  } else {
    words = unwalled(job);
    options.environment = environment_of(job, job.folder.string());
    options.working_folder = job.folder;
  }
  auto process = run_process(words, options);
  make_removable(job.folder);
  if (!process) return Failure(std::move(process).error());
  if (process->stopped) return fail(ErrorCode::kInterrupted, "what ran in the sandbox was stopped");
  if (walls() && walls()->own() && process->exit_status == NamespaceWalls::kNotEntered && process->output.starts_with("sandbox: ")) {
    return fail(ErrorCode::kIo, process->output);
  }
  Outcome outcome{*std::move(process), {}};
  outcome.ended = outcome.process.timed_out ? fmt::format("it took more than {:g} s", job.limits.time_s) : outcome.process.ended;
  if (outcome.ended.empty() && outcome.process.exit_status == 128 + SIGXFSZ) {
    outcome.ended = fmt::format("it wrote a file of more than {:g} MB", job.limits.file_mb);
  }
  return outcome;
}

Result<std::string> take_file(const fs::path& folder, const std::string& name, std::size_t max_bytes) {
  const auto not_there = [&](std::string_view why) { return fail(ErrorCode::kIo, fmt::format("{} {}", name, why), name); };
  if (name.empty() || name.find('/') != std::string::npos || name == "..") return not_there("is no name of a file in the folder");
  const Descriptor file(::open((folder / name).c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat facts {};
  if (file.get() < 0 || ::fstat(file.get(), &facts) != 0) return not_there("was not written");
  if (!S_ISREG(facts.st_mode) || facts.st_nlink != 1) return not_there("is no plain file");
  if (static_cast<std::uint64_t>(facts.st_size) > max_bytes) {
    return fail(ErrorCode::kTooLarge, fmt::format("{} has {} bytes, more than {}", name, facts.st_size, max_bytes), name);
  }
  std::string bytes(static_cast<std::size_t>(facts.st_size), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::read(file.get(), bytes.data() + done, bytes.size() - done);
    if (count <= 0) return not_there("cannot be read");
    done += static_cast<std::size_t>(count);
  }
  return bytes;
}

}  // namespace layoutbox::sandbox
