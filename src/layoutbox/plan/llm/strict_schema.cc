#include "layoutbox/plan/llm/strict_schema.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "layoutbox/embedded/schema.h"
#include "layoutbox/scene/relation_table.h"

namespace layoutbox::llm {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMostItems = 24, kMostItemsBrief = 6;
// Without bounds a weak model writes a text to its limit; and patterns are what servers force, lengths are not.
constexpr const char* kIdPattern = "^[A-Za-z0-9_]{1,40}$";
constexpr const char* kTextPattern = "^[A-Za-z0-9 .,:;()'/_%+-]{0,80}$";
constexpr const char *kIdPatternBrief = "^[A-Za-z0-9_]{1,24}$", *kTextPatternBrief = "^[A-Za-z0-9 _-]{0,24}$";

// How many things and relations an answer may hold: about twice what the text names, in few steps, as servers prepare each schema once.
struct Most {
  std::size_t objects = 0, relations = 0;
};

Most most_of(const SchemaWanted& wanted) {
  constexpr std::size_t kObjects = 100;
  if (wanted.objects == 0) return {kObjects, 2 * kObjects};
  if (wanted.brief) return {std::min(kObjects, wanted.objects + wanted.objects / 4 + 2), wanted.objects + wanted.objects / 2 + 3};
  for (const std::size_t most : {12u, 25u, 50u}) {
    if (2 * wanted.objects + 4 <= most) return {most, 2 * most};
  }
  return {kObjects, 2 * kObjects};
}

class Deriver {
 public:
  Deriver(const Json& root, const SchemaWanted& wanted) : root_(root), wanted_(wanted) {}

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
      if (type == "string") out["pattern"] = pattern_of(part);
      for (const char* bound : {"minimum", "maximum", "exclusiveMinimum"}) {
        if (part.contains(bound)) out[bound] = part[bound];
      }
    }
    if (part.contains("description") && tells_enough(part["description"])) out["description"] = part["description"];
    return out;
  }

 private:
  bool is_wanted(const Json& part) const {
    const auto said = part.find("x-model");
    if (said == part.end()) return true;
    if (*said == "full") return !wanted_.brief;
    return *said == "catalogue" && wanted_.articles;
  }

  std::string pattern_of(const Json& part) const {
    if (wanted_.brief && part.contains("x-model-pattern")) return part["x-model-pattern"].get<std::string>();
    if (part.contains("minLength")) return wanted_.brief ? kIdPatternBrief : kIdPattern;
    return wanted_.brief ? kTextPatternBrief : kTextPattern;
  }

  bool tells_enough(const Json& description) const {
    constexpr std::size_t kLongestBrief = 60;
    return !wanted_.brief || description.get_ref<const std::string&>().size() <= kLongestBrief;
  }

  // What stands beside a reference adds to it. That a number is in metres and an id a name is said in the rules, not fifty times here.
  Json resolved(const Json& part, const std::string& reference) const {
    Json target = root_.at("definitions").at(reference.substr(reference.rfind('/') + 1));
    if (const auto type = target.find("type"); type != target.end() && (*type == "number" || *type == "string"))
      target.erase("description");
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
    const bool whole = wanted_.brief && part.value("x-model-whole", false);
    for (const auto& [name, member] : part.at("properties").items()) {
      if (!is_wanted(member)) continue;
      Json made = derive(member);
      const bool may_miss = !whole && std::ranges::none_of(required, [&](const Json& one) { return one == name; });
      if (may_miss && !wanted_.brief) allow_null(made);
      out["properties"][name] = std::move(made);
      if (!may_miss || !wanted_.brief) out["required"].push_back(name);
    }
    out["additionalProperties"] = false;
  }

  void add_items(const Json& part, Json& out) const {
    out["items"] = derive(part.at("items"));
    if (part.contains("minItems")) out["minItems"] = part["minItems"];
    const int most =
        part.value("x-model-items", std::min(part.value("maxItems", kMostItems), wanted_.brief ? kMostItemsBrief : kMostItems));
    out["maxItems"] = most;
  }

  static void allow_null(Json& part) {
    part["type"] = Json::array({part["type"], "null"});
    if (part.contains("enum")) part["enum"].push_back(nullptr);
  }

  const Json& root_;
  const SchemaWanted& wanted_;
};

Json whole_schema() {
  Json root = Json::parse(embedded::scene_schema_json);
  Json& names = root["definitions"]["relationType"]["enum"] = Json::array();
  for (const RelationRow& row : relation_table()) names.push_back(row.name);
  return root;
}

}  // namespace

std::string scene_schema(const SchemaWanted& wanted) {
  static const Json root = whole_schema();
  Json whole = root;
  whole.erase("description");
  Json schema = Deriver(root, wanted).derive(std::move(whole));
  const Most most = most_of(wanted);
  schema["properties"]["furniture"]["maxItems"] = most.objects;
  schema["properties"]["constraints"]["maxItems"] = most.relations;
  if (wanted.brief && !wanted.openings) schema["properties"]["room"]["properties"].erase("openings");
  if (wanted.brief && !wanted.categories.empty()) {
    Json& category = schema["properties"]["furniture"]["items"]["properties"]["category"];
    category.erase("pattern");
    category["enum"] = wanted.categories;
  }
  if (wanted.brief && !wanted.sizes) schema["properties"]["furniture"]["items"]["properties"].erase("dims");
  return schema.dump();
}

int answer_tokens(const SchemaWanted& wanted) {
  const Most most = most_of(wanted);
  const std::size_t around = wanted.brief ? 150 : 600, object = wanted.brief ? 60 : 130, relation = wanted.brief ? 55 : 170;
  const std::size_t relations = wanted.brief ? most.relations : most.relations / 2;  // what is twice as much once is enough
  return static_cast<int>(around + most.objects * object + relations * relation);
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
