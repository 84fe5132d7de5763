#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "layoutbox/base/words.h"
#include "layoutbox/embedded/schema.h"
#include "layoutbox/plan/llm/mend.h"
#include "layoutbox/scene/quirks.h"
#include "layoutbox/scene/relation_table.h"

namespace layoutbox::llm {
namespace {

using nlohmann::json;

// "1.6", "1.6 m", "160cm" → metres.
std::optional<double> number_from(std::string_view text) {
  const char* const end = text.data() + text.size();
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{}) return std::nullopt;
  std::string_view unit(stop, static_cast<std::size_t>(end - stop));
  while (unit.starts_with(' ')) unit.remove_prefix(1);
  while (unit.ends_with(' ')) unit.remove_suffix(1);
  if (unit.empty() || unit == "deg" || unit == "degrees" || unit == "°") return value;
  const auto metres = metres_per_unit(unit);
  return metres ? std::optional(value * *metres) : std::nullopt;
}

class SchemaMender {
 public:
  SchemaMender(const json& root, Notes& notes) : root_(root), notes_(notes) {}

  // False: the value is wrong and cannot be mended.
  bool mend(const json& written, json& value, const std::string& at) {
    const json& schema = resolved(written);
    if (schema.contains("enum")) return mend_enum(schema, value, at);
    if (value.is_object() && allows(schema, "object") && schema.contains("properties")) return mend_object(schema, value, at);
    if (value.is_array() && allows(schema, "array")) return mend_list(schema, value, at);
    if (allows(schema, "number") || allows(schema, "integer")) return mend_number(schema, value, at);
    if (value.is_number() && allows(schema, "string")) {
      value = value.dump();
      return true;
    }
    if (value.is_string() && allows(schema, "array") && !allows(schema, "string")) value = json::array({value});
    return is_of_type(schema, value);
  }

 private:
  const json& resolved(const json& schema) const {
    const auto reference = schema.find("$ref");
    if (reference == schema.end()) return schema;
    const std::string text = reference->get<std::string>();
    return root_.at("definitions").at(text.substr(text.rfind('/') + 1));
  }

  static bool allows(const json& schema, std::string_view type) {
    const auto written = schema.find("type");
    if (written == schema.end()) return false;
    if (written->is_string()) return *written == type;
    return std::ranges::any_of(*written, [&](const json& one) { return one == type; });
  }

  static bool is_of_type(const json& schema, const json& value) {
    if (!schema.contains("type")) return true;
    return (value.is_string() && allows(schema, "string")) || (value.is_boolean() && allows(schema, "boolean")) ||
           (value.is_array() && allows(schema, "array")) || (value.is_object() && allows(schema, "object"));
  }

  void note(std::string message, const std::string& at) { notes_.push_back({"mended", std::move(message), at}); }

  bool mend_enum(const json& schema, json& value, const std::string& at) {
    const json& choices = schema.at("enum");
    if (std::ranges::find(choices, value) != choices.end()) return true;
    if (!value.is_string()) return false;
    const std::string text = value.get<std::string>();
    std::vector<std::string> names;
    for (const json& choice : choices) names.push_back(choice.get<std::string>());
    std::string meant;
    for (const std::string& name : names) {
      if (same_name(name, text)) meant = name;
    }
    if (meant.empty()) meant = nearest_word(text, names);
    if (meant.empty()) return false;
    note(fmt::format("\"{}\" is read as \"{}\"", text.substr(0, 40), meant), at);
    value = meant;
    return true;
  }

  bool mend_object(const json& schema, json& value, const std::string& at) {
    const json& members = schema.at("properties");
    rename_members(schema, members, value, at);
    const json required = schema.value("required", json::array());
    std::vector<std::string> wrong;
    for (auto& [key, member] : value.items()) {
      if (!members.contains(key)) {
        if (schema.value("additionalProperties", true) == false) wrong.push_back(key);
        continue;
      }
      const bool good = mend(members.at(key), member, at + "/" + key);
      const bool needed = std::ranges::any_of(required, [&](const json& name) { return name == key; });
      if (!good && !needed) wrong.push_back(key);  // what is needed and wrong is a fault for the model
    }
    for (const std::string& key : wrong) {
      const std::string text = value[key].dump(-1, ' ', false, json::error_handler_t::replace);
      note(fmt::format("\"{}\": {} is left out", key.substr(0, 40), text.size() > 40 ? "…" : text), at);
      value.erase(key);
    }
    return true;
  }

  // roomType for room_type; the nearest of the names that are not there yet.
  void rename_members(const json& schema, const json& members, json& value, const std::string& at) {
    if (schema.value("additionalProperties", true) != false) return;
    std::vector<std::string> missing, unknown;
    for (const auto& [name, member] : members.items()) {
      if (!value.contains(name)) missing.push_back(name);
    }
    for (const auto& [key, member] : value.items()) {
      if (!members.contains(key)) unknown.push_back(key);
    }
    for (const std::string& key : unknown) {
      std::string meant;
      for (const std::string& name : missing) {
        if (same_name(name, key)) meant = name;
      }
      if (meant.empty() && key.size() > 3) meant = nearest_word(key, missing);
      if (meant.empty()) continue;
      note(fmt::format("\"{}\" is read as \"{}\"", key.substr(0, 40), meant), at);
      value[meant] = value[key];
      value.erase(key);
      std::erase(missing, meant);
    }
  }

  bool mend_list(const json& schema, json& value, const std::string& at) {
    bool good = true;
    if (schema.contains("items")) {
      for (std::size_t i = 0; i < value.size(); ++i) good = mend(schema.at("items"), value[i], fmt::format("{}/{}", at, i)) && good;
    }
    const bool too_few = schema.contains("minItems") && value.size() < schema["minItems"].get<std::size_t>();
    const bool too_many = schema.contains("maxItems") && value.size() > schema["maxItems"].get<std::size_t>();
    // Of a list of things each can be judged by itself; of a point, a colour, a range every part is needed.
    const bool fixed = schema.contains("minItems") && schema.contains("maxItems") && schema["minItems"] == schema["maxItems"];
    return fixed ? good && !too_few && !too_many : !too_many;
  }

  bool mend_number(const json& schema, json& value, const std::string& at) {
    if (value.is_string()) {
      const auto number = number_from(value.get_ref<const std::string&>());
      if (!number) return false;
      note(fmt::format("{} is read as the number {:g}", value.dump(), *number), at);
      value = *number;
    }
    if (!value.is_number()) return false;
    const double number = value.get<double>();
    if (allows(schema, "integer") && !allows(schema, "number") && value.is_number_float()) value = std::llround(number);
    if (schema.contains("minimum") && number < schema["minimum"].get<double>()) return false;
    if (schema.contains("maximum") && number > schema["maximum"].get<double>()) return false;
    return !schema.contains("exclusiveMinimum") || number > schema["exclusiveMinimum"].get<double>();
  }

  const json& root_;
  Notes& notes_;
};

const json& scene_schema() {
  static const json schema = [] {
    json parsed = json::parse(embedded::scene_schema_json);
    json& names = parsed["definitions"]["relationType"]["enum"] = json::array();
    for (const RelationRow& row : relation_table()) names.push_back(row.name);
    return parsed;
  }();
  return schema;
}

}  // namespace

void mend_by_schema(json& scene, Notes& notes) {
  if (scene.is_object())
    (void)SchemaMender(scene_schema(), notes).mend(scene_schema(), scene, "");  // what stays wrong is found by validation
}

}  // namespace layoutbox::llm
