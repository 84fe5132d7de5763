#include "layoutbox/catalog/normalize.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "layoutbox/scene/random_scene.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// A catalogue of a few plain kinds, so that these tests do not follow the data.
const Catalog& catalog() {
  static const Catalog value = Catalog::from_json(R"({"entries": [
    {"id": "bed", "name": "bed", "size": {"w": [0.9, 1.6, 2.0], "d": [1.9, 2.0, 2.2], "h": [0.4, 0.5, 1.2]}, "usedSides": ["front", "left", "right"],
     "variants": [{"words": ["king", "king size"], "size": {"w": [1.8, 1.9, 2.0]}}], "backToWall": true, "shape": {"family": "bed"}},
    {"id": "desk", "name": "desk", "synonyms": ["writing desk"], "size": {"w": [1.0, 1.2, 1.6], "d": [0.5, 0.6, 0.8], "h": 0.75}, "usedSides": ["front"],
     "topCarries": true, "shape": {"family": "desk"}},
    {"id": "nightstand", "name": "nightstand", "size": {"w": 0.4, "d": 0.4, "h": 0.5}, "topCarries": true, "shape": {"family": "cabinet"}},
    {"id": "lamp", "name": "lamp", "mount": "surface", "size": {"w": [0.2, 0.3, 0.4], "d": [0.2, 0.3, 0.4], "h": [0.3, 0.4, 0.6]}, "hasFront": false,
     "standsOn": ["nightstand", "desk"], "shape": {"family": "lamp"}},
    {"id": "floor_lamp", "name": "floor lamp", "kindOf": "lamp", "size": {"w": 0.4, "d": 0.4, "h": [1.3, 1.6, 1.8]}, "shape": {"family": "lamp"}},
    {"id": "book", "name": "book", "mount": "surface", "size": {"w": 0.2, "d": 0.15, "h": 0.03}, "shape": {"family": "book"}},
    {"id": "towel", "name": "towel", "mount": "hung", "size": {"w": 0.5, "d": 0.05, "h": 0.7}, "shape": {"family": "cloth"}},
    {"id": "rug", "name": "rug", "thin": true, "size": {"w": 2.0, "d": 1.4, "h": 0.02}, "shape": {"family": "rug"}},
    {"id": "plant", "name": "plant", "size": {"w": 0.4, "d": 0.4, "h": [0.3, 0.8, 1.5]}, "hasFront": false, "shape": {"family": "plant"}},
    {"id": "tv", "name": "TV", "mount": "surface", "hangHeight": 1.0, "size": {"w": 1.2, "d": 0.1, "h": 0.7}, "standsOn": ["nightstand"], "shape": {"family": "tv"}},
    {"id": "wardrobe", "name": "wardrobe", "size": {"w": [0.8, 1.5, 2.4], "d": 0.6, "h": [1.8, 2.0, 2.4]}, "shape": {"family": "cabinet"}}
  ]})",
                                                  R"({"rooms": [{"id": "bedroom", "name": "bedroom", "synonyms": ["master bedroom"],
    "size": {"w": 4.0, "d": 3.5, "h": 2.6}, "usual": [["bed", 1]]}]})")
                                   .value();
  return value;
}

SceneObject object(std::string id, std::string category) {
  SceneObject out;
  out.id = std::move(id);
  out.category = std::move(category);
  return out;
}

Relation relation(RelationType type, std::vector<std::string> targets, std::vector<std::string> references) {
  Relation out;
  out.type = type;
  out.targets = std::move(targets);
  out.references = std::move(references);
  return out;
}

SceneGraph scene_of(std::vector<SceneObject> objects, std::vector<Relation> relations = {}) {
  SceneGraph scene;
  scene.room.type = "bedroom";
  scene.objects = std::move(objects);
  scene.relations = std::move(relations);
  return scene;
}

SceneGraph normalized(SceneGraph scene, const NormalizeOptions& options = {}) {
  auto result = normalize_scene(std::move(scene), catalog(), options);
  if (!result) ADD_FAILURE() << result.error().message;
  return result.value_or(SceneGraph{});
}

Error error_of(SceneGraph scene) {
  const auto result = normalize_scene(std::move(scene), catalog());
  EXPECT_FALSE(result);
  return result ? Error{} : result.error();
}

