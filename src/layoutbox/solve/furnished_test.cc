// Rooms of many kinds in which words say little of where things stand: what a person would not have done.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

std::string numbered(const std::string& kind, int i) { return kind + "_" + std::to_string(i); }

// From the nearest wall of a room that begins at the origin to the edge of what is about as deep as wide.
double off_walls(const PlacedObject& thing, Mm width, Mm depth) {
  const double x = thing.position[0], y = thing.position[1];
  return std::min({x, y, width - x, depth - y}) - std::min(thing.size.width, thing.size.depth) / 2.0;
}

TEST(Furnished, PlantsStandAtTheWallsHoweverManyTheyAre) {
  const Layout layout = solved_as_asked(SceneMaker(5000, 4000).add("plant", 6).add("sofa").add("coffee_table").make(true));
  for (int i = 1; i <= 6; ++i) EXPECT_LT(off_walls(object(layout, numbered("plant", i)), 5000, 4000), 300) << i;
}

TEST(Furnished, DesksOfAnOfficeStandInIslands) {
  const Layout layout = solved_as_asked(SceneMaker(9000, 7000).add("desk", 8).add("office_chair", 8).add("filing_cabinet", 2).make(true));
  for (int i = 1; i <= 8; ++i) {
    const PlacedObject& desk = object(layout, numbered("desk", i));
    bool backed = false;
    for (int j = 1; j <= 8; ++j) {
      const PlacedObject& other = object(layout, numbered("desk", j));
      const Point at = seen_from(desk, other);
      backed |= std::abs(at.x) < 60 && std::abs(at.y - desk.size.depth) < 60 &&
                std::lround(std::abs(other.rotation_deg - desk.rotation_deg)) == 180;
    }
    EXPECT_TRUE(backed) << "somebody sits across from desk " << i;
  }
}

TEST(Furnished, AFewSeatsThatLookAtSomethingSitInOneRow) {
  SceneMaker maker = SceneMaker(6000, 5500).add("chair", 4).add("grand_piano");
  for (int i = 1; i <= 4; ++i) maker.relate("facing", {numbered("chair", i)}, {"grand_piano_1"});
  const Layout layout = solved_as_asked(maker.make(true));
  for (int i = 2; i <= 4; ++i)
    EXPECT_NEAR(seen_from(object(layout, "chair_1"), object(layout, numbered("chair", i))).y, 0, 100) << "not behind one another";
}

TEST(Furnished, WhoLeadsACrowdSitsAmongIt) {
  SceneMaker maker =
      SceneMaker(8000, 7000, 3000).add("chair", 15).add("projector_screen").relate("facing", {"chair_1"}, {"projector_screen_1"});
  for (int i = 2; i <= 15; ++i) maker.relate("sameOrientation", {numbered("chair", i)}, {"chair_1"});
  const Layout layout = solved_as_asked(maker.make(true));
  int abreast = 0;
  for (int i = 2; i <= 15; ++i) abreast += std::abs(seen_from(object(layout, "chair_1"), object(layout, numbered("chair", i))).y) < 60;
  EXPECT_GE(abreast, 3) << "in a row of the others, not before them";
}

TEST(Furnished, TheTeacherSitsBetweenTheBoardAndTheClassAndLooksAtIt) {
  const Layout layout = solved_as_asked(
      SceneMaker(9000, 7000, 3000).add("school_desk", 9).add("student_chair", 9).add("whiteboard").add("teacher_desk").make(true));
  const PlacedObject &board = object(layout, "whiteboard_1"), &teacher = object(layout, "teacher_desk_1");
  EXPECT_NEAR(board.rotation_deg, teacher.rotation_deg, 0.1);
  for (int i = 1; i <= 9; ++i) {
    const PlacedObject& desk = object(layout, numbered("school_desk", i));
    EXPECT_GT(-seen_from(board, desk).y, -seen_from(board, teacher).y) << i;
    EXPECT_EQ(std::lround(desk.rotation_deg - board.rotation_deg + 720) % 360, 180) << i;
  }
}

