// How child processes are started: in a process group of their own, stdout and stderr in one pipe. For process.cc and service.cc.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/descriptor.h"
#include "layoutbox/base/process.h"
#include "layoutbox/base/result.h"

namespace layoutbox {

// A child that does not end when it is asked to is killed after so long.
inline constexpr double kGraceSeconds = 2;

// Since `begin`, in seconds.
inline double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

struct Child {
  pid_t pid = 0;      // also its process group
  Descriptor output;  // what it prints, to be read
  Descriptor input;   // its stdin, to be written; none unless wished
};

// Collects what a child prints: the last 64 KiB of all, and whole lines for a callback.
class OutputReader {
 public:
  OutputReader(std::string& kept, const std::function<void(std::string_view)>& on_line) : kept_(kept), on_line_(on_line) {}
  void add(std::string_view bytes);
  void finish();  // no more will come

 private:
  void finish_line();
  void pass_on(std::string_view line);

  std::string& kept_;
  const std::function<void(std::string_view)>& on_line_;
  std::string line_;
};

// Starts command[0] (looked up on the PATH); the caller waits for it and ends its group. Errors: kIo when it cannot be started.
Result<Child> spawn(const std::vector<std::string>& command, const ProcessOptions& options, bool with_input);

}  // namespace layoutbox
