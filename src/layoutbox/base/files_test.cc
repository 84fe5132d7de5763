#include "layoutbox/base/files.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>

namespace layoutbox {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  TemporaryFolder folder_ = TemporaryFolder::make("test").value();
  fs::path path_ = folder_.path() / "file.txt";

  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
  }
};

TEST_F(Files, WhatIsWrittenIsRead) {
  const std::string bytes("a\0b\n\xFF", 5);
  ASSERT_TRUE(write_file(path_, bytes));
  EXPECT_EQ(read_file(path_).value(), bytes);
  EXPECT_EQ(entries(), 1u) << "a temporary file is left";
}

TEST_F(Files, WritingReplacesWhole) {
  ASSERT_TRUE(write_file(path_, std::string(100'000, 'a')));
  ASSERT_TRUE(write_file(path_, "short"));
  EXPECT_EQ(read_file(path_).value(), "short");
}

TEST_F(Files, FilesGetUsualPermissions) {
  ASSERT_TRUE(write_file(path_, "x"));
  struct stat status {};
  ASSERT_EQ(::stat(path_.c_str(), &status), 0);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  EXPECT_EQ(status.st_mode & 0777, 0666 & ~mask);
}

TEST_F(Files, AFailedWriteLeavesTheOldFileAndNothingElse) {
  // A folder that is not there cannot be written into.
  const Status status = write_file(folder_.path() / "missing" / "file.txt", "x");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kIo);
  EXPECT_EQ(entries(), 0u);
  const Status onto_folder = write_file(folder_.path(), "x");
  ASSERT_FALSE(onto_folder);
  EXPECT_EQ(onto_folder.error().code, ErrorCode::kIo);
}

TEST_F(Files, AFullDiskIsSaidInWords) {
  if (::access("/dev/full", W_OK) != 0) GTEST_SKIP() << "there is no /dev/full here";
  const Status status = write_file("/dev/full", "x");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kIo);
  EXPECT_THAT(status.error().message, testing::HasSubstr("No space left"));
  EXPECT_FALSE(status.error().hint.empty());
}

TEST_F(Files, ReadingTellsWhatIsWrong) {
  EXPECT_EQ(read_file(path_).error().code, ErrorCode::kIo);
  EXPECT_EQ(read_file(folder_.path()).error().code, ErrorCode::kIo);
  ASSERT_TRUE(write_file(path_, std::string(100'001, 'a')));
  EXPECT_EQ(read_file(path_, 100'000).error().code, ErrorCode::kTooLarge);
  EXPECT_TRUE(read_file(path_, 100'001));
}

TEST_F(Files, FoldersAreMadeWithThoseAbove) {
  const fs::path deep = folder_.path() / "a" / "b";
  ASSERT_TRUE(make_folder(deep));
  EXPECT_TRUE(fs::is_directory(deep));
  EXPECT_TRUE(make_folder(deep)) << "it may be there already";
  EXPECT_TRUE(fs::is_empty(deep)) << "the probe is left";
  ASSERT_TRUE(write_file(path_, "x"));
  EXPECT_EQ(make_folder(path_).error().code, ErrorCode::kIo);
  EXPECT_EQ(make_folder(path_ / "below").error().code, ErrorCode::kIo);
}

// TMPDIR is `path` while it lives: in the machine's own, another process may be about to remove the very folder that a test looks at.
class TemporaryFoldersIn {
 public:
  explicit TemporaryFoldersIn(const fs::path& path) {
    if (const char* before = std::getenv("TMPDIR")) before_ = before;
    ::setenv("TMPDIR", path.c_str(), 1);
  }
  ~TemporaryFoldersIn() { before_ ? ::setenv("TMPDIR", before_->c_str(), 1) : ::unsetenv("TMPDIR"); }
  TemporaryFoldersIn(const TemporaryFoldersIn&) = delete;
  TemporaryFoldersIn& operator=(const TemporaryFoldersIn&) = delete;

 private:
  std::optional<std::string> before_;
};

TEST(TemporaryFolders, OfAProcessThatWasKilledGoAtTheNextStart) {
  const TemporaryFolder own = TemporaryFolder::make("own").value();
  const TemporaryFoldersIn only_here(own.path());
  const fs::path base = fs::temp_directory_path();
  const fs::path abandoned = base / "layoutbox-tmp-killed-abcdef", fresh = base / "layoutbox-tmp-killed-ghijkl";
  const fs::path of_a_person = base / "layoutbox-sunset", of_a_person_too = base / "layoutbox-tmp-garden";
  const TemporaryFolder held = TemporaryFolder::make("held").value();
  for (const fs::path& folder : {abandoned, fresh, of_a_person, of_a_person_too}) ASSERT_TRUE(make_folder(folder));
  ASSERT_TRUE(write_file(abandoned / "a", "x"));
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
  for (const fs::path& folder : {abandoned, held.path(), of_a_person, of_a_person_too}) fs::last_write_time(folder, long_ago);
  const std::vector<fs::path> removed = remove_abandoned_folders();
  EXPECT_NE(std::find(removed.begin(), removed.end(), abandoned), removed.end());
  EXPECT_FALSE(fs::exists(abandoned));
  EXPECT_TRUE(fs::exists(held.path())) << "it is in use";
  EXPECT_TRUE(fs::exists(fresh)) << "its process may not have locked it yet";
  for (const fs::path& folder : {of_a_person, of_a_person_too}) EXPECT_TRUE(fs::exists(folder)) << "not ours";
}

TEST(TemporaryFolders, GoWithEverythingInThem) {
  fs::path path;
  {
    TemporaryFolder first = TemporaryFolder::make("test").value();
    path = first.path();
    ASSERT_TRUE(make_folder(path / "deep"));
    const TemporaryFolder second = std::move(first);
    EXPECT_EQ(second.path(), path);
    EXPECT_TRUE(fs::exists(path));
  }
  EXPECT_FALSE(fs::exists(path));
}

}  // namespace
}  // namespace layoutbox
