#include "layoutbox/experiment/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "layoutbox/base/files.h"
#include "layoutbox/embedded/suites.h"

namespace layoutbox::experiment {

std::vector<std::string> suite_names() {
  std::vector<std::string> names;
  for (const auto& [file, text] : embedded::suites_files()) names.emplace_back(file.substr(0, file.rfind('.')));
  std::sort(names.begin(), names.end());
  return names;
}

Result<Suite> load_suite(const std::string& name_or_file) {
  Suite suite{name_or_file, {}};
  std::string table;
  for (const auto& [file, text] : embedded::suites_files()) {
    if (file == name_or_file + ".csv") table = text;
  }
  if (table.empty()) {
    auto read = read_file(name_or_file);
    if (!read) {
      std::string names;
      for (const std::string& name : suite_names()) names += (names.empty() ? "" : ", ") + name;
      read.error().hint = fmt::format("name a table (ID, Description, ObjCount, OORel, OARel) or one of {}", names);
      return Failure(std::move(read).error());
    }
    table = *std::move(read);
    suite.name = std::filesystem::path(name_or_file).stem().string();
  }
  LAYOUTBOX_ASSIGN(suite.scenes, scoring::read_annotations(table));
  if (suite.scenes.empty()) return fail(ErrorCode::kEmpty, "the suite has no row", name_or_file);
  return suite;
}

}  // namespace layoutbox::experiment
