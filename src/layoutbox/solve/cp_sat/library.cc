#include "layoutbox/solve/cp_sat/library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "layoutbox/solve/cp_sat_folder.h"

namespace layoutbox::placement {
namespace {

namespace fs = std::filesystem;

// What set_cp_sat_folder() was told.
fs::path& told_folder() {
  static fs::path folder;
  return folder;
}

constexpr const char* kName = "libortools.so.9";
constexpr int kMajor = 9, kLeastMinor = 8;  // tried with 9.15; the fields used are the same since 9.8
constexpr const char* kInstall = "run scripts/setup.sh, or set ORTOOLS_ROOT to a folder of OR-Tools 9.15";

std::vector<fs::path> places() {
  std::vector<fs::path> found;
  std::error_code ignored;
  const auto add_root = [&](const fs::path& root) {
    for (const char* below : {"", "lib", "lib64", "ortools/.libs"}) found.push_back(root / below / kName);
  };
  if (const char* root = std::getenv("ORTOOLS_ROOT"); root && *root) {
    add_root(root);
    return found;  // who names a folder means that one
  }
  if (!told_folder().empty()) add_root(told_folder());
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  // build/release/src/layoutbox/ and build/release/src/layoutbox/cli/ both lie below build/.
  for (fs::path up = program; up.has_relative_path(); up = up.parent_path()) found.push_back(up / "deps/ortools/ortools/.libs" / kName);
  found.push_back(program / "../lib/layoutbox/ortools/.libs" / kName);  // installed
  return found;
}

std::string last_error() {
  const char* text = dlerror();
  return text ? text : "unknown reason";
}

// Stops a search from a thread of its own when told to or when the time is up.
class Watch {
 public:
  Watch(const std::atomic<bool>* stop, double seconds, std::function<void()> stop_search)
      : thread_([this, stop, seconds, act = std::move(stop_search)] {
          const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
          std::unique_lock lock(mutex_);
          while (!done_) {
            changed_.wait_for(lock, std::chrono::milliseconds(5));
            if (!done_ && ((stop && stop->load()) || std::chrono::steady_clock::now() > end)) act();
          }
        }) {}
  ~Watch() {
    {
      const std::lock_guard lock(mutex_);
      done_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool done_ = false;
  std::thread thread_;
};

// `reason`: what the loader said, empty where no file was found.
std::string why_not_loaded(const std::string& reason) {
  if (!reason.empty()) return "the solver library cannot be loaded: " + reason;
  const char* const root = std::getenv("ORTOOLS_ROOT");
  if (root != nullptr) return fmt::format("ORTOOLS_ROOT is {}, where there is no {}", root, kName);
  return "the solver library OR-Tools is not installed";
}

}  // namespace

Result<CpSatLibrary> CpSatLibrary::open() {
  CpSatLibrary library;
  void* handle = nullptr;
  std::string reason;
  for (const fs::path& path : places()) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) continue;
    handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    library.path_ = path.lexically_normal().string();
    if (handle) break;
    reason = last_error();
  }
  if (!handle && !std::getenv("ORTOOLS_ROOT")) {
    handle = dlopen(kName, RTLD_NOW | RTLD_LOCAL);
    if (handle) library.path_ = kName;
  }
  if (!handle) return fail(ErrorCode::kNoSolver, why_not_loaded(reason), library.path_, kInstall);
  const auto function = [&](const char* name) { return dlsym(handle, name); };
  library.new_env_ = reinterpret_cast<NewEnv>(function("SolveCpNewEnv"));
  library.destroy_env_ = reinterpret_cast<WithEnv>(function("SolveCpDestroyEnv"));
  library.stop_search_ = reinterpret_cast<WithEnv>(function("SolveCpStopSearch"));
  library.solve_ = reinterpret_cast<Interruptible>(function("SolveCpInterruptible"));
  if (!library.new_env_ || !library.destroy_env_ || !library.stop_search_ || !library.solve_) {
    return fail(ErrorCode::kNoSolver, "the solver library has no C interface to CP-SAT", library.path_, kInstall);
  }
  using Number = int (*)();
  const auto major = reinterpret_cast<Number>(function("_ZN19operations_research19OrToolsMajorVersionEv"));
  const auto minor = reinterpret_cast<Number>(function("_ZN19operations_research19OrToolsMinorVersionEv"));
  library.version_ = major && minor ? fmt::format("{}.{}", major(), minor()) : "of unknown version";
  if (!major || !minor || major() != kMajor || minor() < kLeastMinor) {
    return fail(ErrorCode::kNoSolver,
                fmt::format("the solver library is OR-Tools {}, {}.{} or later is needed", library.version_, kMajor, kLeastMinor),
                library.path_, kInstall);
  }
  return library;
}

Result<const CpSatLibrary*> CpSatLibrary::get() {
  static const Result<CpSatLibrary> library = open();
  if (!library) return Failure(library.error());
  return &*library;
}

std::string CpSatLibrary::solve(std::string_view model, std::string_view parameters, const std::atomic<bool>* stop, double seconds) const {
  void* env = new_env_();
  void* response = nullptr;
  int length = 0;
  {
    const Watch watch(stop, seconds, [&] { stop_search_(env); });
    solve_(env, model.data(), static_cast<int>(model.size()), parameters.data(), static_cast<int>(parameters.size()), &response, &length);
  }
  destroy_env_(env);
  std::string bytes(static_cast<const char*>(response), response ? static_cast<std::size_t>(length) : 0);
  std::free(response);  // NOLINT: allocated by the library with malloc
  return bytes;
}

}  // namespace layoutbox::placement

void layoutbox::set_cp_sat_folder(std::filesystem::path folder) { placement::told_folder() = std::move(folder); }
