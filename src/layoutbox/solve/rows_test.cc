// Many of a kind stand in straight rows and files: classes with their seats, who waits before a desk, pillars along a hall.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

std::string numbered(const std::string& kind, int i) { return kind + "_" + std::to_string(i); }

// Different places along an axis, as seen to the centimetre.
std::size_t lines_of(const Layout& layout, const std::string& kind, int n, int axis) {
  std::set<long> lines;
  for (int i = 1; i <= n; ++i)
    lines.insert(std::lround(layout.find_object(numbered(kind, i))->position[static_cast<std::size_t>(axis)] / 10));
  return lines.size();
}

RelationParameters at_most(Mm max) {
  RelationParameters parameters;
  parameters.max = max;
  return parameters;
}

RelationParameters in_columns(int columns) {
  RelationParameters parameters;
  parameters.columns = columns;
  return parameters;
}

SceneMaker class_of(int n, Mm width, Mm depth) {
  SceneMaker maker(width, depth);
  maker.add("school_desk", n).add("student_chair", n).add("whiteboard");
  maker.relate("facing", {"school_desk_1"}, {"whiteboard_1"});
  for (int i = 1; i <= n; ++i) {
    if (i > 1) maker.relate("sameOrientation", {numbered("school_desk", i)}, {"school_desk_1"});
    maker.relate("behind", {numbered("student_chair", i)}, {numbered("school_desk", i)}, at_most(400));
    maker.relate("facing", {numbered("student_chair", i)}, {numbered("school_desk", i)});
  }
  return maker;
}

class Classes : public testing::TestWithParam<int> {};

