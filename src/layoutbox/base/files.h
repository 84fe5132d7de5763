// Reading and writing files so that a stopped or full run leaves no half file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/descriptor.h"
#include "layoutbox/base/result.h"

namespace layoutbox {

// REQUIRES: max_bytes > 0. Errors: kIo (missing, a folder, no permission), kTooLarge.
Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes = 256u << 20);

// Writes under a temporary name beside `path`, syncs, renames. Errors: kIo, with the reason (no space, no permission); nothing is left.
Status write_file(const std::filesystem::path& path, std::string_view bytes);

// Makes the folder and those above it, and checks that a file can be written there.
Status make_folder(const std::filesystem::path& path);

// A new empty folder for temporary files, "layoutbox-tmp-PURPOSE-…" in TMPDIR, removed with everything in it when the value dies; where its
// process is killed before, by remove_abandoned_folders(), a minute later or more.
class TemporaryFolder {
 public:
  static Result<TemporaryFolder> make(std::string_view purpose);
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&& other) noexcept;
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  TemporaryFolder(std::filesystem::path path, Descriptor mark) : path_(std::move(path)), mark_(std::move(mark)) {}
  std::filesystem::path path_;
  Descriptor mark_;  // that the folder is in use
};

// Such folders that killed processes of this user left, which every make() removes as well. Returns which they were.
std::vector<std::filesystem::path> remove_abandoned_folders();

}  // namespace layoutbox
