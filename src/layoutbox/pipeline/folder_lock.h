// One run at a time in an output folder.
#pragma once

#include <filesystem>

#include "layoutbox/base/result.h"

namespace layoutbox {

// Holds an advisory lock on a folder until it dies; the kernel lets go of it when the process ends in whatever way.
class FolderLock {
 public:
  // Errors: kIo when another run holds the folder, or it cannot be opened.
  static Result<FolderLock> acquire(const std::filesystem::path& folder);
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  explicit FolderLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace layoutbox
