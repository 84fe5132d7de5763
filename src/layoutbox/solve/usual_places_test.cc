// Where words leave it open, things stand where their kind usually does.
#include <gtest/gtest.h>

#include <cmath>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

double between(const Layout& layout, const std::string& a, const std::string& b) {
  const PlacedObject *one = layout.find_object(a), *other = layout.find_object(b);
  return std::hypot(one->position[0] - other->position[0], one->position[1] - other->position[1]);
}

// "Curtains on the window": side by side before it, neither on its sill nor one before the other.
TEST(UsualPlaces, CurtainsSaidToBeOnAWindowShareIt) {
  const Layout layout = solved_as_asked(SceneMaker(4000, 3500)
                                            .opening(OpeningType::kWindow, "wall3", 1400, 1200, 900, 1200)
                                            .opening(OpeningType::kWindow, "wall4", 1000, 1200, 900, 1200)
                                            .add("blackout_curtain", 2)
                                            .relate("on", {"blackout_curtain_1", "blackout_curtain_2"}, {"window1"})
                                            .make());
  const PlacedObject &left = *layout.find_object("blackout_curtain_1"), &right = *layout.find_object("blackout_curtain_2");
  EXPECT_LT(left.position[2], 100) << "down to the floor";
  EXPECT_NEAR(left.position[1], right.position[1], 1) << "on one rod";
  EXPECT_NEAR(std::abs(left.position[0] - right.position[0]), left.size.width, 20);
  EXPECT_NEAR((left.position[0] + right.position[0]) / 2, 2000, 20);
}

TEST(UsualPlaces, WhoSitsAtATableAloneHasAWallOrAWindowBeforeHim) {
  const Layout layout = solved_as_asked(SceneMaker(4000, 3500).add("table").add("chair").make(true));
  const PlacedObject& table = *layout.find_object("table_1");
  const double half = std::min(table.size.width, table.size.depth) / 2;
  const double off = std::min({table.position[0], table.position[1], 4000 - table.position[0], 3500 - table.position[1]});
  EXPECT_LT(off - half, 100);
  EXPECT_LT(between(layout, "table_1", "chair_1"), 1000);
}

TEST(UsualPlaces, LeavesOfTwoDoorsDoNotMeet) {
  SceneMaker maker = SceneMaker(3500, 4200).opening(OpeningType::kDoor, "wall2", 100).add("single_bed");
  maker.opening(OpeningType::kDoor, "", std::nullopt).opening(OpeningType::kWindow, "", std::nullopt, 1200, 900, 1200);
  const Layout layout = solved_as_asked(maker.make());
  const Opening &fixed = layout.room.openings[0], &free = layout.room.openings[1];
  ASSERT_TRUE(fixed.offset && free.offset);
  // From the corner of the front and the right wall, where both would be.
  if (free.wall == "wall1") {
    EXPECT_LT(*free.offset + free.width, 3500 - fixed.width + 1);
  } else if (free.wall == "wall2") {
    EXPECT_GE(*free.offset, *fixed.offset + fixed.width + free.width);
  }
}

TEST(UsualPlaces, ADeskThatFacesAWindowStandsAtIt) {
  const Layout layout = solved_as_asked(SceneMaker(4500, 3500)
                                            .opening(OpeningType::kWindow, "wall4", 1200, 1200, 900, 1200)
                                            .opening(OpeningType::kDoor, "wall1", 200)
                                            .add("desk")
                                            .add("office_chair")
                                            .add("loveseat")
                                            .relate("facing", {"desk_1"}, {"window1"})
                                            .make());
  EXPECT_LT(layout.find_object("desk_1")->position[0], 600);
}

TEST(UsualPlaces, BunkBedsKeepToCorners) {
  const Layout layout = solved_as_asked(SceneMaker(4000, 3600).add("bunk_bed", 2).make(true));
  for (const std::string id : {"bunk_bed_1", "bunk_bed_2"}) {
    const PlacedObject& bed = *layout.find_object(id);
    const bool across = std::abs(std::remainder(bed.rotation_deg, 180)) > 45;
    const double w = (across ? bed.size.depth : bed.size.width) / 2.0, d = (across ? bed.size.width : bed.size.depth) / 2.0;
    EXPECT_LT(std::min(bed.position[0] - w, 4000 - bed.position[0] - w), 30) << id;
    EXPECT_LT(std::min(bed.position[1] - d, 3600 - bed.position[1] - d), 30) << id;
  }
}

