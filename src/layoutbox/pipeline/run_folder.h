// The folder that a run writes into: one run at a time, whole files, none of an earlier run among them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/pipeline/artefacts.h"
#include "layoutbox/pipeline/folder_lock.h"

namespace layoutbox {

class RunFolder {
 public:
  explicit RunFolder(std::filesystem::path path) : path_(std::move(path)) {}

  // Made where it is missing, held until this dies, and cleared of what an earlier run wrote. Errors: kIo.
  Status open();
  // Is there the record of an earlier run?
  bool holds_a_run() const;

  // Under a temporary name first: whole or not at all.
  Status write(const std::string& name, std::string_view bytes);
  // A file that somebody else has put there.
  void add(std::string name) { files_.push_back(std::move(name)); }
  // What is written after a stage, of the first layout or of another; its names for people.
  Result<std::string> write_artefacts(Stage stage, const RoomSoFar& room, std::size_t variant = 0);

  const std::filesystem::path& path() const { return path_; }
  // Names in the order in which they were written.
  const std::vector<std::string>& files() const { return files_; }
  // The stages begin again; what they wrote is written over.
  void forget_files() { files_.clear(); }

 private:
  void remove_earlier_outputs() const;

  std::filesystem::path path_;
  std::optional<FolderLock> lock_;
  std::vector<std::string> files_;
};

}  // namespace layoutbox
