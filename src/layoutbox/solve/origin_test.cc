// Asked beats concluded beats assumed: what nobody asked for gives way without a conflict, and the room is as asked.
#include <gmock/gmock.h>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

SceneMaker& by(SceneMaker& maker, Origin origin) {
  maker.raw().relations.back().origin = origin;
  return maker;
}

Layout solved(const SceneGraph& scene, OnConflict on_conflict = OnConflict::kRelax) {
  SolveOptions options;
  options.on_conflict = on_conflict;
  const auto layout = solve(scene, Catalog::builtin(), options);
  EXPECT_TRUE(layout) << layout.error().message;
  return layout ? *layout : Layout{};
}

// All that was asked for holds, whatever gave way.
void expect_as_asked(const Layout& layout) {
  EXPECT_EQ(layout.status, LayoutStatus::kSolved);
  EXPECT_TRUE(layout.relaxed.empty()) << layout.relaxed[0].why;
  EXPECT_TRUE(layout.conflicts.empty()) << layout.conflicts[0].sentence;
  for (const PlacedRelation& placed : layout.relations) {
    if (placed.relation.asked() && placed.relation.hard) {
      EXPECT_TRUE(placed.held) << placed.relation.id;
    }
  }
  expect_sound(layout);
}

TEST(Origins, WhatIsAssumedGivesWayToWhatIsAsked) {
  for (const Origin origin : {Origin::kAssumed, Origin::kAdded, Origin::kConcluded}) {
    SceneMaker maker(4000, 3500);
    maker.add("bed").add("wardrobe");
    maker.relate("againstWall", {"bed_1"}, {"wall3"}).relate("againstWall", {"bed_1"}, {"wall1"});
    by(maker, origin);
    for (const OnConflict mode : {OnConflict::kRelax, OnConflict::kFail}) {
      const Layout layout = solved(maker.make(), mode);
      expect_as_asked(layout);
      ASSERT_EQ(layout.gave_way.size(), 1u);
      EXPECT_EQ(layout.gave_way[0].relation, "c2");
      EXPECT_THAT(layout.gave_way[0].why, HasSubstr("the bed"));
    }
  }
}

TEST(Origins, OfTwoThatNobodyAskedForTheLowerGives) {
  SceneMaker maker(4000, 3500);
  maker.add("bed");
  maker.relate("againstWall", {"bed_1"}, {"wall3"});
  by(maker, Origin::kAssumed);
  maker.relate("againstWall", {"bed_1"}, {"wall1"});
  by(maker, Origin::kConcluded);
  const Layout layout = solved(maker.make());
  ASSERT_EQ(layout.gave_way.size(), 1u);
  EXPECT_EQ(layout.gave_way[0].relation, "c1");
}

TEST(Origins, AnAssumedHostGivesWay) {
  SceneMaker maker(4000, 3500);
  maker.add("nightstand").add("bed").add("lamp");
  maker.relate("on", {"lamp_1"}, {"nightstand_1"});
  by(maker, Origin::kAssumed);
  RelationParameters apart;
  apart.min = 1500;
  maker.relate("distance", {"lamp_1"}, {"nightstand_1"}, apart);
  expect_as_asked(solved(maker.make()));
}

TEST(Origins, ObjectsThatNobodyAskedForAreLeftOutFirst) {
  SceneMaker maker(2300, 2300);
  maker.add("bed").sized(1600, 2000, 500).add("wardrobe").sized(1200, 600, 2000).add("desk").sized(1400, 700, 750);
  maker.raw().objects.back().origin = Origin::kAdded;
  const Layout layout = solved(maker.make());
  expect_as_asked(layout);
  EXPECT_EQ(layout.find_object("desk_1"), nullptr);
  ASSERT_EQ(layout.gave_way.size(), 1u);
  EXPECT_THAT(layout.gave_way[0].why, HasSubstr("left out"));
}

// Without a proof that it finds no place, all the rest stands all the same.
TEST(Origins, ACompanionThatFindsNoPlaceTakesNothingWithIt) {
  SceneMaker maker(4000, 3500);
  maker.add("reception_desk").relate("againstWall", {"reception_desk_1"}, {"wall3"});
  maker.add("chair", 4).relate("againstWall", {"chair_1"}, {"wall4"}).relate("againstWall", {"chair_2"}, {"wall2"});
  maker.add("office_chair");
  maker.raw().objects.back().origin = Origin::kAdded;
  maker.relate("behind", {"office_chair_1"}, {"reception_desk_1"});
  by(maker, Origin::kAdded);
  SolveOptions options;
  options.prove = false;
  const auto layout = solve(maker.make(), Catalog::builtin(), options);
  ASSERT_TRUE(layout) << layout.error().message;
  expect_as_asked(*layout);
  EXPECT_EQ(layout->objects.size(), 5u);
}

