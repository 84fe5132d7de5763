// How a room is composed: things in the axis of what they go with, pairs alike on both sides, who talks face to face.
#include <gtest/gtest.h>

#include <cmath>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

// Where it is in the other's frame: to its right and behind it.
TestPoint from(const Layout& layout, const std::string& other, const std::string& id) {
  const PlacedObject& o = *layout.find_object(id);
  return in_frame_of(*layout.find_object(other), {o.position[0], o.position[1], 0});
}

TEST(Composition, EachOfTwoDesksHasItsChairBeforeItsMiddle) {
  const Layout layout = solved_as_asked(SceneMaker(3500, 3000)
                                            .add("desk", 2)
                                            .add("office_chair", 2)
                                            .add("shelf")
                                            .relate("nextTo", {"office_chair_1"}, {"desk_1"})
                                            .relate("nextTo", {"office_chair_2"}, {"desk_2"})
                                            .make(true));
  for (const char* number : {"1", "2"})
    EXPECT_NEAR(from(layout, std::string("desk_") + number, std::string("office_chair_") + number).x, 0, 160) << number;
}

TEST(Composition, ASideboardIsInTheAxisOfItsTable) {
  const Layout layout = solved_as_asked(
      SceneMaker(4400, 3700)
          .add("dining_table")
          .add("dining_chair", 6)
          .add("sideboard")
          .relate("around", {"dining_chair_1", "dining_chair_2", "dining_chair_3", "dining_chair_4", "dining_chair_5", "dining_chair_6"},
                  {"dining_table_1"})
          .make(true));
  EXPECT_NEAR(from(layout, "sideboard_1", "dining_table_1").x, 0, 250);
}

TEST(Composition, EasyChairsByASofaWithoutATableSitAcrossFromIt) {
  const Layout layout = solved_as_asked(SceneMaker(5000, 4200).add("sofa").add("armchair", 2).add("bookshelf").make(true));
  for (const char* chair : {"armchair_1", "armchair_2"}) {
    EXPECT_NEAR(turned(layout, chair, "sofa_1"), 180, 1) << chair;
    EXPECT_LT(-from(layout, "sofa_1", chair).y, 2200) << chair;
  }
  EXPECT_LT(std::abs(from(layout, "armchair_1", "armchair_2").x), 1400);
}

TEST(Composition, FourEasyChairsByTheFireSitFaceToFace) {
  const Layout layout = solved_as_asked(SceneMaker(4600, 4200).add("fireplace").add("armchair", 4).make(true));
  for (const auto& [one, other] : {std::pair{"armchair_1", "armchair_2"}, std::pair{"armchair_3", "armchair_4"}}) {
    EXPECT_NEAR(turned(layout, one, other), 180, 1) << one;
    EXPECT_LT(from(layout, one, other).y, 0) << one;  // before it
  }
}

TEST(Composition, EasyChairsAtTheEndsOfATableStandAsFarFromIt) {
  const Layout layout = solved_as_asked(
      SceneMaker(4700, 4000).add("sofa").add("armchair", 2).add("coffee_table").add("tv_stand").add("bookshelf").make(true));
  EXPECT_NEAR(from(layout, "coffee_table_1", "armchair_1").x, -from(layout, "coffee_table_1", "armchair_2").x, 180);
}

TEST(Composition, ABarAtTheWindowHasTheWallBehind) {
  SceneMaker maker(6100, 5100);
  maker.add("bar_counter")
      .add("bar_stool", 3)
      .opening(OpeningType::kDoor, "wall1", 300)
      .opening(OpeningType::kWindow, "wall3", 2000, 1600, 1150, 1000);
  for (const char* stool : {"bar_stool_1", "bar_stool_2", "bar_stool_3"}) maker.relate("inFrontOf", {stool}, {"bar_counter_1"});
  const Layout layout = solved_as_asked(maker.relate("underWindow", {"bar_counter_1"}, {"window2"}).make());
  const PlacedObject& bar = *layout.find_object("bar_counter_1");
  EXPECT_LT(5100 - bar.position[1] - bar.size.depth / 2.0, 60);
}

TEST(Composition, AWindowThatNobodyPlacedIsNotInTheBoardsWall) {
  SceneMaker maker(8000, 7000);
  maker.add("whiteboard").add("teacher_desk").add("school_desk", 12);
  for (int i = 1; i <= 12; ++i) maker.relate("facing", {"school_desk_" + std::to_string(i)}, {"whiteboard_1"});
  const Layout layout = solved_as_asked(maker.make(true));
  for (const Opening& opening : layout.room.openings) {
    if (opening.type != OpeningType::kWindow) continue;
    EXPECT_NE(opening.wall, layout.find_object("whiteboard_1")->supported_by);
  }
}

TEST(Composition, ATelevisionDoesNotHangBehindTheOpenDoor) {
  const Layout layout = solved_as_asked(SceneMaker(4300, 3800)
                                            .add("single_bed")
                                            .add("desk")
                                            .add("wardrobe")
                                            .add("bookshelf")
                                            .add("bean_bag")
                                            .add("tv")
                                            .mounted(Mount::kWall)
                                            .opening(OpeningType::kDoor, "wall2", 2800)
                                            .opening(OpeningType::kWindow, "wall3", 1500, 1200, 900, 1200)
                                            .make());
  const PlacedObject& tv = *layout.find_object("tv_1");
  const bool behind = tv.position[0] > 4300 - 900 && tv.position[1] > 3800 - 120;
  EXPECT_FALSE(behind) << tv.position[0] << ' ' << tv.position[1];
}

TEST(Composition, EasyChairsShareTheLowTablesOut) {
  const Layout layout =
      solved_as_asked(SceneMaker(7000, 6000).add("reception_desk").add("sofa", 2).add("armchair", 4).add("coffee_table", 2).make(true));
  for (int i = 1; i <= 4; ++i) {
    const std::string chair = "armchair_" + std::to_string(i), table = "coffee_table_" + std::to_string((i + 1) / 2);
    EXPECT_LT(std::hypot(from(layout, table, chair).x, from(layout, table, chair).y), 1800) << chair;
  }
}

TEST(Composition, ChairsWithoutATableTouchTheWall) {
  const Layout layout = solved_as_asked(SceneMaker(4100, 3700).add("chair", 4).add("bookshelf").add("toy_chest").make(true));
  for (int i = 1; i <= 4; ++i) {
    const PlacedObject& chair = *layout.find_object("chair_" + std::to_string(i));
    const double x = chair.position[0], y = chair.position[1];
    EXPECT_LT(std::min({x, y, 4100 - x, 3700 - y}), chair.size.depth / 2.0 + 30) << i;
  }
}

TEST(Composition, ALowBenchTouchesItsWall) {
  const Layout layout = solved_as_asked(SceneMaker(3600, 1800).add("bench").add("console_table").add("shoe_rack").make(true));
  const PlacedObject& bench = *layout.find_object("bench_1");
  const bool across = std::lround(bench.rotation_deg) % 180 == 0;
  const double x = bench.position[0], y = bench.position[1], half_x = (across ? bench.size.width : bench.size.depth) / 2.0,
               half_y = (across ? bench.size.depth : bench.size.width) / 2.0;
  EXPECT_LT(std::min({x - half_x, y - half_y, 3600 - x - half_x, 1800 - y - half_y}), 20);
}

}  // namespace
}  // namespace layoutbox::placement
