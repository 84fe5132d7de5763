// Rooms arranged as a person would draw them: who sits where, what shares the floor, what stands in one line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

TestPoint seen_from(const Layout& layout, const std::string& host, const std::string& id) {
  const PlacedObject& other = object(layout, id);
  return in_frame_of(object(layout, host), {other.position[0], other.position[1], 0});
}

std::vector<std::string> ids(const std::string& kind, int count) {
  std::vector<std::string> found;
  for (int i = 1; i <= count; ++i) found.push_back(kind + "_" + std::to_string(i));
  return found;
}

TEST(Arrangement, AGridStandsAboutTheMiddleThoughOneByOneNoneCouldMove) {
  SceneMaker maker(7500, 6200);
  RelationParameters five;
  five.columns = 5;
  maker.add("yoga_mat", 10).add("bench").add("shelf").relate("grid", ids("yoga_mat", 10), {}, five);
  const Layout layout = solved_as_asked(maker.make(true));
  double x = 0;
  for (const std::string& id : ids("yoga_mat", 10)) x += object(layout, id).position[0] / 10;
  EXPECT_NEAR(x, 3750, 300);
}

TEST(Arrangement, TwoFormationsShareTheRoom) {
  SceneMaker maker(9500, 7000);
  RelationParameters two;
  two.columns = 2;
  maker.add("bookshelf", 12).add("table", 4).relate("grid", ids("bookshelf", 12), {}, two);
  const Layout layout = solved_as_asked(maker.make(true));
  double low = 1e9, high = -1e9;
  for (const std::string& id : ids("bookshelf", 12)) {
    low = std::min(low, object(layout, id).position[0]), high = std::max(high, object(layout, id).position[0]);
  }
  for (const std::string& id : ids("table", 4)) {
    const double x = object(layout, id).position[0];
    EXPECT_TRUE(x < low - 600 || x > high + 600) << id << " at " << x << ", shelves from " << low << " to " << high;
  }
}

TEST(Arrangement, TwoInTheMiddleStandSideBySide) {
  for (const char* kind : {"bench", "table"}) {
    const std::vector<std::string> both = ids(kind, 2);
    const Layout layout = solved_as_asked(SceneMaker(5200, 4300).add(kind, 2).add("shelf", 2).relate("centerOfRoom", both).make(true));
    const PlacedObject &one = object(layout, both[0]), &two = object(layout, both[1]);
    const double dx = std::abs(one.position[0] - two.position[0]), dy = std::abs(one.position[1] - two.position[1]);
    EXPECT_LT(std::min(dx, dy), 60) << kind;
    EXPECT_LT(std::fmod(turned(layout, both[0], both[1]), 180), 1) << kind;
  }
}

TEST(Arrangement, WhoWorksAtADeskSitsAcrossFromVisitors) {
  SceneMaker maker(4500, 3800);
  maker.raw().room.type = "clinic";
  maker.add("desk").add("office_chair").add("chair", 2).relate("inFrontOf", {"chair_1"}, {"desk_1"});
  maker.relate("inFrontOf", {"chair_2"}, {"desk_1"});
  const Layout layout = solved_as_asked(maker.make(true));
  EXPECT_GT(seen_from(layout, "desk_1", "office_chair_1").y, 0);
  EXPECT_LT(seen_from(layout, "desk_1", "chair_1").y, 0);
  EXPECT_NEAR(turned(layout, "office_chair_1", "chair_1"), 180, 1);
}

// "A desk with an executive chair, and two chairs for clients": not the three of them in a row.
TEST(Arrangement, ClientsSitAcrossFromTheChairThatADeskIsToldToHave) {
  SceneMaker maker(4500, 3800);
  maker.raw().room.type = "office";
  maker.add("desk").add("office_chair").add("chair", 2).relate("inFrontOf", {"office_chair_1"}, {"desk_1"});
  const Layout layout = solved_as_asked(maker.make(true));
  EXPECT_LT(seen_from(layout, "desk_1", "office_chair_1").y, 0);
  for (const char* client : {"chair_1", "chair_2"}) {
    EXPECT_GT(seen_from(layout, "desk_1", client).y, 0) << client;
    EXPECT_NEAR(turned(layout, "office_chair_1", client), 180, 1) << client;
  }
}

TEST(Arrangement, ASquareShowerStandsInACorner) {
  const Layout layout = solved_as_asked(SceneMaker(3600, 2900).add("bathtub").add("shower").add("sink", 2).add("toilet").make(true));
  const PlacedObject& shower = object(layout, "shower_1");
  const double x = std::min(shower.position[0], 3600 - shower.position[0]), y = std::min(shower.position[1], 2900 - shower.position[1]);
  EXPECT_LT(std::max(x, y), 520);
}

TEST(Arrangement, TwinBedsWithNightstandsStandBesideEachOther) {
  const Layout layout = solved_as_asked(SceneMaker(4700, 3900).add("single_bed", 2).add("nightstand", 2).make(true));
  EXPECT_LT(turned(layout, "single_bed_1", "single_bed_2"), 1);
  EXPECT_LT(std::abs(seen_from(layout, "single_bed_1", "single_bed_2").x), 2400);
  EXPECT_NEAR(seen_from(layout, "single_bed_1", "single_bed_2").y, 0, 60);
}

