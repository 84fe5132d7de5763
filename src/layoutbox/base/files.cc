#include "layoutbox/base/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <system_error>

namespace layoutbox {
namespace {

namespace fs = std::filesystem;

// "Permission denied" and what can be done about it.
Failure io_error(std::string_view doing, const fs::path& path, int error) {
  std::string hint;
  switch (error) {
    case ENOENT: hint = "check the path"; break;
    case EACCES:
    case EPERM: hint = "check who owns it and its permissions"; break;
    case EROFS: hint = "the file system is read-only: choose another folder"; break;
    case ENOSPC:
    case EDQUOT: hint = "free some space or choose another folder"; break;
    case EFBIG: hint = "files may not be as large as that here: see ulimit -f"; break;
    case EISDIR: hint = "give a file, not a folder"; break;
    case ENOTDIR: hint = "a part of the path is a file, not a folder"; break;
    default: break;
  }
  return fail(ErrorCode::kIo, fmt::format("cannot {} {}: {}", doing, path.string(), std::generic_category().message(error)), path.string(),
              std::move(hint));
}

// errno, or 0.
int write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      return errno;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

// mkstemp makes files of mode 0600; ours get what open() would have given them. Asked once: the question changes the mask for a moment,
// which other threads must not see.
mode_t usual_file_mode() {
  static const mode_t mode = [] {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
  }();
  return mode;
}

// The folder, open and marked as in use by this process; the mark goes with the process, however that ends. It is a lock of another kind
// than a run's on its output folder, which may be this one.
Descriptor folder_in_use(const fs::path& folder) {
  Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  struct flock mark {};
  mark.l_type = F_RDLCK;
  if (descriptor.get() >= 0) (void)::fcntl(descriptor.get(), F_OFD_SETLK, &mark);  // without it the folder is only not swept up
  return descriptor;
}

// Whether a process has marked it, or that cannot be told.
bool is_in_use(const fs::path& folder) {
  const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  struct flock other {};
  other.l_type = F_WRLCK;
  return descriptor.get() < 0 || ::fcntl(descriptor.get(), F_OFD_GETLK, &other) != 0 || other.l_type != F_UNLCK;
}

constexpr std::string_view kOurs = "layoutbox-tmp-";
constexpr std::size_t kRandomLetters = 6;  // of mkdtemp

}  // namespace

Result<std::string> read_file(const fs::path& path, std::size_t max_bytes) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) return io_error("read", path, errno);
  std::string bytes;
  struct stat status {};
  if (::fstat(file.get(), &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0) {
    bytes.reserve(std::min(static_cast<std::size_t>(status.st_size), max_bytes) + 1);
  }
  constexpr std::size_t kChunk = 1 << 16;
  for (;;) {
    const std::size_t before = bytes.size();
    bytes.resize(before + kChunk);
    const ssize_t count = ::read(file.get(), bytes.data() + before, kChunk);
    if (count < 0) {
      bytes.resize(before);
      if (errno == EINTR) continue;
      return io_error("read", path, errno);
    }
    bytes.resize(before + static_cast<std::size_t>(count));
    if (count == 0) return bytes;
    if (bytes.size() > max_bytes) {
      return fail(ErrorCode::kTooLarge, fmt::format("{} is larger than {} bytes, the most that is read", path.string(), max_bytes),
                  path.string());
    }
  }
}

Status write_file(const fs::path& path, std::string_view bytes) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return io_error("write", path, EISDIR);
  // What is no regular file (/dev/stdout, a pipe) cannot be replaced by renaming.
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) {
    const Descriptor target(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (target.get() < 0) return io_error("write", path, errno);
    if (const int error = write_all(target.get(), bytes)) return io_error("write", path, error);
    return {};
  }
  std::string temporary = (path.parent_path() / fmt::format(".{}.XXXXXX", path.filename().string())).string();
  Descriptor file(::mkstemp(temporary.data()));
  if (file.get() < 0) return io_error("write", path, errno);
  int error = write_all(file.get(), bytes);
  if (error == 0 && ::fchmod(file.get(), usual_file_mode()) != 0) error = errno;
  if (error == 0 && ::fsync(file.get()) != 0 && errno != EINVAL) error = errno;
  if (file.close() != 0 && error == 0) error = errno;
  if (error == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error == 0) return {};
  ::unlink(temporary.c_str());
  return io_error("write", path, error);
}

Status make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) return io_error("make the folder", path, error.value());
  if (!fs::is_directory(path, error)) return io_error("make the folder", path, ENOTDIR);
  // Permissions alone do not tell (read-only mounts, quotas): try it.
  std::string probe = (path / ".layoutbox.XXXXXX").string();
  const Descriptor file(::mkstemp(probe.data()));
  if (file.get() < 0) return io_error("write into the folder", path, errno);
  ::unlink(probe.c_str());
  return {};
}

// Folders of this user that make() named, a minute old (a new one is not marked yet), which no process uses.
std::vector<fs::path> remove_abandoned_folders() {
  std::vector<fs::path> removed;
  std::error_code ignored;
  const auto latest = fs::file_time_type::clock::now() - std::chrono::minutes(1);
  for (fs::directory_iterator entry(fs::temp_directory_path(ignored), ignored), end; entry != end; entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(kOurs) || name.size() < kOurs.size() + 1 + kRandomLetters || name[name.size() - kRandomLetters - 1] != '-')
      continue;
    struct stat status {};
    if (::lstat(entry->path().c_str(), &status) != 0 || !S_ISDIR(status.st_mode) || status.st_uid != ::geteuid()) continue;
    if (entry->last_write_time(ignored) > latest || is_in_use(entry->path())) continue;
    if (fs::remove_all(entry->path(), ignored) > 0) removed.push_back(entry->path());
  }
  return removed;
}

Result<TemporaryFolder> TemporaryFolder::make(std::string_view purpose) {
  std::error_code error;
  const fs::path base = fs::temp_directory_path(error);
  if (error) return io_error("find a temporary folder in", "TMPDIR", error.value());
  remove_abandoned_folders();
  std::string name = (base / fmt::format("{}{}-XXXXXX", kOurs, purpose)).string();
  if (::mkdtemp(name.data()) == nullptr) return io_error("make a temporary folder in", base, errno);
  return TemporaryFolder(fs::path(name), folder_in_use(name));
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept
    : path_(std::exchange(other.path_, fs::path{})), mark_(std::move(other.mark_)) {}

TemporaryFolder& TemporaryFolder::operator=(TemporaryFolder&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(mark_, other.mark_);
  return *this;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

}  // namespace layoutbox
