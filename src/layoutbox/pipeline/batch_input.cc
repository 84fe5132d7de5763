#include "layoutbox/pipeline/batch_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/csv.h"
#include "layoutbox/catalog/room_size.h"
#include "layoutbox/scene/json_text.h"

namespace layoutbox {
namespace {

constexpr std::size_t kMostLines = 1'000'000;
constexpr std::size_t kLongestId = 200;  // bytes; file systems allow 255
constexpr std::string_view kKeys = "id, prompt, type, room, units, seed, effort";

// A line as words: key → value, both as text. JSON and tables meet here.
using Fields = std::map<std::string, std::string>;

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

Status check_id(const std::string& id) {
  const auto is_bad = [](unsigned char c) { return c < 0x20 || c == 0x7F || c == '/' || c == '\\'; };
  const bool bad = id.empty() || id.size() > kLongestId || id.front() == '.' || std::any_of(id.begin(), id.end(), is_bad);
  if (!bad && id != "summary.json") return {};
  return fail(ErrorCode::kUsage, fmt::format("the id '{}' cannot be the name of a folder", id.substr(0, 60)), "id",
              "use letters, digits, '-' and '_', no '/', no '.' in front, at most 200 bytes");
}

template <class T>
Result<T> whole_number(const std::string& text, const char* name) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    return fail(ErrorCode::kUsage, fmt::format("'{}' is not a whole number", text), name);
  }
  return value;
}

// Keys as people write them in tables.
std::string key_for(std::string_view word) {
  const std::string key = key_of(word);
  return key == "text" || key == "description" ? "prompt" : key;
}

std::string take(Fields& fields, const char* key) {
  const auto found = fields.find(key);
  if (found == fields.end()) return {};
  std::string value = std::move(found->second);
  fields.erase(found);
  return value;
}

Status fill(Fields fields, BatchLine& line) {
  const std::string id = take(fields, "id");
  if (!id.empty()) line.id = id;
  LAYOUTBOX_CHECK(check_id(line.id));
  line.prompt = take(fields, "prompt");
  const std::string type = take(fields, "type");
  const std::string room = take(fields, "room"), units = take(fields, "units");
  const std::string seed = take(fields, "seed"), effort = take(fields, "effort");
  if (!fields.empty()) {
    return fail(ErrorCode::kSchema, fmt::format("there is no option '{}' of a line", fields.begin()->first), fields.begin()->first,
                fmt::format("use {}", kKeys));
  }
  if (is_blank(line.prompt) == type.empty()) {
    return fail(ErrorCode::kEmpty, type.empty() ? "there is nothing in the prompt" : "a prompt and a type exclude one another", "prompt",
                "say what the room is like, or its type");
  }
  if (!type.empty()) line.prompt = fmt::format("A {}.", type);
  if (!room.empty()) {
    LAYOUTBOX_ASSIGN(line.room_size, parse_room_size(room, units));
  }
  if (!seed.empty()) {
    LAYOUTBOX_ASSIGN(line.seed, whole_number<std::uint64_t>(seed, "seed"));
  }
  if (!effort.empty()) {
    LAYOUTBOX_ASSIGN(line.effort, whole_number<std::int64_t>(effort, "effort"));
    if (*line.effort < 1 || *line.effort > 10'000'000) return fail(ErrorCode::kUsage, "effort lies between 1 and 10000000", "effort");
  }
  return {};
}

Result<Fields> fields_of(const nlohmann::json& object) {
  if (!object.is_object()) return fail(ErrorCode::kSchema, "the line is no JSON object", {}, R"(write {"id": "1", "prompt": "A bedroom"})");
  Fields fields;
  for (const auto& [key, value] : object.items()) {
    if (value.is_null()) continue;
    if (!value.is_string() && !value.is_number()) {
      return fail(ErrorCode::kSchema, fmt::format("'{}' is neither text nor a number", key), key);
    }
    // An empty cell of a table is nothing said; here somebody wrote it. An empty prompt has a sentence of its own.
    const bool empty = value.is_string() && value.get_ref<const std::string&>().empty();
    if (empty && key_for(key) != "prompt")
      return fail(ErrorCode::kSchema, fmt::format("'{}' is empty", key), key, "give it a value or leave it out");
    fields[key] = value.is_string() ? value.get<std::string>() : value.dump();
  }
  return fields;
}

Result<Fields> fields_of_line(std::string_view text) {
  LAYOUTBOX_ASSIGN(const nlohmann::json object, parse_json(text));
  return fields_of(object);
}