TEST(UsualPlaces, ANightstandSaidToBeAtASideStandsByThePillow) {
  const Layout layout = solved_as_asked(
      SceneMaker(4400, 4000).add("bed").add("nightstand").add("wardrobe").relate("rightOf", {"nightstand_1"}, {"bed_1"}).make(true));
  const PlacedObject &bed = *layout.find_object("bed_1"), &stand = *layout.find_object("nightstand_1");
  EXPECT_LT(between(layout, "bed_1", "nightstand_1"), std::hypot(bed.size.width, bed.size.depth) / 2 + stand.size.width);
}

TEST(UsualPlaces, AChairSaidToBeNearADeskSitsAtIt) {
  const Layout layout =
      solved_as_asked(SceneMaker(4000, 3500).add("desk").add("office_chair").relate("near", {"office_chair_1"}, {"desk_1"}).make(true));
  EXPECT_LT(between(layout, "office_chair_1", "desk_1"), 1200);  // near is half a metre off at least
  const double turned =
      std::remainder(layout.find_object("office_chair_1")->rotation_deg - layout.find_object("desk_1")->rotation_deg, 360);
  EXPECT_NEAR(std::abs(turned), 180, 1);
}

TEST(UsualPlaces, AScreenLooksAtWhoIsToldToSitThere) {
  const Layout layout = solved_as_asked(SceneMaker(4000, 3500)
                                            .add("table")
                                            .add("office_chair")
                                            .add("monitor")
                                            .relate("facing", {"office_chair_1"}, {"table_1"})
                                            .relate("on", {"monitor_1"}, {"table_1"})
                                            .make(true));
  const double turned =
      std::remainder(layout.find_object("office_chair_1")->rotation_deg - layout.find_object("monitor_1")->rotation_deg, 360);
  EXPECT_NEAR(std::abs(turned), 180, 1);
}

// How far the back of a thing is from the wall behind it, in a room of that size.
double behind_back(const Layout& layout, const std::string& id, double width, double depth) {
  const PlacedObject& o = *layout.find_object(id);
  const int turn = static_cast<int>(std::lround(o.rotation_deg)) % 360;
  const double half = o.size.depth / 2.0, x = o.position[0], y = o.position[1];
  switch (turn) {
    case 0: return depth - y - half;
    case 90: return x - half;
    case 180: return y - half;
    default: return width - x - half;
  }
}

TEST(UsualPlaces, ShelvesBehindABarHaveTheWallBehindThem) {
  SceneMaker maker(6000, 5000);
  maker.add("bar_counter").add("bookshelf", 2).add("bar_stool", 4);
  for (const char* id : {"bookshelf_1", "bookshelf_2"}) maker.relate("behind", {id}, {"bar_counter_1"});
  const Layout layout = solved_as_asked(maker.make(true));
  for (const char* id : {"bookshelf_1", "bookshelf_2"}) EXPECT_LT(behind_back(layout, id, 6000, 5000), 60) << id;
}

TEST(UsualPlaces, AFullBookcaseByASeatStandsAtTheWall) {
  SceneMaker maker(5000, 4200);
  maker.add("recliner").add("bookshelf").add("book", 2).add("sculpture", 2).add("table").add("sofa").add("coffee_table");
  for (const char* id : {"book_1", "book_2", "sculpture_1", "sculpture_2"}) maker.relate("in", {id}, {"bookshelf_1"});
  const Layout layout = solved_as_asked(maker.relate("nextTo", {"recliner_1"}, {"bookshelf_1"})
                                            .relate("opposite", {"table_1"}, {"recliner_1"})
                                            .relate("centerOfRoom", {"coffee_table_1"})
                                            .make(true));
  EXPECT_LT(behind_back(layout, "bookshelf_1", 5000, 4200), 150);
}

