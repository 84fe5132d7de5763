// On what things stand, hang or lie where words do not say it.
#include <gmock/gmock.h>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/catalog/test_kinds.h"

namespace layoutbox {
namespace {

using namespace test_kinds;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;

TEST(NormalizeSupport, ATelevisionHangsWhereNothingOfItsKindCarriesIt) {
  EXPECT_EQ(normalized(scene_of({object("desk_1", "desk"), object("tv_1", "tv")})).objects[1].mount, Mount::kWall);
  EXPECT_EQ(normalized(scene_of({object("night_1", "nightstand"), object("tv_1", "tv")})).objects[1].mount, Mount::kSurface);
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

TEST(NormalizeSupport, CushionsAndBootsStandOnNoTops) {
  const SceneGraph scene = with_whole_catalogue(scene_of({object("low_1", "low_table"), object("case_1", "display_counter"),
                                                          object("freezer_1", "freezer"), object("a", "pillow"), object("b", "shoe")}));
  EXPECT_EQ(scene.objects[3].category, "floor_cushion");
  EXPECT_EQ(scene.objects[3].mount, Mount::kFloor);
  EXPECT_EQ(scene.objects[4].mount, Mount::kFloor);
  const SceneGraph bed = with_whole_catalogue(scene_of({object("low_1", "low_table"), object("bed_1", "bed"), object("a", "pillow")}));
  EXPECT_THAT(supports_of(bed, "a"), ElementsAre("bed_1"));
}

TEST(NormalizeSupport, BlanketsAreFoldedOverSeatsThatAreNarrower) {
  const SceneGraph scene = with_whole_catalogue(scene_of({object("chair_1", "armchair"), object("a", "blanket")}));
  EXPECT_THAT(supports_of(scene, "a"), ElementsAre("chair_1"));
  EXPECT_LT(scene.objects[1].size->greatest.width, scene.objects[0].size->usual.width);
  const SceneGraph bed = with_whole_catalogue(scene_of({object("bed_1", "bed"), object("a", "blanket")}));
  EXPECT_GT(bed.objects[1].size->usual.width, 1000);
}

TEST(NormalizeSupport, AMediumOneIsSmallerThanABigOneAndLargerThanALittleOne) {
  const auto sized = [](const char* word) {
    SceneObject bed = object("bed_1", "bed");
    bed.attributes = {word};
    return with_whole_catalogue(scene_of({bed})).objects[0].size.value();
  };
  EXPECT_LT(sized("little").usual.width, sized("medium").least.width);
  EXPECT_LT(sized("medium").usual.width, sized("big").least.width);
}

TEST(NormalizeSupport, CoatsHangOnTheHooksThatAreThere) {
  const SceneGraph scene = with_whole_catalogue(scene_of({object("bench_1", "bench"), object("freezer_1", "freezer"),
                                                          object("hooks_1", "hook_rail"), object("a", "garment"), object("b", "garment")}));
  EXPECT_THAT(supports_of(scene, "a"), ElementsAre("hooks_1"));
  EXPECT_THAT(supports_of(scene, "b"), ElementsAre("hooks_1"));
  const SceneGraph bare = with_whole_catalogue(scene_of({object("freezer_1", "freezer"), object("a", "garment")}));
  EXPECT_EQ(bare.objects[1].mount, Mount::kWall);
}

TEST(NormalizeSupport, NothingStandsWhereOneSitsWhileThereIsAnotherTop) {
  const SceneGraph scene =
      with_whole_catalogue(scene_of({object("seat_1", "window_seat"), object("dresser_1", "dresser"), object("a", "record_player")}));
  EXPECT_THAT(supports_of(scene, "a"), ElementsAre("dresser_1"));
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

}  // namespace
}  // namespace layoutbox
