// Child processes with a time limit, a stop from outside, and no process left behind.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "layoutbox/base/result.h"

namespace layoutbox {

// A limit of the system for a process and what it starts (setrlimit).
struct ResourceLimit {
  int resource = 0;  // RLIMIT_FSIZE…
  std::uint64_t most = 0;
};

struct ProcessOptions {
  std::filesystem::path working_folder;            // empty: the caller's
  std::map<std::string, std::string> environment;  // added to the caller's
  bool own_environment = false;                    // nothing of the caller's: `environment` is all there is, no descriptor is inherited
  std::vector<ResourceLimit> limits;               // those that cannot be set are left
  std::vector<int> inherited;                      // but these, which stay open under their numbers
  // In the child, last before it becomes the program: it may call the system and nothing that allocates. May be empty.
  std::function<void()> before_exec;
  double time_limit_s = 600;                           // then SIGTERM, and SIGKILL 2 s later, to the whole process group
  const std::atomic<bool>* stop = nullptr;             // the same when it becomes true
  std::function<void(std::string_view line)> on_line;  // each line of stdout and stderr as it comes; may be empty
  std::function<std::string(pid_t child)> watch;       // asked many times a second; ends the child by saying why. May be empty
};

struct ProcessOutcome {
  int exit_status = 0;  // of exit(), or 128 + signal
  bool timed_out = false, stopped = false;
  std::string ended;   // what `watch` ended it for
  std::string output;  // stdout and stderr together, the last 64 KiB
};

// command[0] is looked up on the PATH. Errors: kIo when it cannot be started.
Result<ProcessOutcome> run_process(const std::vector<std::string>& command, const ProcessOptions& options = {});

// Where a program is on the PATH, or empty.
std::filesystem::path find_program(std::string_view name);

}  // namespace layoutbox