TEST(Furnished, ASofaIsNearEnoughToItsScreen) {
  const Layout layout = solved_as_asked(SceneMaker(7000, 5000)
                                            .add("coffee_table")
                                            .add("sofa")
                                            .add("tv")
                                            .mounted(Mount::kWall)
                                            .relate("facing", {"sofa_1"}, {"tv_1"})
                                            .make(true));
  const Point tv = seen_from(object(layout, "sofa_1"), object(layout, "tv_1"));
  EXPECT_LT(tv.y, 0);
  EXPECT_GT(tv.y, -5000);
}

TEST(Furnished, AScreenHangsWhereTheSofaLooks) {
  const Layout layout = solved_as_asked(
      SceneMaker(6000, 4500).add("bed").add("sofa").add("wardrobe").add("dining_table").add("tv").mounted(Mount::kWall).make(true));
  const Point tv = seen_from(object(layout, "sofa_1"), object(layout, "tv_1"));
  EXPECT_LT(tv.y, -1000);
  EXPECT_LT(std::abs(tv.x), -tv.y);
}

TEST(Furnished, AChestAtTheFootStandsBeforeTheMiddleOfItsBed) {
  const Layout layout = solved_as_asked(SceneMaker(5000, 4000)
                                            .add("double_bed")
                                            .add("nightstand", 2)
                                            .add("armchair")
                                            .add("dresser")
                                            .add("chest")
                                            .relate("atFootOf", {"chest_1"}, {"double_bed_1"})
                                            .make(true));
  EXPECT_NEAR(seen_from(object(layout, "double_bed_1"), object(layout, "chest_1")).x, 0, 100);
}

TEST(Furnished, WhatIsToldToBeInTheMiddleHasItForItself) {
  const Layout layout = solved_as_asked(SceneMaker(4200, 4200).add("easel").add("table").relate("centerOfRoom", {"easel_1"}).make(true));
  const PlacedObject &easel = object(layout, "easel_1"), &table = object(layout, "table_1");
  EXPECT_GT(std::hypot(easel.position[0] - table.position[0], easel.position[1] - table.position[1]), 1200);
}

TEST(Furnished, WhoLooksIntoAMirrorSitsBeforeIt) {
  for (const bool row : {false, true}) {
    SceneMaker maker = SceneMaker(5500, 4500).add("salon_chair", 3).add("mirror", 3).add("bench");
    for (int i = 1; i <= 3; ++i) {
      maker.relate("facing", {numbered("salon_chair", i)}, {numbered("mirror", i)});
      maker.relate("onWall", {numbered("mirror", i)}, {});
    }
    if (row) maker.relate("row", {"salon_chair_1", "salon_chair_2", "salon_chair_3"}, {});
    const Layout layout = solved_as_asked(maker.make(true));
    for (int i = 1; i <= 3; ++i) {
      const Point seat = seen_from(object(layout, numbered("mirror", i)), object(layout, numbered("salon_chair", i)));
      EXPECT_LT(std::abs(seat.x), 150) << i << row;
      EXPECT_GT(seat.y, -1500) << i << row;
    }
  }
}

TEST(Furnished, CupboardsOfAKitchenHangOverItsUnits) {
  const Layout layout =
      solved_as_asked(SceneMaker(4000, 3500).add("stove").add("kitchen_sink").add("dishwasher").add("wall_cabinet", 2).make(true));
  for (int i = 1; i <= 2; ++i) {
    double nearest = 1e9;
    for (const char* unit : {"stove_1", "kitchen_sink_1", "dishwasher_1"}) {
      const Point at = seen_from(object(layout, unit), object(layout, numbered("wall_cabinet", i)));
      nearest = std::min(nearest, std::hypot(at.x, at.y));
    }
    EXPECT_LT(nearest, 700) << i;
  }
}

