// Rooms in which nobody said where things stand: what a person would expect of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

TEST(Habits, NightstandsStandAtBothSidesOfTheirBed) {
  const Layout layout = solved_as_asked(SceneMaker(4300, 3900).add("bed").add("nightstand", 2).add("wardrobe").add("dresser").make(true));
  const PlacedObject& bed = object(layout, "bed_1");
  const Point one = seen_from(bed, object(layout, "nightstand_1")), two = seen_from(bed, object(layout, "nightstand_2"));
  EXPECT_LT(std::int64_t{one.x} * two.x, 0);
  for (const Point& p : {one, two}) {
    EXPECT_LT(std::abs(p.x) - bed.size.width / 2.0, 450) << "beside it, not somewhere else";
    EXPECT_GT(p.y, 0) << "at its head";
  }
}

TEST(Habits, ARugShowsAtTheFootOfTheBed) {
  const Layout layout = solved_as_asked(SceneMaker(4300, 3900).add("bed").add("rug").make(true));
  const PlacedObject& bed = object(layout, "bed_1");
  const Point rug = seen_from(bed, object(layout, "rug_1"));
  EXPECT_NEAR(rug.x, 0, 60);
  EXPECT_LT(rug.y - object(layout, "rug_1").size.depth / 2, -bed.size.depth / 2 - 300);
}

TEST(Habits, ARugNextToTheBedShows) {
  const Layout layout =
      solved_as_asked(SceneMaker(3350, 3660).add("double_bed").add("rug").relate("nextTo", {"rug_1"}, {"double_bed_1"}).make(true));
  const PlacedObject& bed = object(layout, "double_bed_1");
  const PlacedObject& lying = object(layout, "rug_1");
  const Point rug = seen_from(bed, lying);
  const bool aside = std::abs(rug.x) >= bed.size.width / 2.0 + 300, beyond = std::abs(rug.y) >= bed.size.depth / 2.0 + 300;
  EXPECT_TRUE(aside || beyond);
}

TEST(Habits, TwoLongTablesStandSideBySide) {
  SceneMaker maker(7000, 6000);
  maker.add("dining_table", 2).add("chair", 8);
  maker.relate("around", {"chair_1", "chair_2", "chair_3", "chair_4"}, {"dining_table_1"});
  maker.relate("around", {"chair_5", "chair_6", "chair_7", "chair_8"}, {"dining_table_2"});
  const Layout layout = solved_as_asked(maker.make(true));
  const PlacedObject &one = object(layout, "dining_table_1"), &two = object(layout, "dining_table_2");
  EXPECT_EQ(std::lround(one.rotation_deg) % 180, std::lround(two.rotation_deg) % 180);
  const double dx = std::abs(one.position[0] - two.position[0]), dy = std::abs(one.position[1] - two.position[1]);
  EXPECT_LT(std::min(dx, dy), 60) << "in line";
  EXPECT_GT(std::max(dx, dy), 1500) << "with room for chairs between";
}

TEST(Habits, ChairsBehindADeskSitAbreast) {
  const Layout layout = solved_as_asked(SceneMaker(6000, 5000)
                                            .add("desk")
                                            .sized(2000, 800, 750)
                                            .add("chair", 2)
                                            .relate("centerOfRoom", {"desk_1"})
                                            .relate("behind", {"chair_1"}, {"desk_1"})
                                            .relate("behind", {"chair_2"}, {"desk_1"})
                                            .make(true));
  const PlacedObject& desk = object(layout, "desk_1");
  const Point one = seen_from(desk, object(layout, "chair_1")), two = seen_from(desk, object(layout, "chair_2"));
  EXPECT_NEAR(one.y, two.y, 30);
  EXPECT_NEAR(one.x, -two.x, 60);
}

TEST(Habits, NextToStandsAtTheSide) {
  const Layout layout = solved_as_asked(SceneMaker(5500, 4500)
                                            .add("bed")
                                            .add("tv_stand")
                                            .add("plant")
                                            .add("nightstand")
                                            .relate("nextTo", {"plant_1"}, {"tv_stand_1"})
                                            .relate("nextTo", {"nightstand_1"}, {"bed_1"})
                                            .make(true));
  const PlacedObject &bed = object(layout, "bed_1"), &stand = object(layout, "tv_stand_1");
  const Point plant = seen_from(stand, object(layout, "plant_1")), nightstand = seen_from(bed, object(layout, "nightstand_1"));
  EXPECT_GT(std::abs(plant.x), stand.size.width / 2);
  EXPECT_GT(std::abs(nightstand.x), bed.size.width / 2);
  EXPECT_GT(nightstand.y, 0) << "at its head";
}

