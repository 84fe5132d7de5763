#include "layoutbox/solve/solver.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>

#include "layoutbox/scene/scene_json.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

Layout solved_fully(const SceneGraph& scene) {
  const Layout layout = solved_soundly(scene);
  EXPECT_EQ(layout.status, LayoutStatus::kSolved) << (layout.conflicts.empty() ? "" : layout.conflicts[0].sentence);
  EXPECT_EQ(layout.objects.size(), scene.objects.size());
  for (const PlacedRelation& r : layout.relations) {
    EXPECT_TRUE(r.held || !r.relation.hard) << r.relation.id << " " << relation_row(r.relation.type).name;
  }
  return layout;
}

RelationParameters part(const std::string& words) {
  RelationParameters p;
  p.part = ThingPart(words);
  return p;
}

TEST(Solver, BedroomOfThePaper) {
  const Layout layout = solved_fully(SceneMaker(4000, 3200, 3000)
                                         .add("bed")
                                         .add("wardrobe")
                                         .add("desk")
                                         .add("table_lamp")
                                         .relate("againstWall", {"bed_1"}, {"wall4"})
                                         .relate("centeredOnWall", {"wardrobe_1"}, {"wall3"})
                                         .relate("atFootOf", {"desk_1"}, {"bed_1"})
                                         .relate("on", {"table_lamp_1"}, {"desk_1"}, part("left"))
                                         .make(true));
  const PlacedObject& bed = *layout.find_object("bed_1");
  EXPECT_EQ(bed.rotation_deg, 90);  // its back to the left wall
  EXPECT_NEAR(bed.position[0], bed.size.depth / 2.0, 20.5);
  EXPECT_EQ(layout.find_object("wardrobe_1")->position[0], 2000);
  EXPECT_EQ(layout.find_object("table_lamp_1")->supported_by, "desk_1");
}

TEST(Solver, DiningRoomOfThePaper) {
  const Layout layout = solved_fully(
      SceneMaker(3600, 3600, 3000)
          .add("dining_table")
          .add("dining_chair", 6)
          .add("sideboard")
          .add("pendant_lamp")
          .relate("centerOfRoom", {"dining_table_1"})
          .relate("around", {"dining_chair_1", "dining_chair_2", "dining_chair_3", "dining_chair_4", "dining_chair_5", "dining_chair_6"},
                  {"dining_table_1"})
          .relate("againstWall", {"sideboard_1"}, {"wall3"})
          .relate("above", {"pendant_lamp_1"}, {"dining_table_1"})
          .make(true));
  const PlacedObject& lamp = *layout.find_object("pendant_lamp_1");
  EXPECT_EQ(lamp.position[2] + lamp.size.height, 3000);
  EXPECT_EQ(lamp.supported_by, "ceiling");
}

TEST(Solver, SofaComesForwardForWhatStandsBehindIt) {
  RelationParameters along;
  along.gap = 300;
  const Layout layout = solved_fully(SceneMaker(4500, 3500, 3000)
                                         .add("sofa")
                                         .add("floor_lamp")
                                         .relate("againstWall", {"sofa_1"}, {"wall4"}, along)
                                         .relate("behind", {"floor_lamp_1"}, {"sofa_1"})
                                         .make());
  const PlacedObject& sofa = *layout.find_object("sofa_1");
  EXPECT_GT(sofa.position[0] - sofa.size.depth / 2.0, 100);
}

