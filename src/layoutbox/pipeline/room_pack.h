// One room of a shard: what it is made from, and its files packed.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "layoutbox/pipeline/batch.h"

namespace layoutbox {

struct Expected {
  const BatchLine* line = nullptr;
  GenerateOptions options;
  std::string made;  // differs where prompt, options, inputs or version do
};

// REQUIRES: the line outlives it.
Expected expected_of(const BatchLine& line, const GenerateOptions& all);

// One room, packed.
struct Packed {
  std::string tar;
  nlohmann::ordered_json manifest;
  BatchItem item;
  std::optional<Error> surroundings;  // what ends the whole batch: another machine might have made it
};

// Never fails: what went wrong stands in the manifest.
Packed pack_room(const Expected& expected, const Planner& planner, const Catalog& catalog);

}  // namespace layoutbox