std::vector<std::string> supports_of(const SceneGraph& scene, const std::string& id) {
  std::vector<std::string> out;
  for (const Relation& item : scene.relations) {
    if (item.type == RelationType::kOn && item.targets == std::vector{id}) out.push_back(item.references.at(0));
  }
  return out;
}

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

double area(const SceneGraph& scene) { return static_cast<double>(doubled_area(scene.room.polygon)) / 2e6; }

TEST(NormalizeHosts, GrowForWhatTheyHold) {
  const auto width = [](int lamps) {
    std::vector<SceneObject> objects{object("desk_1", "desk")};
    std::vector<Relation> relations;
    for (int i = 0; i < lamps; ++i) {
      objects.push_back(object("lamp_" + std::to_string(i), "lamp"));
      relations.push_back(relation(RelationType::kOn, {objects.back().id}, {"desk_1"}));
    }
    return normalized(scene_of(objects, relations)).find_object("desk_1")->size->usual.width;
  };
  EXPECT_EQ(width(1), 1200);
  EXPECT_EQ(width(3), 1200);
  EXPECT_GT(width(6), 1200);
  EXPECT_EQ(width(40), 1600);  // its range is the limit
}

TEST(NormalizeHosts, ASizeThatWasGivenStays) {
  SceneObject desk = object("desk_1", "desk");
  desk.size = SizeRange{{1000, 500, 750}, {1000, 500, 750}, {1000, 500, 750}};
  desk.size_source = SizeSource::kUser;
  std::vector<SceneObject> objects{desk};
  std::vector<Relation> relations;
  for (int i = 0; i < 8; ++i) {
    objects.push_back(object("lamp_" + std::to_string(i), "lamp"));
    relations.push_back(relation(RelationType::kOn, {objects.back().id}, {"desk_1"}));
  }
  EXPECT_EQ(normalized(scene_of(objects, relations)).find_object("desk_1")->size->usual.width, 1000);
}

