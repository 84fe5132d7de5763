#include "layoutbox/catalog/normalize.h"

#include <gmock/gmock.h>

#include <cmath>

#include "layoutbox/catalog/test_kinds.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

using namespace test_kinds;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;

TEST(NormalizeRoom, WallsThatNobodyNamedGiveWayToAThingOfTheirName) {
  SceneGraph scene;
  scene.objects = {object("wall1", "bed"), object("room_wall3", "desk"), object("wall3", "desk")};
  const auto normal = normalize_scene(scene, catalog());
  ASSERT_TRUE(normal) << normal.error().message;
  std::vector<std::string> ids;
  for (const Wall& wall : normal->room.walls) ids.push_back(wall.id);
  EXPECT_THAT(ids, ElementsAre("room_wall1", "wall2", "room_room_wall3", "wall4"));
}

TEST(NormalizeRoom, FillsASizeForTheKindOfRoom) {
  const SceneGraph scene = normalized(scene_of({}));
  EXPECT_THAT(scene.room.polygon, ElementsAre(Point{0, 0}, Point{4000, 0}, Point{4000, 3500}, Point{0, 3500}));
  EXPECT_EQ(scene.room.height, 2600);
  ASSERT_EQ(scene.room.walls.size(), 4u);
  EXPECT_EQ(scene.find_wall("front")->id, "wall1");
  EXPECT_EQ(scene.find_wall("right")->id, "wall2");
  EXPECT_EQ(scene.find_wall("back")->id, "wall3");
  EXPECT_EQ(scene.find_wall("left")->id, "wall4");
  EXPECT_THAT(scene.notes, Contains(AllOf(Field(&Note::code, "filled"), Field(&Note::pointer, "/room/dims"))));
}

TEST(NormalizeRoom, IsSmallForLittleUnlessTheTextSaysHowLarge) {
  const SceneGraph little = normalized(scene_of({object("chair_1", "chair")})), nothing = normalized(scene_of({}));
  EXPECT_LT(doubled_area(little.room.polygon), doubled_area(nothing.room.polygon));
  SceneGraph large = scene_of({object("chair_1", "chair")});
  large.room.size_word = "medium";
  EXPECT_EQ(doubled_area(normalized(large).room.polygon), doubled_area(nothing.room.polygon));
}

TEST(NormalizeRoom, IsSmallerAndFullerWhereTheTextCallsItTiny) {
  const auto area_of = [](const char* word) {
    SceneGraph scene = scene_of({object("chair_1", "chair")});
    scene.room.size_word = word;
    return doubled_area(normalized(scene).room.polygon);
  };
  EXPECT_LT(area_of("tiny"), area_of(""));
  EXPECT_LT(area_of("tiny"), area_of("small"));
  EXPECT_LT(area_of("small"), area_of("medium"));
}

TEST(NormalizeObjects, PicturesAboveOneThingAreTogetherNoWiderThanIt) {
  std::vector<SceneObject> objects{object("desk_1", "desk")};
  std::vector<Relation> relations;
  for (int i = 0; i < 4; ++i) {
    objects.push_back(object("painting_" + std::to_string(i), "painting"));
    objects.back().mount = Mount::kWall;
    relations.push_back(relation(RelationType::kAbove, {objects.back().id}, {"desk_1"}));
  }
  const SceneGraph alone = normalized(scene_of({objects[0], objects[1]})), row = normalized(scene_of(objects, relations));
  EXPECT_LT(row.find_object("painting_0")->size->usual.width, alone.find_object("painting_0")->size->usual.width);
}

double area(const SceneGraph& scene) { return static_cast<double>(doubled_area(scene.room.polygon)) / 2e6; }

TEST(NormalizeRoom, GrowsUntilWhatIsToBeFarCanBe) {
  const auto diagonal = [](RelationType type) {
    const Point corner =
        normalized(scene_of({object("bed_1", "bed"), object("wardrobe_1", "wardrobe")}, {relation(type, {"bed_1"}, {"wardrobe_1"})}))
            .room.polygon[2];
    return std::hypot(double(corner.x), double(corner.y));
  };
  EXPECT_GT(diagonal(RelationType::kFar), diagonal(RelationType::kNextTo) + 500);
}

