#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "layoutbox/base/utf8.h"
#include "layoutbox/scene/json_text.h"

namespace layoutbox {
namespace {

using nlohmann::json;

std::string line_and_column(std::string_view text, std::size_t byte) {
  byte = std::min(byte, text.size());
  const std::string_view before = text.substr(0, byte);
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const std::size_t line_begin = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  // Columns count characters, not the bytes of UTF-8.
  const auto column = characters_in(before.substr(line_begin));
  return fmt::format("line {}, column {}", lines + 1, std::max<std::size_t>(column, 1));
}

std::string shortened(std::string_view token) {
  constexpr std::size_t kMost = 30;
  std::string out;
  for (const char c : token.substr(0, kMost)) {
    // Whatever is not plain ASCII may have been cut in the middle of a character.
    out += static_cast<unsigned char>(c) >= 0x20 && static_cast<unsigned char>(c) < 0x7F ? c : '?';
  }
  return token.size() > kMost ? out + "…" : out;
}

// Builds the document, and stops at what plain JSON allows and we do not.
class DocumentBuilder : public nlohmann::json_sax<json> {
 public:
  explicit DocumentBuilder(std::string_view text) : text_(text) {}

  json take() { return std::move(root_); }
  Error take_error() { return std::move(error_); }

  bool null() override { return put(nullptr); }
  bool boolean(bool value) override { return put(value); }
  bool number_integer(number_integer_t value) override { return put(value); }
  bool number_unsigned(number_unsigned_t value) override { return put(value); }
  bool number_float(number_float_t value, const string_t&) override { return put(value); }
  bool string(string_t& value) override { return put(std::move(value)); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(json::object()); }
  bool start_array(std::size_t) override { return open(json::array()); }
  bool end_array() override { return close(); }
  bool end_object() override {
    keys_.pop_back();
    return close();
  }
  bool key(string_t& name) override {
    key_ = name;
    if (keys_.back().insert(name).second) return true;
    error_ = {
        ErrorCode::kParse, fmt::format("the key \"{}\" is given twice in one object", name), pointer_to(name), "keep one of them", {}};
    return false;
  }

  bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception& exception) override {
    std::string what = exception.what();
    // "[json.exception.parse_error.101] parse error at line 1, column 5: syntax error while parsing value - invalid literal; last read:
    // 'xx'"
    if (const std::size_t dash = what.find(" - "); dash != std::string::npos)
      what = what.substr(dash + 3);
    else if (const std::size_t bracket = what.find("] "); bracket != std::string::npos)
      what = what.substr(bracket + 2);
    if (const std::size_t last = what.find("; last read"); last != std::string::npos) what.resize(last);
    std::string hint = "correct the file at that place";
    if (position >= text_.size() && exception.id == 101) hint = "the text ends too early: is the file complete?";
    const std::string near = std::string(text_.substr(position > 9 ? position - 9 : 0, 18));
    if (near.find("NaN") != std::string::npos || near.find("nan") != std::string::npos || near.find("Infinity") != std::string::npos) {
      what = "NaN and Infinity are no JSON numbers";
      hint = "write a number, or null where there is none";
    } else if (exception.id == 406) {
      what = fmt::format("the number {} is too large", shortened(token));
      hint = "write a number of metres";
    }
    error_ = {ErrorCode::kParse, fmt::format("not valid JSON at {}: {}", line_and_column(text_, position), what), {}, std::move(hint), {}};
    return false;
  }

 private:
  bool put(json value) {
    if (open_.empty())
      root_ = std::move(value);
    else if (open_.back()->is_array())
      open_.back()->push_back(std::move(value));
    else
      (*open_.back())[key_] = std::move(value);
    return true;
  }

  bool open(json value) {
    if (open_.size() >= static_cast<std::size_t>(kDeepestJson)) {
      error_ = {ErrorCode::kParse,
                fmt::format("objects and lists are nested more than {} deep", kDeepestJson),
                {},
                "no scene or layout needs that",
                {}};
      return false;
    }
    const bool is_object = value.is_object();
    if (open_.empty()) {
      root_ = std::move(value);
      open_.push_back(&root_);
    } else if (open_.back()->is_array()) {
      open_.back()->push_back(std::move(value));
      open_.push_back(&open_.back()->back());
    } else {
      json& place = (*open_.back())[key_];
      place = std::move(value);
      path_.push_back(key_);
      open_.push_back(&place);
      if (is_object) keys_.emplace_back();
      return true;
    }
    path_.push_back(open_.size() > 1 ? std::to_string(open_[open_.size() - 2]->size() - 1) : std::string());
    if (is_object) keys_.emplace_back();
    return true;
  }

  bool close() {
    open_.pop_back();
    path_.pop_back();
    return true;
  }

  std::string pointer_to(const std::string& name) const {
    std::string pointer;
    for (std::size_t i = 1; i < path_.size(); ++i) pointer += "/" + path_[i];
    return pointer + "/" + name;
  }

  std::string_view text_;
  json root_;
  std::vector<json*> open_;        // pointers stay valid: a parent grows only after its child is closed
  std::vector<std::string> path_;  // the key or index of each open value
  std::vector<std::set<std::string>> keys_;
  std::string key_;
  Error error_;
};

}  // namespace

Result<json> parse_json(std::string_view text) {
  if (text.size() > kLongestJson) {
    return fail(ErrorCode::kTooLarge, fmt::format("the document has {} bytes; at most {} are read", text.size(), kLongestJson));
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return fail(ErrorCode::kParse, "the document is empty", {}, "give a JSON object");
  }
  DocumentBuilder builder(text);
  if (!json::sax_parse(text, &builder)) return Failure(builder.take_error());
  return builder.take();
}

}  // namespace layoutbox
