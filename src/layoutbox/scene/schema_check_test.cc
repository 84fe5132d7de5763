// What is said of documents that do not follow their schema; that the walk finds what another validator finds.
#include "layoutbox/scene/schema_check.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <random>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "layoutbox/base/files.h"
#include "layoutbox/embedded/schema.h"

namespace layoutbox {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<Error> errors_of(const char* schema, const char* document) {
  return JsonSchema(json::parse(schema)).check(json::parse(document));
}

// The only violation.
Error error_of(const char* schema, const char* document) {
  const auto errors = errors_of(schema, document);
  EXPECT_EQ(errors.size(), 1u) << schema << " " << document;
  return errors.empty() ? Error{} : errors.front();
}

TEST(SchemaCheck, SaysWhereAndWhat) {
  const char* schema = R"({"type": "object", "required": ["a/b"], "additionalProperties": false, "properties": {
      "a/b": {"type": ["integer", "null"], "minimum": 1, "description": "how many"}, "list": {"items": [{"type": "string"}, {"const": 2}]}}})";
  EXPECT_THAT(errors_of(schema, R"({"a/b": null, "list": ["x", 2, 3]})"), IsEmpty());
  EXPECT_EQ(error_of(schema, "[]").message, "the document should be an object {…}, not []");
  EXPECT_EQ(error_of(schema, "{}").hint, "add \"a/b\": how many");
  EXPECT_EQ(error_of(schema, R"({"a/b": 0})").pointer, "/a~1b");
  EXPECT_EQ(error_of(schema, R"({"a/b": "1"})").message, "/a~1b should be a whole number or null, not \"1\"");
  EXPECT_EQ(error_of(schema, R"({"a/b": 1, "list": ["x", 3]})").pointer, "/list/1");
  EXPECT_THAT(error_of(schema, R"({"a/b": 1, "lits": []})").hint, HasSubstr("\"list\""));
}

TEST(SchemaCheck, AFormOfTheValuesTypeSaysWhy) {
  const char* schema = R"({"description": "a length", "oneOf": [
      {"type": "number", "exclusiveMinimum": 0}, {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3}]})";
  EXPECT_THAT(errors_of(schema, "2"), IsEmpty());
  EXPECT_THAT(errors_of(schema, "[1, 2, 3]"), IsEmpty());
  EXPECT_EQ(error_of(schema, "[1, 2]").message, "the document has 2 items");
  EXPECT_THAT(error_of(schema, "0").hint, HasSubstr("above 0"));
  EXPECT_EQ(error_of(schema, "\"x\"").message, "the document is \"x\", which has none of its forms");
  EXPECT_EQ(error_of(schema, "\"x\"").hint, "it means: a length");
  EXPECT_THAT(error_of(R"({"oneOf": [{"minimum": 1}, {"minimum": 2}]})", "3").message, HasSubstr("several of its forms"));
}

TEST(SchemaCheck, PatternsCountsAndNames) {
  EXPECT_THAT(error_of(R"({"pattern": "^[a-z]+$"})", "\"aB\"").message, HasSubstr("has not the form ^[a-z]+$"));
  EXPECT_EQ(errors_of(R"({"pattern": "^[a-z]+$"})", R"("a\u0000b")").size(), 1u);
  EXPECT_EQ(error_of(R"({"maxLength": 2})", "\"äöü\"").message, "the document has 3 characters");
  EXPECT_EQ(error_of(R"({"maxItems": 1})", "[1, 2]").code, ErrorCode::kTooLarge);
  EXPECT_THAT(error_of(R"({"uniqueItems": true})", R"([1, {"a": 2}, 3, {"a": 2}])").message, HasSubstr("twice"));
  EXPECT_EQ(error_of(R"({"minProperties": 1})", "{}").hint, "give at least 1 members");
  EXPECT_THAT(error_of(R"({"propertyNames": {"enum": ["front", "back"]}})", R"({"fornt": 1})").hint, HasSubstr("\"front\""));
}

TEST(SchemaCheck, AKeywordThatNothingReadsIsNoSilentYes) {
  EXPECT_EQ(error_of(R"({"properties": {"a": {"anyOf": []}}})", "1").code, ErrorCode::kInternal);
  EXPECT_EQ(error_of(R"({"pattern": "(("})", "1").code, ErrorCode::kInternal);
  for (const SchemaName name : {SchemaName::kScene, SchemaName::kLayout, SchemaName::kCatalog})
    for (const Error& error : check_against_schema(json(1), name)) EXPECT_EQ(error.code, ErrorCode::kSchema) << error.message;
}

// A part of the document, any of them alike.
json& any_part(json& document, std::mt19937& random) {
  json* part = &document;
  while (part->is_structured() && !part->empty() && random() % 5 != 0) {
    auto next = part->begin();
    std::advance(next, static_cast<std::ptrdiff_t>(random() % part->size()));
    part = &*next;
  }
  return *part;
}

void spoil(json& document, std::mt19937& random) {
  static const std::vector<json> kValues{nullptr,    true,          -1,     0,         0.5,           1e9, "", "bed",
                                         "bad name", json::array(), {1, 2}, {1, 2, 3}, json::object()};
  json& part = any_part(document, random);
  if (part.is_object() && !part.empty() && random() % 2 == 0) {
    part.erase(std::next(part.begin(), static_cast<std::ptrdiff_t>(random() % part.size())).key());
  } else if (part.is_object()) {
    part["surplus"] = kValues[random() % kValues.size()];
  } else if (part.is_array() && random() % 2 == 0) {
    part.push_back(part.empty() ? json(1) : part.back());
  } else {
    part = kValues[random() % kValues.size()];
  }
}

// Valijson is another hand's reading of the same drafts.
class ByValijson {
 public:
  explicit ByValijson(json schema) : schema_(std::move(schema)) {
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_), compiled_);
  }
  bool follows(const json& document) {
    return valijson::Validator().validate(compiled_, valijson::adapters::NlohmannJsonAdapter(document), nullptr);
  }

 private:
  json schema_;
  valijson::Schema compiled_;
};

void expect_agreement(std::string_view schema_text, const char* example) {
  const json schema = json::parse(schema_text);
  const auto text = read_file(std::string(LAYOUTBOX_SOURCE_FOLDER) + example);
  ASSERT_TRUE(text);
  const json document = json::parse(*text);
  const JsonSchema ours(schema);
  ByValijson theirs(schema);
  for (const Error& error : ours.check(document)) ADD_FAILURE() << example << error.pointer << ": " << error.message;
  std::mt19937 random(1);
  int followed = 0;
  for (int round = 0; round < 400; ++round) {
    json spoilt = document;
    for (auto faults = random() % 3; faults-- > 0;) spoil(spoilt, random);
    const bool follows = theirs.follows(spoilt);
    followed += follows ? 1 : 0;
    ASSERT_EQ(ours.check(spoilt).empty(), follows) << spoilt.dump();
  }
  EXPECT_GT(followed, 40);
  EXPECT_LT(followed, 360);
}

TEST(SchemaCheck, FindsWhatAnotherValidatorFinds) {
  expect_agreement(embedded::scene_schema_json, "/examples/scenes/bedroom.json");
  expect_agreement(embedded::catalog_schema_json, "/catalog/music.json");
}

}  // namespace
}  // namespace layoutbox
