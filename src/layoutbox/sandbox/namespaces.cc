#include "layoutbox/sandbox/namespaces.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/capability.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace layoutbox::sandbox {
namespace {

namespace fs = std::filesystem;

// The old root and the new one, within a folder in memory that both are put into while the new one is built.
constexpr const char* kStage = "/tmp";
constexpr const char* kOld = "/old";
constexpr const char* kNew = "/new";
constexpr int kNobody = 65534;
constexpr int kDescriptors = 4096;

// <linux/mount.h> and <sys/mount.h> do not go together everywhere; these are the kernel's.
struct MountAttributes {
  std::uint64_t set = 0, clear = 0, propagation = 0, userns_fd = 0;
};
constexpr std::uint64_t kReadOnly = 1, kNoSetuid = 2, kNoDevices = 4;
constexpr unsigned kRecursive = 0x8000;  // AT_RECURSIVE

// Says what failed and ends: what was to run does not.
[[noreturn]] void failed(const char* step, const char* what) {
  char number[16];
  std::snprintf(number, sizeof number, "%d", errno);
  for (const char* part : {"sandbox: ", step, " ", what, ": error ", static_cast<const char*>(number), "\n"}) {
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, part, std::strlen(part));
  }
  ::_exit(NamespaceWalls::kNotEntered);
}

int seal(const char* path, std::uint64_t attributes, bool all_below) {
#ifdef __NR_mount_setattr
  const MountAttributes wanted{attributes, 0, 0, 0};
  return static_cast<int>(::syscall(__NR_mount_setattr, -1, path, all_below ? kRecursive : 0u, &wanted, sizeof wanted));
#else
  errno = ENOSYS;
  return -1;
#endif
}

bool put(const char* file, const char* text) {
  const int descriptor = ::open(file, O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool written = ::write(descriptor, text, std::strlen(text)) == static_cast<ssize_t>(std::strlen(text));
  ::close(descriptor);
  return written;
}

// Namespaces of one's own, in which one is nobody.
void leave_the_others(const char* users, const char* groups) {
  constexpr int kAll = CLONE_NEWUSER | CLONE_NEWNS | CLONE_NEWPID | CLONE_NEWNET | CLONE_NEWIPC | CLONE_NEWUTS;
  if (::unshare(kAll) != 0) failed("new namespaces", "");
  ::unshare(CLONE_NEWCGROUP);  // where there are any
  put("/proc/self/setgroups", "deny");
  if (!put("/proc/self/uid_map", users) || !put("/proc/self/gid_map", groups)) failed("users", "of its own");
  if (::sethostname("sandbox", 7) != 0) failed("a name", "of its own");
}

[[noreturn]] void end_like(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  ::_exit(WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status));
}

void close_all_but_output() {
  for (int other = 3; other < kDescriptors; ++other) ::close(other);
}

void drop_rights() {
  for (int right = 0; right <= 63; ++right) ::prctl(PR_CAPBSET_DROP, right, 0, 0, 0);
  ::prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0);
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct none[2]{};
  if (::syscall(SYS_capset, &header, none) != 0) failed("rights", "cannot be dropped");
}

}  // namespace

void NamespaceWalls::make_way_to(const std::string& inside) {
  for (std::size_t at = inside.find('/', 1); at != std::string::npos; at = inside.find('/', at + 1)) {
    const std::string folder = inside.substr(0, at);
    if (std::find(made_.begin(), made_.end(), folder) != made_.end()) continue;
    made_.push_back(folder);
    steps_.push_back({What::kMakeFolder, {}, kNew + folder, {}});
  }
}

void NamespaceWalls::add_shown(const fs::path& path, const std::string& inside, What what) {
  std::error_code error;
  const bool folder = fs::is_directory(path, error);
  if (!folder && !fs::exists(path, error)) return;
  make_way_to(inside);
  if (std::find(made_.begin(), made_.end(), inside) == made_.end()) {
    made_.push_back(inside);
    steps_.push_back({folder ? What::kMakeFolder : What::kMakeFile, {}, kNew + inside, {}});
  }
  steps_.push_back({what, kOld + fs::canonical(path, error).string(), kNew + inside, {}});
}

void NamespaceWalls::show(const fs::path& path, std::string inside) {
  add_shown(path, inside.empty() ? path.string() : inside, What::kRead);
}

void NamespaceWalls::show_device(const std::string& path) { add_shown(path, path, What::kWrite); }

void NamespaceWalls::link(std::string target, std::string inside) {
  make_way_to(inside);
  steps_.push_back({What::kLink, std::move(target), kNew + inside, {}});
}

