// Sets that share a wall, a thing below them or the floor round a table; what looks into the room; visitors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

// How far the middle of the room is off the way a thing looks, in degrees.
double off_middle(const Layout& layout, const std::string& id, double width, double depth) {
  const TestPoint at = in_frame_of(*layout.find_object(id), {width / 2, depth / 2, 0});
  return std::abs(std::atan2(at.x, -at.y)) * 180 / kPi;
}

TEST(Sets, HooksOverABenchHangInOneRowOverItsMiddle) {
  SceneMaker maker(2600, 2200);
  maker.add("entryway_bench").relate("againstWall", {"entryway_bench_1"}).add("hook", 5);
  std::vector<std::string> hooks;
  for (int i = 1; i <= 5; ++i) {
    hooks.push_back("hook_" + std::to_string(i));
    maker.relate("onWall", {hooks.back()}).relate("above", {hooks.back()}, {"entryway_bench_1"});
  }
  const Layout layout = solved_as_asked(maker.make(true));
  const PlacedObject &first = *layout.find_object("hook_1"), &bench = *layout.find_object("entryway_bench_1");
  for (const std::string& id : hooks) {
    const PlacedObject& hook = *layout.find_object(id);
    EXPECT_NEAR(hook.rotation_deg, first.rotation_deg, 1) << id;
    EXPECT_NEAR(hook.position[2], first.position[2], 20) << id;
    const TestPoint at = in_frame_of(bench, {hook.position[0], hook.position[1], 0});
    EXPECT_LE(std::abs(at.x), bench.size.width / 2.0) << id;
  }
}

TEST(Sets, PicturesAboveASofaAreTogetherNoWiderThanIt) {
  SceneMaker maker(4500, 4000);
  maker.add("sofa").relate("againstWall", {"sofa_1"}).add("painting", 4);
  for (int i = 1; i <= 4; ++i) {
    const std::string id = "painting_" + std::to_string(i);
    maker.relate("onWall", {id}).relate("above", {id}, {"sofa_1"});
  }
  const Layout layout = solved_as_asked(maker.make(true));
  const PlacedObject &sofa = *layout.find_object("sofa_1"), &first = *layout.find_object("painting_1");
  for (int i = 1; i <= 4; ++i) {
    const PlacedObject& picture = *layout.find_object("painting_" + std::to_string(i));
    const TestPoint at = in_frame_of(sofa, {picture.position[0], picture.position[1], 0});
    EXPECT_LE(std::abs(at.x) + picture.size.width / 2.0, sofa.size.width / 2.0 + 60) << i;
    EXPECT_NEAR(picture.position[2], first.position[2], 20) << i;
  }
}

TEST(Sets, AFewThatAreToldAWallHangSideBySide) {
  SceneMaker maker(4500, 4000);
  maker.add("sofa").add("neon_sign").mounted(Mount::kWall).add("wall_skateboard", 3);
  maker.relate("above", {"neon_sign_1"}, {"sofa_1"});
  for (int i = 1; i <= 3; ++i) maker.relate("onWall", {"wall_skateboard_" + std::to_string(i)});
  const Layout layout = solved_as_asked(maker.make(true));
  const PlacedObject& first = *layout.find_object("wall_skateboard_1");
  for (int i = 2; i <= 3; ++i) {
    const PlacedObject& board = *layout.find_object("wall_skateboard_" + std::to_string(i));
    EXPECT_NEAR(board.rotation_deg, first.rotation_deg, 1) << i;
    EXPECT_NEAR(board.position[2], first.position[2], 20) << i;
    EXPECT_LT(std::hypot(board.position[0] - first.position[0], board.position[1] - first.position[1]), 1000) << i;
  }
}

