// What comes in numbers stands in rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

TEST(UsualGroups, HooksHangInARow) {
  SceneMaker maker(4000, 3000);
  maker.add("bench").add("coat_hook", 3);
  for (const char* hook : {"coat_hook_1", "coat_hook_2", "coat_hook_3"}) maker.relate("above", {hook}, {"bench_1"});
  const Layout layout = solved_as_asked(maker.relate("againstWall", {"bench_1"}).make(true));
  EXPECT_NEAR(between_middles(layout, "coat_hook_1", "coat_hook_2"), between_middles(layout, "coat_hook_2", "coat_hook_3"), 30);
  EXPECT_EQ(layout.find_object("coat_hook_1")->position[2], layout.find_object("coat_hook_3")->position[2]);
}

TEST(UsualGroups, BookshelvesStandSideBySide) {
  const Layout layout = solved_as_asked(SceneMaker(5000, 4000).add("bookshelf", 3).make(true));
  EXPECT_LT(turned(layout, "bookshelf_1", "bookshelf_2"), 1);
  EXPECT_LT(turned(layout, "bookshelf_2", "bookshelf_3"), 1);
  EXPECT_LT(between_middles(layout, "bookshelf_1", "bookshelf_2"), 1300);
}

TEST(UsualGroups, BedsOfAWardStandInRows) {
  const Layout layout = solved_as_asked(SceneMaker(7000, 6000).add("hospital_bed", 4).make(true));
  for (const char* bed : {"hospital_bed_2", "hospital_bed_3", "hospital_bed_4"}) {
    EXPECT_LT(std::fmod(turned(layout, "hospital_bed_1", bed), 180), 1) << bed;
  }
}

TEST(UsualGroups, AnAudienceStandsInRowsBeforeTheStage) {
  SceneMaker maker(9000, 7000);
  maker.add("stage").add("chair", 12);
  for (int i = 1; i <= 12; ++i) maker.relate("facing", {"chair_" + std::to_string(i)}, {"stage_1"});
  const Layout layout = solved_as_asked(maker.make(true));
  const PlacedObject& stage = *layout.find_object("stage_1");
  int before = 0;
  for (int i = 1; i <= 12; ++i) {
    const PlacedObject& chair = *layout.find_object("chair_" + std::to_string(i));
    before += in_frame_of(stage, {chair.position[0], chair.position[1], 0}).y < -stage.size.depth / 2.0;
    EXPECT_LT(std::abs(in_frame_of(stage, {chair.position[0], chair.position[1], 0}).x), 2600);
  }
  EXPECT_EQ(before, 12);
}

TEST(UsualGroups, AShortLastRowStandsAboutTheMiddle) {
  const Layout layout = solved_as_asked(SceneMaker(8000, 6500).add("dining_table", 5).make(true));
  double lowest = 1e9;
  for (int i = 1; i <= 5; ++i) lowest = std::min(lowest, layout.find_object("dining_table_" + std::to_string(i))->position[1]);
  double of_first = 0, of_others = 0;
  int first = 0;
  for (int i = 1; i <= 5; ++i) {
    const PlacedObject& table = *layout.find_object("dining_table_" + std::to_string(i));
    const bool in_first = table.position[1] < lowest + 300;
    (in_first ? of_first : of_others) += table.position[0];
    first += in_first;
  }
  ASSERT_GT(first, 1);
  EXPECT_NEAR(of_first / first, of_others / (5 - first), 150);
}

TEST(UsualGroups, AnAisleLeadsBetweenTwoColumnsOfPews) {
  RelationParameters two_columns;
  two_columns.columns = 2;
  const Layout layout = solved_as_asked(SceneMaker(8000, 10000)
                                            .add("altar")
                                            .add("church_pew", 8)
                                            .relate("facing", {"church_pew_1"}, {"altar_1"})
                                            .relate("grid",
                                                    {"church_pew_1", "church_pew_2", "church_pew_3", "church_pew_4", "church_pew_5",
                                                     "church_pew_6", "church_pew_7", "church_pew_8"},
                                                    {}, two_columns)
                                            .make(true));
  EXPECT_GT(between_middles(layout, "church_pew_1", "church_pew_2"), layout.find_object("church_pew_1")->size.width + 550);
}

