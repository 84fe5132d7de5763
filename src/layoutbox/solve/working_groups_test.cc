// Things that belong together work together: seats at their mirrors, screens that are seen, desks with who serves and who waits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

// Where one stands in the other's frame.
TestPoint seen_from(const Layout& layout, const std::string& from, const std::string& what) {
  const PlacedObject& thing = object(layout, what);
  return in_frame_of(object(layout, from), {thing.position[0], thing.position[1], 0});
}

// Free floor between two upright boxes.
double apart(const Layout& layout, const std::string& a, const std::string& b) {
  const TestPoint at = seen_from(layout, a, b);
  const PlacedObject &one = object(layout, a), &other = object(layout, b);
  const bool across = std::abs(std::remainder(turned(layout, a, b), 180)) > 45;
  const double w = across ? other.size.depth : other.size.width, d = across ? other.size.width : other.size.depth;
  return std::max(std::abs(at.x) - (one.size.width + w) / 2, std::abs(at.y) - (one.size.depth + d) / 2);
}

TEST(WorkingGroups, EachBarbersChairHasAMirrorOfItsOwn) {
  const Layout layout = solved_as_asked(SceneMaker(5700, 4700).add("salon_chair", 3).add("mirror", 3).add("reception_desk").make(true));
  for (const std::string k : {"1", "2", "3"}) {
    const TestPoint chair = seen_from(layout, "mirror_" + k, "salon_chair_" + k);
    EXPECT_LT(std::abs(chair.x), 100) << k;
    EXPECT_GT(chair.y, -1300) << k;
    EXPECT_LT(chair.y, 0) << k;
    EXPECT_NEAR(turned(layout, "mirror_" + k, "salon_chair_" + k), 180, 1) << k;
    EXPECT_LT(turned(layout, "mirror_1", "mirror_" + k), 1) << k;
  }
}

TEST(WorkingGroups, WhoRunsOrRidesSeesTheScreen) {
  const Layout layout = solved_as_asked(SceneMaker(5000, 4100).add("treadmill").add("exercise_bike").add("tv").make(true));
  for (const char* machine : {"treadmill_1", "exercise_bike_1"}) {
    EXPECT_LT(seen_from(layout, machine, "tv_1").y, 0) << machine;  // its user looks towards its front
    EXPECT_LT(seen_from(layout, "tv_1", machine).y, 0) << machine;
  }
}

// A case behind the desk, or a window, moves neither of them to the front alone.
TEST(WorkingGroups, ScreensOfOneDeskStandInALine) {
  const Layout layout = solved_as_asked(SceneMaker(3600, 3200)
                                            .add("desk")
                                            .sized(1700, 800, 750)
                                            .add("monitor", 2)
                                            .add("office_chair")
                                            .add("bookshelf")
                                            .relate("behind", {"bookshelf_1"}, {"desk_1"})
                                            .make(true));
  EXPECT_NEAR(seen_from(layout, "monitor_1", "monitor_2").y, 0, 30);
}

// Desks in islands whose chairs are told to be behind them have these on the outside, not beyond the desk across.
TEST(WorkingGroups, WhoSitsBehindADeskOfAnIslandSitsAtItsScreen) {
  SceneMaker maker(7000, 6000);
  maker.add("desk", 6).add("office_chair", 6).add("monitor", 6);
  for (const std::string k : {"1", "2", "3", "4", "5", "6"}) {
    maker.relate("behind", {"office_chair_" + k}, {"desk_" + k}).relate("on", {"monitor_" + k}, {"desk_" + k});
  }
  const Layout layout = solved_as_asked(maker.make(true));
  for (const std::string k : {"1", "2", "3", "4", "5", "6"}) {
    EXPECT_LT(apart(layout, "desk_" + k, "office_chair_" + k), 250) << k;
    const TestPoint chair = seen_from(layout, "monitor_" + k, "office_chair_" + k);
    EXPECT_LT(chair.y, 0) << k;
    EXPECT_GT(chair.y, -1100) << k;
  }
}

TEST(WorkingGroups, WhoReceivesSitsBehindTheDesk) {
  const Layout layout = solved_as_asked(SceneMaker(5500, 4500).add("reception_desk").add("office_chair").add("beam_seating", 2).make(true));
  EXPECT_GT(seen_from(layout, "reception_desk_1", "office_chair_1").y, 0);
}

