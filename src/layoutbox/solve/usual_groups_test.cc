// What belongs together or comes in numbers stands as people would put it.
#include <gtest/gtest.h>

#include <cmath>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

TEST(UsualGroups, SeatsWithATableBetweenThemDrawUpToIt) {
  const Layout layout = solved_as_asked(SceneMaker(6000, 5000)
                                            .add("armchair", 2)
                                            .add("game_table")
                                            .relate("facing", {"armchair_1"}, {"armchair_2"})
                                            .relate("facing", {"armchair_2"}, {"armchair_1"})
                                            .relate("between", {"game_table_1"}, {"armchair_1", "armchair_2"})
                                            .make(true));
  EXPECT_LE(between_middles(layout, "armchair_1", "armchair_2"), 3200);  // 2600 to 3200, by the seed
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
  EXPECT_LT(between_middles(layout, "stage_1", "statue_1"), 60);
}

TEST(UsualGroups, WhatHangsOverACribHangsOverItsMiddle) {
  const Layout layout = solved_as_asked(SceneMaker(4000, 3500)
                                            .add("crib")
                                            .add("baby_mobile")
                                            .relate("corner", {"crib_1"})
                                            .relate("onCeiling", {"baby_mobile_1"})
                                            .relate("above", {"baby_mobile_1"}, {"crib_1"})
                                            .make(true));
  EXPECT_LT(between_middles(layout, "crib_1", "baby_mobile_1"), 60);
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

// From the edge of one to the nearer edge of the other, both turned by quarters.
double between_edges(const Layout& layout, const std::string& a, const std::string& b) {
  double off[2];
  for (const int axis : {0, 1}) {
    double reach = 0;
    for (const PlacedObject* o : {layout.find_object(a), layout.find_object(b)}) {
      const bool aside = std::lround(o->rotation_deg) % 180 != 0;
      reach += ((axis == 0) != aside ? o->size.width : o->size.depth) / 2.0;
    }
    off[axis] = std::max(0.0, std::abs(layout.find_object(a)->position[axis] - layout.find_object(b)->position[axis]) - reach);
  }
  return std::hypot(off[0], off[1]);
}

TEST(UsualGroups, ABedForOneStandsInACorner) {
  const Layout layout = solved_as_asked(SceneMaker(4200, 3600).add("single_bed").add("wardrobe").make(true));
  const PlacedObject& bed = *layout.find_object("single_bed_1");
  const double across = std::abs(std::sin(bed.rotation_deg * kPi / 180)) > 0.5 ? bed.position[1] : bed.position[0];
  const double wide = across == bed.position[1] ? 3600 : 4200;
  EXPECT_LT(std::min(across, wide - across) - bed.size.width / 2.0, 60);
}

TEST(UsualGroups, ABedInACornerIsGotIntoFromItsOtherSide) {
  for (const char* wall : {"wall1", "wall2", "wall3", "wall4"}) {
    const Layout layout = solved_as_asked(
        SceneMaker(3600, 3200).add("single_bed").add("floor_lamp").add("bookshelf").relate("corner", {"single_bed_1"}, {wall}).make(true));
    for (const char* other : {"floor_lamp_1", "bookshelf_1"}) {
      const PlacedObject &bed = *layout.find_object("single_bed_1"), &thing = *layout.find_object(other);
      const TestPoint place = in_frame_of(bed, {thing.position[0], thing.position[1], 0});
      EXPECT_FALSE(std::abs(place.y) < 300 && std::abs(place.x) < bed.size.width / 2.0 + 500) << wall << " " << other;
    }
  }
}

TEST(UsualGroups, ChairsByTheFireDoNotPullTheTableFromItsSofa) {
  SceneMaker maker(5500, 4200);
  maker.add("sofa").add("fireplace").add("armchair", 2).add("coffee_table");
  maker.relate("facing", {"sofa_1"}, {"fireplace_1"}).relate("eachSideOf", {"armchair_1", "armchair_2"}, {"fireplace_1"});
  const Layout layout = solved_as_asked(maker.make(true));
  EXPECT_LT(between_edges(layout, "sofa_1", "coffee_table_1"), 700);
}

TEST(UsualGroups, ASofaAndItsTableInTheMiddleStandTogether) {
  const Layout layout = solved_as_asked(
      SceneMaker(5500, 4600).add("sofa").add("coffee_table").relate("centerOfRoom", {"sofa_1", "coffee_table_1"}).make(true));
  EXPECT_LT(between_edges(layout, "sofa_1", "coffee_table_1"), 700);
}

TEST(UsualGroups, AnIslandStandsAlongTheRun) {
  const Layout layout =
      solved_as_asked(SceneMaker(5200, 4400).add("fridge").add("stove").add("kitchen_sink").add("kitchen_island").make(true));
  EXPECT_LT(turned(layout, "stove_1", "kitchen_island_1"), 1);
}

TEST(UsualGroups, AScreenHangsAtTheEndOfALongTableWithNothingBeforeIt) {
  SceneMaker maker(7000, 4600);
  maker.add("conference_table").add("conference_chair", 8).add("projector_screen").mounted(Mount::kWall).add("sideboard");
  std::vector<std::string> seats;
  for (int i = 1; i <= 8; ++i) seats.push_back("conference_chair_" + std::to_string(i));
  const Layout layout = solved_as_asked(maker.relate("around", seats, {"conference_table_1"}).make(true));
  const PlacedObject& screen = *layout.find_object("projector_screen_1");
  const PlacedObject& table = *layout.find_object("conference_table_1");
  const TestPoint seen = in_frame_of(table, {screen.position[0], screen.position[1], 0});
  EXPECT_LT(std::abs(table.size.width > table.size.depth ? seen.y : seen.x), 400);
  EXPECT_GT(between_edges(layout, "projector_screen_1", "sideboard_1"), 0);
}

TEST(UsualGroups, AScreenDoesNotHangOverTheBed) {
  const Layout layout = solved_as_asked(
      SceneMaker(6000, 5000).add("bed").add("sofa").add("tv").mounted(Mount::kWall).relate("facing", {"sofa_1"}, {"tv_1"}).make(true));
  const PlacedObject &bed = *layout.find_object("bed_1"), &tv = *layout.find_object("tv_1");
  const TestPoint seen = in_frame_of(bed, {tv.position[0], tv.position[1], 0});
  EXPECT_FALSE(std::abs(seen.x) < bed.size.width / 2.0 && seen.y > 0);
}

TEST(UsualGroups, ALaptopLooksAtWhoSitsBeforeIt) {
  const Layout layout = solved_as_asked(SceneMaker(4200, 3600)
                                            .add("table")
                                            .add("laptop")
                                            .add("office_chair")
                                            .relate("on", {"laptop_1"}, {"table_1"})
                                            .relate("facing", {"office_chair_1"}, {"table_1"})
                                            .make(true));
  EXPECT_NEAR(turned(layout, "laptop_1", "office_chair_1"), 180, 1);
}

TEST(UsualGroups, AWholeGroupMovesToTheMiddleOfItsWall) {
  SceneMaker maker(5400, 4200);
  maker.add("sofa").add("coffee_table").add("armchair", 2).add("tv_stand").add("tv").add("rug");
  const Layout layout = solved_as_asked(maker.relate("on", {"tv_1"}, {"tv_stand_1"}).make(true));
  const PlacedObject& sofa = *layout.find_object("sofa_1");
  const bool aside = std::lround(sofa.rotation_deg) % 180 != 0;
  EXPECT_NEAR(sofa.position[aside ? 1 : 0], aside ? 2100 : 2700, 450);
}

TEST(UsualGroups, AnAltarIsInTheMiddleOfItsWall) {
  const Layout layout = solved_as_asked(SceneMaker(8000, 6000)
                                            .add("altar")
                                            .add("kneeler", 2)
                                            .relate("againstWall", {"altar_1"}, {"wall3"})
                                            .relate("inFrontOf", {"kneeler_1"}, {"altar_1"})
                                            .relate("inFrontOf", {"kneeler_2"}, {"altar_1"})
                                            .make());
  EXPECT_NEAR(layout.find_object("altar_1")->position[0], 4000, 400);
}

TEST(UsualGroups, WhatCarriesTheTelevisionStandsAtAWall) {
  const Layout layout = solved_as_asked(SceneMaker(5500, 4500)
                                            .opening(OpeningType::kWindow, "wall1", 2150, 1200, 900, 1200)
                                            .add("sofa")
                                            .add("tv")
                                            .add("furniture")
                                            .relate("underWindow", {"sofa_1"})
                                            .relate("opposite", {"tv_1"}, {"sofa_1"})
                                            .relate("on", {"tv_1"}, {"furniture_1"})
                                            .make());
  const PlacedObject& unit = *layout.find_object("furniture_1");
  const double angle = unit.rotation_deg * kPi / 180;
  const double x = unit.position[0] - std::sin(angle) * unit.size.depth / 2, y = unit.position[1] + std::cos(angle) * unit.size.depth / 2;
  EXPECT_LT(std::min({x, 5500 - x, y, 4500 - y}), 60);
}

}  // namespace
}  // namespace layoutbox::placement
