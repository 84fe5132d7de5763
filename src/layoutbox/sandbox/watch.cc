#include "layoutbox/sandbox/watch.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <charconv>
#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <vector>

namespace layoutbox::sandbox {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 64;  // folders within folders

struct KernelTask {
  pid_t parent = 0;
  int threads = 0;
  double pages = 0;
};

// Of /proc/PID/stat: what follows the name in brackets, which may hold anything.
bool read_task(pid_t pid, KernelTask& task) {
  std::ifstream file(fmt::format("/proc/{}/stat", pid));
  std::string line;
  if (!std::getline(file, line)) return false;
  const std::size_t end = line.rfind(')');
  if (end == std::string::npos) return false;
  char state = 0;
  return std::sscanf(line.c_str() + end + 1, " %c %d %*d %*d %*d %*d %*u %*u %*u %*u %*u %*u %*u %*d %*d %*d %*d %d %*d %*u %*u %lf",
                     &state, &task.parent, &task.threads, &task.pages) == 4;
}

void add_contents(const fs::path& folder, int depth, Contents& contents) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    struct stat facts {};
    if (::lstat(entry->path().c_str(), &facts) != 0) continue;
    ++contents.files;
    contents.mb += static_cast<double>(facts.st_blocks) * 512 / kMb;
    if (!S_ISDIR(facts.st_mode)) continue;
    if (depth >= kDeepest) contents.files += 1 << 20;  // nobody honest builds so deep
    if (depth < kDeepest) add_contents(entry->path(), depth + 1, contents);
  }
}

}  // namespace

Load load_of(pid_t top) {
  std::map<pid_t, KernelTask> tasks;
  std::error_code error;
  for (fs::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    pid_t pid = 0;
    const auto [rest, failed] = std::from_chars(name.data(), name.data() + name.size(), pid);
    if (failed != std::errc{} || rest != name.data() + name.size()) continue;
    KernelTask task;
    if (read_task(pid, task)) tasks[pid] = task;
  }
  const double page_mb = static_cast<double>(::sysconf(_SC_PAGESIZE)) / kMb;
  Load load;
  std::set<pid_t> below{top};
  for (bool found = true; found;) {  // numbers may wrap round, so that a child's need not be the larger
    found = false;
    for (const auto& [pid, task] : tasks) found = (below.contains(task.parent) && below.insert(pid).second) || found;
  }
  for (const pid_t pid : below) {
    const auto task = tasks.find(pid);
    if (task == tasks.end()) continue;
    load.memory_mb += task->second.pages * page_mb;
    load.tasks += task->second.threads;
  }
  return load;
}

Contents contents_of(const fs::path& folder) {
  Contents contents;
  add_contents(folder, 0, contents);
  return contents;
}

std::string passed_limit(pid_t top, const fs::path& folder, const Limits& limits) {
  const Load load = load_of(top);
  if (load.tasks > limits.tasks) return fmt::format("it ran more than {} processes and threads", limits.tasks);
  if (load.memory_mb > limits.memory_mb) return fmt::format("it used more than {:g} MB of memory", limits.memory_mb);
  const Contents contents = contents_of(folder);
  if (contents.mb > limits.folder_mb) return fmt::format("it wrote more than {:g} MB", limits.folder_mb);
  if (contents.files > limits.files) return fmt::format("it made more than {} files", limits.files);
  return {};
}

void make_removable(const fs::path& folder) {
  std::error_code error;
  fs::permissions(folder, fs::perms::owner_all, fs::perm_options::add, error);
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (fs::symlink_status(entry->path(), ignored).type() == fs::file_type::directory) make_removable(entry->path());
  }
}

}  // namespace layoutbox::sandbox