TEST(NormalizeRoom, IsRatherLongerThanLargerWhereThingsAreToBeFarApart) {
  SceneGraph scene = scene_of({object("crib_1", "crib"), object("changing_table_1", "changing_table")},
                              {relation(RelationType::kFar, {"crib_1"}, {"changing_table_1"})});
  const Point corner = normalized(std::move(scene)).room.polygon[2];
  EXPECT_GT(std::max(corner.x, corner.y), 1.3 * std::min(corner.x, corner.y));
}

TEST(NormalizeRoom, FarIsAsFarAsARoomOfGivenSizeGoes) {
  const auto least = [](Mm width, Mm depth) {
    SceneGraph scene =
        scene_of({object("desk_1", "desk"), object("lamp_1", "floor_lamp")}, {relation(RelationType::kFar, {"desk_1"}, {"lamp_1"})});
    scene.room.polygon = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
    return normalized(std::move(scene)).relations[0].parameters.min;
  };
  EXPECT_FALSE(least(8000, 6000));
  ASSERT_TRUE(least(3000, 3000));
  EXPECT_LT(*least(3000, 3000), 3000);
  EXPECT_GT(*least(3000, 3000), 1500);
}

TEST(NormalizeRoom, WhatStandsOppositeABedFindsRoomAcrossFromIt) {
  const Point corner = normalized(scene_of({object("bed_1", "bed"), object("wardrobe_1", "wardrobe")},
                                           {relation(RelationType::kOpposite, {"wardrobe_1"}, {"bed_1"})}))
                           .room.polygon[2];
  EXPECT_GE(std::max(corner.x, corner.y), 2000 + 1500 + 600);
}

TEST(NormalizeRoom, InANarrowRoomWhatIsOppositeIsAsFarAsThereIsRoom) {
  SceneGraph scene =
      scene_of({object("bed_1", "bed"), object("wardrobe_1", "wardrobe")},
               {relation(RelationType::kOpposite, {"wardrobe_1"}, {"bed_1"}), relation(RelationType::kAgainstWall, {"bed_1"}, {"left"})});
  const auto least = [&](Mm width) {
    scene.room.polygon = room_outline("", width, 4000);
    return normalized(scene).relations[0].parameters.min;
  };
  EXPECT_FALSE(least(5000));
  ASSERT_TRUE(least(3400));
  EXPECT_LT(*least(3400), 1000);
  EXPECT_GT(*least(3400), 400);
}

TEST(NormalizeRoom, WhatGoesFromFloorToCeilingIsAsHighAsTheRoom) {
  std::vector<SceneObject> objects{object("wardrobe_1", "wardrobe"), object("wardrobe_2", "wardrobe")};
  objects[0].size = objects[1].size = std::nullopt;
  objects[0].attributes = {"floor to ceiling"};
  const SceneGraph scene = normalized(scene_of(objects, {}));
  EXPECT_GT(scene.find_object("wardrobe_1")->size->least.height, scene.room.height - 50);
  EXPECT_LE(scene.find_object("wardrobe_1")->size->greatest.height, scene.room.height);
  EXPECT_LT(scene.find_object("wardrobe_2")->size->usual.height, scene.room.height - 50);
}

TEST(NormalizeRoom, WhatHangsAboveSomethingEndsBelowTheCeiling) {
  std::vector<SceneObject> objects{object("desk_1", "desk"), object("wardrobe_1", "wardrobe")};
  objects[1].mount = Mount::kWall;
  const SceneGraph scene = normalized(scene_of(objects, {relation(RelationType::kAbove, {"wardrobe_1"}, {"desk_1"})}));
  const SizeRange& size = *scene.find_object("wardrobe_1")->size;
  EXPECT_LE(size.usual.height, scene.room.height - 750);
  EXPECT_LE(size.least.height, size.usual.height);
}

TEST(NormalizeRoom, GrowsWithItsFurniture) {
  std::vector<SceneObject> beds;
  for (int i = 0; i < 6; ++i) beds.push_back(object("bed_" + std::to_string(i), "bed"));
  const SceneGraph scene = normalized(scene_of(beds));
  EXPECT_GE(area(scene), 6 * 3.2 / 0.35);
  EXPECT_LE(area(scene), 6 * 3.2 / 0.25);
}

