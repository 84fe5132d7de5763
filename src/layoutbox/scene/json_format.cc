#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>

#include "layoutbox/scene/json_text.h"

namespace layoutbox {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kLineLength = 150;

std::string scalar_text(const ordered_json& text) { return text.dump(-1, ' ', false, ordered_json::error_handler_t::replace); }

// As a JSON string; the library is asked where a sign needs more than to be copied.
void append_string(std::string& out, const std::string& text) {
  const bool plain = std::ranges::all_of(text, [](char c) { return c >= ' ' && c < 127 && c != '"' && c != '\\'; });
  if (plain) {
    ((out += '"') += text) += '"';
  } else {
    out += scalar_text(text);
  }
}

void append_key(std::string& out, const std::string& key) {
  append_string(out, key);
  out += ": ";
}

void append_flat(std::string& out, const ordered_json& value) {
  if (value.is_object()) {
    out += '{';
    for (auto it = value.begin(); it != value.end(); ++it) {
      if (it != value.begin()) out += ", ";
      append_key(out, it.key());
      append_flat(out, it.value());
    }
    out += '}';
  } else if (value.is_array()) {
    out += '[';
    for (auto it = value.begin(); it != value.end(); ++it) {
      if (it != value.begin()) out += ", ";
      append_flat(out, *it);
    }
    out += ']';
  } else if (value.is_number_float()) {
    out += format_number(value.get<double>());
  } else if (value.is_string()) {
    append_string(out, value.get_ref<const std::string&>());
  } else {
    out += scalar_text(value);
  }
}

// How deep a value is written one member a line; below that, as much as fits goes on a line.
constexpr std::size_t kOpenDepth = 2;

class Writer {
 public:
  std::string take() { return std::move(out_); }

  void write(const ordered_json& value, std::size_t depth) {
    const bool may_open = value.is_structured() && !value.empty();
    if (may_open && (depth == 0 || is_list_of_objects(value))) return write_open(value, depth);
    flatten(value);
    if (may_open && flat_.size() > room_left()) return write_open(value, depth);
    out_ += flat_;
  }

 private:
  static bool is_list_of_objects(const ordered_json& value) { return value.is_array() && value.front().is_object(); }

  void flatten(const ordered_json& value) {
    flat_.clear();
    append_flat(flat_, value);
  }

  std::size_t column() const {
    const std::size_t line = out_.rfind('\n');
    return line == std::string::npos ? out_.size() : out_.size() - line - 1;
  }
  std::size_t room_left() const { return kLineLength > column() ? kLineLength - column() : 0; }

  void write_open(const ordered_json& value, std::size_t depth) {
    if (value.is_object() && depth >= kOpenDepth)
      write_packed(value, depth);
    else
      write_lines(value, depth);
  }

  void write_lines(const ordered_json& value, std::size_t depth) {
    const std::string indent(2 * (depth + 1), ' ');
    out_ += value.is_object() ? "{\n" : "[\n";
    for (auto it = value.begin(); it != value.end(); ++it) {
      if (it != value.begin()) out_ += ",\n";
      out_ += indent;
      if (value.is_object()) append_key(out_, it.key());
      write(*it, depth + 1);
    }
    out_ += '\n' + std::string(2 * depth, ' ') + (value.is_object() ? '}' : ']');
  }

  // {"id": "bed_1", "category": "bed",
  //  "size": [1.6, 2, 0.5]}
  void write_packed(const ordered_json& object, std::size_t depth) {
    const std::string indent(column() + 1, ' ');
    out_ += '{';
    for (auto it = object.begin(); it != object.end(); ++it) {
      std::string key;
      append_key(key, it.key());
      flatten(*it);
      if (it != object.begin()) {
        out_ += ',';
        if (key.size() + flat_.size() + 2 > room_left())
          out_ += '\n' + indent;
        else
          out_ += ' ';
      }
      out_ += key;
      if (flat_.size() > room_left())
        write(*it, depth + 1);
      else
        out_ += flat_;
    }
    out_ += '}';
  }

  std::string out_;
  std::string flat_;  // a value on one line, while it is asked whether it fits
};

ordered_json object_of(const Error& error) {
  ordered_json json{{"code", error_code_name(error.code)}, {"message", error.message}, {"pointer", error.pointer}, {"hint", error.hint}};
  for (const Error& detail : error.details) json["details"].push_back(object_of(detail));
  return json;
}

}  // namespace

std::string write_error(const Error& error) { return object_of(error).dump(-1, ' ', false, ordered_json::error_handler_t::replace); }

std::string format_number(double value) {
  constexpr double kMostExact = 1e15;
  constexpr std::int64_t kParts = 10000;
  if (!std::isfinite(value)) return "null";
  const double scaled = std::round(value * static_cast<double>(kParts));
  if (std::abs(scaled) > kMostExact) return fmt::format("{:.0f}", value);
  const auto parts = static_cast<std::int64_t>(scaled);
  const std::int64_t whole = std::abs(parts) / kParts, rest = std::abs(parts) % kParts;
  std::string text = (parts < 0 ? "-" : "") + std::to_string(whole);
  if (rest == 0) return text;
  fmt::format_to(std::back_inserter(text), ".{:04}", rest);
  text.erase(text.find_last_not_of('0') + 1);
  return text;
}

std::string format_json(const ordered_json& value) {
  Writer writer;
  writer.write(value, 0);
  return writer.take() + '\n';
}

}  // namespace layoutbox