TEST(WorkingGroups, GuestsWaitInARowAwayFromTheDesk) {
  const Layout layout = solved_as_asked(SceneMaker(5500, 4500).add("reception_desk").add("office_chair").add("chair", 3).make(true));
  for (const char* chair : {"chair_1", "chair_2", "chair_3"}) {
    EXPECT_GT(apart(layout, "reception_desk_1", chair), 800) << chair;
    EXPECT_LT(turned(layout, "chair_1", chair), 1) << chair;
  }
}

TEST(WorkingGroups, NoBarIsBetweenTheSofaAndTheScreen) {
  const Layout layout = solved_as_asked(SceneMaker(6400, 5700)
                                            .add("pool_table")
                                            .add("sofa")
                                            .add("tv")
                                            .add("bar_counter")
                                            .add("stool", 3)
                                            .add("dart_board")
                                            .add("mini_fridge")
                                            .relate("inFrontOf", {"stool_1", "stool_2", "stool_3"}, {"bar_counter_1"})
                                            .make(true));
  const TestPoint screen = seen_from(layout, "sofa_1", "tv_1");
  EXPECT_LT(screen.y, 0);
  for (const char* id : {"bar_counter_1", "pool_table_1"}) {
    const TestPoint bar = seen_from(layout, "sofa_1", id);
    const bool between = bar.y < 0 && bar.y > screen.y && std::abs(bar.x) < 600;
    EXPECT_FALSE(between) << id;
  }
}

TEST(WorkingGroups, TheSofaSeesTheScreenThoughABedIsThere) {
  const Layout layout = solved_as_asked(SceneMaker(6200, 5200)
                                            .add("bed")
                                            .add("sofa")
                                            .add("tv")
                                            .add("kitchenette")
                                            .add("dining_table")
                                            .add("chair", 2)
                                            .add("wardrobe")
                                            .relate("around", {"chair_1", "chair_2"}, {"dining_table_1"})
                                            .make(true));
  EXPECT_LT(seen_from(layout, "sofa_1", "tv_1").y, -600);
  EXPECT_LT(seen_from(layout, "tv_1", "sofa_1").y, 0);
}

TEST(WorkingGroups, NobodySitsUnderTheTelevision) {
  const Layout layout = solved_as_asked(
      SceneMaker(4500, 4000).add("hospital_bed").add("visitor_chair").add("tv").add("nightstand").add("wardrobe").make(true));
  const TestPoint chair = seen_from(layout, "tv_1", "visitor_chair_1");
  EXPECT_TRUE(std::abs(chair.x) > 700 || chair.y < -700) << chair.x << " " << chair.y;
}

TEST(WorkingGroups, AToiletHasRoomAtItsSides) {
  const Layout layout = solved_as_asked(SceneMaker(2600, 1800)
                                            .opening(OpeningType::kDoor, "wall1", 1600)
                                            .add("bathtub")
                                            .add("toilet")
                                            .add("sink")
                                            .relate("againstWall", {"sink_1"}, {"wall3"})
                                            .relate("againstWall", {"toilet_1"}, {"wall3"})
                                            .relate("againstWall", {"bathtub_1"}, {"wall4"})
                                            .make());
  for (const char* other : {"sink_1", "bathtub_1"}) EXPECT_GE(apart(layout, "toilet_1", other), 150) << other;
}

TEST(WorkingGroups, TowelsHangBesideTheBasin) {
  const Layout layout = solved_as_asked(
      SceneMaker(2700, 2200).add("shower").add("toilet").add("sink").add("mirror").add("towel_rack").add("laundry_basket").make(true));
  const TestPoint rail = seen_from(layout, "sink_1", "towel_rack_1");
  EXPECT_LT(std::abs(rail.x), 900);
  EXPECT_GT(std::abs(rail.x), (object(layout, "sink_1").size.width + object(layout, "towel_rack_1").size.width) / 2.0 - 10);
}

TEST(WorkingGroups, ABathMatLiesBeforeTheBath) {
  const Layout layout =
      solved_as_asked(SceneMaker(3300, 2600).add("bathtub").add("toilet").add("double_vanity").add("bath_mat").make(true));
  EXPECT_LT(apart(layout, "bathtub_1", "bath_mat_1"), 150);
}