TEST(Habits, ManyDesksStandInRowsWithTheirChairsBehindThem) {
  const Layout layout = solved_as_asked(
      SceneMaker(8000, 7000, 3000).add("school_desk", 9).add("student_chair", 9).add("chalkboard").add("teacher_desk").make(true));
  std::set<Mm> columns, rows;
  for (int i = 1; i <= 9; ++i) {
    const std::string n = std::to_string(i);
    const PlacedObject& desk = object(layout, "school_desk_" + n);
    EXPECT_EQ(desk.rotation_deg, object(layout, "school_desk_1").rotation_deg);
    columns.insert(static_cast<Mm>(std::lround(desk.position[0] / 50))), rows.insert(static_cast<Mm>(std::lround(desk.position[1] / 50)));
    const Point chair = seen_from(desk, object(layout, "student_chair_" + n));
    EXPECT_NEAR(chair.x, 0, 60) << n;
    EXPECT_GT(chair.y, 0) << n << ": a school desk looks away from who sits at it";
  }
  EXPECT_EQ(columns.size() * rows.size(), 9U);
}

TEST(Habits, ChairsAreSharedOutOverTheSidesOfTheirTable) {
  const Layout layout = solved_as_asked(SceneMaker(4200, 3600).add("dining_table").sized(1600, 900, 750).add("dining_chair", 6).make(true));
  const PlacedObject& table = object(layout, "dining_table_1");
  int front = 0, back = 0, left = 0, right = 0;
  for (int i = 1; i <= 6; ++i) {
    const Point p = seen_from(table, object(layout, "dining_chair_" + std::to_string(i)));
    const bool end = std::abs(p.x) > table.size.width / 2;
    front += !end && p.y < 0, back += !end && p.y > 0, left += end && p.x < 0, right += end && p.x > 0;
  }
  EXPECT_EQ(front, back);
  EXPECT_EQ(left, right);
  EXPECT_EQ(front + back + left + right, 6);
}

TEST(Habits, ATalkingGroupRoundTheCoffeeTable) {
  const Layout layout = solved_as_asked(SceneMaker(5000, 4200)
                                            .add("sofa")
                                            .add("armchair", 2)
                                            .add("coffee_table")
                                            .add("tv_stand")
                                            .add("tv")
                                            .relate("on", {"tv_1"}, {"tv_stand_1"})
                                            .make(true));
  const PlacedObject &sofa = object(layout, "sofa_1"), &table = object(layout, "coffee_table_1");
  const Point before = seen_from(sofa, table);
  EXPECT_NEAR(before.x, 0, 100);
  EXPECT_LT(before.y, 0);
  for (const char* id : {"armchair_1", "armchair_2"}) {
    const Point p = seen_from(object(layout, id), table);  // before its front, not far
    EXPECT_LT(p.y, 0) << id;
    EXPECT_LT(std::abs(p.x), 400) << id;
    EXPECT_GT(p.y, -1800) << id;
  }
}

TEST(Habits, AGridThatFacesABoardFindsItsPlace) {
  SceneMaker maker(8000, 6000, 3000);
  maker.add("school_desk", 4).add("student_chair", 4).add("chalkboard");
  maker.relate("grid", {"school_desk_1", "school_desk_2", "school_desk_3", "school_desk_4"});
  maker.relate("facing", {"school_desk_4"}, {"chalkboard_1"}).relate("onWall", {"chalkboard_1"}, {"wall3"});
  for (int i = 1; i <= 4; ++i) maker.relate("tuckedUnder", {"student_chair_" + std::to_string(i)}, {"school_desk_" + std::to_string(i)});
  const Layout layout = solved_as_asked(maker.make(true));
  for (const PlacedRelation& r : layout.relations) EXPECT_TRUE(r.held || !r.relation.hard) << r.relation.id;
}

TEST(Habits, ACrowdThatLooksOneWayStandsInRows) {
  SceneMaker maker(7700, 6700, 3000);
  maker.add("school_desk", 30).add("chair", 30).add("whiteboard").relate("facing", {"school_desk_1"}, {"whiteboard_1"});
  for (int i = 2; i <= 30; ++i) maker.relate("sameOrientation", {"school_desk_" + std::to_string(i)}, {"school_desk_1"});
  for (int i = 1; i <= 30; ++i) maker.relate("tuckedUnder", {"chair_" + std::to_string(i)}, {"school_desk_" + std::to_string(i)});
  const Layout layout = solved_as_asked(maker.make(true));
  EXPECT_EQ(layout.stats.solver.find("cp-sat"), std::string::npos) << "found by search";
  for (const PlacedRelation& r : layout.relations) EXPECT_TRUE(r.held || !r.relation.hard) << r.relation.id;
}