TEST(UsualPlaces, WhatIsOnAShelfStandsWhereItIsSeen) {
  SceneMaker maker(4000, 3500);
  maker.add("shelf").add("soup_can", 4);
  for (int i = 1; i <= 4; ++i) maker.relate("on", {"soup_can_" + std::to_string(i)}, {"shelf_1"});
  const Layout layout = solved_as_asked(maker.make(true));
  const PlacedObject& shelf = *layout.find_object("shelf_1");
  const double turn = radians_from_degrees(shelf.rotation_deg);
  for (int i = 1; i <= 4; ++i) {
    const PlacedObject& can = *layout.find_object("soup_can_" + std::to_string(i));
    const double to_front = (can.position[0] - shelf.position[0]) * std::sin(turn) - (can.position[1] - shelf.position[1]) * std::cos(turn);
    EXPECT_GT(to_front, shelf.size.depth / 4.0) << can.id;
  }
}

TEST(UsualPlaces, ChairsWithTheirBacksToTheWallSitInARow) {
  SceneMaker maker(4500, 3600);
  maker.add("chair", 6).add("aquarium");
  for (int i = 1; i <= 6; ++i) maker.relate("againstWall", {"chair_" + std::to_string(i)});
  const Layout layout = solved_as_asked(maker.relate("corner", {"aquarium_1"}).make(true));
  for (int i = 2; i <= 6; ++i) {
    const PlacedObject &one = *layout.find_object("chair_" + std::to_string(i - 1)),
                       &next = *layout.find_object("chair_" + std::to_string(i));
    EXPECT_NEAR(one.rotation_deg, next.rotation_deg, 1) << next.id;
    EXPECT_LT(std::hypot(one.position[0] - next.position[0], one.position[1] - next.position[1]), 700) << next.id;
  }
}

TEST(UsualPlaces, WhatIsToldItsWallStandsThereSideBySide) {
  for (const char* kind : {"bookshelf", "wardrobe", "locker"}) {
    SceneMaker maker(5000, 4200);
    maker.opening(OpeningType::kDoor, "wall1", 100).add(kind, 2).add("painting");
    const std::string one = std::string(kind) + "_1", other = std::string(kind) + "_2";
    for (const std::string& id : {one, other}) maker.relate("againstWall", {id}).relate("farFromDoor", {id});
    const Layout layout = solved_as_asked(maker.make());
    EXPECT_NEAR(layout.find_object(one)->rotation_deg, layout.find_object(other)->rotation_deg, 1) << kind;
    EXPECT_LT(between(layout, one, other), layout.find_object(one)->size.width + 200.0) << kind;
  }
}

TEST(UsualPlaces, WhoVisitsAPatientHasRoomForTheKnees) {
  for (const char* side : {"leftOf", "rightOf"}) {
    const Layout layout = solved_as_asked(SceneMaker(4500, 4000)
                                              .add("hospital_bed")
                                              .add("conference_chair")
                                              .add("iv_stand")
                                              .relate(side, {"conference_chair_1"}, {"hospital_bed_1"})
                                              .relate("nextTo", {"iv_stand_1"}, {"hospital_bed_1"})
                                              .make(true));
    const PlacedObject &chair = *layout.find_object("conference_chair_1"), &bed = *layout.find_object("hospital_bed_1");
    const TestPoint at = in_frame_of(chair, {bed.position[0], bed.position[1], 0});
    const bool across = static_cast<int>(std::lround(std::abs(chair.rotation_deg - bed.rotation_deg))) % 180 != 0;
    const double half_x = (across ? bed.size.depth : bed.size.width) / 2.0, half_y = (across ? bed.size.width : bed.size.depth) / 2.0;
    const bool before = at.y < 0 && std::abs(at.x) < half_x + chair.size.width / 2.0 - 10;
    if (before) {
      EXPECT_GE(-at.y - half_y - chair.size.depth / 2.0, 450) << side;
    }
  }
}

