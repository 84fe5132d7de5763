#include "layoutbox/scene/schema_words.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "layoutbox/base/utf8.h"

namespace layoutbox {

using nlohmann::json;

std::string type_words(const json& type) {
  const auto one = [](const std::string& name) -> std::string {
    if (name == "object") return "an object {…}";
    if (name == "array") return "a list […]";
    if (name == "integer") return "a whole number";
    if (name == "boolean") return "true or false";
    if (name == "null") return name;
    return "a " + name;
  };
  if (type.is_string()) return one(type.get<std::string>());
  std::string out;
  for (const json& name : type) out += (out.empty() ? "" : " or ") + one(name.get<std::string>());
  return out;
}

std::string value_words(const json& value) {
  constexpr std::size_t kMost = 40;
  if (value.is_object()) return value.empty() ? "an empty object {}" : "an object {…}";
  if (value.is_array() && value.size() > 4) return fmt::format("a list of {} items", value.size());
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  if (text.size() <= kMost) return text;
  return std::string(first_bytes(text, kMost)) + "…";
}

std::string range_hint(const json& schema) {
  std::string hint = "give a number";
  const auto bound = [&](const char* key, std::string_view words) {
    if (schema.contains(key)) hint += fmt::format(" {} {:g}", words, schema[key].get<double>());
  };
  bound("exclusiveMinimum", "above");
  bound("minimum", "of at least");
  if (schema.contains("maximum") && hint != "give a number") hint += " and";
  bound("maximum", "at most");
  if (schema.value("description", "") == "metres") hint += " (metres; if the file is in another unit, say so in metadata.units)";
  return hint;
}

std::string count_hint(const json& schema, const std::string& what, std::string_view noun) {
  const auto least = schema.find("min" + what), most = schema.find("max" + what);
  if (least != schema.end() && most != schema.end() && *least == *most) return fmt::format("give {} {}", least->get<int>(), noun);
  std::string hint = "give";
  if (least != schema.end()) hint += fmt::format(" at least {}", least->get<int>());
  if (most != schema.end()) hint += fmt::format("{} at most {}", least != schema.end() ? " and" : "", most->get<int>());
  return hint + " " + std::string(noun);
}

}  // namespace layoutbox