TEST(Habits, TwinBedsStandSideBySideWithTheNightstandBetween) {
  const Layout layout = solved_as_asked(SceneMaker(5200, 4700)
                                            .add("single_bed", 2)
                                            .add("nightstand")
                                            .add("wardrobe")
                                            .relate("between", {"nightstand_1"}, {"single_bed_1", "single_bed_2"})
                                            .make(true));
  const PlacedObject &one = object(layout, "single_bed_1"), &two = object(layout, "single_bed_2");
  EXPECT_EQ(one.rotation_deg, two.rotation_deg);
  const Point seen = seen_from(one, two);
  EXPECT_NEAR(seen.y, 0, 60) << "heads in line";
  EXPECT_LT(std::abs(seen.x) - one.size.width, 900) << "no farther apart than the nightstand needs";
}

TEST(Habits, StoolsShareOutTheWidthOfTheCounterTheyStandBefore) {
  SceneMaker maker = SceneMaker(6000, 5000).add("bar_counter").add("bar_stool", 4);
  for (int i = 1; i <= 4; ++i) maker.relate("inFrontOf", {"bar_stool_" + std::to_string(i)}, {"bar_counter_1"});
  const Layout layout = solved_as_asked(maker.make(true));
  const PlacedObject& bar = object(layout, "bar_counter_1");
  std::vector<Mm> along;
  for (int i = 1; i <= 4; ++i) {
    const PlacedObject& stool = object(layout, "bar_stool_" + std::to_string(i));
    const Point seen = seen_from(bar, stool);
    along.push_back(seen.x);
    EXPECT_LT(-seen.y - (bar.size.depth + stool.size.depth) / 2, 120) << "within reach of the counter";
  }
  std::sort(along.begin(), along.end());
  for (std::size_t i = 1; i < along.size(); ++i) EXPECT_NEAR(along[i] - along[i - 1], bar.size.width / 4.0, 40);
}

TEST(Habits, ChairsToldToStandAtTheWallsStandCloseToThem) {
  SceneMaker maker = SceneMaker(6000, 5000).add("chair", 6).add("desk");
  for (int i = 1; i <= 6; ++i) maker.relate("againstWall", {"chair_" + std::to_string(i)}, {});
  const Layout layout = solved_as_asked(maker.make(true));
  for (int i = 1; i <= 6; ++i) {
    const PlacedObject& chair = object(layout, "chair_" + std::to_string(i));
    const double x = chair.position[0], y = chair.position[1];
    EXPECT_LT(std::min({x, y, 6000 - x, 5000 - y}) - chair.size.depth / 2.0, 60) << chair.id;
  }
}

TEST(Habits, KitchenUnitsStandInOneRun) {
  const Layout layout = solved_as_asked(SceneMaker(5000, 4000).add("fridge").add("stove").add("kitchen_sink").add("dishwasher").make(true));
  std::vector<std::string> ids{"fridge_1", "stove_1", "kitchen_sink_1", "dishwasher_1"};
  for (const std::string& id : ids) {
    double nearest = 1e9;
    for (const std::string& other : ids) {
      if (other == id) continue;
      const Point seen = seen_from(object(layout, id), object(layout, other));
      nearest = std::min(nearest, std::abs(seen.x) - (object(layout, id).size.width + object(layout, other).size.width) / 2.0);
    }
    EXPECT_LT(nearest, 100) << id << " has a neighbour";
  }
}

TEST(Habits, WhatTheClockCutsShortIsALayoutAllTheSame) {
  SceneMaker maker(5000, 4000);
  maker.add("desk", 6);
  for (int i = 1; i <= 6; ++i) {
    const std::string desk = "desk_" + std::to_string(i);
    maker.relate("underWindow", {desk}).relate("corner", {desk}).relate("nearDoor", {desk});
  }
  SolveOptions options;
  options.time_limit_s = 0.05;
  const auto layout = solve(maker.make(true), Catalog::builtin(), options);
  ASSERT_TRUE(layout) << layout.error().message;
  expect_sound(*layout);
  EXPECT_FALSE(layout->relaxed.empty());
  for (const Relaxation& given_up : layout->relaxed) EXPECT_FALSE(given_up.why.empty());
}

}  // namespace
}  // namespace layoutbox::placement