TEST(Origins, FreeFloorBeforeOpeningsGivesWay) {
  SceneMaker maker(3000, 3000);
  maker.opening(OpeningType::kWindow, "wall1", 900, 1200, 900, 1200).opening(OpeningType::kDoor, "wall2", 1000);
  maker.add("wardrobe").sized(1200, 600, 2000).relate("centeredOnWall", {"wardrobe_1"}, {"wall1"});
  maker.add("desk").sized(1200, 600, 750).relate("centeredOnWall", {"desk_1"}, {"wall2"});
  const Layout layout = solved(maker.make());
  expect_as_asked(layout);
  EXPECT_TRUE(layout.lists_as_given_up("free space before window1"));
  EXPECT_TRUE(layout.lists_as_given_up("door swing of door2"));
}

// The catalogue hangs these; nobody asked for that.
TEST(Origins, AnAssumedMountGivesWay) {
  for (const char* kind : {"mirror", "wall_clock", "tv", "chandelier", "pendant_lamp", "ceiling_fan"}) {
    SCOPED_TRACE(kind);
    const std::string id = std::string(kind) + "_1";
    SceneMaker on_floor(4000, 3500);
    expect_as_asked(solved(on_floor.add(kind).add("bed").relate("on", {id}, {"floor"}).make()));
    SceneMaker away(4000, 3500);
    const Layout layout = solved(away.add(kind).add("bed").relate("awayFromWall", {id}).make());
    expect_as_asked(layout);
  }
}

TEST(Origins, AMountThatGaveWayIsListed) {
  const Layout layout = solved(SceneMaker(4000, 3500).add("mirror").relate("awayFromWall", {"mirror_1"}).make());
  expect_as_asked(layout);
  ASSERT_EQ(layout.gave_way.size(), 1u);
  EXPECT_THAT(layout.gave_way[0].relation, StartsWith("mount of mirror_1"));
  EXPECT_EQ(layout.find_object("mirror_1")->supported_by, "floor");
}

TEST(Origins, WithoutReasonThingsHangAsTheirKindDoes) {
  const Layout layout = solved(SceneMaker(4000, 3500).add("mirror").add("chandelier").add("bed").add("painting", 3).make());
  expect_as_asked(layout);
  EXPECT_TRUE(layout.gave_way.empty());
  for (const PlacedObject& object : layout.objects) {
    if (object.category != "bed") {
      EXPECT_NE(object.supported_by, "floor") << object.id;
    }
  }
}

TEST(Origins, TheCataloguesSizesGiveWay) {
  SceneMaker maker(4000, 3500);
  maker.add("bed").add("basket").sized(300, 300, 300).add("plant").relate("in", {"plant_1"}, {"basket_1"});
  const SceneGraph scene = maker.make();
  expect_as_asked(solved(scene));
  EXPECT_LE(scene.objects[2].size->usual.width, 300);
}

TEST(NeedlessRestrictions, ACupOnACoasterOnATableIsOnTheTable) {
  SceneMaker maker(4000, 3500);
  maker.add("table").add("coaster").add("cup");
  maker.relate("on", {"coaster_1"}, {"table_1"}).relate("on", {"cup_1"}, {"coaster_1"}).relate("on", {"cup_1"}, {"table_1"});
  const Layout layout = solved(maker.make());
  expect_as_asked(layout);
  EXPECT_EQ(layout.find_object("cup_1")->supported_by, "coaster_1");
}

TEST(NeedlessRestrictions, ATableIsFlankedFromFrontAndBackToo) {
  SceneMaker maker(2000, 4500);
  maker.add("dining_table").sized(1500, 900, 750).add("dining_chair", 2);
  maker.relate("eachSideOf", {"dining_chair_1", "dining_chair_2"}, {"dining_table_1"});
  RelationParameters turned;
  turned.axis = Axis::kX;
  maker.relate("align", {"dining_chair_1", "dining_table_1"}, {}, turned);
  expect_as_asked(solved(maker.make()));
}

}  // namespace
}  // namespace layoutbox::placement
