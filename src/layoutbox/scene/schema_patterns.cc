// What a schema is read for before documents are held to it: its patterns, and that every keyword is known.
#include <regex.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "layoutbox/scene/schema_walk.h"

namespace layoutbox {
namespace {

using nlohmann::json;

constexpr std::string_view kRules[] = {"$ref",
                                       "additionalProperties",
                                       "const",
                                       "enum",
                                       "exclusiveMinimum",
                                       "items",
                                       "maxItems",
                                       "maxLength",
                                       "maximum",
                                       "minItems",
                                       "minLength",
                                       "minProperties",
                                       "minimum",
                                       "oneOf",
                                       "pattern",
                                       "properties",
                                       "propertyNames",
                                       "required",
                                       "type",
                                       "uniqueItems"};
// Say something to people, or hold what references point at.
constexpr std::string_view kRemarks[] = {"$id", "$schema", "components", "default", "definitions", "description", "format", "title"};

// Calls what is given with every schema that stands within one.
void for_each_part(const json& schema, const auto& call) {
  const auto each = [&](const char* key) {
    if (const auto found = schema.find(key); found != schema.end()) {
      for (const json& part : *found) call(part);
    }
  };
  for (const char* map : {"properties", "definitions"}) each(map);
  if (schema.contains("components") && schema["components"].contains("schemas")) {
    for (const json& part : schema["components"]["schemas"]) call(part);
  }
  each("oneOf");
  for (const char* key : {"additionalProperties", "propertyNames", "items"}) {
    if (const auto part = schema.find(key); part != schema.end() && part->is_object()) call(*part);
  }
  if (schema.contains("items") && schema["items"].is_array()) each("items");
}

bool is_known(std::string_view keyword) {
  const auto is_in = [keyword](std::span<const std::string_view> list) { return std::ranges::find(list, keyword) != list.end(); };
  return is_in(kRules) || is_in(kRemarks) || keyword.starts_with("x-");
}

}  // namespace

struct SchemaPatterns::Expression {
  explicit Expression(const std::string& pattern) : good(::regcomp(&compiled, pattern.c_str(), REG_EXTENDED | REG_NOSUB) == 0) {}
  Expression(const Expression&) = delete;
  Expression& operator=(const Expression&) = delete;
  ~Expression() {
    if (good) ::regfree(&compiled);
  }

  ::regex_t compiled{};
  bool good;
};

bool SchemaPatterns::add(const std::string& pattern) {
  auto expression = std::make_shared<const Expression>(pattern);
  if (!expression->good) return false;
  expressions_.emplace(pattern, std::move(expression));
  return true;
}

bool SchemaPatterns::match(const std::string& pattern, const std::string& text) const {
  // A text goes on after a zero byte.
  if (text.find('\0') != std::string::npos) return false;
  return ::regexec(&expressions_.at(pattern)->compiled, text.c_str(), 0, nullptr, 0) == 0;
}

std::string prepare_schema(const json& schema, SchemaPatterns& patterns) {
  if (!schema.is_object()) return "";
  for (const auto& [keyword, rule] : schema.items()) {
    if (!is_known(keyword)) return keyword;
    if (keyword == "pattern" && !patterns.add(rule.get<std::string>())) return rule.get<std::string>();
  }
  std::string fault;
  for_each_part(schema, [&](const json& part) {
    if (fault.empty()) fault = prepare_schema(part, patterns);
  });
  return fault;
}

}  // namespace layoutbox
