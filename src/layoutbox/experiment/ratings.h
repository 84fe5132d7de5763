// What people say of rooms: the tables that the studio's rating page gives (docs/studio.md).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"

namespace layoutbox::experiment {

struct Rating {
  std::string rater, room;  // the file, and the room's id in it
  double score = 0;         // 1 to 10
  std::string kind = {}, reason = {};
};

// A table with the columns id and score; kind and reason may be there. Errors: kParse, kSchema (a column is missing), kEmpty.
Result<std::vector<Rating>> read_ratings(std::string_view csv, const std::string& rater);

}  // namespace layoutbox::experiment