TEST(Sets, BucketsAlongAWallTakeAllOfIt) {
  SceneMaker maker(5000, 4000);
  maker.add("bucket", 6);
  for (int i = 1; i <= 6; ++i) maker.relate("againstWall", {"bucket_" + std::to_string(i)}, {"wall3"});
  const Layout layout = solved_as_asked(maker.make());
  std::vector<double> at;
  for (int i = 1; i <= 6; ++i) at.push_back(layout.find_object("bucket_" + std::to_string(i))->position[0]);
  std::ranges::sort(at);
  for (std::size_t i = 1; i < at.size(); ++i) {
    EXPECT_GT(at[i] - at[i - 1], 600) << i;
    EXPECT_LT(at[i] - at[i - 1], 1100) << i;
  }
}

TEST(Sets, NothingIsJammedAgainstAPoolTable) {
  SceneMaker maker(7000, 6000);
  maker.add("pool_table").relate("centerOfRoom", {"pool_table_1"}).add("bar_table", 3).add("jukebox");
  const Layout layout = solved_as_asked(maker.make(true));
  const PlacedObject& played = *layout.find_object("pool_table_1");
  for (int i = 1; i <= 3; ++i) {
    const PlacedObject& table = *layout.find_object("bar_table_" + std::to_string(i));
    const TestPoint at = in_frame_of(played, {table.position[0], table.position[1], 0});
    const double half = std::max(table.size.width, table.size.depth) / 2.0;
    EXPECT_GE(std::max(std::abs(at.x) - played.size.width / 2.0, std::abs(at.y) - played.size.depth / 2.0) - half, 900) << i;
  }
}

TEST(Sets, TheDrummerSitsBehindAKitThatLooksIntoTheRoom) {
  const Layout layout =
      solved_as_asked(SceneMaker(4500, 4000).add("drum_kit").add("drum_stool").add("sofa").relate("corner", {"drum_kit_1"}).make(true));
  EXPECT_LT(off_middle(layout, "drum_kit_1", 4500, 4000), 91);
  const PlacedObject& stool = *layout.find_object("drum_stool_1");
  EXPECT_GT(in_frame_of(*layout.find_object("drum_kit_1"), {stool.position[0], stool.position[1], 0}).y, 0);
}

TEST(Sets, ATeddyInACornerLooksIntoTheRoom) {
  SceneMaker maker(4000, 3600);
  maker.add("bed").add("teddy_bear").mounted(Mount::kFloor).relate("corner", {"teddy_bear_1"});
  EXPECT_LT(off_middle(solved_as_asked(maker.make(true)), "teddy_bear_1", 4000, 3600), 91);
}

TEST(Sets, AVisitorLooksAtTheBedTheChairIsAt) {
  SceneMaker maker(5700, 5000);
  maker.add("hospital_bed", 2).add("visitor_chair", 2);
  for (const char* number : {"1", "2"})
    maker.relate("atFootOf", {std::string("visitor_chair_") + number}, {std::string("hospital_bed_") + number});
  const Layout layout = solved_as_asked(maker.make(true));
  for (const char* number : {"1", "2"}) {
    const PlacedObject &chair = *layout.find_object(std::string("visitor_chair_") + number),
                       &bed = *layout.find_object(std::string("hospital_bed_") + number);
    const TestPoint at = in_frame_of(chair, {bed.position[0], bed.position[1], 0});
    EXPECT_LT(at.y, 0) << number;
    EXPECT_LT(std::abs(at.x), bed.size.depth / 2.0) << number;
  }
}

TEST(Sets, AShelfAboveTwoSideBySideHangsOverBoth) {
  SceneMaker maker(2600, 3000);
  maker.add("washing_machine").add("dryer").add("wall_shelf").relate("nextTo", {"washing_machine_1"}, {"dryer_1"});
  maker.relate("edgeAlign", {"dryer_1"}, {"washing_machine_1"}).relate("sameOrientation", {"dryer_1"}, {"washing_machine_1"});
  const Layout layout = solved_as_asked(maker.relate("above", {"wall_shelf_1"}, {"dryer_1"}).make(true));
  EXPECT_NEAR(between_middles(layout, "wall_shelf_1", "dryer_1"), between_middles(layout, "wall_shelf_1", "washing_machine_1"), 250);
}