TEST(NormalizeRoom, ReadsAreaSizeWordsAndShape) {
  SceneGraph scene = scene_of({});
  scene.room.area_m2 = 20;
  EXPECT_NEAR(area(normalized(scene)), 20, 0.1);
  scene.room.shape = "L";
  EXPECT_NEAR(area(normalized(scene)), 20, 0.3);
  EXPECT_EQ(normalized(scene).room.walls.size(), 6u);
  scene.room.shape = "T";
  EXPECT_EQ(normalized(scene).room.walls.size(), 8u);
  scene.room.shape = "U";
  EXPECT_EQ(normalized(scene).room.walls.size(), 8u);
  scene = scene_of({});
  const double ordinary = area(normalized(scene));
  scene.room.size_word = "spacious";
  EXPECT_GT(area(normalized(scene)), ordinary);
  scene.room.size_word = "small";
  EXPECT_LT(area(normalized(scene)), ordinary);
}

TEST(NormalizeRoom, TheCallersSizeWins) {
  SceneGraph scene = scene_of({});
  scene.room.polygon = {{0, 0}, {9000, 0}, {9000, 9000}, {0, 9000}};
  scene = normalized(scene, {{5000, 4000, 3000}, true});
  EXPECT_EQ(scene.room.polygon[2], (Point{5000, 4000}));
  EXPECT_EQ(scene.room.height, 3000);
  EXPECT_THAT(scene.notes, Contains(Field(&Note::code, "contradiction")));
}

TEST(NormalizeRoom, GetsADoorAndAWindowOnlyWhereNothingIsSaid) {
  const SceneGraph scene = normalized(scene_of({}));
  ASSERT_EQ(scene.room.openings.size(), 2u);
  EXPECT_EQ(scene.room.openings[0].type, OpeningType::kDoor);
  EXPECT_EQ(scene.room.openings[1].type, OpeningType::kWindow);
  for (const Opening& opening : scene.room.openings) {
    EXPECT_EQ(opening.origin, Origin::kAssumed);
    EXPECT_THAT(opening.wall, IsEmpty());
    EXPECT_FALSE(opening.offset);
  }
  SceneGraph none = scene_of({});
  none.room.openings_given = true;
  EXPECT_THAT(normalized(none).room.openings, IsEmpty());
  EXPECT_THAT(normalized(scene_of({}), {{}, false}).room.openings, IsEmpty());
  SceneGraph one = scene_of({});
  one.room.openings = {Opening{}};
  one.room.openings[0].id = "way_in";
  EXPECT_EQ(normalized(one).room.openings.size(), 1u);
}

TEST(NormalizeRoom, DefaultsGiveWayToSmallRooms) {
  const SceneGraph scene = normalized(scene_of({}), {{900, 800, 1900}, true});
  for (const Opening& opening : scene.room.openings) {
    EXPECT_LE(opening.width, 800);
    EXPECT_LE(opening.sill + opening.height, 1900);
    EXPECT_GT(opening.width, 0);
    EXPECT_GT(opening.height, 0);
  }
}

TEST(NormalizeRoom, AWindowIsAsWideAsWhatStandsUnderIt) {
  const auto width = [](int desks, Origin origin) {
    std::vector<SceneObject> objects;
    std::vector<Relation> relations;
    for (int i = 0; i < desks; ++i) {
      objects.push_back(object("desk_" + std::to_string(i), "desk"));
      relations.push_back(relation(RelationType::kUnderWindow, {objects.back().id}, {"window1"}));
    }
    SceneGraph scene = scene_of(objects, relations);
    scene.room.polygon = {{0, 0}, {5000, 0}, {5000, 3500}, {0, 3500}};
    Opening window;
    window.id = "window1", window.type = OpeningType::kWindow, window.width = 1200, window.height = 1200, window.sill = 900;
    window.origin = origin;
    scene.room.openings = {window};
    return normalized(scene).room.openings[0].width;
  };
  EXPECT_EQ(width(0, Origin::kAssumed), 1200);
  EXPECT_GE(width(2, Origin::kAssumed), 2400);
  EXPECT_LE(width(9, Origin::kAssumed), 3750) << "the wall is the limit";
  EXPECT_EQ(width(2, Origin::kAsked), 1200) << "a size that was said stays";
}

TEST(NormalizeRoom, AnAssumedWindowLightsALargeRoom) {
  const auto width = [](Mm depth) {
    SceneGraph scene = scene_of({object("desk_1", "desk")}, {});
    scene.room.polygon = {{0, 0}, {8000, 0}, {8000, depth}, {0, depth}};
    const SceneGraph settled = normalized(scene);
    const auto window = std::ranges::find(settled.room.openings, OpeningType::kWindow, &Opening::type);
    return window == settled.room.openings.end() ? Mm{0} : window->width;
  };
  EXPECT_EQ(width(2000), 1200);
  EXPECT_GE(width(4000) * 1.2, 0.08 * 8000 * 4) << "8 % of the floor";
  EXPECT_GT(width(6000), width(4000));
}

