// Scene files as people and models write them: what is read.
#include <gmock/gmock.h>

#include "layoutbox/embedded/schema.h"
#include "layoutbox/scene/relation_table.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/scene/test_paper_scene.h"

namespace layoutbox {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(PaperScene, IsReadUnchanged) {
  const SceneGraph scene = read(paper_scene());
  EXPECT_EQ(scene.room.type, "bedroom");
  EXPECT_EQ(scene.room.height, 3000);
  EXPECT_EQ(scene.room.polygon, (std::vector<Point>{{0, 0}, {4000, 0}, {4000, 3200}, {0, 3200}}));
  ASSERT_EQ(scene.room.walls.size(), 4u);
  ASSERT_EQ(scene.room.openings.size(), 1u);
  EXPECT_EQ(scene.room.openings[0].wall, "wall1");
  EXPECT_EQ(scene.room.openings[0].type, OpeningType::kDoor);
  EXPECT_TRUE(scene.room.openings_given);
  ASSERT_EQ(scene.objects.size(), 2u);
  const Size bed{1600, 2000, 500};
  EXPECT_EQ(scene.objects[0].size, (SizeRange{bed, bed, bed}));
  EXPECT_EQ(scene.objects[0].hint.rotation_deg, 90);
  EXPECT_TRUE(scene.objects[0].hint.z_may_be_centre);
  EXPECT_FALSE(scene.objects[1].size);
  EXPECT_THAT(scene.relations[0].references, ElementsAre("wall4"));
  EXPECT_EQ(scene.relations[0].parameters.distance, 0);
  EXPECT_EQ(scene.relations[1].parameters.axis, Axis::kY);
  EXPECT_EQ(scene.materials[0].uv_scale, (std::array<double, 2>{1, 1}));
}

TEST(PaperScene, SizesGoByManyNames) {
  json scene = paper_scene();
  scene["furniture"][1]["dims"] = {{"w", 1.2}, {"l", 0.6}, {"h", 0.75}};
  EXPECT_EQ(read(scene).objects[1].size->usual, (Size{1200, 600, 750}));
  scene["furniture"][1]["dims"] = {{"width", 1.2}, {"depth", 0.6}, {"height", 0.75}};
  EXPECT_EQ(read(scene).objects[1].size->usual, (Size{1200, 600, 750}));
  scene["furniture"][1]["dims"] = {{"length", 1.2}, {"d", 0.6}, {"height", 0.75}};
  EXPECT_EQ(read(scene).objects[1].size->usual, (Size{1200, 600, 750}));
  scene["furniture"][1]["dims"] = {1.2, 0.6, 0.75};
  const SceneGraph listed = read(scene);
  EXPECT_EQ(listed.objects[1].size->usual, (Size{1200, 600, 750}));
  EXPECT_THAT(listed.notes, testing::Contains(testing::Field(&Note::pointer, "/furniture/1/dims")));
  scene["furniture"][1]["dims"] = {{"w", 1.2}};
  EXPECT_EQ(read(scene).objects[1].size->usual, (Size{1200, 0, 0})) << "unknown sides stay unknown";
}

TEST(PaperScene, UnitsAreConverted) {
  json scene = paper_scene();
  scene["metadata"]["units"] = "cm";
  scene["room"] = {{"dims", {{"w", 400}, {"d", 320}, {"h", 300}}},
                   {"openings", {{{"id", "w"}, {"type", "window"}, {"w", 120}, {"h", 100}, {"sill", 90}}}}};
  scene["furniture"][0]["dims"] = {{"w", 160}, {"d", 200}, {"h", 50}};
  scene["furniture"][0]["xform"]["pos"] = {100, 150, 25};
  scene["constraints"][0]["distance"] = 60;
  const SceneGraph in_cm = read(scene);
  EXPECT_EQ(in_cm.room.polygon[2], (Point{4000, 3200}));
  EXPECT_EQ(in_cm.room.height, 3000);
  EXPECT_EQ(in_cm.room.openings[0].sill, 900);
  EXPECT_EQ(in_cm.objects[0].size->usual.width, 1600);
  EXPECT_EQ(in_cm.objects[0].hint.position, (std::array<double, 3>{1000, 1500, 250}));
  EXPECT_EQ(in_cm.relations[0].parameters.distance, 600);
  EXPECT_EQ(read(scene, "mm").room.polygon[2], (Point{400, 320})) << "the caller's units win";
  scene["metadata"]["units"] = "ft";
  scene["room"] = {{"dims", {{"w", 10}, {"d", 10}, {"h", 8}}}};
  scene["furniture"] = json::array();
  scene["constraints"] = json::array();
  EXPECT_EQ(read(scene).room.polygon[2], (Point{3048, 3048}));
  EXPECT_EQ(read_scene(scene.dump(), "parsec").error().code, ErrorCode::kUsage);
}

TEST(PaperScene, YUpFilesAreTurned) {
  json scene = paper_scene();
  scene["metadata"]["axes"] = {{"right", "X+"}, {"forward", "X+"}, {"up", "Y+"}};
  const auto none = read_scene(scene.dump());
  ASSERT_FALSE(none) << "one axis twice is no frame";
  EXPECT_EQ(none.error().pointer, "/metadata/axes");
  scene["metadata"]["axes"] = {{"right", "X+"}, {"forward", "Z-"}, {"up", "Y+"}};
  scene["room"].erase("walls");
  scene["furniture"][0]["xform"] = {{"pos", {1.0, 0.25, -1.5}}, {"rot", {0, 90, 0}}};
  scene["constraints"][1]["alignAxis"] = "Z";
  const SceneGraph turned = read(scene);
  EXPECT_EQ(turned.objects[0].hint.position, (std::array<double, 3>{1000, 1500, 250}));
  EXPECT_EQ(turned.objects[0].hint.rotation_deg, 90);
  EXPECT_EQ(turned.relations[1].parameters.axis, Axis::kY);
}

TEST(PaperScene, LeftHandedFilesTurnTheOtherWay) {
  json scene = paper_scene();
  scene["metadata"]["axes"] = {{"right", "X+"}, {"forward", "Z+"}, {"up", "Y+"}};
  scene["room"]["walls"][2] = {{"id", "wall3"}, {"start", {4, 0, 3.2}}, {"end", {0, 0, 3.2}}};
  scene["room"]["walls"][1]["end"] = {4, 0, 3.2};
  scene["room"]["walls"][3]["start"] = {0, 0, 3.2};
  scene["furniture"][0]["xform"] = {{"pos", {1.0, 0.25, 1.5}}, {"rot", {0, 90, 0}}};
  const SceneGraph turned = read(scene);
  EXPECT_EQ(turned.room.walls[2].start, (Point{4000, 3200}));
  EXPECT_EQ(turned.objects[0].hint.position, (std::array<double, 3>{1000, 1500, 250}));
  EXPECT_EQ(turned.objects[0].hint.rotation_deg, 270);
}

TEST(PaperScene, ColoursOf255AreRead) {
  json scene = paper_scene();
  scene["materials"] = {{{"id", "a"}, {"color", {255, 0, 51}}}, {{"id", "b"}, {"color", {1, 0, 1}}, {"scaleUV", {1, 1}}}};
  const SceneGraph colours = read(scene);
  EXPECT_EQ(colours.materials[0].color, (Color{1, 0, 0.2}));
  EXPECT_EQ(colours.materials[1].color, (Color{1, 0, 1}));
}

TEST(PaperScene, NamesAreReadInAnyCase) {
  json scene = paper_scene();
  scene["constraints"][0]["type"] = "group_align";
  scene["constraints"][0]["relativeTo"] = "WALL_4";
  scene["constraints"][2]["targets"] = "Desk";
  scene["furniture"][0]["mount"] = "Floor";
  const SceneGraph named = read(scene);
  EXPECT_EQ(named.relations[0].type, RelationType::kGroupAlign);
  EXPECT_THAT(named.relations[0].references, ElementsAre("wall4"));
  EXPECT_THAT(named.relations[2].targets, ElementsAre("desk"));
  EXPECT_EQ(named.objects[0].mount, Mount::kFloor);
}

TEST(OwnScene, ARelationWithoutANameIsWrittenAsItWasRead) {
  const auto scene = read_scene(R"({"room": {"polygon": [[0, 0], [4, 0], [4, 3], [0, 3]], "height": 2.5},
    "furniture": [{"id": "bed", "category": "bed"}],
    "constraints": [{"type": "againstWall", "targets": ["bed"]}]})");
  ASSERT_TRUE(scene.has_value()) << scene.error().message;
  const auto again = read_scene(write_scene(*scene));
  ASSERT_TRUE(again.has_value()) << again.error().message;
  ASSERT_EQ(again->relations.size(), 1u);
  EXPECT_EQ(again->relations[0].targets, scene->relations[0].targets);
}