TEST(Furnished, AWardsCurtainHangsAlongItsBed) {
  SceneMaker maker = SceneMaker(6000, 4500).add("hospital_bed", 2).add("privacy_curtain", 2);
  for (int i = 1; i <= 2; ++i) maker.relate("nextTo", {numbered("privacy_curtain", i)}, {numbered("hospital_bed", i)});
  const Layout layout = solved_as_asked(maker.make(true));
  for (int i = 1; i <= 2; ++i) {
    const PlacedObject &bed = object(layout, numbered("hospital_bed", i)), &curtain = object(layout, numbered("privacy_curtain", i));
    EXPECT_GT(std::abs(seen_from(bed, curtain).x), bed.size.width / 2) << i;
    EXPECT_EQ(std::lround(std::abs(curtain.rotation_deg - bed.rotation_deg)) % 180, 90) << i;
  }
}

TEST(Furnished, MatsThatOneKneelsOnLieSideBySide) {
  const Layout layout = solved_as_asked(SceneMaker(4500, 4000).add("prayer_rug", 6).add("shelf").make(true));
  for (int i = 1; i <= 6; ++i) {
    for (int j = 1; j < i; ++j) {
      const PlacedObject &a = object(layout, numbered("prayer_rug", i)), &b = object(layout, numbered("prayer_rug", j));
      EXPECT_GT(std::hypot(a.position[0] - b.position[0], a.position[1] - b.position[1]), 600) << i << " and " << j;
    }
  }
}

TEST(Furnished, LampsShareTheLengthOfTheirTable) {
  for (const bool told : {false, true}) {
    SceneMaker maker(5000, 4000);
    maker.add("dining_table").sized(2000, 900, 750).add("pendant_lamp", 2);
    if (told) {
      for (const char* lamp : {"pendant_lamp_1", "pendant_lamp_2"}) maker.relate("above", {lamp}, {"dining_table_1"});
    }
    const Layout layout = solved_as_asked(maker.make(true));
    const PlacedObject& table = object(layout, "dining_table_1");
    const Point one = seen_from(table, object(layout, "pendant_lamp_1")), two = seen_from(table, object(layout, "pendant_lamp_2"));
    EXPECT_NEAR(std::abs(one.x - two.x), 1000, 100) << told;
    EXPECT_NEAR(one.y, 0, 60) << told;
  }
}

TEST(Furnished, WhatHangsAndIsNoLampKeepsOffTheDesks) {
  const Layout layout = solved_as_asked(SceneMaker(4500, 4000).add("workbench").add("hanging_plant", 2).make(true));
  const PlacedObject& bench = object(layout, "workbench_1");
  for (const char* id : {"hanging_plant_1", "hanging_plant_2"}) EXPECT_LT(seen_from(bench, object(layout, id)).y, -600) << id;
}

TEST(Furnished, TablesAlongAWindowStandInLine) {
  SceneMaker maker(9000, 7000);
  maker.opening(OpeningType::kWindow, "wall3", 1800, 5400, 900, 1200).add("table", 3).sized(800, 700, 750).add("chair", 6);
  for (int i = 1; i <= 3; ++i) {
    maker.relate("underWindow", {numbered("table", i)});
    maker.relate("around", {numbered("chair", 2 * i - 1), numbered("chair", 2 * i)}, {numbered("table", i)});
  }
  const Layout layout = solved_as_asked(maker.make(true));
  for (int i = 2; i <= 3; ++i)
    EXPECT_NEAR(object(layout, numbered("table", i)).position[1], object(layout, "table_1").position[1], 40) << i;
}

TEST(Furnished, TwoBenchesOfWhichTheSameIsSaidLieParallel) {
  const Layout layout = solved_as_asked(SceneMaker(6000, 5000)
                                            .add("rug")
                                            .sized(2600, 2000, 12)
                                            .add("bench", 2)
                                            .relate("on", {"bench_1"}, {"rug_1"})
                                            .relate("on", {"bench_2"}, {"rug_1"})
                                            .make(true));
  EXPECT_EQ(std::lround(std::abs(object(layout, "bench_1").rotation_deg - object(layout, "bench_2").rotation_deg)) % 180, 0);
}

