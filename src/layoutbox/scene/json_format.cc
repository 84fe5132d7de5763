#include <cmath>
#include <nlohmann/json.hpp>

#include "layoutbox/scene/json_text.h"

namespace layoutbox {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kLineLength = 150;

std::string scalar_text(const ordered_json& text) { return text.dump(-1, ' ', false, ordered_json::error_handler_t::replace); }

void append_flat(std::string& out, const ordered_json& value) {
  if (value.is_object()) {
    out += '{';
    for (auto it = value.begin(); it != value.end(); ++it) {
      if (it != value.begin()) out += ", ";
      out += scalar_text(it.key()) + ": ";
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
    const bool open =
        value.is_structured() && !value.empty() && (depth == 0 || is_list_of_objects(value) || flat_length(value) > room_left());
    if (!open)
      append_flat(out_, value);
    else if (value.is_object() && depth >= kOpenDepth)
      write_packed(value, depth);
    else
      write_lines(value, depth);
  }

 private:
  static bool is_list_of_objects(const ordered_json& value) { return value.is_array() && value.front().is_object(); }

  static std::size_t flat_length(const ordered_json& value) {
    std::string flat;
    append_flat(flat, value);
    return flat.size();
  }

  std::size_t column() const {
    const std::size_t line = out_.rfind('\n');
    return line == std::string::npos ? out_.size() : out_.size() - line - 1;
  }
  std::size_t room_left() const { return kLineLength > column() ? kLineLength - column() : 0; }

  void write_lines(const ordered_json& value, std::size_t depth) {
    const std::string indent(2 * (depth + 1), ' ');
    out_ += value.is_object() ? "{\n" : "[\n";
    for (auto it = value.begin(); it != value.end(); ++it) {
      if (it != value.begin()) out_ += ",\n";
      out_ += indent;
      if (value.is_object()) out_ += scalar_text(it.key()) + ": ";
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
      const std::string key = scalar_text(it.key()) + ": ";
      if (it != object.begin()) {
        out_ += ',';
        if (key.size() + flat_length(*it) + 2 > room_left())
          out_ += '\n' + indent;
        else
          out_ += ' ';
      }
      out_ += key;
      if (flat_length(*it) > room_left())
        write(*it, depth + 1);
      else
        append_flat(out_, *it);
    }
    out_ += '}';
  }

  std::string out_;
};

ordered_json object_of(const Error& error) {
  ordered_json json{{"code", error_code_name(error.code)}, {"message", error.message}, {"pointer", error.pointer}, {"hint", error.hint}};
  for (const Error& detail : error.details) json["details"].push_back(object_of(detail));
  return json;
}

}  // namespace

std::string write_error(const Error& error) { return object_of(error).dump(-1, ' ', false, ordered_json::error_handler_t::replace); }

std::string format_number(double value) {
  if (!std::isfinite(value)) return "null";
  char text[64];
  const double rounded = std::round(value * 1e4) / 1e4;
  int length = std::snprintf(text, sizeof text, "%.4f", rounded == 0 ? 0.0 : rounded);
  if (length < 0 || length >= static_cast<int>(sizeof text)) return std::to_string(value);
  while (text[length - 1] == '0') --length;
  if (text[length - 1] == '.') --length;
  return {text, static_cast<std::size_t>(length)};
}

std::string format_json(const ordered_json& value) {
  Writer writer;
  writer.write(value, 0);
  return writer.take() + '\n';
}

}  // namespace layoutbox