TEST(PaperScene, MissingMembersAreMissing) {
  const SceneGraph scene = read({{"room", json::object()}, {"furniture", json::array()}});
  EXPECT_THAT(scene.room.polygon, IsEmpty());
  EXPECT_EQ(scene.room.height, 0);
  EXPECT_FALSE(scene.room.openings_given);
  EXPECT_THAT(scene.relations, IsEmpty());
}

TEST(SceneSchema, KnowsExactlyTheRelationsOfTheTable) {
  const json schema = json::parse(embedded::scene_schema_json);
  std::vector<std::string> table;
  for (const RelationRow& row : relation_table()) table.emplace_back(row.name);
  EXPECT_THAT(schema["definitions"]["relationType"]["enum"].get<std::vector<std::string>>(), testing::ElementsAreArray(table));
}

TEST(SceneSchema, KnowsExactlyTheParametersAndTheirValues) {
  const json schema = json::parse(embedded::scene_schema_json);
  const json& members = schema["definitions"]["relation"]["properties"];
  const auto values = [&](const char* key) { return members[key]["enum"].get<std::vector<std::string>>(); };
  EXPECT_THAT(values("edge"), testing::ElementsAreArray(edge_names()));
  EXPECT_THAT(values("region"), testing::ElementsAreArray(region_names()));
  for (const std::string_view word : part_words()) {
    EXPECT_THAT(members["part"]["description"].get<std::string>(), HasSubstr(std::string(word)));
  }
  for (const RelationRow& row : relation_table()) {
    EXPECT_EQ(row.reads("edge"), !edges_of(row.type).empty()) << row.name;
    for (const char* key : {"edge", "region", "part", "gap", "min"}) EXPECT_TRUE(members.contains(key));
  }
  // Defaults are the table's: what the schema does not say cannot be another.
  for (const auto& [key, member] : members.items()) EXPECT_FALSE(member.contains("default")) << key;
}