TEST(Solver, OpeningsGetPlacesAndStayFree) {
  const Layout layout = solved_fully(SceneMaker(3500, 3000).add("bed").add("wardrobe").add("desk").add("bookshelf").make(true));
  ASSERT_EQ(layout.room.openings.size(), 2u);
  for (const Opening& o : layout.room.openings) {
    EXPECT_FALSE(o.wall.empty());
    ASSERT_TRUE(o.offset);
    const Wall& wall = *layout.find_wall(o.wall);
    const double length = std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y);
    EXPECT_GE(*o.offset, 0);
    EXPECT_LE(*o.offset + o.width, length);
    // A point a hand's breadth before each opening, at its middle height, lies in no body.
    const double ux = (wall.end.x - wall.start.x) / length, uy = (wall.end.y - wall.start.y) / length;
    const double along = *o.offset + o.width / 2.0;
    const TestPoint p{wall.start.x + ux * along - uy * 100, wall.start.y + uy * along + ux * 100, o.sill + o.height / 2.0};
    for (const PlacedObject& object : layout.objects) EXPECT_FALSE(in_body(object, p)) << object.id << " before " << o.id;
  }
}

TEST(Solver, ThingsStandOnAndInThings) {
  const Layout layout = solved_fully(SceneMaker(4000, 3000)
                                         .add("bookshelf")
                                         .add("book", 5)
                                         .add("desk")
                                         .add("monitor")
                                         .add("table_lamp")
                                         .add("vase")
                                         .relate("in", {"book_1"}, {"bookshelf_1"})
                                         .relate("in", {"book_2"}, {"bookshelf_1"})
                                         .relate("on", {"monitor_1"}, {"desk_1"})
                                         .relate("on", {"table_lamp_1"}, {"desk_1"}, part("left back corner"))
                                         .relate("on", {"vase_1"}, {"bookshelf_1"})
                                         .make());
  EXPECT_EQ(layout.find_object("book_1")->supported_by, "bookshelf_1");
  EXPECT_EQ(layout.find_object("monitor_1")->supported_by, "desk_1");
}

TEST(Solver, WhatIsUnderALoftBedBringsItsCompany) {
  const Layout layout = solved_fully(SceneMaker(4000, 3600)
                                         .add("loft_bed")
                                         .add("desk")
                                         .add("monitor", 2)
                                         .relate("under", {"desk_1"}, {"loft_bed_1"})
                                         .relate("on", {"monitor_1"}, {"desk_1"})
                                         .relate("on", {"monitor_2"}, {"desk_1"})
                                         .make());
  EXPECT_EQ(layout.find_object("monitor_2")->supported_by, "desk_1");
}

TEST(Solver, SameSeedSameBytes) {
  const SceneGraph scene =
      SceneMaker(5000, 4000).add("sofa").add("armchair", 2).add("coffee_table").add("tv_stand").add("bookshelf").add("plant", 2).make(true);
  std::string first;
  for (int i = 0; i < 2; ++i) {
    Layout layout = solved_soundly(scene);
    layout.stats.seconds = 0;
    const std::string bytes = write_layout(layout);
    if (i == 0) first = bytes;
    EXPECT_EQ(bytes, first);
  }
}

TEST(Solver, SmallerSizesWhereTheRoomAsksForThem) {
  const SceneGraph scene = SceneMaker(2300, 1500).add("bed").make();
  const Layout layout = solved_fully(scene);
  const PlacedObject& bed = layout.objects[0];
  EXPECT_LT(bed.size.width, scene.objects[0].size->usual.width);
  EXPECT_GE(bed.size.width, scene.objects[0].size->least.width);
}

TEST(Solver, FixedObjectsStay) {
  const Layout layout =
      solved_fully(SceneMaker(4000, 3000).add("column").sized(300, 300, 2800).at(2000, 1500, 0, 0, true).add("bed").add("wardrobe").make());
  EXPECT_EQ(layout.find_object("column_1")->position[0], 2000);
  EXPECT_EQ(layout.find_object("column_1")->position[1], 1500);
}

TEST(Solver, HintsHoldUnlessARelationSaysOtherwise) {
  const Layout layout = solved_fully(SceneMaker(5000, 4000)
                                         .add("armchair")
                                         .at(3000, 1200, 0, 180, false)
                                         .add("plant")
                                         .at(4000, 2000, 0, 0, false)
                                         .relate("corner", {"plant_1"})
                                         .make());
  EXPECT_NEAR(layout.find_object("armchair_1")->position[0], 3000, 1);
  EXPECT_NEAR(layout.find_object("armchair_1")->position[1], 1200, 1);
  EXPECT_EQ(layout.find_object("armchair_1")->rotation_deg, 180);
}

