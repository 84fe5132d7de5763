// How child processes are started: in a process group of their own, stdout and stderr in one pipe. For process.cc and service.cc.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "layoutbox/base/process.h"
#include "layoutbox/base/result.h"

namespace layoutbox {

// A file descriptor that is closed with its owner.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor();
  int get() const { return number_; }
  void close();

 private:
  int number_;
};

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
