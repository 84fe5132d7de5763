#include "layoutbox/pipeline/run_folder.h"

#include <system_error>
#include <utility>

#include "layoutbox/base/files.h"
#include "layoutbox/pipeline/variants.h"

namespace layoutbox {
namespace {

constexpr std::string_view kRecord = "run.json";
constexpr std::size_t kMostVariants = 50;

}  // namespace

Status RunFolder::open() {
  LAYOUTBOX_CHECK(make_folder(path_));
  LAYOUTBOX_ASSIGN(FolderLock lock, FolderLock::acquire(path_));
  lock_ = std::move(lock);
  remove_earlier_outputs();
  return {};
}

bool RunFolder::holds_a_run() const {
  std::error_code ignored;
  return std::filesystem::exists(path_ / kRecord, ignored);
}

Status RunFolder::write(const std::string& name, std::string_view bytes) {
  LAYOUTBOX_CHECK(write_file(path_ / name, bytes));
  files_.push_back(name);
  return {};
}

Result<std::string> RunFolder::write_artefacts(Stage stage, const RoomSoFar& room, std::size_t variant) {
  std::string names;
  for (const Artefact& one : artefacts()) {
    if (one.stage != stage || one.make == nullptr || (variant > 0 && !one.each_variant)) continue;
    LAYOUTBOX_ASSIGN(const std::string bytes, one.make(room));
    const std::string name = variant_name(std::string(one.file), variant);
    LAYOUTBOX_CHECK(write(name, bytes));
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

// A folder never holds files of two different runs; one without a record is somebody's own.
void RunFolder::remove_earlier_outputs() const {
  if (!holds_a_run()) return;
  std::error_code ignored;
  for (const Artefact& one : artefacts()) {
    const std::string name(one.file);
    std::filesystem::remove(path_ / name, ignored);
    for (std::size_t k = 1; one.each_variant && k < kMostVariants; ++k) std::filesystem::remove(path_ / variant_name(name, k), ignored);
  }
}

}  // namespace layoutbox