class BatchReader {
 public:
  Result<std::vector<BatchLine>> read(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    const std::string_view first = first_line(text);
    if (first.empty())
      return fail(ErrorCode::kEmpty, "there is no prompt", {}, R"(write a line {"id": "1", "prompt": "A bedroom"} a room)");
    if (first.front() == '{') {
      LAYOUTBOX_CHECK(each_line(text, [this](std::size_t number, std::string_view line) { add(number, fields_of_line(line)); }));
    } else if (const auto list = parse_json(text); first.front() == '[' && list && list->is_array()) {
      LAYOUTBOX_CHECK(read_list(*list));
    } else if (is_header(first)) {
      LAYOUTBOX_CHECK(read_table(text));
    } else {
      LAYOUTBOX_CHECK(each_line(text, [this](std::size_t number, std::string_view line) {
        add(number, Fields{{"prompt", std::string(line)}});
      }));
    }
    return std::move(lines_);
  }

 private:
  static std::string_view first_line(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return {};
    return trimmed(text.substr(begin, text.find('\n', begin) - begin));
  }

  // Is this the first line of a table? One of its cells names the prompts, and there is another.
  static bool is_header(std::string_view line) {
    bool found = false;
    std::size_t cells = 0;
    for (std::size_t at = 0; at <= line.size(); ++cells) {
      const std::size_t end = std::min(line.find_first_of(",;\t", at), line.size());
      found = found || key_for(line.substr(at, end - at)) == "prompt";
      at = end + 1;
    }
    return found && (cells > 1 || line.find(' ') == std::string_view::npos);
  }

  template <class Function>
  Status each_line(std::string_view text, const Function& function) {
    std::size_t number = 0;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      ++number;
      if (const std::string_view line = trimmed(text.substr(at, end - at)); !line.empty()) function(number, line);
      at = end + 1;
      if (lines_.size() > kMostLines) return fail(ErrorCode::kTooLarge, fmt::format("there are more than {} prompts", kMostLines));
    }
    return {};
  }

  // A JSON list of objects as on lines, or of prompts; what is wrong is named by its number in the list.
  Status read_list(const nlohmann::json& list) {
    if (list.empty()) return fail(ErrorCode::kEmpty, "there is no prompt", {}, R"(write [{"id": "1", "prompt": "A bedroom"}])");
    if (list.size() > kMostLines) return fail(ErrorCode::kTooLarge, fmt::format("there are more than {} prompts", kMostLines));
    for (std::size_t i = 0; i < list.size(); ++i) {
      add(i + 1, list[i].is_string() ? Result<Fields>(Fields{{"prompt", list[i].get<std::string>()}}) : fields_of(list[i]));
    }
    return {};
  }

  Status read_table(std::string_view text) {
    LAYOUTBOX_ASSIGN(const std::vector<CsvRow> rows, read_csv(text));
    if (rows.size() > kMostLines) return fail(ErrorCode::kTooLarge, fmt::format("there are more than {} prompts", kMostLines));
    const std::vector<std::string>& header = rows.front().fields;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      Fields fields;
      for (std::size_t k = 0; k < header.size(); ++k) {
        const std::string key = key_for(header[k]);
        if (kKeys.find(key) == std::string_view::npos) continue;  // tables carry columns for other purposes
        if (!rows[i].fields[k].empty()) fields.emplace(key, rows[i].fields[k]);
      }
      add(rows[i].line, std::move(fields));
    }
    return {};
  }

  void add(std::size_t number, Result<Fields> fields) {
    BatchLine line;
    line.line = number;
    line.id = fmt::format("{:04}", lines_.size() + 1);
    const Status filled = fields ? fill(*std::move(fields), line) : Status(Failure(std::move(fields).error()));
    if (!filled) {
      line.error = filled.error();
    } else if (const auto [earlier, is_new] = ids_.emplace(line.id, number); !is_new) {
      line.error = Error{ErrorCode::kReference,
                         fmt::format("the id '{}' is that of line {} already", line.id, earlier->second),
                         "id",
                         "give every line an id of its own",
                         {}};
    }
    lines_.push_back(std::move(line));
  }

  std::vector<BatchLine> lines_;
  std::map<std::string, std::size_t> ids_;
};

}  // namespace

Result<std::vector<BatchLine>> read_batch(std::string_view text) { return BatchReader().read(text); }

}  // namespace layoutbox