TEST(UsualPlaces, AScreenOnACounterLooksAtTheStoolBehindIt) {
  const Layout layout = solved_as_asked(SceneMaker(5000, 4000)
                                            .add("shop_counter")
                                            .add("laptop")
                                            .add("bar_stool")
                                            .relate("on", {"laptop_1"}, {"shop_counter_1"})
                                            .relate("behind", {"bar_stool_1"}, {"shop_counter_1"})
                                            .make(true));
  const PlacedObject &laptop = *layout.find_object("laptop_1"), &stool = *layout.find_object("bar_stool_1");
  EXPECT_LT(in_frame_of(laptop, {stool.position[0], stool.position[1], 0}).y, 0);
}

TEST(UsualPlaces, WhoLookIntoOneMirrorSitSideBySideBeforeIt) {
  SceneMaker maker(5000, 4000);
  maker.add("salon_chair", 3).add("mirror");
  for (int i = 1; i <= 3; ++i) maker.relate("facing", {"salon_chair_" + std::to_string(i)}, {"mirror_1"});
  const Layout layout = solved_as_asked(maker.make(true));
  const PlacedObject& mirror = *layout.find_object("mirror_1");
  EXPECT_GE(mirror.size.width, 2400);
  std::vector<double> before;
  for (int i = 1; i <= 3; ++i) {
    const PlacedObject& chair = *layout.find_object("salon_chair_" + std::to_string(i));
    before.push_back(in_frame_of(mirror, {chair.position[0], chair.position[1], 0}).y);
  }
  EXPECT_NEAR(before[0], before[1], 60);
  EXPECT_NEAR(before[1], before[2], 60);
}

TEST(UsualPlaces, ATillOnACounterIsForWhoServes) {
  const Layout layout = solved_as_asked(
      SceneMaker(5000, 4000).add("shop_counter").add("cash_register").relate("on", {"cash_register_1"}, {"shop_counter_1"}).make(true));
  const PlacedObject &counter = *layout.find_object("shop_counter_1"), &till = *layout.find_object("cash_register_1");
  EXPECT_EQ(std::abs(std::lround(till.rotation_deg - counter.rotation_deg)) % 360, 180) << "the till is for who serves";
}

TEST(UsualPlaces, EachLooksIntoItsOwnMirrorFromTheSameDistance) {
  SceneMaker maker(5000, 4000);
  maker.add("salon_chair", 3).add("mirror", 3).add("wall_shelf", 3);
  for (int i = 1; i <= 3; ++i) {
    const std::string mirror = "mirror_" + std::to_string(i);
    maker.relate("facing", {"salon_chair_" + std::to_string(i)}, {mirror}).relate("under", {"wall_shelf_" + std::to_string(i)}, {mirror});
  }
  const Layout layout = solved_as_asked(maker.make(true));
  for (int i = 1; i <= 3; ++i) {
    const PlacedObject &chair = *layout.find_object("salon_chair_" + std::to_string(i)),
                       &mirror = *layout.find_object("mirror_" + std::to_string(i));
    const TestPoint at = in_frame_of(mirror, {chair.position[0], chair.position[1], 0});
    EXPECT_NEAR(at.x, 0, 60) << i;
    EXPECT_NEAR(-at.y, 650 + chair.size.depth / 2.0, 150) << i;
  }
}

TEST(UsualPlaces, AShelfBelowAMirrorHangsCloseBelowIt) {
  for (const char* above : {"mirror", "painting"}) {
    const std::string over = std::string(above) + "_1";
    const Layout layout = solved_as_asked(SceneMaker(4000, 3500)
                                              .add("salon_chair")
                                              .add(above)
                                              .add("wall_shelf")
                                              .relate("facing", {"salon_chair_1"}, {over})
                                              .relate("under", {"wall_shelf_1"}, {over})
                                              .make(true));
    const PlacedObject &high = *layout.find_object(over), &shelf = *layout.find_object("wall_shelf_1");
    EXPECT_NEAR(high.position[2] - shelf.position[2] - shelf.size.height, 60, 60) << above;
    EXPECT_NEAR(high.position[2], above == std::string("mirror") ? 1150 : 1300, 100) << "where it hangs without the shelf";
  }
}

}  // namespace
}  // namespace layoutbox::placement