TEST(WorkingGroups, TwoEasyChairsTalk) {
  const Layout layout = solved_as_asked(SceneMaker(4500, 4000).add("armchair", 2).add("desk").add("bookshelf").make(true));
  EXPECT_NEAR(turned(layout, "armchair_1", "armchair_2"), 180, 1);
  EXPECT_LT(apart(layout, "armchair_1", "armchair_2"), 1500);
}

// Who sits below a loft bed sits below it: the bed is not in the way of the chair.
TEST(WorkingGroups, ADeskIsBelowItsLoftBed) {
  const Layout layout = solved_as_asked(SceneMaker(3900, 3500)
                                            .add("loft_bed")
                                            .add("desk")
                                            .add("office_chair")
                                            .relate("corner", {"loft_bed_1"}, {"wall3", "wall2"})
                                            .relate("under", {"desk_1"}, {"loft_bed_1"})
                                            .relate("inFrontOf", {"office_chair_1"}, {"desk_1"})
                                            .relate("facing", {"office_chair_1"}, {"desk_1"})
                                            .make(true));
  const TestPoint desk = seen_from(layout, "loft_bed_1", "desk_1");
  const PlacedObject &bed = object(layout, "loft_bed_1"), &table = object(layout, "desk_1");
  const bool across = std::abs(std::remainder(turned(layout, "loft_bed_1", "desk_1"), 180)) > 45;
  EXPECT_LE(std::abs(desk.x) + (across ? table.size.depth : table.size.width) / 2.0, bed.size.width / 2.0 + 20);
  EXPECT_LT(std::abs(seen_from(layout, "loft_bed_1", "office_chair_1").x), bed.size.width / 2.0 + 100);
}

TEST(WorkingGroups, AFewDesksStandAbreastBeforeWhatTheyFace) {
  SceneMaker maker(6500, 5100);
  maker.add("control_console", 3).add("office_chair", 3).add("video_wall");
  for (const std::string k : {"1", "2", "3"}) {
    maker.relate("facing", {"control_console_" + k}, {"video_wall_1"}).relate("behind", {"office_chair_" + k}, {"control_console_" + k});
  }
  const Layout layout = solved_as_asked(maker.make(true));
  for (const char* other : {"control_console_2", "control_console_3"}) {
    EXPECT_NEAR(seen_from(layout, "control_console_1", other).y, 0, 50) << other;
  }
}

TEST(WorkingGroups, WhoSitsBehindADeskHasTheKeysBeforeTheScreen) {
  const Layout layout = solved_as_asked(SceneMaker(4500, 4000)
                                            .add("desk")
                                            .add("office_chair")
                                            .add("monitor")
                                            .add("keyboard")
                                            .add("whiteboard")
                                            .relate("facing", {"desk_1"}, {"whiteboard_1"})
                                            .relate("behind", {"office_chair_1"}, {"desk_1"})
                                            .relate("on", {"monitor_1"}, {"desk_1"})
                                            .relate("on", {"keyboard_1"}, {"desk_1"})
                                            .make(true));
  EXPECT_LT(seen_from(layout, "monitor_1", "keyboard_1").y, 0);
  EXPECT_GT(seen_from(layout, "desk_1", "keyboard_1").y, 0);
}

TEST(WorkingGroups, AStoolNextToAChairIsAtItsSide) {
  const Layout layout = solved_as_asked(SceneMaker(4000, 3500)
                                            .add("workbench")
                                            .add("office_chair")
                                            .add("milking_stool")
                                            .relate("inFrontOf", {"office_chair_1"}, {"workbench_1"})
                                            .relate("facing", {"office_chair_1"}, {"workbench_1"})
                                            .relate("nextTo", {"milking_stool_1"}, {"office_chair_1"})
                                            .make(true));
  const TestPoint stool = seen_from(layout, "office_chair_1", "milking_stool_1");
  EXPECT_GT(std::abs(stool.x), std::abs(stool.y));
}

