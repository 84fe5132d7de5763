// Checks a document against one of the JSON Schemas in schema/, and says in words what is wrong.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"

namespace layoutbox {

enum class SchemaName { kScene, kLayout, kCatalog };

// A schema that is compiled once and checked against from any thread.
class JsonSchema {
 public:
  // REQUIRES: a valid JSON Schema (draft 7) whose references stay within it and whose keywords are those of schema_walk.cc (others: check()
  // says kInternal).
  explicit JsonSchema(nlohmann::json schema);
  JsonSchema(JsonSchema&&) noexcept;
  JsonSchema& operator=(JsonSchema&&) noexcept;
  ~JsonSchema();

  // Every violation, with its JSON pointer, in the document's order; empty when the document is valid.
  std::vector<Error> check(const nlohmann::json& document) const;

 private:
  struct Compiled;
  std::unique_ptr<Compiled> compiled_;
};

// The violations of one of ours. `at` checks against a definition instead of the whole schema: "room" with kScene checks a room alone.
std::vector<Error> check_against_schema(const nlohmann::json& document, SchemaName schema, std::string_view at = {});

}  // namespace layoutbox
