// Comma-separated tables as spreadsheets write them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"

namespace layoutbox {

struct CsvRow {
  std::size_t line = 1;  // where it begins in the file
  std::vector<std::string> fields;
};

// The first row is the header. The separator (comma, semicolon or tab) is what the header has most of; fields may be quoted, a quote within
// them doubled. Empty lines are left out. Errors, all at once: kParse with the line: a row with more or fewer fields than the header, a
// quote that is not closed, text after a closing quote.
Result<std::vector<CsvRow>> read_csv(std::string_view text);

}  // namespace layoutbox