TEST(Sets, WhoIsToldToSitAtTheEndOfATableHasIt) {
  SceneMaker maker(4500, 4000);
  RelationParameters end;
  end.side = Side::kShort;
  maker.add("dining_table").sized(1400, 850, 750).add("dining_chair", 5).add("high_chair");
  maker.relate("around", {"dining_chair_1", "dining_chair_2", "dining_chair_3", "dining_chair_4", "dining_chair_5"}, {"dining_table_1"});
  const Layout layout = solved_as_asked(maker.relate("alongSide", {"high_chair_1"}, {"dining_table_1"}, end)
                                            .relate("facing", {"high_chair_1"}, {"dining_table_1"})
                                            .make(true));
  const PlacedObject& high = *layout.find_object("high_chair_1");
  const TestPoint at = in_frame_of(*layout.find_object("dining_table_1"), {high.position[0], high.position[1], 0});
  EXPECT_LT(std::abs(at.x) - 700 - high.size.depth / 2.0, 300) << "no chair is between";
}

// "four chairs on each long side, one at each end"
TEST(Sets, SeatsAtTheSidesOfATableShareThemEvenly) {
  SceneMaker maker(6500, 4000);
  maker.add("table").sized(2600, 1100, 750).add("chair", 10).relate("centerOfRoom", {"table_1"}, {});
  for (int i = 1; i <= 10; ++i) {
    RelationParameters side;
    side.side = i <= 8 ? Side::kLong : Side::kShort;
    maker.relate("alongSide", {"chair_" + std::to_string(i)}, {"table_1"}, side);
  }
  const Layout layout = solved_as_asked(maker.make());
  std::vector<double> front, back;
  for (int i = 1; i <= 10; ++i) {
    const PlacedObject& chair = *layout.find_object("chair_" + std::to_string(i));
    const TestPoint at = in_frame_of(*layout.find_object("table_1"), {chair.position[0], chair.position[1], 0});
    if (i <= 8) {
      EXPECT_LT(std::abs(at.y), 550 + chair.size.depth) << "chair " << i << " is in a second row";
      (at.y < 0 ? front : back).push_back(at.x);
    } else {
      EXPECT_NEAR(at.y, 0, 150) << "chair " << i << " at its end";
    }
  }
  for (std::vector<double>* side : {&front, &back}) {
    ASSERT_EQ(side->size(), 4U);
    std::ranges::sort(*side);
    for (std::size_t i = 1; i < side->size(); ++i) EXPECT_NEAR((*side)[i] - (*side)[i - 1], 2600 / 4.0, 150);
  }
}

TEST(Sets, GuestsSitOffTheReceptionDesk) {
  SceneMaker maker(5500, 4500);
  maker.add("reception_desk").add("chair", 6).opening(OpeningType::kDoor, "wall1", 2300);
  for (int i = 1; i <= 6; ++i) maker.relate("againstWall", {"chair_" + std::to_string(i)}, {i % 2 == 0 ? "wall2" : "wall4"});
  maker.relate("facing", {"reception_desk_1"}, {"door1"});
  const Layout layout = solved_as_asked(maker.make());
  const PlacedObject& desk = *layout.find_object("reception_desk_1");
  for (int i = 1; i <= 6; ++i) {
    const PlacedObject& chair = *layout.find_object("chair_" + std::to_string(i));
    const TestPoint at = in_frame_of(desk, {chair.position[0], chair.position[1], 0});
    const bool off = std::abs(at.x) > desk.size.width / 2.0 + 700 || at.y < -desk.size.depth / 2.0 - 600;
    EXPECT_TRUE(off && at.y < desk.size.depth / 2.0 + 300) << "chair " << i;
  }
}

}  // namespace
}  // namespace layoutbox::placement