TEST(UsualGroups, SeveralTablesInTheMiddleStandInRows) {
  const Layout layout = solved_as_asked(SceneMaker(9000, 8000)
                                            .add("table", 6)
                                            .relate("centerOfRoom", {"table_1", "table_2", "table_3", "table_4", "table_5", "table_6"})
                                            .make(true));
  for (int i = 1; i <= 6; ++i) {
    const PlacedObject& one = *layout.find_object("table_" + std::to_string(i));
    int in_line = 0;
    for (int j = 1; j <= 6; ++j) {
      const PlacedObject& other = *layout.find_object("table_" + std::to_string(j));
      for (const int axis : {0, 1}) in_line += i != j && std::abs(one.position[axis] - other.position[axis]) < 60;
    }
    EXPECT_GE(in_line, 2) << one.id;
  }
}

// A window is nothing that one sits at.
TEST(UsualGroups, SeveralSeatsInFrontOfAWindow) {
  SceneMaker maker(5000, 4000);
  maker.add("chair", 3).add("table").opening(OpeningType::kWindow, "wall3", 1800, 1600, 900, 1200);
  for (const char* chair : {"chair_1", "chair_2", "chair_3"}) maker.relate("inFrontOf", {chair}, {"window1"});
  const Layout layout = solved_as_asked(maker.make(true));
  for (const char* chair : {"chair_1", "chair_2", "chair_3"}) EXPECT_GT(layout.find_object(chair)->position[1], 2000) << chair;
}

TEST(UsualGroups, BetweenColumnsOfDesksForTwoOneGetsOut) {
  SceneMaker maker(9000, 7000);
  maker.add("whiteboard").relate("onWall", {"whiteboard_1"}, {"wall1"});
  std::vector<std::string> desks;
  for (int i = 1; i <= 9; ++i) {
    desks.push_back("school_desk_" + std::to_string(i));
    maker.add("school_desk").sized(1200, 500, 750);
    if (i % 3 == 2) maker.relate("facing", {desks.back()}, {"whiteboard_1"});
  }
  RelationParameters three;
  three.columns = 3;
  const Layout layout = solved_as_asked(maker.relate("grid", desks, {}, three).make(true));
  EXPECT_GT(between_middles(layout, "school_desk_1", "school_desk_2"), 1600);
}

TEST(UsualGroups, WhatStandsDownTheMiddleIsSharedOutOverTheRoom) {
  SceneMaker maker(10000, 6000);
  maker.add("plinth", 3);
  const std::vector<std::string> plinths = {"plinth_1", "plinth_2", "plinth_3"};
  const Layout layout = solved_as_asked(maker.relate("centerOfRoom", plinths).relate("row", plinths).make(true));
  for (const std::string& id : plinths) EXPECT_NEAR(layout.find_object(id)->position[1], 3000, 200) << id;
  EXPECT_GT(between_middles(layout, "plinth_1", "plinth_2"), 1800);
}

TEST(UsualGroups, LargePicturesShareTheirWallOut) {
  SceneMaker maker(9000, 6000, 3200);
  for (int i = 1; i <= 4; ++i)
    maker.add("painting").sized(1400, 40, 1000).relate("onWall", {"painting_" + std::to_string(i)}, {i <= 2 ? "wall3" : "wall1"});
  const Layout layout = solved_as_asked(maker.make(true));
  EXPECT_GT(between_middles(layout, "painting_1", "painting_2"), 2000);
  EXPECT_GT(between_middles(layout, "painting_3", "painting_4"), 2000);
}

}  // namespace
}  // namespace layoutbox::placement