TEST_P(Classes, StandInRowsAndFilesTheirChairsAlike) {
  const int n = GetParam();
  const Mm side = 6000 + 100 * n;
  const Layout layout = solved_as_asked(class_of(n, side, side).make(true));
  const std::size_t x = lines_of(layout, "school_desk", n, 0), y = lines_of(layout, "school_desk", n, 1);
  EXPECT_GE(x * y, static_cast<std::size_t>(n));
  EXPECT_LE(std::min(x, y) * (std::max(x, y) - 1), static_cast<std::size_t>(2 * n)) << x << " by " << y;
  for (int i = 1; i <= n; ++i) {
    const PlacedObject &desk = *layout.find_object(numbered("school_desk", i)), &chair = *layout.find_object(numbered("student_chair", i));
    const TestPoint at = in_frame_of(desk, {chair.position[0], chair.position[1], 0});
    EXPECT_NEAR(at.x, 0, 60) << i;
    EXPECT_NEAR(at.y, (desk.size.depth + chair.size.depth) / 2.0, 60) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(OfAllSizes, Classes, testing::Values(12, 20, 30));

TEST(Rows, TheTeacherToldToBeBeforeTheBoardLooksAtTheClass) {
  SceneMaker maker = class_of(12, 8000, 7000);
  maker.add("teacher_desk").relate("inFrontOf", {"teacher_desk_1"}, {"whiteboard_1"});
  const Layout layout = solved_as_asked(maker.make(true));
  EXPECT_EQ(std::lround(layout.find_object("teacher_desk_1")->rotation_deg), std::lround(layout.find_object("whiteboard_1")->rotation_deg));
}

TEST(Rows, TheTeacherToldToBeAtTheFrontHasFloorBeforeTheClass) {
  SceneMaker maker = class_of(20, 8900, 7700);
  RelationParameters front;
  front.region = RoomRegion::kFront;
  maker.add("teacher_desk").relate("inRegion", {"teacher_desk_1"}, {}, front);
  const Layout layout = solved_as_asked(maker.make(true));
  const PlacedObject& teacher = *layout.find_object("teacher_desk_1");
  for (int i = 1; i <= 20; ++i) {
    const PlacedObject& desk = *layout.find_object(numbered("school_desk", i));
    EXPECT_GE(std::abs(desk.position[1] - teacher.position[1]) - (desk.size.depth + teacher.size.depth) / 2.0, 600) << i;
  }
}

TEST(Rows, PillarsAreSpreadOverTheLengthOfTheHall) {
  SceneMaker maker(8000, 16000, 5000);
  maker.add("pillar", 8);
  std::vector<std::string> all;
  for (int i = 1; i <= 8; ++i) all.push_back(numbered("pillar", i));
  maker.relate("grid", all, {}, in_columns(2));
  const Layout layout = solved_as_asked(maker.make(true));
  double least = 16000, most = 0;
  for (const std::string& id : all) {
    least = std::min(least, layout.find_object(id)->position[1]);
    most = std::max(most, layout.find_object(id)->position[1]);
  }
  EXPECT_GE(most - least, 11000);
}

TEST(Rows, WhoWaitsLooksAtTheReceptionDeskAndLeavesAWayBeforeIt) {
  SceneMaker maker(7500, 7000);
  maker.add("reception_desk").add("chair", 12);
  const Layout layout = solved_as_asked(maker.make(true));
  const PlacedObject& desk = *layout.find_object("reception_desk_1");
  for (int i = 1; i <= 12; ++i) {
    const PlacedObject& chair = *layout.find_object(numbered("chair", i));
    const TestPoint at = in_frame_of(desk, {chair.position[0], chair.position[1], 0});
    EXPECT_LE(at.y, -desk.size.depth / 2.0 - 700) << i;
  }
}

TEST(Rows, NightstandsStayBesideABedInTheMiddle) {
  SceneMaker maker(5000, 4600);
  maker.add("bed").add("nightstand", 2).relate("centerOfRoom", {"bed_1"}).relate("eachSideOf", {"nightstand_1", "nightstand_2"}, {"bed_1"});
  const Layout layout = solved_as_asked(maker.make(true));
  const PlacedObject& bed = *layout.find_object("bed_1");
  for (const std::string id : {"nightstand_1", "nightstand_2"}) {
    const PlacedObject& stand = *layout.find_object(id);
    const TestPoint at = in_frame_of(bed, {stand.position[0], stand.position[1], 0});
    EXPECT_LE(std::abs(at.x) - (bed.size.width + stand.size.width) / 2.0, 200) << id;
    EXPECT_GE(at.y, bed.size.depth / 4.0) << id;
  }
}

TEST(Rows, OneComesInBehindAClassWhoseBoardHangsOnAWallWithoutWindows) {
  SceneMaker maker = class_of(20, 10000, 7000);
  maker.add("teacher_desk");
  SceneGraph scene = maker.make(true);
  int number = 0;
  for (const char* wall : {"wall1", "wall3"}) {
    Opening window;
    window.id = "light" + std::to_string(++number);
    window.type = OpeningType::kWindow;
    window.wall = wall, window.width = 3000, window.height = 1200, window.sill = 900, window.offset = 3500;
    scene.room.openings.push_back(window);
  }
  const Layout layout = solved_as_asked(scene);
  const int turn = static_cast<int>(std::lround(layout.find_object("whiteboard_1")->rotation_deg));
  EXPECT_EQ(turn % 180, 90) << turn;
}

TEST(Rows, TheBackBarIsBehindWhoServes) {
  SceneMaker maker(6000, 5000);
  maker.add("bar_counter").add("back_bar").add("bar_stool", 4);
  const Layout layout = solved_as_asked(maker.make(true));
  const PlacedObject &counter = *layout.find_object("bar_counter_1"), &shelf = *layout.find_object("back_bar_1");
  const TestPoint at = in_frame_of(counter, {shelf.position[0], shelf.position[1], 0});
  EXPECT_LE(std::abs(at.x), counter.size.width / 2.0);
  EXPECT_NEAR(at.y - (counter.size.depth + shelf.size.depth) / 2.0, 900, 200);
}

// Whatever seats they are: what there is to look at hangs before the middle of them all.
TEST(Rows, SeatsInRowsLookAtTheScreen) {
  for (const auto& [seat, shown] :
       {std::pair{"theater_seat", "projector_screen"}, {"student_chair", "projector_screen"}, {"theater_seat", "whiteboard"}}) {
    SceneMaker maker(9000, 10000);
    maker.add(seat, 24).add(shown);
    std::vector<std::string> ids;
    for (int i = 1; i <= 24; ++i) ids.push_back(std::string(seat) + "_" + std::to_string(i));
    maker.relate("grid", ids);
    const Layout layout = solved_as_asked(maker.make(true));
    const PlacedObject& screen = object(layout, std::string(shown) + "_1");
    double middle = 0;
    for (const std::string& id : ids) {
      const PlacedObject& one = object(layout, id);
      const TestPoint at = in_frame_of(screen, {one.position[0], one.position[1], 0});
      middle += at.x / 24;
      EXPECT_LT(at.y, 0) << id;
      EXPECT_NEAR(turned(layout, std::string(shown) + "_1", id), 180, 1) << id;
    }
    EXPECT_NEAR(middle, 0, 700) << seat << " " << shown;
  }
}

}  // namespace
}  // namespace layoutbox::placement
