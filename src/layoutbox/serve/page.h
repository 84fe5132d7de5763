// The built page: a few files of one folder, kept in memory; who opens it after a new build gets the new one. Without a folder: what is
// embedded in the program.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "layoutbox/serve/calls.h"

namespace layoutbox::serve {

// Was the page built before the program?
bool page_is_embedded();

class Page {
 public:
  // Empty: the embedded page. Where there is none, start() says so.
  explicit Page(std::filesystem::path folder);
  Answer start();  // reads the folder again where a file of it has changed
  std::optional<Answer> file(const std::string& name) const;

 private:
  using Stamps = std::map<std::string, std::filesystem::file_time_type>;
  using Files = std::map<std::string, Answer>;
  std::shared_ptr<const Files> files() const;

  std::filesystem::path folder_;
  mutable std::mutex mutex_;
  Stamps stamps_;
  std::shared_ptr<const Files> files_;
};

}  // namespace layoutbox::serve