TEST(WorkingGroups, ABasinIsNotUnderABarbersMirror) {
  SceneMaker maker(5700, 4700);
  maker.add("mirror", 4).add("salon_chair", 4).add("sink", 2).add("reception_desk").add("sofa").relate("underWindow", {"sofa_1"});
  for (const std::string k : {"1", "2", "3", "4"}) maker.relate("facing", {"salon_chair_" + k}, {"mirror_" + k});
  const Layout layout = solved_as_asked(maker.make(true));
  for (const std::string mirror : {"mirror_1", "mirror_2", "mirror_3", "mirror_4"}) {
    for (const std::string sink : {"sink_1", "sink_2"}) EXPECT_GT(apart(layout, mirror, sink), 0) << mirror;
  }
}

TEST(WorkingGroups, InFrontOfAMirrorOneLooksIntoIt) {
  SceneMaker maker(5500, 4500);
  maker.add("mirror", 2).add("salon_chair", 2).add("sink", 2);
  for (const std::string k : {"1", "2"}) maker.relate("inFrontOf", {"salon_chair_" + k}, {"mirror_" + k});
  const Layout layout = solved_as_asked(maker.make(true));
  for (const std::string k : {"1", "2"}) {
    EXPECT_NEAR(turned(layout, "mirror_" + k, "salon_chair_" + k), 180, 1) << k;
    for (const std::string sink : {"sink_1", "sink_2"}) EXPECT_GT(apart(layout, "mirror_" + k, sink), 0) << k;
  }
}

// Four mirrors along a wall hang in their order, each with its chair.
TEST(WorkingGroups, ChairsBeforeMirrorsOfOneWallAreAbreast) {
  SceneMaker maker(5500, 4500);
  maker.add("salon_chair", 4).add("mirror", 4);
  for (const std::string k : {"1", "2", "3", "4"}) {
    maker.relate("facing", {"salon_chair_" + k}, {"mirror_" + k}).relate("onWall", {"mirror_" + k}, {"wall2"});
    maker.add("wall_shelf").relate("under", {"wall_shelf_" + k}, {"mirror_" + k});
  }
  const Layout layout = solved_as_asked(maker.make(true));
  const auto y_of = [&](const std::string& k) { return layout.find_object("salon_chair_" + k)->position[1]; };
  const bool up = y_of("2") > y_of("1");
  for (const auto& [one, next] : {std::pair{"1", "2"}, std::pair{"2", "3"}, std::pair{"3", "4"}}) {
    EXPECT_GT(up ? y_of(next) - y_of(one) : y_of(one) - y_of(next), 900) << one;
    EXPECT_NEAR(layout.find_object(std::string("salon_chair_") + one)->position[0],
                layout.find_object(std::string("salon_chair_") + next)->position[0], 100);
  }
}

// A table of a kind stands clear of the others, also where all are told to be by one window, and in line with them.
TEST(WorkingGroups, TablesByAWindowStandInLineAndApart) {
  SceneMaker maker(8000, 6000);
  maker.add("bistro_table", 3).add("folding_chair", 6);
  for (int k = 1; k <= 3; ++k) {
    const std::string table = "bistro_table_" + std::to_string(k);
    maker.relate("nextTo", {table}, {"window1"});
    for (int seat : {2 * k - 1, 2 * k}) maker.relate("nextTo", {"folding_chair_" + std::to_string(seat)}, {table});
  }
  const Layout layout = solved_as_asked(maker.make(true));
  for (const auto& [one, other] : {std::pair{1, 2}, std::pair{2, 3}, std::pair{1, 3}})
    EXPECT_GT(apart(layout, "bistro_table_" + std::to_string(one), "bistro_table_" + std::to_string(other)), 800) << one << other;
}

// What lies by nature hangs flat on a wall, not on its end.
TEST(WorkingGroups, ASwordHangsFlatOnItsWall) {
  SceneMaker maker(5000, 4000);
  maker.add("fireplace").add("sword").relate("onWall", {"sword_1"}).relate("above", {"sword_1"}, {"fireplace_1"});
  const Layout layout = solved_as_asked(maker.make(true));
  const PlacedObject& sword = *layout.find_object("sword_1");
  EXPECT_LT(sword.size.depth, 100);
  const auto& at = sword.position;
  EXPECT_LT(std::min({at[0], at[1], 5000 - at[0], 4000 - at[1]}), 100) << "its middle is at the wall";
}

}  // namespace
}  // namespace layoutbox::placement
