// What runs in a sandbox, seen from outside: limits that the kernel has no word for.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "layoutbox/sandbox/sandbox.h"

namespace layoutbox::sandbox {

inline constexpr double kMb = 1 << 20;

// Memory and tasks of a process and all below it.
struct Load {
  double memory_mb = 0;
  int tasks = 0;
};
Load load_of(pid_t top);

// Files and bytes in a folder, at any depth; links are not followed.
struct Contents {
  double mb = 0;
  int files = 0;
};
Contents contents_of(const std::filesystem::path& folder);

// The limit that is passed, as a sentence; empty where none is.
std::string passed_limit(pid_t top, const std::filesystem::path& folder, const Limits& limits);

// So that everything in it can be removed: folders that were made unreadable can be entered again.
void make_removable(const std::filesystem::path& folder);

}  // namespace layoutbox::sandbox
