#include "layoutbox/plan/llm/loose_json.h"

#include <nlohmann/json.hpp>
#include <string>

#include "layoutbox/scene/json_text.h"

namespace layoutbox::llm {
namespace {

using nlohmann::json;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

// Rewrites the outermost object of a text token by token; ends where its last bracket closes.
class Rewriter {
 public:
  explicit Rewriter(std::string_view text) : text_(text) {}

  std::string run() {
    at_ = text_.find('{');
    if (at_ == std::string_view::npos) return {};
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        copy_text(c);
        continue;
      }
      if (is_comment()) continue;
      if (is_letter(c) || (c == '-' && at_ + 1 < text_.size() && is_letter(text_[at_ + 1]))) {
        copy_word();
        continue;
      }
      if (c == '+') {  // "+1" is no number of JSON
        ++at_;
        continue;
      }
      if (c == '{' || c == '[') open_ += c;
      const bool closes = c == '}' || c == ']';
      if (closes) {
        drop_comma();
        open_.pop_back();
      }
      out_ += c;
      ++at_;
      if (closes && !is_within_item()) whole_ = out_.size(), open_at_whole_ = open_;
      if (open_.empty()) break;
    }
    return out_;
  }

  // After run(): the text up to the last item of a list, or member, that was whole, and closed; empty where it was not cut off, or too
  // soon.
  std::string closed() const {
    if (open_.empty() || whole_ == 0) return {};
    std::string text = out_.substr(0, whole_);
    for (auto bracket = open_at_whole_.rbegin(); bracket != open_at_whole_.rend(); ++bracket) text += *bracket == '{' ? '}' : ']';
    return text;
  }

 private:
  void copy_text(char quote) {
    out_ += '"';
    for (++at_; at_ < text_.size() && text_[at_] != quote; ++at_) {
      const char c = text_[at_];
      if (c == '\\' && at_ + 1 < text_.size()) {
        if (text_[at_ + 1] == '\'') {
          out_ += '\'';
        } else {
          out_ += {c, text_[at_ + 1]};
        }
        ++at_;
      } else if (c == '"') {
        out_ += "\\\"";
      } else if (static_cast<unsigned char>(c) < ' ') {
        out_ += c == '\n' ? "\\n" : " ";
      } else {
        out_ += c;
      }
    }
    out_ += '"';
    ++at_;
  }

  bool is_comment() {
    if (text_.substr(at_, 2) == "//") {
      at_ = std::min(text_.find('\n', at_), text_.size());
      return true;
    }
    if (text_.substr(at_, 2) != "/*") return false;
    const std::size_t end = text_.find("*/", at_ + 2);
    at_ = end == std::string_view::npos ? text_.size() : end + 2;
    return true;
  }

  // A name without quotes where a key is expected, else one of the words that stand for values.
  void copy_word() {
    const std::size_t begin = at_;
    if (text_[at_] == '-') ++at_;
    // The exponent of a number is no word.
    const bool in_number = !out_.empty() && ((out_.back() >= '0' && out_.back() <= '9') || out_.back() == '.');
    while (at_ < text_.size() && (is_letter(text_[at_]) || (text_[at_] >= '0' && text_[at_] <= '9'))) ++at_;
    const std::string_view word = text_.substr(begin, at_ - begin);
    std::size_t next = at_;
    while (next < text_.size() && static_cast<unsigned char>(text_[next]) <= ' ') ++next;
    if (in_number) {
      out_ += word;
    } else if (next < text_.size() && text_[next] == ':') {
      out_ += '"' + std::string(word) + '"';
    } else if (word == "True" || word == "true") {
      out_ += "true";
    } else if (word == "False" || word == "false") {
      out_ += "false";
    } else if (word == "None" || word == "null" || word == "NaN" || word == "undefined" || word == "Infinity" || word == "-Infinity") {
      out_ += "null";
    } else {
      out_ += word;
    }
  }

  void drop_comma() {
    std::size_t end = out_.size();
    while (end > 0 && static_cast<unsigned char>(out_[end - 1]) <= ' ') --end;
    if (end > 0 && out_[end - 1] == ',') out_.resize(end - 1);
  }

  // Is an item of a list open: a thing of which but some members have come?
  bool is_within_item() const {
    const std::size_t list = open_.find('[');
    return list != std::string::npos && list + 1 < open_.size();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string out_;
  std::string open_, open_at_whole_;  // brackets
  std::size_t whole_ = 0;
};

}  // namespace

Result<json> parse_loose_json(std::string_view text, std::vector<Note>& notes) {
  Result<json> strict = parse_json(text);
  if (strict && strict->is_object()) return strict;
  if (strict && strict->is_string()) {  // JSON within a text of JSON
    notes.push_back({"mended", "the scene was wrapped into a text", {}});
    return parse_loose_json(strict->get<std::string>(), notes);
  }
  Result<json> loose = parse_json(Rewriter(text).run());
  if (loose && loose->is_object()) {
    notes.push_back({"mended", "the answer was not quite JSON and was read as it was meant", {}});
    return loose;
  }
  if (!strict) return strict;
  return fail(ErrorCode::kParse, "the answer is no JSON object");
}

Result<json> parse_cut_json(std::string_view text) {
  Rewriter rewriter(text);
  rewriter.run();
  const std::string closed = rewriter.closed();
  if (closed.empty()) return fail(ErrorCode::kParse, "nothing of the answer is whole");
  return parse_json(closed);
}

}  // namespace layoutbox::llm
