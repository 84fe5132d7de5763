// Every length of catalog/groups.json has a name in the code, says what it is and where it is from.
#include "layoutbox/catalog/measures.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "layoutbox/embedded/catalog_data.h"

namespace layoutbox {
namespace {

TEST(Measures, EachIsAskedForAndSaysWhatItIsAndWhereItIsFrom) {
  const std::set<std::string> asked = {
#define LAYOUTBOX_MEASURE(field, key) key,
#include "layoutbox/catalog/measure_list.inc"
#undef LAYOUTBOX_MEASURE
  };
  const nlohmann::json rows = nlohmann::json::parse(embedded::groups_json).at("measures");
  for (const auto& [key, row] : rows.items()) {
    EXPECT_TRUE(asked.contains(key)) << key;
    EXPECT_FALSE(row.value("is", "").empty()) << key;
    EXPECT_FALSE(row.value("source", "").empty()) << key;
  }
  EXPECT_EQ(rows.size(), asked.size());
}

TEST(Measures, AreInMillimetres) {
  EXPECT_EQ(measures().desk_for_two, 1200);
  EXPECT_EQ(measures().chair_at_desk, 10);
}

}  // namespace
}  // namespace layoutbox
