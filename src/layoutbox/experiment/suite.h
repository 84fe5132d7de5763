// The prompts of an experiment: annotated tables, ours (suites/*.csv) or anybody's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/judge/annotation.h"

namespace layoutbox::experiment {

struct Suite {
  std::string name;
  std::vector<scoring::Annotation> scenes;
};

std::vector<std::string> suite_names();  // of those that are built in

// One of ours by its name, else a table in a file. Errors: kIo, kParse, kSchema; kEmpty where it has no row.
Result<Suite> load_suite(const std::string& name_or_file);

}  // namespace layoutbox::experiment
