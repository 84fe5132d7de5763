#include "layoutbox/scene/schema_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "layoutbox/base/words.h"
#include "layoutbox/embedded/schema.h"
#include "layoutbox/scene/relation_table.h"

namespace layoutbox {
namespace {

using nlohmann::json;

constexpr std::string_view kSceneFile = "scene.schema.json";

// References to the scene schema become references into `definitions/scene.schema.json`, where bundled() puts its definitions.
void redirect_references(json& node, std::string_view own_prefix) {
  if (node.is_object()) {
    if (const auto found = node.find("$ref"); found != node.end() && found->is_string()) {
      std::string text = found->get<std::string>();
      if (text.starts_with(kSceneFile))
        text = "#/definitions/" + std::string(kSceneFile) + text.substr(kSceneFile.size() + std::string_view("#/definitions").size());
      else if (!own_prefix.empty())
        text = std::string(own_prefix) + text.substr(std::string_view("#/definitions").size());
      *found = text;
    }
  }
  for (json& child : node) {
    if (child.is_structured()) redirect_references(child, own_prefix);
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
  redirect_references(layout, {});
  redirect_references(shared, "#/definitions/" + std::string(kSceneFile));
  layout["definitions"][std::string(kSceneFile)] = std::move(shared);
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

const json& resolved(const json& root, const json& node) {
  const json* current = &node;
  for (int step = 0; step < 10 && current->is_object() && current->contains("$ref"); ++step) {
    current = &root.at(json::json_pointer(current->at("$ref").get<std::string>().substr(1)));
  }
  return *current;
}

// The schema of one member or item, or null where the schema does not say.
const json* step_into(const json& root, const json& node, const std::string& key, bool is_index) {
  const json& schema = resolved(root, node);
  if (!schema.is_object()) return nullptr;
  if (is_index) {
    const auto items = schema.find("items");
    if (items == schema.end()) return nullptr;
    if (items->is_object()) return &*items;
    const std::size_t index = std::stoul(key);
    return index < items->size() ? &(*items)[index] : nullptr;
  }
  if (const auto properties = schema.find("properties"); properties != schema.end() && properties->contains(key))
    return &properties->at(key);
  const auto additional = schema.find("additionalProperties");
  return additional != schema.end() && additional->is_object() ? &*additional : nullptr;
}

std::string type_words(const json& type) {
  const auto one = [](const std::string& name) -> std::string {
    if (name == "object") return "an object {…}";
    if (name == "array") return "a list […]";
    if (name == "integer") return "a whole number";
    if (name == "boolean") return "true or false";
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
  std::size_t cut = kMost;
  while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0) == 0x80) --cut;
  return text.substr(0, cut) + "…";
}

// Says what is wrong with one value by one violation that the validator found.
class Explainer {
 public:
  Explainer(const json& root, const json& schema, const json& value, std::string pointer)
      : root_(root), schema_(resolved(root, schema)), value_(value), pointer_(std::move(pointer)) {}

  void explain(const std::string& description, std::vector<Error>& errors) const {
    const auto begins = [&](std::string_view text) { return description.starts_with(text); };
    if (begins("Value type not permitted")) {
      add(errors, fmt::format("{} should be {}, not {}", subject(), type_words(schema_.value("type", json("value"))), value_words(value_)),
          meaning());
    } else if (begins("Missing required property '")) {
      const std::string key = description.substr(27, description.rfind('\'') - 27);
      add(errors, fmt::format("{} has no \"{}\"", subject(), key), fmt::format("add \"{}\"{}", key, meaning_of(key)));
    } else if (begins("Object contains a property")) {
      explain_unknown_keys(errors);
    } else if (begins("Failed to match against any enum") || begins("Failed to match expected value")) {
      explain_choice(errors);
    } else if (begins("Expected number")) {
      add(errors, fmt::format("{} is {}, out of range", subject(), value_words(value_)), range_hint());
    } else if (begins("Array should contain")) {
      add(errors, fmt::format("{} has {} items", subject(), value_.size()), count_hint("Items", "items"));
    } else if (begins("String should be")) {
      add(errors, fmt::format("{} has {} characters", subject(), value_.is_string() ? value_.get_ref<const std::string&>().size() : 0),
          count_hint("Length", "characters"));
    } else {
      add(errors, fmt::format("{}: {}", subject(), description), meaning());
    }
  }

 private:
  void add(std::vector<Error>& errors, std::string message, std::string hint, const std::string& key = {}) const {
    const bool too_many = message.ends_with(" items") && schema_.contains("maxItems") && value_.is_array() &&
                          value_.size() > schema_["maxItems"].get<std::size_t>();
    errors.push_back({too_many ? ErrorCode::kTooLarge : ErrorCode::kSchema,
                      std::move(message),
                      key.empty() ? pointer_ : pointer_ + "/" + key,
                      std::move(hint),
                      {}});
  }

  std::string subject() const { return pointer_.empty() ? "the document" : pointer_; }

  std::string meaning() const {
    const std::string text = schema_.is_object() ? schema_.value("description", std::string()) : std::string();
    return text.empty() ? "" : "it means: " + text;
  }

  std::string meaning_of(const std::string& key) const {
    const json* member = step_into(root_, schema_, key, false);
    if (member == nullptr) return "";
    const std::string text = resolved(root_, *member).value("description", std::string());
    return text.empty() ? "" : ": " + text;
  }

  void explain_unknown_keys(std::vector<Error>& errors) const {
    std::vector<std::string> known;
    if (const auto properties = schema_.find("properties"); properties != schema_.end()) {
      for (const auto& item : properties->items()) known.push_back(item.key());
    }
    for (const auto& item : value_.items()) {
      if (std::ranges::find(known, item.key()) != known.end()) continue;
      const std::string near = nearest_word(item.key(), known);
      std::string list;
      for (const std::string& key : known) list += (list.empty() ? "" : ", ") + key;
      add(errors, fmt::format("{} has an unknown key \"{}\"", subject(), item.key()),
          near.empty() ? "known are: " + list : fmt::format("did you mean \"{}\"?", near), item.key());
    }
  }

  void explain_choice(std::vector<Error>& errors) const {
    std::vector<std::string> choices;
    if (schema_.contains("const")) choices.push_back(schema_["const"].get<std::string>());
    if (const auto values = schema_.find("enum"); values != schema_.end()) choices = values->get<std::vector<std::string>>();
    std::string list;
    for (const std::string& choice : choices) list += (list.empty() ? "" : ", ") + choice;
    const std::string near = value_.is_string() ? nearest_word(value_.get<std::string>(), choices) : "";
    add(errors, fmt::format("{} is {}, which is none of its values", subject(), value_words(value_)),
        near.empty() ? "give one of: " + list : fmt::format("did you mean \"{}\"?", near));
  }

  std::string range_hint() const {
    std::string hint = "give a number";
    const auto bound = [&](const char* key, std::string_view words) {
      if (schema_.contains(key)) hint += fmt::format(" {} {:g}", words, schema_[key].get<double>());
    };
    bound("exclusiveMinimum", "above");
    bound("minimum", "of at least");
    if (schema_.contains("maximum") && hint != "give a number") hint += " and";
    bound("maximum", "at most");
    const std::string text = schema_.value("description", std::string());
    if (text == "metres") hint += " (metres; if the file is in another unit, say so in metadata.units)";
    return hint;
  }

  std::string count_hint(const std::string& what, std::string_view noun) const {
    const auto least = schema_.find("min" + what), most = schema_.find("max" + what);
    if (least != schema_.end() && most != schema_.end() && *least == *most) return fmt::format("give {} {}", least->get<int>(), noun);
    std::string hint = "give";
    if (least != schema_.end()) hint += fmt::format(" at least {}", least->get<int>());
    if (most != schema_.end()) hint += fmt::format("{} at most {}", least != schema_.end() ? " and" : "", most->get<int>());
    return hint + " " + std::string(noun);
  }

  const json& root_;
  const json& schema_;
  const json& value_;
  std::string pointer_;
};

// Violations of a part are reported again for each whole that contains it; those say nothing new.
bool repeats_a_part(const std::string& description) {
  return description.starts_with("Failed to validate against schema associated with") ||
         description.starts_with("Failed to validate item #") ||
         description.starts_with("Failed to validate against additional properties");
}

void explain(const json& root, const json& document, const valijson::ValidationResults::Error& violation, std::vector<Error>& errors) {
  const json* schema = &root;
  const json* value = &document;
  std::string pointer;
  for (std::size_t i = 1; i < violation.context.size(); ++i) {  // context[0] is "<root>", then "[key]"
    const std::string& step = violation.context[i];
    const std::string key = step.size() >= 2 ? step.substr(1, step.size() - 2) : step;
    const bool is_index = value->is_array();
    static const json kAnything = json::object();
    const json* next = step_into(root, *schema, key, is_index);
    schema = next != nullptr ? next : &kAnything;
    value = is_index ? &value->at(std::stoul(key)) : &value->at(key);
    pointer += "/" + key;
  }
  Explainer(root, *schema, *value, pointer).explain(violation.description, errors);
}

}  // namespace

struct JsonSchema::Compiled {
  json document;
  valijson::Schema schema;
};

JsonSchema::JsonSchema(json schema) : compiled_(std::make_unique<Compiled>()) {
  compiled_->document = std::move(schema);
  valijson::SchemaParser parser;
  const valijson::adapters::NlohmannJsonAdapter adapter(compiled_->document);
  parser.populateSchema(adapter, compiled_->schema);
}

JsonSchema::JsonSchema(JsonSchema&&) noexcept = default;
JsonSchema& JsonSchema::operator=(JsonSchema&&) noexcept = default;
JsonSchema::~JsonSchema() = default;

std::vector<Error> JsonSchema::check(const json& document) const {
  constexpr std::size_t kMostErrors = 100;
  std::vector<Error> errors;
  valijson::Validator validator;
  valijson::ValidationResults results;
  const valijson::adapters::NlohmannJsonAdapter adapter(document);
  if (validator.validate(compiled_->schema, adapter, &results)) return errors;
  for (const auto& violation : results) {
    if (errors.size() >= kMostErrors) break;
    if (!repeats_a_part(violation.description)) explain(compiled_->document, document, violation, errors);
  }
  if (errors.empty()) errors.push_back({ErrorCode::kSchema, "the document does not follow its schema", {}, {}, {}});
  return errors;
}

std::vector<Error> check_against_schema(const json& document, SchemaName name, std::string_view at) {
  try {
    return loaded_schema(name, at).check(document);
  } catch (const std::exception& error) {
    return {{ErrorCode::kInternal, fmt::format("the schema check failed: {}", error.what()), {}, {}, {}}};
  }
}

}  // namespace layoutbox
