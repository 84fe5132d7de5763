#include "layoutbox/scene/schema_check.h"

#include <fmt/format.h>

#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

#include "layoutbox/embedded/schema.h"
#include "layoutbox/scene/relation_table.h"
#include "layoutbox/scene/schema_walk.h"

namespace layoutbox {
namespace {

using nlohmann::json;

constexpr std::string_view kSceneFile = "scene.schema.json";

// References to the scene schema, and where `own` those within it, become references to `definitions/scene.NAME`, where the layout's
// schema takes its definitions in.
void redirect_references(json& node, bool own) {
  constexpr std::string_view kDefinitions = "#/definitions/";
  if (node.is_object()) {
    if (const auto found = node.find("$ref"); found != node.end() && found->is_string()) {
      std::string_view text = found->get_ref<const std::string&>();
      const bool other = text.starts_with(kSceneFile);
      if (other) text.remove_prefix(kSceneFile.size());
      if (other || own) *found = std::string(kDefinitions) + "scene." + std::string(text.substr(kDefinitions.size()));
    }
  }
  for (json& child : node) {
    if (child.is_structured()) redirect_references(child, own);
  }
}

// The scene schema as in the file, with the names of relations from the table itself.
json scene_schema() {
  json schema = json::parse(embedded::scene_schema_json);
  json& names = schema["definitions"]["relationType"]["enum"] = json::array();
  for (const RelationRow& row : relation_table()) names.push_back(row.name);
  return schema;
}

json schema_document(SchemaName name) {
  switch (name) {
    case SchemaName::kScene: return scene_schema();
    case SchemaName::kCatalog: return json::parse(embedded::catalog_schema_json);
    case SchemaName::kLayout: break;
  }
  json layout = json::parse(embedded::layout_schema_json);
  json shared = scene_schema().at("definitions");
  redirect_references(layout, false);
  redirect_references(shared, true);
  for (const auto& [key, definition] : shared.items()) layout["definitions"]["scene." + key] = definition;
  layout.erase("$id");
  return layout;
}

// Compiled once for each schema and entry point.
const JsonSchema& loaded_schema(SchemaName name, std::string_view at) {
  static std::mutex mutex;
  static std::map<std::pair<SchemaName, std::string>, JsonSchema> cache;
  const std::lock_guard lock(mutex);
  if (const auto found = cache.find({name, std::string(at)}); found != cache.end()) return found->second;
  json document = schema_document(name);
  document.erase("$id");
  if (!at.empty()) {
    json part = document.at("definitions").at(std::string(at));
    part["definitions"] = document.at("definitions");
    document = std::move(part);
  }
  return cache.emplace(std::pair{name, std::string(at)}, JsonSchema(std::move(document))).first->second;
}

}  // namespace

struct JsonSchema::Compiled {
  json document;
  SchemaPatterns patterns;
  std::string fault;  // of the schema itself
};

JsonSchema::JsonSchema(json schema) : compiled_(std::make_unique<Compiled>()) {
  compiled_->document = std::move(schema);
  compiled_->fault = prepare_schema(compiled_->document, compiled_->patterns);
}

JsonSchema::JsonSchema(JsonSchema&&) noexcept = default;
JsonSchema& JsonSchema::operator=(JsonSchema&&) noexcept = default;
JsonSchema::~JsonSchema() = default;

std::vector<Error> JsonSchema::check(const json& document) const {
  if (!compiled_->fault.empty())
    return {{ErrorCode::kInternal, fmt::format("the schema says \"{}\", which nothing here reads", compiled_->fault), {}, {}, {}}};
  return walk_schema(compiled_->document, compiled_->patterns, document);
}

std::vector<Error> check_against_schema(const json& document, SchemaName name, std::string_view at) {
  try {
    return loaded_schema(name, at).check(document);
  } catch (const std::exception& error) {
    return {{ErrorCode::kInternal, fmt::format("the schema check failed: {}", error.what()), {}, {}, {}}};
  }
}

}  // namespace layoutbox
