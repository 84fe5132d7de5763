// Code that nobody vouches for (a script that a model wrote, a .blend from elsewhere) runs here: no network, no files but the system's
// and one folder, no processes beside it, no environment, limits on time, memory, threads, files and what it writes.
//
// The walls are bubblewrap's (namespaces of the kernel, made by an ordinary user or by root), else the same namespaces without it, a filter
// of system calls, and a watch over what limits of the kernel cannot say. Where the machine allows neither, nothing is run unless the
// caller insists.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/process.h"
#include "layoutbox/base/result.h"

namespace layoutbox::sandbox {

// Where the folder of a job is for the code that runs in it; also where it starts.
inline constexpr std::string_view kFolder = "/job";

struct Limits {
  double time_s = 120;
  double memory_mb = 6000;  // of all it runs together
  int tasks = 512;          // processes and threads
  double file_mb = 256;     // one file
  double folder_mb = 512;   // all files
  int files = 1000;
};

struct Job {
  std::vector<std::string> command;             // its first word a path; files of the job's folder are under kFolder
  std::filesystem::path folder;                 // the one that can be written. REQUIRES: it is there, nothing else is in it
  std::vector<std::filesystem::path> readable;  // besides the system's: where the program is
  std::map<std::string, std::string> environment;
  Limits limits;
  // Run without walls where there are none, under the limits alone. For people who know what they run. DEFAULT: false.
  bool without_walls = false;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(std::string_view line)> on_line;
};

struct Outcome {
  ProcessOutcome process;
  // The limit that ended it: "it took more than 120 s", "it used more than 6000 MB of memory"; empty where none did.
  std::string ended;
};

// What the walls are on this machine: "bubblewrap 0.8.0", "namespaces of the kernel". Found out once. Error: kIo, why there are none and
// what to do.
Result<std::string> describe_walls();

// Errors: that of describe_walls(), kIo where it cannot be started, kInterrupted. How the code ended is no error but the outcome.
Result<Outcome> run(const Job& job);

// A file that the code left in its folder. Nothing but a plain file directly in it is read: no links, no pipes. Errors: kIo, kTooLarge.
Result<std::string> take_file(const std::filesystem::path& folder, const std::string& name, std::size_t max_bytes);

}  // namespace layoutbox::sandbox
