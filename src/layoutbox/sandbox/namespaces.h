// Walls of the kernel's own, for machines without bubblewrap: a process gives itself new namespaces, a root of its own in which there is
// nothing but what is put there, and no rights; then the filter of system calls.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace layoutbox::sandbox {

class NamespaceWalls {
 public:
  // What is to be there. Paths are the same within, save where `inside` says another.
  void show(const std::filesystem::path& path, std::string inside = {});  // to read; nothing where it is not there
  void show_device(const std::string& path);                              // of /dev
  void link(std::string target, std::string inside);                      // a symbolic link
  void give(const std::filesystem::path& folder, std::string inside);     // to write
  void give_memory(std::string inside, double mb);                        // an empty folder in memory, to write
  void start_in(std::string folder) { start_ = std::move(folder); }
  void filter(std::string program) { filter_ = std::move(program); }  // of seccomp_filter()

  // How a process ends that could not go behind the walls; what failed stands on stderr, after "sandbox: ".
  static constexpr int kNotEntered = 126;

  // For ProcessOptions::before_exec: goes behind the walls, in a process of its own; the one that calls stays outside, waits for it and
  // ends as it does. Nothing is allocated.
  void enter() const;

 private:
  enum class What { kMakeFolder, kMakeFile, kRead, kWrite, kMemory, kLink };
  struct Step {
    What what;
    std::string from, to, words;
  };
  void make_way_to(const std::string& inside);
  void add_shown(const std::filesystem::path& path, const std::string& inside, What what);
  void build() const;
  void take(const Step& step) const;

  std::vector<Step> steps_;
  std::vector<std::string> made_, sealed_;
  std::string start_ = "/", filter_;
};

}  // namespace layoutbox::sandbox
