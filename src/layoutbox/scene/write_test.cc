#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "layoutbox/scene/json_text.h"
#include "layoutbox/scene/layout_scene.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox {
namespace {

TEST(Numbers, HaveAtMostFourDecimals) {
  EXPECT_EQ(format_number(1.6), "1.6");
  EXPECT_EQ(format_number(3), "3");
  EXPECT_EQ(format_number(0.1 + 0.2), "0.3");
  EXPECT_EQ(format_number(0.0005), "0.0005");
  EXPECT_EQ(format_number(-0.00001), "0");
  EXPECT_EQ(format_number(-12.34567), "-12.3457");
  EXPECT_EQ(format_number(100), "100");
}

TEST(Json, ShortThingsStandOnOneLine) {
  const nlohmann::ordered_json value{
      {"a", {1, 2.5}}, {"list", {{{"id", "x"}, {"n", 1}}, {{"id", "y"}}}}, {"none", nlohmann::ordered_json::array()}};
  EXPECT_EQ(format_json(value),
            "{\n"
            "  \"a\": [1, 2.5],\n"
            "  \"list\": [\n"
            "    {\"id\": \"x\", \"n\": 1},\n"
            "    {\"id\": \"y\"}\n"
            "  ],\n"
            "  \"none\": []\n"
            "}\n");
}

TEST(Json, LongObjectsAreFilledLineByLine) {
  nlohmann::ordered_json item;
  for (int i = 0; i < 30; ++i) item["member" + std::to_string(i)] = "value";
  const std::string text = format_json({{"list", {item}}});
  std::size_t longest = 0, lines = 0;
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1, ++lines)
    longest = std::max(longest, end - begin);
  EXPECT_LE(longest, 150u);
  EXPECT_LT(lines, 12u) << text;
  EXPECT_EQ(nlohmann::ordered_json::parse(text)["list"][0], item);
}

TEST(Layouts, AreWrittenAsTheFormatPageShows) {
  Layout layout;
  layout.prompt = "a bed";
  layout.room.type = "bedroom";
  layout.room.polygon = {{0, 0}, {4000, 0}, {4000, 3200}, {0, 3200}};
  layout.room.height = 3000;
  Wall wall;
  wall.id = "wall1";
  wall.end = {4000, 0};
  layout.room.walls = {wall};
  Opening door;
  door.id = "door1";
  door.wall = "wall1";
  door.offset = 300;
  layout.room.openings = {door};
  PlacedObject bed;
  bed.id = "bed_1";
  bed.category = "bed";
  bed.name = "queen bed";
  bed.attributes = {"blue"};
  bed.size = {1600, 2000, 500};
  bed.position = {2000, 2200.5, 0};
  bed.used_sides = {Side::kFront};
  layout.objects = {bed};
  Relation relation;
  relation.id = "c1";
  relation.type = RelationType::kAgainstWall;
  relation.targets = {"bed_1"};
  relation.references = {"wall3"};
  layout.relations = {{relation, true}};
  layout.stats.seconds = 0.0042;
  EXPECT_EQ(write_layout(layout), R"({
  "format": "layoutbox/layout@1",
  "prompt": "a bed",
  "roomType": "bedroom",
  "status": "solved",
  "room": {
    "polygon": [[0, 0], [4, 0], [4, 3.2], [0, 3.2]],
    "height": 3,
    "walls": [
      {"id": "wall1", "start": [0, 0], "end": [4, 0], "thickness": 0.1}
    ],
    "openings": [
      {"id": "door1", "type": "door", "wall": "wall1", "offset": 0.3, "w": 0.9, "h": 2, "sill": 0, "swing": "in-left", "origin": "asked"}
    ]
  },
  "objects": [
    {"id": "bed_1", "category": "bed", "name": "queen bed", "attributes": ["blue"], "size": [1.6, 2, 0.5], "pos": [2, 2.2005, 0], "rotation": 0,
     "mount": "floor", "supportedBy": "floor", "usedSides": ["front"], "origin": "asked"}
  ],
  "relations": [
    {"id": "c1", "type": "againstWall", "targets": ["bed_1"], "relativeTo": "wall3", "hard": true, "origin": "asked", "held": true}
  ],
  "relaxed": [],
  "conflicts": [],
  "score": {"total": 0, "terms": {}},
  "stats": {"solver": "", "seed": 1, "seconds": 0.0042, "proven": false}
}
)");
}

// What was left out is listed by its id, and relations may speak of it; of what nobody heard they may not.
TEST(Layouts, MaySpeakOfWhatTheyLeaveOut) {
  const auto text_with = [](const char* relaxed) {
    return std::string(R"({"format": "layoutbox/layout@1", "prompt": "", "roomType": "", "status": "relaxed",
      "room": {"polygon": [[0, 0], [4, 0], [4, 3], [0, 3]], "height": 2.5},
      "objects": [{"id": "desk_1", "category": "desk", "name": "desk", "size": [1, 0.6, 0.75], "pos": [2, 1, 0], "rotation": 0,
                   "mount": "floor", "supportedBy": "floor", "usedSides": ["front"]}],
      "relations": [{"id": "c1", "type": "near", "targets": ["desk_1", "chair_1"], "relativeTo": "bed_1", "held": false},
                    {"id": "c2", "type": "againstWall", "targets": ["desk_1", "chair_1"], "relativeTo": "wall1", "held": false}],
      "relaxed": [)") +
           relaxed + R"(], "conflicts": [], "score": {"total": 1, "terms": {}}})";
  };
  const char* listed = R"({"relation": "bed_1", "by": 0, "why": "left out"}, {"relation": "chair_1", "by": 0, "why": "left out"})";
  const auto layout = read_layout(text_with(listed));
  ASSERT_TRUE(layout) << layout.error().message;
  EXPECT_EQ(layout->relations.size(), 2u);
  EXPECT_TRUE(read_layout(write_layout(*layout)));

  const SceneGraph scene = scene_of(*layout);
  ASSERT_EQ(scene.relations.size(), 1u);
  EXPECT_EQ(scene.relations[0].id, "c2");
  EXPECT_THAT(scene.relations[0].targets, testing::ElementsAre("desk_1"));

  const auto unlisted = read_layout(text_with(""));
  ASSERT_FALSE(unlisted);
  EXPECT_EQ(unlisted.error().code, ErrorCode::kReference);
}

}  // namespace
}  // namespace layoutbox