TEST(Arrangement, WhatIsToldToBeByTheWindowStandsAtTheWall) {
  for (const char* kind : {"cat_tree", "plant"}) {
    const std::string id = std::string(kind) + "_1";
    const Layout layout =
        solved_as_asked(SceneMaker(5200, 3800).add("sofa").add("sideboard").add(kind).relate("nearWindow", {id}).make(true));
    const PlacedObject& tree = object(layout, id);
    const double x = tree.position[0], y = tree.position[1];
    EXPECT_LT(std::min({x, 5200 - x, y, 3800 - y}) - std::max(tree.size.width, tree.size.depth) / 2.0, 160) << kind;
  }
}

TEST(Arrangement, ARugShowsBeforeTheSofa) {
  const Layout layout = solved_as_asked(SceneMaker(4500, 3600).add("sofa").add("desk").add("rug").make(true));
  const TestPoint rug = seen_from(layout, "sofa_1", "rug_1");
  EXPECT_NEAR(rug.x, 0, 60);
  EXPECT_LT(rug.y, -object(layout, "sofa_1").size.depth / 2.0);
}

TEST(Arrangement, NobodySitsAtTableBetweenTheSofaAndItsScreen) {
  const Layout layout = solved_as_asked(SceneMaker(5800, 4800)
                                            .add("sofa")
                                            .add("tv_stand")
                                            .add("tv")
                                            .add("dining_table")
                                            .add("dining_chair", 2)
                                            .relate("on", {"tv_1"}, {"tv_stand_1"})
                                            .make(true));
  const TestPoint table = seen_from(layout, "sofa_1", "dining_table_1"), screen = seen_from(layout, "sofa_1", "tv_1");
  const bool before = table.y < 0 && table.y > screen.y && std::abs(table.x) < 1000;
  EXPECT_FALSE(before) << table.x << " " << table.y;
}

TEST(Arrangement, SeveralThatFaceTheWindowStandAbreast) {
  SceneMaker maker(6400, 5400);
  maker.add("treadmill", 3).add("yoga_mat", 2).opening(OpeningType::kWindow, "wall3", 2000, 2400, 900, 1200);
  maker.opening(OpeningType::kDoor, "wall1", 300);
  for (const std::string& id : ids("treadmill", 3)) maker.relate("facing", {id}, {"window1"});
  const Layout layout = solved_as_asked(maker.make());
  for (const char* other : {"treadmill_2", "treadmill_3"}) {
    EXPECT_NEAR(seen_from(layout, "treadmill_1", other).y, 0, 60) << other;
  }
}

TEST(Arrangement, StoolsStandBeforeTheBar) {
  const Layout layout = solved_as_asked(SceneMaker(6000, 5000)
                                            .add("bar_counter")
                                            .add("wine_barrel", 2)
                                            .add("stool", 3)
                                            .relate("behind", {"wine_barrel_1"}, {"bar_counter_1"})
                                            .relate("behind", {"wine_barrel_2"}, {"bar_counter_1"})
                                            .make(true));
  const PlacedObject& bar = object(layout, "bar_counter_1");
  for (const std::string& id : ids("stool", 3)) {
    const TestPoint at = seen_from(layout, "bar_counter_1", id);
    EXPECT_LT(at.y, -bar.size.depth / 2.0) << id;
    EXPECT_LT(std::abs(at.x), bar.size.width / 2.0) << id;
  }
}

TEST(Arrangement, GrownUpsDoNotSitAtTheChildrensTable) {
  const Layout layout = solved_as_asked(SceneMaker(5000, 4000).add("sofa").add("chair", 4).add("kids_table").make(true));
  for (const std::string& id : ids("chair", 4)) {
    const TestPoint table = seen_from(layout, id, "kids_table_1");
    EXPECT_GT(std::hypot(table.x, table.y), 800) << id;
  }
}

TEST(Arrangement, ATableIsAsLargeAsTheChairsThatNobodyPlacedNeed) {
  const Layout layout =
      solved_as_asked(SceneMaker(7200, 4500).add("table").add("chair", 10).relate("centerOfRoom", {"table_1"}).make(true));
  EXPECT_GE(object(layout, "table_1").size.width, 2600);
  for (const std::string& id : ids("chair", 10)) {
    const TestPoint table = seen_from(layout, id, "table_1");
    EXPECT_LT(table.y, 0) << id << " looks at it";
    EXPECT_LT(std::hypot(table.x, table.y), 2000) << id;
  }
}

TEST(Arrangement, ChairsStandWhereThereIsRoomForTheKnees) {
  const Layout layout = solved_as_asked(
      SceneMaker(4200, 3500).add("exam_table").add("desk").add("chair", 2).relate("centerOfRoom", {"exam_table_1"}).make(true));
  for (const std::string& id : ids("chair", 2)) EXPECT_LT(seen_from(layout, "desk_1", id).y, 0) << id;
}

}  // namespace
}  // namespace layoutbox::placement