TEST(NormalizeHosts, ATableSeatsAllThatSitAroundIt) {
  std::vector<SceneObject> objects{object("desk_1", "desk")};
  Relation around = relation(RelationType::kAround, {}, {"desk_1"});
  for (int i = 0; i < 7; ++i) {
    objects.push_back(object("plant_" + std::to_string(i), "plant"));
    around.targets.push_back(objects.back().id);
  }
  const Size size = normalized(scene_of(objects, {around})).find_object("desk_1")->size->usual;
  EXPECT_GE(2 * (size.width + size.depth), 7 * 600);
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

TEST(NormalizeObjects, TakeTheirSizeFromTheCatalogue) {
  const SceneGraph scene = normalized(scene_of({object("desk_1", "desk")}));
  EXPECT_EQ(scene.objects[0].size, catalog().find("desk")->size);
  EXPECT_EQ(scene.objects[0].size_source, SizeSource::kCatalog);
  EXPECT_EQ(scene.objects[0].mount, Mount::kFloor);
  EXPECT_THAT(*scene.objects[0].used_sides, ElementsAre(Side::kFront));
  EXPECT_THAT(scene.notes, Contains(Field(&Note::pointer, "/furniture/0/dims")));
}

TEST(NormalizeObjects, WordsNarrowTheSize) {
  SceneObject king = object("bed_1", "bed"), tall = object("plant_1", "plant"), small = object("desk_1", "desk");
  king.name = "king size bed";
  tall.attributes = {"tall"};
  small.attributes = {"small"};
  const SceneGraph scene = normalized(scene_of({king, tall, small}));
  EXPECT_EQ(scene.objects[0].size->least.width, 1800);
  EXPECT_EQ(scene.objects[0].size->least.depth, 1900);
  EXPECT_GE(scene.objects[1].size->least.height, 800);
  EXPECT_GT(scene.objects[1].size->usual.height, 1000);
  EXPECT_EQ(scene.objects[1].size->usual.width, 400);
  EXPECT_LE(scene.objects[2].size->greatest.width, 1200);
  EXPECT_LT(scene.objects[2].size->usual.width, 1100);
}

TEST(NormalizeSupport, ATelevisionHangsWhereNothingOfItsKindCarriesIt) {
  EXPECT_EQ(normalized(scene_of({object("desk_1", "desk"), object("tv_1", "tv")})).objects[1].mount, Mount::kWall);
  EXPECT_EQ(normalized(scene_of({object("night_1", "nightstand"), object("tv_1", "tv")})).objects[1].mount, Mount::kSurface);
}

TEST(NormalizeObjects, GivenSidesStayExact) {
  SceneObject desk = object("desk_1", "desk"), lamp = object("lamp_1", "lamp"), bed = object("bed_1", "bed");
  desk.size = SizeRange{{1234, 0, 0}, {1234, 0, 0}, {1234, 0, 0}};
  lamp.size = SizeRange{{250, 0, 0}, {250, 0, 0}, {250, 0, 0}};
  bed.size = SizeRange{{3, 3, 3}, {3, 3, 3}, {3, 3, 3}};
  const SceneGraph scene = normalized(scene_of({desk, lamp, bed}));
  EXPECT_EQ(scene.objects[0].size, (SizeRange{{1234, 500, 750}, {1234, 600, 750}, {1234, 800, 750}}));
  EXPECT_EQ(scene.objects[0].size_source, SizeSource::kInferred);
  EXPECT_EQ(scene.objects[1].size->least.depth, 250) << "what is as deep as wide stays so";
  EXPECT_EQ(scene.objects[2].size->usual, (Size{3, 3, 3})) << "odd sizes are not changed";
}

TEST(NormalizeObjects, ScaleIsWorkedIntoTheSize) {
  SceneObject desk = object("desk_1", "desk");
  desk.size = SizeRange{{1000, 500, 700}, {1000, 500, 700}, {1000, 500, 700}};
  desk.scale = {1, 2, 0.5};
  const SceneGraph scene = normalized(scene_of({desk}));
  EXPECT_EQ(scene.objects[0].size->usual, (Size{1000, 1000, 350}));
  EXPECT_EQ(scene.objects[0].scale, (std::array<double, 3>{1, 1, 1}));
}

TEST(NormalizeObjects, ImpossibleSizesAreErrors) {
  SceneObject desk = object("desk_1", "desk");
  desk.size = SizeRange{{-5, 500, 700}, {-5, 500, 700}, {-5, 500, 700}};
  EXPECT_EQ(error_of(scene_of({desk})).code, ErrorCode::kGeometry);
  desk.size = SizeRange{{60'000, 500, 700}, {60'000, 500, 700}, {60'000, 500, 700}};
  EXPECT_EQ(error_of(scene_of({desk})).pointer, "/furniture/0/dims");
  desk.size = SizeRange{{2000, 500, 700}, {1000, 500, 700}, {3000, 500, 700}};
  EXPECT_EQ(error_of(scene_of({desk})).pointer, "/furniture/0/dimsRange");
}

TEST(NormalizeObjects, CategoriesBecomeEntriesOrStayTheirOwn) {
  SceneObject writing = object("a", "Writing Desk"), king = object("b", "king bed"), picnic = object("c", "picnic desk"),
              odd = object("d", "spaceship");
  const SceneGraph scene = normalized(scene_of({writing, king, picnic, odd}));
  EXPECT_EQ(scene.objects[0].category, "desk");
  EXPECT_EQ(scene.objects[1].category, "bed");
  EXPECT_EQ(scene.objects[1].size->usual.width, 1900);
  EXPECT_EQ(scene.objects[2].category, "picnic_desk") << "a kind of its own stays that kind";
  EXPECT_EQ(scene.objects[2].size->usual.width, 1200);
  EXPECT_EQ(scene.objects[3].category, "spaceship");
  EXPECT_THAT(scene.notes, Contains(AllOf(Field(&Note::code, "guessed"), Field(&Note::message, HasSubstr("spaceship")))));
}

TEST(NormalizeObjects, IdsBecomeUnique) {
  const SceneGraph scene = normalized(scene_of({object("bed", "bed"), object("bed", "bed"), object("", "desk"), object("room", "desk")}));
  std::vector<std::string> ids;
  for (const SceneObject& item : scene.objects) ids.push_back(item.id);
  std::ranges::sort(ids);
  EXPECT_EQ(std::ranges::adjacent_find(ids), ids.end());
  EXPECT_THAT(ids, Not(Contains("room")));
  EXPECT_THAT(ids, Contains("bed"));
}

TEST(NormalizeObjects, RelationsDecideTheMount) {
  const SceneGraph scene =
      normalized(scene_of({object("plant_1", "plant"), object("plant_2", "plant"), object("plant_3", "plant"), object("desk_1", "desk"),
                           object("rug_1", "rug"), object("lamp_1", "lamp")},
                          {relation(RelationType::kOn, {"plant_1"}, {"desk_1"}), relation(RelationType::kOnWall, {"plant_2"}, {"back"}),
                           relation(RelationType::kOn, {"plant_3"}, {"rug_1"}), relation(RelationType::kOn, {"lamp_1"}, {"floor"})}));
  EXPECT_EQ(scene.objects[0].mount, Mount::kSurface);
  EXPECT_EQ(scene.objects[1].mount, Mount::kWall);
  EXPECT_EQ(scene.objects[2].mount, Mount::kFloor) << "what stands on a rug stands on the floor";
  EXPECT_EQ(scene.objects[5].mount, Mount::kFloor);
  EXPECT_THAT(scene.relations[1].references, ElementsAre("wall3"));
}

TEST(NormalizeSupport, LampsGoWhereLampsGo) {
  const SceneGraph scene = normalized(scene_of({object("desk_1", "desk"), object("night_1", "nightstand"), object("night_2", "nightstand"),
                                                object("a", "lamp"), object("b", "lamp")}));
  EXPECT_THAT(supports_of(scene, "a"), ElementsAre("night_1"));
  EXPECT_THAT(supports_of(scene, "b"), ElementsAre("night_2")) << "the free one";
  EXPECT_TRUE(std::ranges::all_of(scene.relations, [](const Relation& item) { return !item.asked(); }));
}

TEST(NormalizeSupport, WhatIsTooTallForATableStandsOnTheFloor) {
  SceneObject lamp = object("a", "lamp");
  lamp.size = SizeRange{{400, 400, 1500}, {400, 400, 1500}, {400, 400, 1500}};
  const SceneGraph scene = normalized(scene_of({object("night_1", "nightstand"), lamp}));
  EXPECT_EQ(scene.objects[1].mount, Mount::kFloor);
  EXPECT_TRUE(scene.relations.empty());
}

TEST(NormalizeObjects, AMountIsAssumedWhereNoRelationSaysIt) {
  const SceneGraph scene =
      normalized(scene_of({object("a", "lamp"), object("b", "tv"), object("c", "wardrobe"), object("d", "desk")},
                          {relation(RelationType::kOn, {"a"}, {"floor"}), relation(RelationType::kOnWall, {"c"}, {"back"})}));
  EXPECT_EQ(scene.objects[0].mount, Mount::kFloor);
  EXPECT_FALSE(scene.objects[0].mount_assumed);
  EXPECT_TRUE(scene.objects[1].mount_assumed);
  EXPECT_FALSE(scene.objects[2].mount_assumed);
  EXPECT_TRUE(scene.objects[3].mount_assumed);
}

TEST(NormalizeSupport, WhatIsSaidHolds) {
  const SceneGraph scene = normalized(scene_of({object("desk_1", "desk"), object("night_1", "nightstand"), object("a", "lamp")},
                                               {relation(RelationType::kOn, {"a"}, {"desk_1"})}));
  EXPECT_THAT(supports_of(scene, "a"), ElementsAre("desk_1"));
}

TEST(NormalizeSupport, ThePapersInsideMeansOnIt) {
  const SceneGraph scene = normalized(scene_of({object("desk_1", "desk"), object("night_1", "nightstand"), object("a", "lamp")},
                                               {relation(RelationType::kInside, {"a"}, {"desk_1"})}));
  EXPECT_THAT(supports_of(scene, "a"), ElementsAre("desk_1"));
}

TEST(NormalizeSupport, WhatStandsBesideSomethingIsNotOnIt) {
  const SceneGraph scene =
      normalized(scene_of({object("desk_1", "desk"), object("a", "lamp")}, {relation(RelationType::kRightOf, {"a"}, {"desk_1"})}));
  EXPECT_THAT(supports_of(scene, "a"), IsEmpty());
  EXPECT_EQ(scene.objects[1].mount, Mount::kFloor);
  EXPECT_EQ(scene.objects[1].category, "floor_lamp");
  EXPECT_EQ(scene.objects[1].name, "lamp");
  EXPECT_EQ(scene.objects[1].size->usual.height, 1600);
  EXPECT_THAT(scene.notes, Contains(Field(&Note::pointer, "/furniture/1/mount")));
}

TEST(NormalizeSupport, AnyTopServesElseTheFloorOrAWall) {
  const SceneGraph on_desk = normalized(scene_of({object("desk_1", "desk"), object("a", "book")}));
  EXPECT_THAT(supports_of(on_desk, "a"), ElementsAre("desk_1"));
  const SceneGraph bare = normalized(scene_of({object("bed_1", "bed"), object("a", "book"), object("b", "towel")}));
  EXPECT_EQ(bare.objects[1].mount, Mount::kFloor);
  EXPECT_EQ(bare.objects[2].mount, Mount::kWall);
}

TEST(NormalizeSupport, HeightsOfOthersFilesAreSettled) {
  SceneGraph scene = scene_of({object("bed_1", "bed"), object("desk_1", "desk"), object("a", "lamp"), object("b", "lamp")});
  const auto at = [&](std::size_t i, double z, Size size) {
    scene.objects[i].hint.position = {1000, 1000, z};
    scene.objects[i].hint.z_may_be_centre = true;
    scene.objects[i].size = SizeRange{size, size, size};
  };
  at(0, 250, {1600, 2000, 500});  // the centre of a bed of 0.5 m
  at(1, 0, {1200, 600, 750});     // the underside of a desk
  at(2, 750, {200, 200, 400});    // the underside, on the desk
  at(3, 950, {200, 200, 400});    // the centre, on the desk
  scene = normalized(scene);
  EXPECT_EQ((*scene.objects[0].hint.position)[2], 0);
  EXPECT_EQ((*scene.objects[1].hint.position)[2], 0);
  EXPECT_EQ((*scene.objects[2].hint.position)[2], 750);
  EXPECT_EQ((*scene.objects[3].hint.position)[2], 750);
}

TEST(NormalizeRelations, ToNobodyAreLeftOutAndNoted) {
  const SceneGraph scene = normalized(
      scene_of({object("bed_1", "bed"), object("desk_1", "desk")},
               {relation(RelationType::kNear, {"desk_1"}, {"ghost"}), relation(RelationType::kRow, {"bed_1", "ghost", "desk_1"}, {}),
                relation(RelationType::kNearDoor, {"desk_1"}, {"door"})}));
  ASSERT_EQ(scene.relations.size(), 2u);
  EXPECT_THAT(scene.relations[0].targets, ElementsAre("bed_1", "desk_1"));
  EXPECT_THAT(scene.relations[1].references, ElementsAre("door1"));
  EXPECT_THAT(scene.notes, Contains(Field(&Note::message, HasSubstr("ghost"))));
  EXPECT_NE(scene.relations[0].id, scene.relations[1].id);
}

// What solve() requires holds for whatever came in, and a second time changes nothing.
TEST(NormalizeScene, AnyValidSceneBecomesCompleteAndStaysSo) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto first = normalize_scene(RandomScenes(seed).scene(), Catalog::builtin());
    if (!first) {
      EXPECT_EQ(first.error().code, ErrorCode::kGeometry) << "seed " << seed << ": " << first.error().message;
      continue;
    }
    EXPECT_GE(first->room.polygon.size(), 3u) << "seed " << seed;
    EXPECT_GT(doubled_area(first->room.polygon), 0);
    ASSERT_EQ(first->room.walls.size(), first->room.polygon.size());
    for (std::size_t i = 0; i < first->room.walls.size(); ++i)
      ASSERT_EQ(first->room.walls[i].start, first->room.polygon[i]) << "seed " << seed;
    EXPECT_GT(first->room.height, 0);
    for (const SceneObject& item : first->objects) {
      ASSERT_TRUE(item.size && item.mount && item.used_sides) << "seed " << seed;
      ASSERT_GT(item.size->least.width, 0) << "seed " << seed;
      ASSERT_LE(item.size->least.height, item.size->greatest.height) << "seed " << seed;
    }
    auto again = normalize_scene(*first, Catalog::builtin());
    ASSERT_TRUE(again) << "seed " << seed;
    again->notes = first->notes;
    ASSERT_EQ(write_scene(*again), write_scene(*first)) << "seed " << seed;
    ASSERT_TRUE(read_scene(write_scene(*first))) << "seed " << seed;
  }
}

}  // namespace
}  // namespace layoutbox
