// Walks a JSON Schema and a document together and says what does not fit. It knows the keywords that our schemas use, and no others.
#pragma once

#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"

namespace layoutbox {

// The `pattern`s of a schema, ready for use: extended regular expressions of POSIX, which ours are in both languages.
class SchemaPatterns {
 public:
  // False: it is no expression.
  bool add(const std::string& pattern);
  // REQUIRES: `pattern` was added.
  bool match(const std::string& pattern, const std::string& text) const;

 private:
  struct Expression;
  std::map<std::string, std::shared_ptr<const Expression>, std::less<>> expressions_;
};

// Reads the patterns of a schema and says which of its keywords nothing here knows; empty where all is well.
std::string prepare_schema(const nlohmann::json& schema, SchemaPatterns& patterns);

// Every violation in the order of the walk, at most a hundred. REQUIRES: what prepare_schema() found well, with its patterns.
std::vector<Error> walk_schema(const nlohmann::json& schema, const SchemaPatterns& patterns, const nlohmann::json& document);

}  // namespace layoutbox
