// What holds other things is large enough for them.
#include <gmock/gmock.h>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/catalog/test_kinds.h"

namespace layoutbox {
namespace {

using namespace test_kinds;

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
  EXPECT_GT(width(40), 1600);   // small ones find room on a larger one
  EXPECT_EQ(width(400), 1600);  // its range is the limit where nothing helps
}

// A little beyond its range, where all then finds room; that a host is larger than such things mostly are beats leaving things out.
TEST(NormalizeHosts, GrowBeyondTheirRangeWhereThatIsEnough) {
  std::vector<SceneObject> objects{object("desk_1", "desk")};
  std::vector<Relation> relations;
  for (int i = 0; i < 16; ++i) {
    objects.push_back(object("lamp_" + std::to_string(i), "lamp"));
    relations.push_back(relation(RelationType::kOn, {objects.back().id}, {"desk_1"}));
  }
  const Mm width = normalized(scene_of(objects, relations)).find_object("desk_1")->size->usual.width;
  EXPECT_GT(width, 1600);
  EXPECT_LE(width, 2400);
}

TEST(NormalizeHosts, SeatsAcrossFromAnotherStandSideBySide) {
  std::vector<SceneObject> objects{object("desk_1", "desk"), object("bench_1", "nightstand")};
  std::vector<Relation> relations{relation(RelationType::kAlongSide, {"bench_1"}, {"desk_1"}),
                                  relation(RelationType::kOpposite, {}, {"bench_1"})};
  for (const char* seat : {"seat_1", "seat_2"}) {
    objects.push_back(object(seat, "nightstand"));
    relations.push_back(relation(RelationType::kAlongSide, {seat}, {"desk_1"}));
    relations[1].targets.push_back(seat);
  }
  EXPECT_GE(normalized(scene_of(objects, relations)).find_object("desk_1")->size->usual.width, 1240);
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

TEST(NormalizeHosts, ABarForTwoKeepsItsDepth) {
  const SceneGraph scene =
      with_whole_catalogue(scene_of({object("bar_1", "bar_counter"), object("stool_1", "bar_stool"), object("stool_2", "bar_stool")},
                                    {relation(RelationType::kInFrontOf, {"stool_1", "stool_2"}, {"bar_1"})}));
  EXPECT_GE(scene.objects[0].size->usual.depth, 500);
}

// Armchairs need more of a table's edge than chairs do.
TEST(NormalizeHosts, ATableIsLargerForWideSeats) {
  const auto edge = [](const char* kind) {
    std::vector<SceneObject> objects{object("table_1", "dining_table")};
    Relation around = relation(RelationType::kAround, {}, {"table_1"});
    for (int i = 0; i < 10; ++i) {
      objects.push_back(object("seat_" + std::to_string(i), kind));
      around.targets.push_back(objects.back().id);
    }
    const Size size = with_whole_catalogue(scene_of(objects, {around})).objects[0].size->usual;
    return 2 * (size.width + size.depth);
  };
  EXPECT_GE(edge("armchair"), 10 * 780);
  EXPECT_LT(edge("dining_chair"), 10 * 780);
}

// Whatever the order in which it is said.
TEST(NormalizeHosts, WhatIsInSomethingFitsItWhereThatFitsWhatItStandsOn) {
  const SceneGraph scene = with_whole_catalogue(
      scene_of({object("fern_1", "fern"), object("basket_1", "basket"), object("stool_1", "stool")},
               {relation(RelationType::kIn, {"fern_1"}, {"basket_1"}), relation(RelationType::kOn, {"basket_1"}, {"stool_1"})}));
  const auto width = [&](std::size_t i) { return scene.objects[i].size->usual.width; };
  const auto least = [&](std::size_t i) { return scene.objects[i].size->least.width; };
  EXPECT_LE(least(0), width(1));
  EXPECT_LE(width(1), width(2));
}

// A shelf below mirrors on the wall hangs there, along all of them.
TEST(NormalizeHosts, ShelvesBelowMirrorsHang) {
  std::vector<SceneObject> objects{object("shelf_1", "shelf")};
  std::vector<Relation> relations;
  for (const std::string k : {"1", "2", "3"}) {
    objects.push_back(object("mirror_" + k, "mirror"));
    objects.push_back(object("salon_chair_" + k, "salon_chair"));
    relations.push_back(relation(RelationType::kInFrontOf, {"salon_chair_" + k}, {"mirror_" + k}));
    relations.push_back(relation(RelationType::kAbove, {"mirror_" + k}, {"shelf_1"}));
  }
  const Catalog& catalog = Catalog::builtin();
  const SceneGraph scene = *normalize_scene(scene_of(objects, relations), catalog);
  EXPECT_EQ(scene.find_object("shelf_1")->mount, Mount::kWall);
  EXPECT_GT(scene.find_object("shelf_1")->size->usual.width, 2500);
}

}  // namespace
}  // namespace layoutbox
