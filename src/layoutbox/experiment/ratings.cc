#include "layoutbox/experiment/ratings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "layoutbox/catalog/csv.h"

namespace layoutbox::experiment {

Result<std::vector<Rating>> read_ratings(std::string_view csv, const std::string& rater) {
  LAYOUTBOX_ASSIGN(const std::vector<CsvRow> rows, read_csv(csv));
  if (rows.size() < 2) return fail(ErrorCode::kEmpty, "the table of ratings has no row", rater);
  const std::vector<std::string>& header = rows.front().fields;
  const auto column = [&](std::string_view name) {
    return static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
  };
  for (const std::string_view name : {"id", "score"}) {
    if (column(name) < header.size()) continue;
    return fail(ErrorCode::kSchema, fmt::format("the table of ratings has no column {}", name), rater,
                "the studio's page for rating (#rate) writes such tables: id,score,kind,reason,prompt");
  }
  const auto field = [&](const CsvRow& row, std::string_view name) {
    const std::size_t at = column(name);
    return at < row.fields.size() ? row.fields[at] : std::string();
  };
  std::vector<Rating> ratings;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::string word = field(rows[i], "score");
    char* end = nullptr;
    const double score = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !(score >= 1 && score <= 10)) {
      return fail(ErrorCode::kParse, fmt::format("\"{}\" is no rating from 1 to 10", word),
                  fmt::format("{}, line {}", rater, rows[i].line));
    }
    ratings.push_back({rater, field(rows[i], "id"), score, field(rows[i], "kind"), field(rows[i], "reason")});
  }
  return ratings;
}

}  // namespace layoutbox::experiment