TEST(Furnished, ThoseBehindATableSitAbreast) {
  SceneMaker maker = SceneMaker(7000, 6000).add("table").sized(2400, 800, 750).add("chair", 4);
  for (int i = 1; i <= 4; ++i) maker.relate("behind", {numbered("chair", i)}, {"table_1"});
  const Layout layout = solved_as_asked(maker.make(true));
  for (int i = 2; i <= 4; ++i) EXPECT_NEAR(seen_from(object(layout, "chair_1"), object(layout, numbered("chair", i))).y, 0, 100) << i;
}

TEST(Furnished, BehindACounterOfAShopIsRoomToServe) {
  const Layout layout = solved_as_asked(SceneMaker(5500, 4500).add("shop_counter").add("display_table", 2).add("shelf", 3).make(true));
  const PlacedObject& counter = object(layout, "shop_counter_1");
  const double a = counter.rotation_deg * 3.14159265358979 / 180, reach = counter.size.depth / 2 + 650;
  const double x = counter.position[0] - std::sin(a) * reach, y = counter.position[1] + std::cos(a) * reach;
  EXPECT_TRUE(x > 0 && x < 5500 && y > 0 && y < 4500);
}

TEST(Furnished, ThingsAreNotHeapedInOneHalfOfALargeRoom) {
  const Layout layout = solved_as_asked(SceneMaker(9000, 6500)
                                            .add("bookshelf")
                                            .add("piano")
                                            .add("sofa")
                                            .add("coffee_table")
                                            .add("dining_table")
                                            .add("dining_chair", 4)
                                            .add("sideboard")
                                            .add("wardrobe")
                                            .make(true));
  double x = 0, y = 0, all = 0;
  for (const PlacedObject& thing : layout.objects) {
    const double area = double(thing.size.width) * thing.size.depth;
    x += area * thing.position[0], y += area * thing.position[1], all += area;
  }
  EXPECT_NEAR(x / all, 4500, 900);
  EXPECT_NEAR(y / all, 3250, 900);
}

RelationParameters at_part(const std::string& part) {
  RelationParameters parameters;
  parameters.part = ThingPart(part);
  return parameters;
}

// The desk waits for nothing that stands on it: else all of it is taken up again with each thing that finds no place.
TEST(Furnished, AFullDeskIsFoundWithoutAProof) {
  const SceneGraph scene = SceneMaker(3400, 3000)
                               .add("desk")
                               .sized(950, 500, 750)
                               .add("monitor")
                               .add("keyboard")
                               .add("mouse")
                               .add("desk_lamp")
                               .add("office_chair")
                               .add("rug")
                               .relate("on", {"monitor_1"}, {"desk_1"})
                               .relate("on", {"keyboard_1"}, {"desk_1"})
                               .relate("on", {"mouse_1"}, {"desk_1"})
                               .relate("on", {"desk_lamp_1"}, {"desk_1"}, at_part("right"))
                               .relate("inFrontOf", {"office_chair_1"}, {"desk_1"})
                               .relate("facing", {"office_chair_1"}, {"desk_1"})
                               .relate("centerOfRoom", {"rug_1"})
                               .make();
  SolveOptions options;
  options.prove = false, options.effort = 1;
  for (options.seed = 1; options.seed <= 8; ++options.seed) {
    const auto layout = solve(scene, Catalog::builtin(), options);
    ASSERT_TRUE(layout);
    EXPECT_TRUE(layout->relaxed.empty()) << "seed " << options.seed << ": " << layout->relaxed.front().relation;
  }
}

TEST(Furnished, AtTheEndOfACounterIsAtOneOfItsEnds) {
  const SceneGraph scene =
      SceneMaker(4000, 3000).add("counter").add("coffee_machine").relate("on", {"coffee_machine_1"}, {"counter_1"}, at_part("end")).make();
  const auto layout = solve(scene, Catalog::builtin());
  ASSERT_TRUE(layout);
  EXPECT_TRUE(layout->relaxed.empty());
}

}  // namespace
}  // namespace layoutbox::placement