Relation read_relation(json relation, std::vector<Note>* notes = nullptr) {
  json scene = paper_scene();
  relation["targets"] = {"bed"};
  if (!relation.contains("relativeTo") && relation["type"] != "inRegion") relation["relativeTo"] = "desk";
  scene["constraints"] = {relation};
  const SceneGraph read_scene = read(scene);
  if (notes != nullptr) *notes = read_scene.notes;
  return read_scene.relations.empty() ? Relation{} : read_scene.relations[0];
}

TEST(Places, EveryValueIsReadAndWrittenByItsName) {
  for (const std::string_view name : edge_names()) {
    const Relation relation = read_relation({{"type", "align"}, {"edge", name}});
    ASSERT_TRUE(relation.parameters.edge) << name;
    EXPECT_EQ(name_of(*relation.parameters.edge), name);
  }
  for (const std::string_view name : region_names()) {
    const Relation relation = read_relation({{"type", "inRegion"}, {"region", name}});
    ASSERT_TRUE(relation.parameters.region) << name;
    EXPECT_EQ(name_of(*relation.parameters.region), name);
  }
  for (const std::string_view name : part_words()) {
    const Relation relation = read_relation({{"type", "on"}, {"part", name}});
    ASSERT_EQ(relation.parameters.part.words().size(), 1u) << name;
    EXPECT_EQ(name_of(relation.parameters.part.words()[0]), name);
  }
}

