// Every length of catalog/groups.json has a name in the code, says what it is and where it is from.
#include "layoutbox/catalog/measures.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>

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

// A standard, a handbook, a guideline; or that it is our own judgment ("drawn: …"), and of what.
TEST(Seatings, EachSaysWhereItIsFrom) {
  constexpr std::size_t kOwn = std::string_view("drawn: ").size();
  std::size_t from_others = 0;
  const nlohmann::json groups = nlohmann::json::parse(embedded::groups_json);
  for (const auto& row : groups.at("seatings")) {
    const std::string source = row.value("source", "");
    const bool own = source.starts_with("drawn");
    EXPECT_FALSE(source.empty()) << row.at("at");
    EXPECT_TRUE(!own || (source.starts_with("drawn: ") && source.size() > kOwn)) << row.at("at") << ": drawn from what?";
    // How large something is for how many is measured by somebody.
    EXPECT_FALSE(own && row.contains("sizes")) << row.at("at");
    from_others += own ? 0 : 1;
  }
  EXPECT_GE(from_others, 16u);
}

TEST(Measures, AreInMillimetres) {
  EXPECT_EQ(measures().desk_for_two, 1200);
  EXPECT_EQ(measures().chair_at_desk, 10);
}

}  // namespace
}  // namespace layoutbox