void NamespaceWalls::give(const fs::path& folder, std::string inside) { add_shown(folder, inside, What::kWrite); }

void NamespaceWalls::give_memory(std::string inside, double mb) {
  make_way_to(inside);
  if (std::find(made_.begin(), made_.end(), inside) == made_.end()) {
    made_.push_back(inside);
    steps_.push_back({What::kMakeFolder, {}, kNew + inside, {}});
  }
  steps_.push_back({What::kMemory, "tmpfs", kNew + inside, fmt::format("mode=0755,size={:.0f}k", mb * 1024)});
}

void NamespaceWalls::take(const Step& step) const {
  const char *from = step.from.c_str(), *to = step.to.c_str();
  errno = 0;
  switch (step.what) {
    case What::kMakeFolder:
      if (::mkdir(to, 0755) != 0 && errno != EEXIST) failed("folder", to);
      return;
    case What::kMakeFile: {
      const int file = ::open(to, O_CREAT | O_WRONLY | O_CLOEXEC, 0444);
      if (file < 0) failed("file", to);
      ::close(file);
      return;
    }
    case What::kLink:
      if (::symlink(from, to) != 0) failed("link", to);
      return;
    case What::kMemory:
      if (::mount(from, to, from, MS_NOSUID | MS_NODEV, step.words.c_str()) != 0) failed("memory", to);
      return;
    case What::kRead:
    case What::kWrite:
      if (::mount(from, to, nullptr, MS_BIND | MS_REC, nullptr) != 0) failed("mount", to);
      if (step.what == What::kWrite ? seal(to, kNoSetuid, false) != 0 : seal(to, kReadOnly | kNoSetuid | kNoDevices, true) != 0)
        failed("seal", to);
  }
}

// In the first process of the new namespaces: the new root, and nothing of the old one left.
void NamespaceWalls::build() const {
  if (::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) failed("mounts", "of its own");
  if (::mount("tmpfs", kStage, "tmpfs", MS_NOSUID | MS_NODEV, "mode=0755,size=1m") != 0) failed("memory", kStage);
  if (::chdir(kStage) != 0 || ::mkdir("old", 0755) != 0 || ::mkdir("new", 0755) != 0) failed("folder", kStage);
  if (::syscall(SYS_pivot_root, ".", "old") != 0 || ::chdir("/") != 0) failed("root", kStage);
  if (::mount("tmpfs", kNew, "tmpfs", MS_NOSUID | MS_NODEV, "mode=0755,size=1m") != 0) failed("memory", kNew);
  for (const Step& step : steps_) take(step);
  if (::mkdir("/new/proc", 0755) != 0 || ::mount("proc", "/new/proc", "proc", MS_NOSUID | MS_NODEV | MS_NOEXEC, nullptr) != 0) {
    failed("mount", "/proc");
  }
  if (::umount2(kOld, MNT_DETACH) != 0) failed("leave", "the old root");
  for (const char* name : {"/new/proc", "/new/dev", "/new"}) {
    if (seal(name, kReadOnly | kNoSetuid, false) != 0) failed("seal", name);
  }
  if (::chdir(kNew) != 0 || ::syscall(SYS_pivot_root, ".", ".") != 0 || ::umount2(".", MNT_DETACH) != 0 || ::chdir(start_.c_str()) != 0) {
    failed("root", "of its own");
  }
}

void NamespaceWalls::enter() const {
  char users[64], groups[64];
  std::snprintf(users, sizeof users, "%d %u 1", kNobody, ::geteuid());
  std::snprintf(groups, sizeof groups, "%d %u 1", kNobody, ::getegid());
  leave_the_others(users, groups);
  const pid_t first = ::fork();
  if (first < 0) failed("a process", "of its own");
  if (first > 0) {
    close_all_but_output();
    end_like(first);
  }
  ::prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
  // It keeps the caller's memory, which nobody may read: not even what runs as the same user.
  ::prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
  ::setsid();
  build();
  drop_rights();
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) failed("no new", "rights");
  const pid_t second = ::fork();
  if (second < 0) failed("a process", "of its own");
  if (second > 0) {
    close_all_but_output();
    end_like(second);
  }
  ::prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
  sock_fprog program{static_cast<unsigned short>(filter_.size() / sizeof(sock_filter)),
                     reinterpret_cast<sock_filter*>(const_cast<char*>(filter_.data()))};
  if (::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0) != 0) failed("filter", "of calls");
}

}  // namespace layoutbox::sandbox
