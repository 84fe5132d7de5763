// The built page: a few files of one folder, read once.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "layoutbox/serve/calls.h"

namespace layoutbox::serve {

class Page {
 public:
  // Empty or missing: there is no page, and start() says so.
  explicit Page(const std::filesystem::path& folder);
  Answer start() const;
  std::optional<Answer> file(const std::string& name) const;

 private:
  std::map<std::string, Answer> files_;
};

}  // namespace layoutbox::serve
