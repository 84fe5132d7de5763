// What the data of a catalogue must have, and what entries take over from their kinds.
#include <gmock/gmock.h>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/catalog/catalog_json.h"
#include "layoutbox/catalog/trait_table.h"

namespace layoutbox {
namespace {

using testing::HasSubstr;

TEST(Catalog, KindsInheritTraits) {
  const std::string rest = R"("size": {"w": 1, "d": 1, "h": 1}, "shape": {"family": "chair"}})";
  const auto with_traits = [&](std::string_view traits) {
    return Catalog::from_json(R"({"entries": [{"id": "chair", "name": "chair", "traits": ["seat", "tableSeat"], )" + rest +
                                  R"(, {"id": "armchair", "name": "armchair", "kindOf": "chair", "traits": )" + std::string(traits) + "," +
                                  rest + R"(, {"id": "recliner", "name": "recliner", "kindOf": "armchair", )" + rest + "]}",
                              R"({"rooms": []})");
  };
  const Result<Catalog> catalog = with_traits(R"(["-tableSeat", "easySeat"])");
  ASSERT_TRUE(catalog);
  for (const char* id : {"armchair", "recliner"}) {
    const CatalogEntry& entry = *catalog->find(id);
    EXPECT_TRUE(entry.is(Trait::kSeat)) << id;
    EXPECT_TRUE(entry.is(Trait::kEasySeat)) << id;
    EXPECT_FALSE(entry.is(Trait::kTableSeat)) << id;
  }
  EXPECT_FALSE(catalog->find("chair")->is(Trait::kEasySeat));
  const Result<Catalog> unknown = with_traits(R"(["comfy"])");
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().message, HasSubstr("unknown trait \"comfy\""));
}

TEST(Catalog, ShapesHaveTheNumbersOfTheirFamily) {
  CatalogData data;
  ASSERT_TRUE(read_catalog_data(
      R"({"families": {"bed": {"symbol": "bed", "numbers": {"pillows": {"range": [0, 4], "meaning": "pillows"}}}}})", data));
  const auto faults = [&](std::string_view shape) {
    data.entries.clear();
    const std::string entry =
        R"({"entries": [{"id": "bed", "name": "bed", "size": {"w": 1, "d": 2, "h": 1}, "shape": )" + std::string(shape) + "}]}";
    EXPECT_TRUE(read_catalog_data(entry, data));
    return check_catalog_data(data);
  };
  EXPECT_TRUE(faults(R"({"family": "bed", "numbers": {"pillows": 2}})").empty());
  inherit_from_kinds(data);
  EXPECT_EQ(data.entries.at(0).shape.symbol, "bed");
  EXPECT_THAT(faults(R"({"family": "bed", "numbers": {"pilows": 2}})").at(0).message, HasSubstr("have no \"pilows\""));
  EXPECT_THAT(faults(R"({"family": "bed", "numbers": {"pillows": 9}})").at(0).message, HasSubstr("not within 0 to 4"));
  EXPECT_THAT(faults(R"({"family": "raft"})").at(0).message, HasSubstr("no family"));
}

TEST(Catalog, ShapesHaveTheWordsOfTheirFamily) {
  CatalogData data;
  ASSERT_TRUE(read_catalog_data(
      R"({"words": {"material": {"meaning": "stuff"}}, "families": {"rug": {"words": {"top": {"values": ["rect", "round"], "meaning": "outline"}}}}})",
      data));
  const auto faults = [&](std::string_view words) {
    data.entries.clear();
    const std::string entry =
        R"({"entries": [{"id": "rug", "name": "rug", "size": {"w": 1, "d": 2, "h": 0.01}, "shape": {"family": "rug", "words": )" +
        std::string(words) + "}}]}";
    EXPECT_TRUE(read_catalog_data(entry, data));
    return check_catalog_data(data);
  };
  EXPECT_TRUE(faults(R"({"top": "round", "material": "wool"})").empty());
  EXPECT_THAT(faults(R"({"topp": "round"})").at(0).message, HasSubstr("have no word \"topp\""));
  EXPECT_THAT(faults(R"({"top": "star"})").at(0).message, HasSubstr("none of rect, round"));
}

}  // namespace
}  // namespace layoutbox
