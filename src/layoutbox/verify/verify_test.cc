#include "layoutbox/verify/verify.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "layoutbox/verify/test_room.h"

namespace layoutbox::checks {
namespace {

using testing::HasSubstr;

// ---- collisions

TestRoom two_boxes(double apart, double rotation = 0) {
  return TestRoom()
      .add("a", "wardrobe", {1.0, 0.6, 2.0}, {1.0, 1.0})
      .add("b", "wardrobe", {1.0, 0.6, 2.0}, {2.0 + apart, 1.0, 0, rotation});
}

TEST(Collision, TouchingAndFiveMillimetresAreNone) {
  EXPECT_TRUE(passes(two_boxes(0).judge(), "collision"));
  EXPECT_TRUE(passes(two_boxes(-0.005).judge(), "collision"));
  const Report report = two_boxes(-0.006).judge();
  EXPECT_FALSE(report.passed);
  EXPECT_EQ(report.metrics.at("collisions"), 2);
  EXPECT_THAT(find_check(report, "collision")->message, HasSubstr("a and b overlap by 0.006 m"));
}

TEST(Collision, AnyRotation) {
  // Turned by 45°, b's nearest corner is (0.5 + 0.3)·cos 45° = 0.566 m from its centre.
  EXPECT_TRUE(passes(two_boxes(0.07, 45).judge(), "collision"));
  EXPECT_FALSE(passes(two_boxes(0.05, 45).judge(), "collision"));
}

TEST(Collision, ABoxInsideAnotherCollides) {
  TestRoom room;
  room.add("big", "wardrobe", {2, 2, 2}, {2, 2}).add("small", "box", {0.2, 0.2, 0.2}, {2, 2, 1});
  EXPECT_FALSE(passes(room.judge(), "collision"));
}

TEST(Collision, BodiesAtOtherHeightsDoNot) {
  TestRoom room;
  room.add("desk", "desk", {1.2, 0.6, 0.75}, {1, 1}).add("shelf", "shelf", {1.0, 0.3, 0.3}, {1, 1, 1.2}, "wall3");
  EXPECT_TRUE(passes(room.judge(), "collision"));
}

TEST(Collision, RugsUpToThirtyMillimetresAreWalkedOn) {
  const auto table_on_rug = [](double height) {
    return TestRoom().add("rug", "rug", {2, 1.4, height}, {2, 2}).add("table", "coffee_table", {1, 0.6, 0.4}, {2, 2});
  };
  EXPECT_TRUE(passes(table_on_rug(0.03).judge(), "collision"));
  EXPECT_FALSE(passes(table_on_rug(0.04).judge(), "collision"));
}

TestRoom chair_at_desk(double chair_y, bool with_knees, double chair_height = 0.6) {
  TestRoom room;
  room.add("desk", "desk", {1.2, 0.6, 0.75}, {2, 3});
  if (with_knees) room.space("knees", {-0.55, -0.3, 0}, {0.55, 0.25, 0.68}, false);
  room.add("chair", "chair", {0.5, 0.5, chair_height}, {2, chair_y, 0, 180});
  return room;
}

TEST(Collision, SpacesAreExact) {
  EXPECT_TRUE(passes(chair_at_desk(2.7, true).judge(), "collision"));
  EXPECT_FALSE(passes(chair_at_desk(2.7, false).judge(), "collision"));
  EXPECT_FALSE(passes(chair_at_desk(2.7, true, 0.7).judge(), "collision")) << "the chair's back reaches into the desk's top";
  EXPECT_TRUE(passes(chair_at_desk(3.0, true).judge(), "collision"));
  EXPECT_FALSE(passes(chair_at_desk(3.02, true).judge(), "collision")) << "0.02 m into the desk's back";
}

TEST(Collision, TwoSpacesCoverTogetherWhatNoneCoversAlone) {
  TestRoom room;
  room.add("shelf", "bookshelf", {1.0, 0.3, 1.0}, {2, 3});
  room.space("left", {-0.5, -0.15, 0.5}, {0, 0.15, 1.0}).space("right", {0, -0.15, 0.5}, {0.5, 0.15, 1.0});
  room.add("box", "box", {0.4, 0.2, 0.2}, {2, 3, 0.5}, "shelf");
  EXPECT_TRUE(passes(room.judge(), "collision"));
  room.object("shelf").spaces.pop_back();
  EXPECT_FALSE(passes(room.judge(), "collision"));
}

// ---- bounds

TEST(Bounds, OnePercentOfTheFootprintMayBeOutside) {
  const auto at = [](double x) { return TestRoom().add("a", "wardrobe", {1.0, 0.6, 2.0}, {x, 2}); };
  EXPECT_TRUE(passes(at(0.5).judge(), "outOfBounds"));
  EXPECT_TRUE(passes(at(0.49).judge(), "outOfBounds"));
  const Report report = at(0.485).judge();
  EXPECT_FALSE(passes(report, "outOfBounds"));
  EXPECT_NEAR(find_check(report, "outOfBounds")->value, 0.015, 1e-9);
  EXPECT_FALSE(report.passed);
}

TEST(Bounds, NotchesOfTheFloorAreOutside) {
  TestRoom room(4, 4);
  room.layout.room.polygon = {{0, 0}, {4000, 0}, {4000, 2000}, {2000, 2000}, {2000, 4000}, {0, 4000}};
  room.add("a", "wardrobe", {1.0, 0.6, 2.0}, {2.4, 2.4}).add("b", "wardrobe", {1.0, 0.6, 2.0}, {1.0, 3.0});
  const Report report = room.judge();
  EXPECT_NEAR(find_check(report, "outOfBounds", "a")->value, 0.9, 1e-9);
  EXPECT_FALSE(passes(report, "outOfBounds", "a"));
  EXPECT_TRUE(passes(report, "outOfBounds", "b"));
}

TEST(Bounds, TheCeilingIsTenMillimetresAway) {
  const auto tall = [](double height) { return TestRoom(5, 4, 2.0).add("a", "wardrobe", {1.0, 0.6, height}, {2, 2}); };
  EXPECT_TRUE(passes(tall(2.01).judge(), "outOfBounds"));
  EXPECT_FALSE(passes(tall(2.012).judge(), "outOfBounds"));
}

// ---- support

TEST(Support, FloorWithinFiveMillimetres) {
  const auto at = [](double z) { return TestRoom().add("a", "wardrobe", {1, 0.6, 2}, {2, 2, z}); };
  EXPECT_TRUE(passes(at(0.005).judge(), "support"));
  EXPECT_FALSE(passes(at(0.006).judge(), "support"));
  EXPECT_FALSE(passes(at(-0.006).judge(), "support"));
}

TEST(Support, OnAnObject) {
  const auto lamp = [](double x, double z) {
    return TestRoom().add("desk", "desk", {1.2, 0.6, 0.75}, {2, 2}).add("lamp", "table_lamp", {0.2, 0.2, 0.4}, {x, 2, z}, "desk");
  };
  EXPECT_TRUE(passes(lamp(2.0, 0.75).judge(), "support", "lamp"));
  EXPECT_TRUE(passes(lamp(2.6, 0.755).judge(), "support", "lamp")) << "the centre is just over the edge";
  EXPECT_FALSE(passes(lamp(2.601, 0.75).judge(), "support", "lamp"));
  EXPECT_FALSE(passes(lamp(2.0, 0.756).judge(), "support", "lamp"));
}

TEST(Support, OnTheFloorOfASpaceThatCarries) {
  const auto book = [](double z, bool carries) {
    TestRoom room;
    room.add("shelf", "bookshelf", {1.0, 0.3, 1.8}, {2, 3}).space("shelf2", {-0.48, -0.15, 0.4}, {0.48, 0.14, 0.75}, carries);
    return room.add("book", "book", {0.2, 0.15, 0.25}, {2, 3, z}, "shelf");
  };
  EXPECT_TRUE(passes(book(0.405, true).judge(), "support", "book"));
  EXPECT_FALSE(passes(book(0.41, true).judge(), "support", "book"));
  EXPECT_FALSE(passes(book(0.4, false).judge(), "support", "book"));
}

TEST(Support, WallCeilingSillAndHung) {
  TestRoom room;
  room.window("window1", "wall3", 2);  // x from 3.0 to 1.8 at y = 4, sill 0.9
  room.add("picture", "painting", {0.8, 0.03, 0.6}, {4.2, 3.975, 1.4}, "wall3");
  room.add("lamp", "pendant_lamp", {0.4, 0.4, 0.6}, {2, 2, 2.0}, "ceiling");
  room.add("pot", "plant", {0.2, 0.2, 0.3}, {2.4, 3.9, 0.9}, "window1");
  room.add("rack", "coat_rack", {0.4, 0.4, 1.8}, {0.5, 3.0}).add("coat", "coat", {0.3, 0.1, 1.0}, {0.85, 3.0, 0.6, 90}, "rack");
  room.object("coat").mount = Mount::kHung;
  EXPECT_FALSE(passes(room.judge(), "support", "coat"));
  room.object("coat").position[0] = 750;
  for (const char* id : {"picture", "lamp", "pot", "coat"}) EXPECT_TRUE(passes(room.judge(), "support", id)) << id;
  room.object("picture").position[1] = 3974;
  room.object("lamp").position[2] = 1989;
  room.object("pot").position[1] = 3799;
  for (const char* id : {"picture", "lamp", "pot"}) EXPECT_FALSE(passes(room.judge(), "support", id)) << id;
}

TEST(Support, CirclesAndStrangersAreFaults) {
  TestRoom room;
  room.add("a", "box", {0.4, 0.4, 0.4}, {1, 1, 0.4}, "b").add("b", "box", {0.4, 0.4, 0.4}, {1, 1, 0.0}, "a");
  room.add("c", "box", {0.4, 0.4, 0.4}, {3, 1, 0.4}, "nobody").add("d", "box", {0.4, 0.4, 0.4}, {2, 1, 0.4}, "d");
  const Report report = room.judge();
  for (const char* id : {"a", "b", "c", "d"}) EXPECT_FALSE(passes(report, "support", id)) << id;
  EXPECT_THAT(find_check(report, "support", "c")->message, HasSubstr("nobody"));
  EXPECT_EQ(report.metrics.at("support"), 0);
}

// ---- relations as the layout claims them

TestRoom claimed(double gap, bool hard) {
  RelationParameters near;
  near.max = 500;
  return TestRoom()
      .add("a", "bed", {1, 1, 1}, {1, 1})
      .add("b", "bed", {1, 1, 1}, {2 + gap, 1})
      .relation(RelationType::kNextTo, {"b"}, {"a"}, near, hard);
}

TEST(Claims, FiguresInWords) {
  EXPECT_THAT(find_check(claimed(0.62, true).judge(), "relation")->message,
              HasSubstr("0.62 m, at most 0.50 m (the layout says that it holds)"));
  EXPECT_THAT(find_check(claimed(0.3, true).judge(), "relation")->message,
              HasSubstr("nextTo holds: distance between b and a 0.30 m, at most 0.50 m"));
}

TEST(Claims, HardFailsSoftWarnsRelaxedIsListed) {
  EXPECT_FALSE(claimed(0.62, true).judge().passed);
  EXPECT_TRUE(claimed(0.62, false).judge().passed);
  TestRoom room = claimed(0.62, true);
  room.layout.relaxed.push_back({"c1", 0.12, "m", "no room"});
  const Report report = room.judge();
  EXPECT_TRUE(report.passed);
  EXPECT_FALSE(passes(report, "relation"));
  EXPECT_THAT(find_check(report, "relation")->message, HasSubstr("given up"));
  EXPECT_EQ(report.metrics.at("relationsHeld"), 0);
}

TEST(Claims, WhatIsNotThereIsReported) {
  TestRoom room;
  room.add("a", "bed", {1, 1, 1}, {1, 1})
      .relation(RelationType::kNextTo, {"a"}, {"ghost"})
      .relation(RelationType::kNextTo, {"nobody"}, {"a"});
  room.relation(RelationType::kNextTo, {"a"}, {}).relation(RelationType::kNextTo, {}, {"a"});
  const Report report = room.judge();
  for (const char* id : {"c1", "c2", "c3", "c4"}) EXPECT_FALSE(passes(report, "relation", id)) << id;
  EXPECT_THAT(find_check(report, "relation", "c1")->message, HasSubstr("ghost"));
}

// ---- absurd layouts

TEST(Absurd, NeverCrashes) {
  TestRoom room;
  room.door("door1", "wall9", 0).door("door2", "wall1", -4000, 100000);
  room.add("flat", "bed", {0, 0, 0}, {1, 1})
      .add("huge", "bed", {2e6, 2e6, 2e6}, {-1e6, 1e300, -1e300, 1e300})
      .used({Side::kFront, Side::kLeft});
  room.add("nan", "bed", {1, 1, 1}, {std::numeric_limits<double>::quiet_NaN(), 0, 0, std::numeric_limits<double>::quiet_NaN()});
  room.space("inside out", {1, 1, 1}, {-1e12, -1, 0});
  for (const RelationRow& row : relation_table()) {
    for (const char* reference : {"flat", "huge", "nan", "door2", "wall2", "room", "floor"}) {
      room.relation(row.type, {"flat", "huge", "nan"}, {reference});
    }
    room.relation(row.type, {"huge"});
  }
  EXPECT_FALSE(room.judge().passed);
  room.layout.room.polygon.clear();
  EXPECT_FALSE(room.judge().passed);
  room.layout.room.walls.clear();
  EXPECT_FALSE(room.judge().passed);
  EXPECT_FALSE(verify(Layout{}, Catalog::builtin()).checks.empty());
}

TEST(WriteReport, SameValueSameBytes) {
  TestRoom room = claimed(0.62, true);
  room.layout.objects[0].id = "a\xff";
  const std::string text = write_report(room.judge());
  EXPECT_EQ(text, write_report(room.judge()));
  EXPECT_THAT(text, HasSubstr("\"format\": \"layoutbox/report@1\""));
  EXPECT_THAT(text, HasSubstr("\"collisions\": 0.0"));
}

}  // namespace
}  // namespace layoutbox::checks
