#include "layoutbox/scene/schema_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "layoutbox/base/utf8.h"
#include "layoutbox/base/words.h"
#include "layoutbox/scene/schema_words.h"

namespace layoutbox {
namespace {

using nlohmann::json;

const json& resolved(const json& root, const json& node) {
  const json* current = &node;
  for (int step = 0; step < 10 && current->is_object() && current->contains("$ref"); ++step) {
    current = &root.at(json::json_pointer(current->at("$ref").get<std::string>().substr(1)));
  }
  return *current;
}

bool is_one_of_type(const json& value, std::string_view type) {
  if (type == "integer") return value.is_number_integer();
  return value.type_name() == type;
}

bool has_type(const json& value, const json& type) {
  if (type.is_string()) return is_one_of_type(value, type.get_ref<const std::string&>());
  return std::ranges::any_of(type, [&](const json& name) { return is_one_of_type(value, name.get_ref<const std::string&>()); });
}

std::string joined(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

// A step of a JSON pointer (RFC 6901).
std::string pointer_step(std::string_view key) {
  std::string step = "/";
  for (const char c : key) step += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return step;
}

class Walk {
 public:
  Walk(const json& root, const SchemaPatterns& patterns) : root_(root), patterns_(patterns) {}

  void check(const json& node, const json& value) {
    const json& schema = resolved(root_, node);
    if (!schema.is_object() || errors_.size() >= kMostErrors) return;
    if (const auto type = schema.find("type"); type != schema.end() && !has_type(value, *type)) {
      return add(fmt::format("{} should be {}, not {}", subject(), type_words(*type), value_words(value)), meaning(schema));
    }
    check_choice(schema, value);
    check_forms(schema, value);
    if (value.is_number()) check_number(schema, value);
    if (value.is_string()) check_string(schema, value);
    if (value.is_array()) check_items(schema, value);
    if (value.is_object()) check_members(schema, value);
  }

  std::vector<Error> take_errors() { return std::move(errors_); }

 private:
  static constexpr std::size_t kMostErrors = 100;

  std::string subject() const { return pointer_.empty() ? "the document" : pointer_; }

  static std::string meaning(const json& schema) {
    const std::string text = schema.value("description", std::string());
    return text.empty() ? "" : "it means: " + text;
  }

  void add(std::string message, std::string hint, const std::string& step = {}, ErrorCode code = ErrorCode::kSchema) {
    if (errors_.size() < kMostErrors) errors_.push_back({code, std::move(message), pointer_ + step, std::move(hint), {}});
  }

  void check_at(const std::string& step, const json& node, const json& value) {
    const std::size_t length = pointer_.size();
    pointer_ += step;
    check(node, value);
    pointer_.resize(length);
  }

  void check_choice(const json& schema, const json& value) {
    const auto one = schema.find("const"), values = schema.find("enum");
    const bool is_one = one != schema.end() && *one == value;
    const bool is_among = values != schema.end() && std::ranges::find(*values, value) != values->end();
    if ((one == schema.end() && values == schema.end()) || is_one || is_among) return;
    std::vector<json> choices;
    if (one != schema.end()) choices.push_back(*one);
    if (values != schema.end()) choices.insert(choices.end(), values->begin(), values->end());
    std::vector<std::string> words;
    for (const json& choice : choices) words.push_back(choice.is_string() ? choice.get<std::string>() : choice.dump());
    const std::string near = value.is_string() ? nearest_word(value.get<std::string>(), words) : "";
    add(fmt::format("{} is {}, which is none of its values", subject(), value_words(value)),
        near.empty() ? "give one of: " + joined(words) : fmt::format("did you mean \"{}\"?", near));
  }

  // What is wrong with a value by itself, without a word of it.
  std::vector<Error> faults_of(const json& node, const json& value) {
    std::vector<Error> kept = std::exchange(errors_, {});
    check(node, value);
    return std::exchange(errors_, std::move(kept));
  }

  // Just one of several forms fits. Where none does, the form of the value's type says why.
  void check_forms(const json& schema, const json& value) {
    const auto forms = schema.find("oneOf");
    if (forms == schema.end()) return;
    std::size_t fitting = 0;
    std::vector<Error> nearest;
    for (const json& form : *forms) {
      std::vector<Error> faults = faults_of(form, value);
      const json& rules = resolved(root_, form);
      if (faults.empty()) ++fitting;
      if (!faults.empty() && rules.contains("type") && has_type(value, rules["type"])) nearest = std::move(faults);
    }
    if (fitting == 1) return;
    if (fitting == 0 && !nearest.empty()) {
      for (Error& fault : nearest) errors_.push_back(std::move(fault));
      return;
    }
    add(fmt::format("{} is {}, which has {} of its forms", subject(), value_words(value), fitting == 0 ? "none" : "several"),
        meaning(schema));
  }

  void check_number(const json& schema, const json& value) {
    const auto number = value.get<double>();
    const auto breaks = [&](const char* key, auto&& is_beyond) {
      const auto bound = schema.find(key);
      return bound != schema.end() && is_beyond(bound->get<double>());
    };
    if (breaks("minimum", [=](double least) { return number < least; }) || breaks("maximum", [=](double most) { return number > most; }) ||
        breaks("exclusiveMinimum", [=](double below) { return number <= below; })) {
      add(fmt::format("{} is {}, out of range", subject(), value_words(value)), range_hint(schema));
    }
  }

  // There are `count` of `noun`, and as many are allowed as the keywords min… and max… say.
  void check_count(const json& schema, const std::string& what, std::string_view noun, std::size_t count) {
    const auto least = schema.find("min" + what), most = schema.find("max" + what);
    const bool too_few = least != schema.end() && count < least->get<std::size_t>();
    const bool too_many = most != schema.end() && count > most->get<std::size_t>();
    if (!too_few && !too_many) return;
    add(fmt::format("{} has {} {}", subject(), count, noun), count_hint(schema, what, noun), {},
        too_many && what == "Items" ? ErrorCode::kTooLarge : ErrorCode::kSchema);
  }

  void check_string(const json& schema, const json& value) {
    const auto& text = value.get_ref<const std::string&>();
    check_count(schema, "Length", "characters", characters_in(text));
    const auto pattern = schema.find("pattern");
    if (pattern == schema.end() || patterns_.match(pattern->get_ref<const std::string&>(), text)) return;
    add(fmt::format("{} is {}, which has not the form {}", subject(), value_words(value), pattern->get<std::string>()), meaning(schema));
  }

  void check_items(const json& schema, const json& value) {
    check_count(schema, "Items", "items", value.size());
    if (schema.value("uniqueItems", false)) check_unlike(value);
    const auto items = schema.find("items");
    if (items == schema.end()) return;
    for (std::size_t i = 0; i < value.size() && errors_.size() < kMostErrors; ++i) {
      if (items->is_array() && i >= items->size()) break;
      check_at("/" + std::to_string(i), items->is_array() ? (*items)[i] : *items, value[i]);
    }
  }

  void check_unlike(const json& items) {
    std::vector<const json*> sorted;
    for (const json& item : items) sorted.push_back(&item);
    std::ranges::sort(sorted, [](const json* a, const json* b) { return *a < *b; });
    const auto twice = std::ranges::adjacent_find(sorted, [](const json* a, const json* b) { return *a == *b; });
    if (twice != sorted.end()) add(fmt::format("{} has {} twice", subject(), value_words(**twice)), "leave one of them out");
  }

  void check_members(const json& schema, const json& value) {
    static const json kNone = json::object();
    const auto given = schema.find("properties");
    const json& properties = given != schema.end() ? *given : kNone;
    check_count(schema, "Properties", "members", value.size());
    if (const auto required = schema.find("required"); required != schema.end()) {
      for (const json& key : *required) check_required(properties, key.get<std::string>(), value);
    }
    const auto names = schema.find("propertyNames");
    const auto others = schema.find("additionalProperties");
    for (const auto& [key, member] : value.items()) {
      if (names != schema.end()) check_name(*names, key);
      if (const auto known = properties.find(key); known != properties.end()) {
        check_at(pointer_step(key), *known, member);
      } else if (others != schema.end() && others->is_boolean() && !others->get<bool>()) {
        add_unknown(key, keys_of(properties));
      } else if (others != schema.end()) {
        check_at(pointer_step(key), *others, member);
      }
    }
  }

  void check_required(const json& properties, const std::string& key, const json& value) {
    if (value.contains(key)) return;
    const auto member = properties.find(key);
    const std::string means = member == properties.end() ? "" : resolved(root_, *member).value("description", "");
    add(fmt::format("{} has no \"{}\"", subject(), key), fmt::format("add \"{}\"{}", key, means.empty() ? "" : ": " + means));
  }

  void check_name(const json& names, const std::string& key) {
    if (faults_of(names, json(key)).empty()) return;
    const json& rules = resolved(root_, names);
    add_unknown(key, rules.contains("enum") ? rules["enum"].get<std::vector<std::string>>() : std::vector<std::string>{});
  }

  static std::vector<std::string> keys_of(const json& object) {
    std::vector<std::string> keys;
    for (const auto& item : object.items()) keys.push_back(item.key());
    return keys;
  }

  void add_unknown(const std::string& key, const std::vector<std::string>& known) {
    const std::string near = nearest_word(key, known);
    add(fmt::format("{} has an unknown key \"{}\"", subject(), key),
        near.empty() ? "known are: " + joined(known) : fmt::format("did you mean \"{}\"?", near), pointer_step(key));
  }

  const json& root_;
  const SchemaPatterns& patterns_;
  std::string pointer_;
  std::vector<Error> errors_;
};

}  // namespace

std::vector<Error> walk_schema(const json& schema, const SchemaPatterns& patterns, const json& document) {
  Walk walk(schema, patterns);
  walk.check(schema, document);
  return walk.take_errors();
}

}  // namespace layoutbox
