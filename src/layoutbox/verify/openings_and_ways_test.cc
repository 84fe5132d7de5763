// Doors and windows that stay free, and ways from the door to what is used.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "layoutbox/verify/test_room.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox::checks {
namespace {

using testing::HasSubstr;

// A door in the front wall from x = 1.0 to x = 1.9 and a box of 0.2 m with its centre at (x, y).
Report door_and_box(Swing swing, double x, double y, double z = 0) {
  TestRoom room;
  room.door("door1", "wall1", 1.0, 0.9, swing).add("box", "box", {0.2, 0.2, 0.2}, {x, y, z});
  return room.judge();
}

TEST(DoorSwing, TheQuarterDiscAboutTheHinge) {
  // In-left: looking at the front wall from the room, left is the door's end at x = 1.9. The far corner (1.0, 0.9) is outside the disc.
  EXPECT_FALSE(passes(door_and_box(Swing::kInLeft, 1.8, 0.7), "doorSwing"));
  EXPECT_TRUE(passes(door_and_box(Swing::kInLeft, 1.1, 0.7), "doorSwing"));
  EXPECT_FALSE(passes(door_and_box(Swing::kInRight, 1.1, 0.7), "doorSwing"));
  EXPECT_TRUE(passes(door_and_box(Swing::kInRight, 1.8, 0.7), "doorSwing"));
  EXPECT_TRUE(passes(door_and_box(Swing::kInLeft, 1.8, 1.0), "doorSwing")) << "touches the disc";
  EXPECT_FALSE(passes(door_and_box(Swing::kInLeft, 1.8, 0.99), "doorSwing"));
  EXPECT_TRUE(passes(door_and_box(Swing::kInLeft, 1.8, 0.5, 2.0), "doorSwing")) << "above the door";
  EXPECT_TRUE(passes(door_and_box(Swing::kInLeft, 2.0, 0.5), "doorSwing")) << "beside the door";
  EXPECT_TRUE(passes(door_and_box(Swing::kOutLeft, 1.5, 0.5), "doorSwing"));
}

TEST(DoorSwing, FailsTheReportUnlessGivenUp) {
  TestRoom room;
  room.door("door1", "wall1", 1.0).add("box", "box", {0.2, 0.2, 0.2}, {1.8, 0.5});
  EXPECT_FALSE(room.judge().passed);
  room.layout.relaxed.push_back({"door swing of door1", 0.5, "m", ""});
  EXPECT_TRUE(room.judge().passed);
  EXPECT_FALSE(passes(room.judge(), "doorSwing"));
}

TEST(DoorSwing, TurnedAndMirroredRoomsAgree) {
  for (const double y : {0.85, 0.98, 0.995, 1.01}) {
    TestRoom room;
    room.door("door1", "wall1", 1.0).add("box", "box", {0.2, 0.2, 0.2}, {1.8, y});
    Layout layout = room.layout;
    const bool expected = passes(room.judge(), "doorSwing");
    for (int turn = 0; turn < 4; ++turn) {
      layout = quarter_turned(layout);
      EXPECT_EQ(passes(verify(layout, Catalog::builtin()), "doorSwing"), expected) << "turned " << turn + 1 << " y " << y;
      EXPECT_EQ(passes(verify(mirrored(layout), Catalog::builtin()), "doorSwing"), expected) << "mirrored " << turn + 1 << " y " << y;
    }
  }
}

TEST(OpeningClearance, DoorsAsDeepAsWideWindowsHalfAMetreAboveTheSill) {
  const auto box_at = [](double x, double y, double height) {
    TestRoom room;
    room.door("door1", "wall1", 1.0, 0.9, Swing::kOutLeft).window("window1", "wall3", 2).add("box", "wardrobe", {0.4, 0.4, height}, {x, y});
    return room.judge();
  };
  EXPECT_TRUE(passes(box_at(1.4, 1.1, 1), "openingClearance", "door1"));
  EXPECT_FALSE(passes(box_at(1.4, 1.09, 1), "openingClearance", "door1"));
  EXPECT_TRUE(passes(box_at(2.4, 3.8, 0.9), "openingClearance", "window1"));
  EXPECT_FALSE(passes(box_at(2.4, 3.8, 1.0), "openingClearance", "window1"));
  EXPECT_TRUE(passes(box_at(2.4, 3.3, 1.0), "openingClearance", "window1"));
  EXPECT_TRUE(box_at(2.4, 3.8, 1.0).passed) << "a warning, not a failure";
}

TEST(OpeningClearance, CurtainsAndRugsDoNotBlock) {
  TestRoom room;
  room.door("door1", "wall1", 1.0).window("window1", "wall3", 2);
  room.add("curtain", "curtain", {1.4, 0.1, 1.6}, {2.4, 3.95, 0.7}, "wall3").add("mat", "rug", {0.8, 0.5, 0.01}, {1.45, 0.5});
  EXPECT_EQ(room.judge().metrics.at("openingClearance"), 1);
}

TEST(Ways, AWallOfFurnitureSplitsTheFloor) {
  const auto with_gap = [](double gap) { return TestRoom(4, 4).add("a", "wardrobe", {4 - gap, 0.5, 2}, {(4 - gap) / 2, 2}); };
  EXPECT_EQ(with_gap(0.5).judge().metrics.at("navigability"), 1);
  EXPECT_NEAR(with_gap(0.1).judge().metrics.at("navigability"), 0.5, 0.01);
}

TEST(Ways, AccessNeedsOneFreeSide) {
  const auto blocked = [](bool left) {
    TestRoom room;
    room.add("bed", "bed", {1.6, 2, 0.5}, {0.8, 3.0}).used({Side::kFront, Side::kLeft, Side::kRight});
    room.add("chest", "chest", {1.6, 0.4, 0.5}, {0.8, 1.8});
    if (left) room.add("wardrobe", "wardrobe", {2.0, 0.6, 2.0}, {1.9, 3.0, 0, 90});
    return room.judge();
  };
  EXPECT_TRUE(passes(blocked(false), "accessibility", "bed"));
  EXPECT_FALSE(passes(blocked(true), "accessibility", "bed"));
  EXPECT_TRUE(blocked(true).passed);
}

// A shelf from wall to wall leaves the bed behind it out of reach; nothing of that kind is a fault of a sound room.
TEST(Ways, UsedSidesAreReachedFromTheDoor) {
  const auto with_shelf = [](double width) {
    return TestRoom()
        .door("door1", "wall1", 0.5)
        .add("bed", "bed", {1.6, 2, 0.5}, {3.5, 3})
        .used({Side::kFront, Side::kLeft, Side::kRight})
        .add("shelf", "shelf", {0.4, width, 2}, {1.9, width / 2})
        .judge();
  };
  const Report open = with_shelf(3), shut = with_shelf(4);
  EXPECT_TRUE(passes(open, "reachability", "bed"));
  EXPECT_EQ(open.metrics.at("reachability"), 1);
  EXPECT_FALSE(passes(shut, "reachability", "bed"));
  EXPECT_EQ(shut.metrics.at("reachability"), 0);
  EXPECT_THAT(find_check(shut, "reachability", "bed")->message, HasSubstr("the front, left, right side of bed"));
  EXPECT_TRUE(shut.passed);  // it warns
}

// At a wall a bed has one side less.
TEST(Ways, OneUsedSideThatIsReachedIsEnough) {
  const Report report = TestRoom()
                            .door("door1", "wall1", 0.5)
                            .add("bed", "bed", {1.6, 2, 0.5}, {4.2, 3})
                            .used({Side::kFront, Side::kLeft, Side::kRight})
                            .judge();
  EXPECT_TRUE(passes(report, "reachability", "bed"));
  EXPECT_NEAR(report.metrics.at("reachability"), 2 / 3.0, 1e-9);
}

}  // namespace
}  // namespace layoutbox::checks
