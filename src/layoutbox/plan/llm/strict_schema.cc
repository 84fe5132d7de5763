#include "layoutbox/plan/llm/strict_schema.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "layoutbox/embedded/schema.h"
#include "layoutbox/scene/relation_table.h"

namespace layoutbox::llm {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMostItems = 24;
// Without bounds a weak model writes a text to its limit; and patterns are what servers force, lengths are not.
constexpr const char* kIdPattern = "^[A-Za-z0-9_]{1,40}$";
constexpr const char* kTextPattern = "^[A-Za-z0-9 .,:;()'/_%+-]{0,80}$";

bool is_wanted(const Json& part) { return !part.contains("x-model") || part["x-model"] != false; }

class Deriver {
 public:
  explicit Deriver(const Json& root) : root_(root) {}

  Json derive(Json part) const {
    if (const auto reference = part.find("$ref"); reference != part.end()) part = resolved(part, reference->get<std::string>());
    Json out = Json::object();
    if (part.contains("enum")) {
      out["type"] = "string";
      out["enum"] = part["enum"];
    } else {
      const std::string type = type_of(part);
      out["type"] = type;
      if (type == "object") add_members(part, out);
      if (type == "array") add_items(part, out);
      if (type == "string") out["pattern"] = part.contains("minLength") ? kIdPattern : kTextPattern;
      for (const char* bound : {"minimum", "maximum", "exclusiveMinimum"}) {
        if (part.contains(bound)) out[bound] = part[bound];
      }
    }
    if (part.contains("description")) out["description"] = part["description"];
    return out;
  }

 private:
  // What stands beside a reference adds to it.
  Json resolved(const Json& part, const std::string& reference) const {
    Json target = root_.at("definitions").at(reference.substr(reference.rfind('/') + 1));
    for (const auto& [key, value] : part.items()) {
      if (key != "$ref") target[key] = value;
    }
    return target;
  }

  // Of several the one that holds most: a list of ids rather than an id.
  static std::string type_of(const Json& part) {
    const auto type = part.find("type");
    if (type == part.end()) return "string";
    if (type->is_string()) return type->get<std::string>();
    return std::ranges::any_of(*type, [](const Json& one) { return one == "array"; }) ? "array" : type->front().get<std::string>();
  }

  void add_members(const Json& part, Json& out) const {
    out["properties"] = Json::object();
    out["required"] = Json::array();
    const Json required = part.value("required", Json::array());
    for (const auto& [name, member] : part.at("properties").items()) {
      if (!is_wanted(member)) continue;
      Json made = derive(member);
      if (std::ranges::none_of(required, [&](const Json& one) { return one == name; })) allow_null(made);
      out["properties"][name] = std::move(made);
      out["required"].push_back(name);
    }
    out["additionalProperties"] = false;
  }

  void add_items(const Json& part, Json& out) const {
    out["items"] = derive(part.at("items"));
    if (part.contains("minItems")) out["minItems"] = part["minItems"];
    const int most = part.value("x-model-items", std::min(part.value("maxItems", kMostItems), kMostItems));
    out["maxItems"] = most;
  }

  static void allow_null(Json& part) {
    part["type"] = Json::array({part["type"], "null"});
    if (part.contains("enum")) part["enum"].push_back(nullptr);
  }

  const Json& root_;
};

std::string derive_scene() {
  Json root = Json::parse(embedded::scene_schema_json);
  Json& names = root["definitions"]["relationType"]["enum"] = Json::array();
  for (const RelationRow& row : relation_table()) names.push_back(row.name);
  Json whole = root;
  whole.erase("description");
  return Deriver(root).derive(std::move(whole)).dump();
}

}  // namespace

const std::string& strict_scene_schema() {
  static const std::string schema = derive_scene();
  return schema;
}

std::string strict_scene_schema_for(std::size_t objects) {
  constexpr std::size_t kSteps[] = {12, 25, 50};
  for (const std::size_t most : kSteps) {
    if (objects == 0 || 2 * objects + 4 > most) continue;
    Json schema = Json::parse(strict_scene_schema());
    schema["properties"]["furniture"]["maxItems"] = most;
    schema["properties"]["constraints"]["maxItems"] = 2 * most;
    return schema.dump();
  }
  return strict_scene_schema();
}

const std::string& patch_schema() {
  static const std::string schema = [] {
    const Json place{{"type", "string"}, {"pattern", "^/[A-Za-z0-9/_-]{0,80}$"}};
    Json operation{{"type", "object"}};
    operation["properties"] = {{"op", {{"type", "string"}, {"enum", {"add", "remove", "replace", "move", "copy", "test"}}}},
                               {"path", place},
                               {"from", place},
                               {"value", {{"description", "any JSON value"}}}};
    operation["required"] = {"op", "path"};
    Json patch{{"type", "object"}};
    patch["properties"] = {{"patch", {{"type", "array"}, {"items", std::move(operation)}, {"maxItems", 50}}}};
    patch["required"] = {"patch"};
    return patch.dump();
  }();
  return schema;
}

}  // namespace layoutbox::llm
