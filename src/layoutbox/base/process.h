// Child processes with a time limit, a stop from outside, and no process left behind.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "layoutbox/base/result.h"

namespace layoutbox {

struct ProcessOptions {
  std::filesystem::path working_folder;                // empty: the caller's
  std::map<std::string, std::string> environment;      // added to the caller's
  double time_limit_s = 600;                           // then SIGTERM, and SIGKILL 2 s later, to the whole process group
  const std::atomic<bool>* stop = nullptr;             // the same when it becomes true
  std::function<void(std::string_view line)> on_line;  // each line of stdout and stderr as it comes; may be empty
};

struct ProcessOutcome {
  int exit_status = 0;  // of exit(), or 128 + signal
  bool timed_out = false, stopped = false;
  std::string output;  // stdout and stderr together, the last 64 KiB
};

// command[0] is looked up on the PATH. Errors: kIo when it cannot be started.
Result<ProcessOutcome> run_process(const std::vector<std::string>& command, const ProcessOptions& options = {});

// Where a program is on the PATH, or empty.
std::filesystem::path find_program(std::string_view name);

}  // namespace layoutbox