TEST(NormalizeRoom, AnAssumedWindowBeginsAboveWhatIsToldToStandUnderIt) {
  SceneGraph scene;
  scene.room.type = "kitchen";
  scene.objects = {object("kitchen_sink_1", "kitchen_sink")};
  scene.relations = {relation(RelationType::kUnderWindow, {"kitchen_sink_1"}, {})};
  const auto settled = normalize_scene(scene, Catalog::builtin(), {});
  ASSERT_TRUE(settled);
  const auto window = std::ranges::find(settled->room.openings, OpeningType::kWindow, &Opening::type);
  ASSERT_NE(window, settled->room.openings.end());
  EXPECT_GE(window->sill, settled->objects[0].size->usual.height);
  EXPECT_GE(window->height, 600);
}

TEST(NormalizeRoom, TheWindowOfARoomWithoutOneIsAsWideAsTheTablesAlongItAndTheirChairs) {
  std::vector<SceneObject> objects;
  std::vector<Relation> relations;
  for (const char* table : {"table_1", "table_2"}) {
    objects.push_back(object(table, "side_table"));
    relations.push_back(relation(RelationType::kUnderWindow, {table}, {}));
  }
  const auto width = [&] {
    SceneGraph scene = scene_of(objects, relations);
    scene.room.polygon = {{0, 0}, {6000, 0}, {6000, 3000}, {0, 3000}};
    const SceneGraph settled = normalized(scene);
    const auto window = std::ranges::find(settled.room.openings, OpeningType::kWindow, &Opening::type);
    return window == settled.room.openings.end() ? Mm{0} : window->width;
  };
  EXPECT_EQ(width(), 1200) << "two small tables find room under it";
  for (int i = 1; i <= 2; ++i) {
    objects.push_back(object("chair_" + std::to_string(i), "chair"));
    relations.push_back(relation(RelationType::kAround, {objects.back().id}, {"table_" + std::to_string(i)}));
  }
  EXPECT_GE(width(), 2600);
}

TEST(NormalizeRoom, TurnsWallsWithTheirOpenings) {
  SceneGraph scene = scene_of({});
  const auto wall = [](std::string id, Point start, Point end) {
    Wall out;
    out.id = std::move(id);
    out.start = start;
    out.end = end;
    return out;
  };
  scene.room.walls = {wall("N", {0, 3000}, {4000, 3000}), wall("W", {0, 0}, {0, 3000}), wall("S", {0, 0}, {4000, 0}),
                      wall("E", {4000, 3000}, {4000, 0})};
  Opening door;
  door.id = "d";
  door.wall = "N";
  door.offset = 500;
  scene.room.openings = {door};
  scene = normalized(scene);
  EXPECT_EQ(scene.room.walls[0].id, "S");
  EXPECT_EQ(scene.room.walls[2].id, "N");
  EXPECT_EQ(scene.room.walls[2].start, (Point{4000, 3000}));
  EXPECT_EQ(scene.room.openings[0].offset, 4000 - 500 - 900);
}

TEST(NormalizeRoom, MovesTheOriginIntoTheCorner) {
  SceneGraph scene = scene_of({object("bed_1", "bed")});
  scene.room.polygon = {{-2000, -1000}, {2000, -1000}, {2000, 2000}, {-2000, 2000}};
  scene.objects[0].hint.position = {0, 0, 0};
  scene = normalized(scene);
  EXPECT_EQ(scene.room.polygon[0], (Point{0, 0}));
  EXPECT_EQ(scene.objects[0].hint.position, (std::array<double, 3>{2000, 1000, 0}));
}

TEST(NormalizeRoom, ImpossibleRoomsAreErrors) {
  SceneGraph scene = scene_of({});
  scene.room.polygon = {{0, 0}, {200'000, 0}, {200'000, 4000}, {0, 4000}};
  EXPECT_EQ(error_of(scene).code, ErrorCode::kGeometry);
  scene.room.polygon = {{0, 0}, {4000, 3000}, {4000, 0}, {0, 3000}};
  EXPECT_EQ(error_of(scene).code, ErrorCode::kGeometry);
  scene = scene_of({});
  scene.room.height = -1;
  EXPECT_EQ(error_of(scene).code, ErrorCode::kGeometry);
}

}  // namespace
}  // namespace layoutbox
