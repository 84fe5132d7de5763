// OR-Tools' CP-SAT through the C interface that its shared library exports, opened on first use (35 ms that most scenes never pay).
#pragma once

#include <atomic>
#include <string>
#include <string_view>

#include "layoutbox/base/result.h"

namespace layoutbox::placement {

class CpSatLibrary {
 public:
  // Looks in ORTOOLS_ROOT (itself, lib/, lib64/, ortools/.libs/), then in what set_cp_sat_folder() named, then in the build folder where
  // scripts/setup.sh puts it, then in
  // ../lib/layoutbox of an installed program, then where the system looks. Opened once per process.
  // Errors: kNoSolver: not found, not loadable, without the functions needed, or of another version.
  static Result<const CpSatLibrary*> get();

  // Solves a serialised CpModelProto with serialised SatParameters; the serialised CpSolverResponse. Stops within 10 ms when `stop`
  // (may be null) becomes true, or when `seconds` have passed.
  std::string solve(std::string_view model, std::string_view parameters, const std::atomic<bool>* stop, double seconds) const;

  const std::string& path() const { return path_; }
  const std::string& version() const { return version_; }

 private:
  CpSatLibrary() = default;
  static Result<CpSatLibrary> open();

  using NewEnv = void* (*)();
  using WithEnv = void (*)(void*);
  using Interruptible = void (*)(void*, const void*, int, const void*, int, void**, int*);
  NewEnv new_env_ = nullptr;
  WithEnv destroy_env_ = nullptr, stop_search_ = nullptr;
  Interruptible solve_ = nullptr;
  std::string path_, version_;
};

}  // namespace layoutbox::placement
