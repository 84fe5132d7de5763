// What belongs together or comes in numbers stands as people would put it.
#include <gtest/gtest.h>

#include <cmath>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

double turned(const Layout& layout, const std::string& a, const std::string& b) {
  return std::abs(std::remainder(layout.find_object(a)->rotation_deg - layout.find_object(b)->rotation_deg, 360));
}

double apart(const Layout& layout, const std::string& a, const std::string& b) {
  const PlacedObject *one = layout.find_object(a), *other = layout.find_object(b);
  return std::hypot(one->position[0] - other->position[0], one->position[1] - other->position[1]);
}

TEST(UsualGroups, SeatsWithATableBetweenThemDrawUpToIt) {
  const Layout layout = solved_as_asked(SceneMaker(6000, 5000)
                                            .add("armchair", 2)
                                            .add("game_table")
                                            .relate("facing", {"armchair_1"}, {"armchair_2"})
                                            .relate("facing", {"armchair_2"}, {"armchair_1"})
                                            .relate("between", {"game_table_1"}, {"armchair_1", "armchair_2"})
                                            .make(true));
  EXPECT_LT(apart(layout, "armchair_1", "armchair_2"), 2800);
}

TEST(UsualGroups, TheLampIsNotBetweenTheLaptopAndWhoSitsThere) {
  const Layout layout = solved_as_asked(SceneMaker(4000, 3500)
                                            .add("desk")
                                            .add("laptop")
                                            .add("table_lamp")
                                            .relate("on", {"laptop_1"}, {"desk_1"})
                                            .relate("on", {"table_lamp_1"}, {"desk_1"})
                                            .make(true));
  const PlacedObject &desk = *layout.find_object("desk_1"), &laptop = *layout.find_object("laptop_1");
  const TestPoint screen = in_frame_of(desk, {laptop.position[0], laptop.position[1], 0});
  const PlacedObject& lamp = *layout.find_object("table_lamp_1");
  const TestPoint light = in_frame_of(desk, {lamp.position[0], lamp.position[1], 0});
  EXPECT_LT(std::abs(screen.x), 100);
  EXPECT_GT(std::abs(light.x - screen.x), (laptop.size.width + lamp.size.width) / 2.0 - 1);
}

TEST(UsualGroups, OneThingOnAStageIsInItsMiddle) {
  const Layout layout = solved_as_asked(SceneMaker(7000, 6000)
                                            .add("stage")
                                            .add("statue")
                                            .relate("on", {"statue_1"}, {"stage_1"})
                                            .relate("centerOfRoom", {"stage_1"})
                                            .make(true));
  EXPECT_LT(apart(layout, "stage_1", "statue_1"), 60);
}

TEST(UsualGroups, WhatHangsOverACribHangsOverItsMiddle) {
  const Layout layout = solved_as_asked(SceneMaker(4000, 3500)
                                            .add("crib")
                                            .add("baby_mobile")
                                            .relate("corner", {"crib_1"})
                                            .relate("onCeiling", {"baby_mobile_1"})
                                            .relate("above", {"baby_mobile_1"}, {"crib_1"})
                                            .make(true));
  EXPECT_LT(apart(layout, "crib_1", "baby_mobile_1"), 60);
}

TEST(UsualGroups, ADeskUnderTheWindowIsUnderItsMiddle) {
  const Layout layout = solved_as_asked(SceneMaker(4500, 3600)
                                            .opening(OpeningType::kWindow, "wall2", 1200, 1200, 900, 1200)
                                            .opening(OpeningType::kDoor, "wall1", 100)
                                            .add("bed")
                                            .add("desk")
                                            .add("office_chair")
                                            .relate("againstWall", {"bed_1"})
                                            .relate("underWindow", {"desk_1"})
                                            .relate("inFrontOf", {"office_chair_1"}, {"desk_1"})
                                            .make());
  EXPECT_NEAR(layout.find_object("desk_1")->position[1], 1800, 60);
}

TEST(UsualGroups, PunchingBagsHangClearOfTheRing) {
  const Layout layout = solved_as_asked(
      SceneMaker(9000, 8000).add("boxing_ring").add("punching_bag", 2).relate("centerOfRoom", {"boxing_ring_1"}).make(true));
  const PlacedObject& ring = *layout.find_object("boxing_ring_1");
  for (const char* bag : {"punching_bag_1", "punching_bag_2"}) {
    const PlacedObject& o = *layout.find_object(bag);
    const double off = std::max(std::abs(o.position[0] - ring.position[0]), std::abs(o.position[1] - ring.position[1]));
    EXPECT_GE(off - ring.size.width / 2.0 - o.size.width / 2.0, 650) << bag;
  }
}

TEST(UsualGroups, HooksHangInARow) {
  SceneMaker maker(4000, 3000);
  maker.add("bench").add("coat_hook", 3);
  for (const char* hook : {"coat_hook_1", "coat_hook_2", "coat_hook_3"}) maker.relate("above", {hook}, {"bench_1"});
  const Layout layout = solved_as_asked(maker.relate("againstWall", {"bench_1"}).make(true));
  EXPECT_NEAR(apart(layout, "coat_hook_1", "coat_hook_2"), apart(layout, "coat_hook_2", "coat_hook_3"), 30);
  EXPECT_EQ(layout.find_object("coat_hook_1")->position[2], layout.find_object("coat_hook_3")->position[2]);
}

TEST(UsualGroups, BookshelvesStandSideBySide) {
  const Layout layout = solved_as_asked(SceneMaker(5000, 4000).add("bookshelf", 3).make(true));
  EXPECT_LT(turned(layout, "bookshelf_1", "bookshelf_2"), 1);
  EXPECT_LT(turned(layout, "bookshelf_2", "bookshelf_3"), 1);
  EXPECT_LT(apart(layout, "bookshelf_1", "bookshelf_2"), 1300);
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

TEST(UsualGroups, WhoSitsBehindADeskHasTheWallBehind) {
  const Layout layout = solved_as_asked(SceneMaker(5000, 4200)
                                            .add("desk")
                                            .add("office_chair")
                                            .add("chair", 2)
                                            .relate("behind", {"office_chair_1"}, {"desk_1"})
                                            .relate("inFrontOf", {"chair_1"}, {"desk_1"})
                                            .relate("inFrontOf", {"chair_2"}, {"desk_1"})
                                            .make(true));
  const PlacedObject& desk = *layout.find_object("desk_1");
  double nearest = 1e9;  // from the desk's middle to a wall behind its back
  const double a = (desk.rotation_deg + 90) * kPi / 180, x = std::cos(a), y = std::sin(a);
  if (std::abs(x) > 0.5) nearest = x > 0 ? 5000 - desk.position[0] : desk.position[0];
  if (std::abs(y) > 0.5) nearest = y > 0 ? 4200 - desk.position[1] : desk.position[1];
  EXPECT_LT(nearest, 1900);
  EXPECT_GT(nearest, 900);
}

TEST(UsualGroups, GuestsSitBeforeTheBar) {
  SceneMaker maker(7000, 6000);
  maker.add("bar_counter").add("bistro_table", 2);
  const Layout layout = solved_as_asked(maker.make(true));
  const PlacedObject& bar = *layout.find_object("bar_counter_1");
  for (const char* table : {"bistro_table_1", "bistro_table_2"}) {
    const PlacedObject& o = *layout.find_object(table);
    EXPECT_LT(in_frame_of(bar, {o.position[0], o.position[1], 0}).y, 0) << table;
  }
}

}  // namespace
}  // namespace layoutbox::placement
