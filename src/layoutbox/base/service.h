// A child process that takes orders on its stdin, a line each, and answers in lines. It never outlives its owner.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/process.h"
#include "layoutbox/base/result.h"

namespace layoutbox {

struct WaitLimits {
  double time_limit_s = 600;
  double memory_limit_mb = 0;               // of the process itself, resident; 0: none
  const std::atomic<bool>* stop = nullptr;  // ends the waiting when it becomes true
};

enum class WaitEnd { kAnswered, kGone, kTimedOut, kTooLarge, kStopped };

class ServiceProcess {
 public:
  // Starts it with the folder and environment of `options`. Errors: kIo when it cannot be started.
  static Result<ServiceProcess> start(const std::vector<std::string>& command, const ProcessOptions& options);
  ServiceProcess(ServiceProcess&&) noexcept;
  ServiceProcess& operator=(ServiceProcess&&) noexcept;
  ~ServiceProcess();  // as end()

  // Writes the line and a line break. False where the process is gone.
  bool send(std::string_view line);
  // Passes its lines to `is_last` until that returns true (kAnswered) or a limit is met. The process is not ended by that.
  WaitEnd wait(const std::function<bool(std::string_view)>& is_last, const WaitLimits& limits);

  double memory_mb() const;  // resident; 0 where it is gone
  int exit_status() const;   // of exit(), or 128 + signal, once it is gone
  std::string take_log();    // what it printed since the last call, the last 64 KiB
  // Closes its stdin and ends its process group: SIGTERM where it does not go by itself within `patience_s`, SIGKILL 2 s later.
  void end(double patience_s = 0);

 private:
  struct State;
  explicit ServiceProcess(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace layoutbox
