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

// The members of the document and of its parts (depth 0 and 1 objects) always stand on lines of their own.
void append(std::string& out, const ordered_json& value, std::size_t indent) {
  std::string flat;
  const bool nested = value.is_structured() && !value.empty();
  if (!nested || indent > 0) {
    append_flat(flat, value);
    const bool one_line = !nested || flat.size() + indent <= kLineLength;
    const bool list_of_objects = value.is_array() && !value.empty() && value.front().is_object();
    if (one_line && !list_of_objects) {
      out += flat;
      return;
    }
  }
  const std::string inner(indent + 2, ' ');
  out += value.is_object() ? "{\n" : "[\n";
  for (auto it = value.begin(); it != value.end(); ++it) {
    if (it != value.begin()) out += ",\n";
    out += inner;
    if (value.is_object()) out += scalar_text(it.key()) + ": ";
    append(out, *it, indent + 2);
  }
  out += '\n' + std::string(indent, ' ') + (value.is_object() ? '}' : ']');
}

}  // namespace

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
  std::string out;
  append(out, value, 0);
  out += '\n';
  return out;
}

}  // namespace layoutbox
