#include "layoutbox/catalog/csv.h"

#include <fmt/format.h>

#include <algorithm>

#include "layoutbox/scene/scene_check.h"

namespace layoutbox {
namespace {

char separator_of(std::string_view text) {
  const std::string_view header = text.substr(0, text.find('\n'));
  char best = ',';
  for (const char candidate : {';', '\t'}) {
    if (std::ranges::count(header, candidate) > std::ranges::count(header, best)) best = candidate;
  }
  return best;
}

std::string trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return std::string(text);
}

class CsvReader {
 public:
  explicit CsvReader(std::string_view text) : text_(text), separator_(separator_of(text)) {}

  Result<std::vector<CsvRow>> read() {
    while (place_ < text_.size()) {
      const std::size_t errors_before = errors_.size();
      CsvRow row = read_row();
      if (errors_.size() != errors_before) continue;
      if (row.fields.size() == 1 && row.fields[0].empty()) continue;
      if (!rows_.empty() && row.fields.size() != rows_[0].fields.size()) {
        add_error(row.line, fmt::format("{} fields where the header has {}", row.fields.size(), rows_[0].fields.size()),
                  "put a field with a separator in it in quotes");
        continue;
      }
      rows_.push_back(std::move(row));
    }
    if (!errors_.empty()) return Failure(combined(std::move(errors_)));
    return std::move(rows_);
  }

 private:
  CsvRow read_row() {
    CsvRow row{line_, {}};
    do row.fields.push_back(read_field());
    while (take(separator_));
    take('\r');
    if (place_ < text_.size() && !take('\n')) {
      add_error(line_, fmt::format("'{}' stands after a closing quote", text_[place_]), "double the quotes within a quoted field");
      place_ = std::min(text_.find('\n', place_), text_.size());
      take('\n');
    }
    ++line_;
    return row;
  }

  std::string read_field() {
    while (place_ < text_.size() && text_[place_] == ' ') ++place_;
    if (!take('"')) {
      const std::size_t begin = place_;
      while (place_ < text_.size() && text_[place_] != separator_ && text_[place_] != '\n' && text_[place_] != '\r') ++place_;
      return trimmed(text_.substr(begin, place_ - begin));
    }
    std::string field;
    const std::size_t opened = line_;
    for (;;) {
      if (place_ == text_.size()) {
        add_error(opened, "a quote is opened and not closed", "close it, or double a quote that is part of the text");
        return field;
      }
      if (take('"')) {
        if (!take('"')) break;
        field += '"';
        continue;
      }
      if (text_[place_] == '\n') ++line_;
      field += text_[place_++];
    }
    while (place_ < text_.size() && text_[place_] == ' ') ++place_;
    return field;
  }

  bool take(char c) {
    if (place_ == text_.size() || text_[place_] != c) return false;
    ++place_;
    return true;
  }

  void add_error(std::size_t line, std::string message, std::string hint) {
    constexpr std::size_t kMostErrors = 100;
    if (errors_.size() < kMostErrors) {
      errors_.push_back({ErrorCode::kParse, fmt::format("line {}: {}", line, message), fmt::format("line {}", line), std::move(hint), {}});
    }
  }

  std::string_view text_;
  char separator_;
  std::size_t place_ = 0, line_ = 1;
  std::vector<CsvRow> rows_;
  std::vector<Error> errors_;
};

}  // namespace

Result<std::vector<CsvRow>> read_csv(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return CsvReader(text).read();
}

}  // namespace layoutbox