// ---------------------------------------------------------------------------------------------------------------- conflicts

// ---------------------------------------------------------------------------------------------------------------- bad scenes

TEST(BadScene, ItselfAsReference) {
  const Layout layout = solved_soundly(SceneMaker(4000, 3000).add("chair").relate("leftOf", {"chair_1"}, {"chair_1"}).make());
  EXPECT_EQ(layout.status, LayoutStatus::kRelaxed);
  EXPECT_EQ(layout.objects.size(), 1u);
}

TEST(BadScene, TwoThingsOnEachOther) {
  const Layout layout =
      solved_soundly(SceneMaker(4000, 3000).add("box", 2).relate("on", {"box_1"}, {"box_2"}).relate("on", {"box_2"}, {"box_1"}).make());
  EXPECT_EQ(layout.status, LayoutStatus::kRelaxed);
}

TEST(BadScene, UnknownReference) {
  SceneGraph scene = SceneMaker(4000, 3000).add("chair").make();
  Relation relation;
  relation.id = "c1", relation.type = RelationType::kNextTo, relation.targets = {"chair_1"}, relation.references = {"ghost"};
  scene.relations.push_back(relation);
  const auto layout = solve(scene, Catalog::builtin());
  ASSERT_FALSE(layout);
  EXPECT_EQ(layout.error().code, ErrorCode::kReference);
}

TEST(BadScene, TooManyObjects) {
  SceneGraph scene = SceneMaker(20000, 15000).add("chair").make();
  while (scene.objects.size() <= 500) {
    scene.objects.push_back(scene.objects[0]);
    scene.objects.back().id = "chair_" + std::to_string(scene.objects.size());
  }
  const auto layout = solve(scene, Catalog::builtin());
  ASSERT_FALSE(layout);
  EXPECT_EQ(layout.error().code, ErrorCode::kTooLarge);
}

TEST(BadScene, OptionsOutOfRange) {
  SolveOptions options;
  options.effort = 0;
  const auto layout = solve(SceneMaker(4000, 3000).add("chair").make(), Catalog::builtin(), options);
  ASSERT_FALSE(layout);
  EXPECT_EQ(layout.error().code, ErrorCode::kUsage);
}

// Without an improvement too, which alone knows of ways.
TEST(Solver, AWayThatIsAskedForIsLookedForAlsoWithoutAnImprovement) {
  SolveOptions options;
  options.improve = false;
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    options.seed = seed;
    SceneMaker maker(3000, 3000);
    maker.opening(OpeningType::kDoor, "wall1", 100);
    maker.add("bookshelf", 3).add("sofa").add("chair").relate("reachable", {"chair_1"}, {"door1"});
    const auto layout = solve(maker.make(), Catalog::builtin(), options);
    ASSERT_TRUE(layout) << layout.error().message;
    EXPECT_EQ(layout->status, LayoutStatus::kSolved) << "seed " << seed;
  }
}

TEST(Solver, ADoorAndAWindowMayTouch) {
  SceneMaker maker(4000, 3000);
  maker.opening(OpeningType::kDoor, "wall4", 50, 900).opening(OpeningType::kWindow, "wall4", 950, 1200, 900, 1200).add("desk");
  const auto layout = solve(maker.make(), Catalog::builtin());
  ASSERT_TRUE(layout) << layout.error().message;
  EXPECT_EQ(layout->status, LayoutStatus::kSolved);
}

TEST(Stop, FromOutside) {
  const std::atomic<bool> stop = true;
  SolveOptions options;
  options.stop = &stop;
  const auto layout = solve(SceneMaker(4000, 3000).add("chair").make(), Catalog::builtin(), options);
  ASSERT_FALSE(layout);
  EXPECT_EQ(layout.error().code, ErrorCode::kInterrupted);
}

}  // namespace
}  // namespace layoutbox::placement