TEST(Places, AreReadAsPeopleWriteThem) {
  std::vector<Note> notes;
  EXPECT_EQ(read_relation({{"type", "align"}, {"edge", "Centre"}}, &notes).parameters.edge, Edge::kCenter);
  const auto has_note = [&](const char* code) {
    return std::ranges::any_of(notes, [&](const Note& note) { return note.code == code && note.pointer == "/constraints/0/edge"; });
  };
  EXPECT_TRUE(has_note("converted"));
  EXPECT_EQ(read_relation({{"type", "edgeAlign"}, {"edge", "left edge"}}).parameters.edge, Edge::kLeft);
  EXPECT_EQ(read_relation({{"type", "inRegion"}, {"region", "the left-back corner"}}).parameters.region, RoomRegion::kBackLeft);
  EXPECT_EQ(read_relation({{"type", "inRegion"}, {"region", "center"}}).parameters.region, RoomRegion::kMiddle);
  EXPECT_EQ(read_relation({{"type", "inRegion"}, {"region", "middle left"}}).parameters.region, RoomRegion::kLeft);
  EXPECT_EQ(read_relation({{"type", "on"}, {"part", "left corner"}}).parameters.part, (ThingPart{PartWord::kLeft, PartWord::kCorner}));
  EXPECT_TRUE(read_relation({{"type", "on"}, {"part", "the middle"}}).parameters.part.has(PartWord::kCenter));
  // What a type does not read says nothing.
  EXPECT_FALSE(read_relation({{"type", "near"}, {"edge", "nonsense"}}, &notes).parameters.edge);
  EXPECT_TRUE(has_note("ignored"));
}

TEST(Origins, AreReadAndOlderFilesOnlySayAssumed) {
  const auto scene = read_scene(R"({
    "format": "layoutbox/scene@1",
    "room": {"dims": {"w": 4, "d": 3, "h": 2.5}, "openings": [{"id": "door1", "assumed": true}, {"id": "door2"}]},
    "furniture": [
      {"id": "bed", "category": "bed"},
      {"id": "lamp", "category": "lamp", "assumed": true, "mount": "surface", "mountAssumed": true},
      {"id": "chair", "category": "chair", "origin": "added", "assumed": true},
      {"id": "desk", "category": "desk", "origin": "concluded"}
    ],
    "constraints": [
      {"type": "on", "targets": ["lamp"], "relativeTo": "desk", "origin": "concluded", "assumed": true},
      {"type": "near", "targets": ["chair"], "relativeTo": "bed", "origin": "asked", "assumed": true}
    ]})");
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_EQ(scene->room.openings[0].origin, Origin::kAssumed);
  EXPECT_TRUE(scene->room.openings[1].asked());
  EXPECT_TRUE(scene->objects[0].asked());
  EXPECT_EQ(scene->objects[1].origin, Origin::kAssumed);
  EXPECT_TRUE(scene->objects[1].mount_assumed);
  EXPECT_EQ(scene->objects[2].origin, Origin::kAdded);
  EXPECT_EQ(scene->objects[3].origin, Origin::kConcluded);
  EXPECT_EQ(scene->relations[0].origin, Origin::kConcluded);
  EXPECT_TRUE(scene->relations[1].asked());  // the origin says more
  const nlohmann::json written = nlohmann::json::parse(write_scene(*scene));
  EXPECT_EQ(written["furniture"][0]["origin"], "asked");
  EXPECT_FALSE(written["furniture"][0].contains("assumed"));
  EXPECT_EQ(written["furniture"][3]["assumed"], true);
}

TEST(Documents, AreToldApart) {
  EXPECT_EQ(kind_of_document(paper_scene().dump()).value(), "scene");
  EXPECT_EQ(kind_of_document(R"({"format": "layoutbox/layout@1"})").value(), "layout");
  EXPECT_EQ(kind_of_document(R"({"room": {}, "objects": []})").value(), "layout");
  EXPECT_EQ(kind_of_document(R"({"format": "other"})").error().pointer, "/format");
  EXPECT_FALSE(kind_of_document("[]"));
  EXPECT_FALSE(kind_of_document("{}"));
}

TEST(Rooms, AreReadAlone) {
  const auto room =
      read_room(R"({"dims": {"width": 500, "depth": 400, "height": 250}, "openings": [{"id": "d", "wall": "back", "offset": 100}]})", "cm");
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_EQ(room->polygon[2], (Point{5000, 4000}));
  EXPECT_EQ(room->openings[0].offset, 1000);
  EXPECT_TRUE(read_room(paper_scene().dump())) << "a whole file gives its room";
  EXPECT_EQ(read_room(R"({"dims": {"w": -1, "d": 2}})").error().pointer, "/dims/w");
  EXPECT_FALSE(read_room("[1]"));
}

}  // namespace
}  // namespace layoutbox
