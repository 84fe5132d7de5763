#include "layoutbox/scene/shell.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace layoutbox {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Wall wall(std::string id, Point start, Point end) {
  Wall out;
  out.id = std::move(id);
  out.start = start;
  out.end = end;
  return out;
}

std::vector<Wall> four_walls() {
  return {wall("front", {0, 0}, {4000, 0}), wall("right", {4000, 0}, {4000, 3000}), wall("back", {4000, 3000}, {0, 3000}),
          wall("left", {0, 3000}, {0, 0})};
}

std::vector<std::string> ids(const std::vector<Wall>& walls) {
  std::vector<std::string> out;
  for (const Wall& item : walls) out.push_back(item.id);
  return out;
}

TEST(Walls, AnyOrderAndDirectionGiveTheSameRing) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    std::mt19937_64 random(seed);
    std::vector<Wall> walls = four_walls();
    std::vector<Opening> openings(1);
    openings[0].wall = "back";
    openings[0].offset = 500;
    openings[0].width = 900;
    std::shuffle(walls.begin(), walls.end(), random);
    for (Wall& item : walls) {
      if (random() % 2 == 0) continue;
      std::swap(item.start, item.end);
      if (item.id == "back") openings[0].offset = 4000 - 500 - 900;  // where it is does not change
    }
    const auto ring = walls_in_ring(walls, openings);
    ASSERT_TRUE(ring) << "seed " << seed << ": " << ring.error().message;
    EXPECT_THAT(ids(*ring), ElementsAre("front", "right", "back", "left")) << "seed " << seed;
    EXPECT_EQ((*ring)[0].start, (Point{0, 0}));
    EXPECT_EQ((*ring)[2].start, (Point{4000, 3000}));
    EXPECT_EQ(openings[0].offset, 500) << "seed " << seed;
  }
}

TEST(Walls, NearlyMeetingEndsAreJoined) {
  std::vector<Wall> walls = four_walls();
  walls[1].start = {4003, -4};
  std::vector<Opening> none;
  const auto ring = walls_in_ring(walls, none);
  ASSERT_TRUE(ring);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ((*ring)[i].end, (*ring)[(i + 1) % 4].start);
}

TEST(Walls, AGapIsNamedWithItsSize) {
  std::vector<Wall> walls = four_walls();
  walls[2].end = {250, 3000};
  std::vector<Opening> none;
  const auto ring = walls_in_ring(walls, none);
  ASSERT_FALSE(ring);
  EXPECT_EQ(ring.error().code, ErrorCode::kGeometry);
  EXPECT_THAT(ring.error().message, HasSubstr("back"));
  EXPECT_THAT(ring.error().message, HasSubstr("0.25 m"));
  EXPECT_EQ(ring.error().pointer, "/room/walls/2");
}

TEST(Walls, NoLengthTooFewAndCrossingAreErrors) {
  std::vector<Opening> none;
  std::vector<Wall> walls = four_walls();
  walls[1].end = walls[1].start;
  EXPECT_THAT(walls_in_ring(walls, none).error().message, HasSubstr("no length"));
  EXPECT_FALSE(walls_in_ring({wall("a", {0, 0}, {1000, 0}), wall("b", {1000, 0}, {0, 0})}, none));
  EXPECT_THAT(walls_in_ring({wall("a", {0, 0}, {2000, 0}), wall("b", {2000, 0}, {0, 2000}), wall("c", {0, 2000}, {2000, 2000}),
                             wall("d", {2000, 2000}, {0, 0})},
                            none)
                  .error()
                  .message,
              HasSubstr("cross"));
}

TEST(Walls, MissingSidesOfARectangleAreAdded) {
  Room room;
  room.polygon = {{0, 0}, {4000, 0}, {4000, 3000}, {0, 3000}};
  room.walls = {wall("left", {0, 0}, {0, 3000}), wall("back", {0, 3000}, {4000, 3000})};
  ASSERT_TRUE(complete_rectangle(room));
  EXPECT_TRUE(walls_in_ring(room.walls, room.openings));
  room.walls = {wall("left", {0, 0}, {0, 2000}), wall("back", {0, 3000}, {4000, 3000})};
  EXPECT_FALSE(complete_rectangle(room)) << "a part of a side is no side";
}

TEST(Polygons, AreTurnedAndStartAtTheFrontLeft) {
  const auto polygon = tidy_polygon({{4000, 3000}, {4000, 0}, {0, 0}, {0, 3000}, {4000, 3000}});
  ASSERT_TRUE(polygon);
  EXPECT_THAT(*polygon, ElementsAre(Point{0, 0}, Point{4000, 0}, Point{4000, 3000}, Point{0, 3000}));
  EXPECT_EQ(doubled_area(*polygon), 2 * 4000LL * 3000);
}

TEST(Polygons, ThatCrossThemselvesAreErrors) {
  EXPECT_FALSE(tidy_polygon({{0, 0}, {4000, 3000}, {4000, 0}, {0, 3000}}));
  EXPECT_FALSE(tidy_polygon({{0, 0}, {4000, 0}, {2000, 0}})) << "it folds back on itself";
  EXPECT_FALSE(tidy_polygon({{0, 0}, {4000, 0}}));
  EXPECT_FALSE(tidy_polygon({{0, 0}, {4000, 0}, {4000, 2000}, {2000, 0}, {0, 2000}})) << "a corner touches an edge";
  EXPECT_TRUE(tidy_polygon({{0, 0}, {2000, 0}, {4000, 0}, {4000, 2000}})) << "a corner on a straight wall does no harm";
}

TEST(Walls, AreFoundBySideAndName) {
  std::vector<Wall> walls = four_walls();
  walls.push_back(wall("nook", {1000, 2000}, {500, 2000}));
  EXPECT_EQ(wall_on_side(walls, Side::kBack)->id, "back");
  EXPECT_EQ(wall_on_side(walls, Side::kLeft)->id, "left");
  std::swap(walls[1].start, walls[1].end);
  EXPECT_EQ(wall_on_side(walls, Side::kRight)->id, "right");
  SceneGraph scene;
  scene.room.walls = {wall("Wall_1", {0, 0}, {4000, 0}), wall("Wall_2", {4000, 0}, {4000, 3000}), wall("Wall_3", {4000, 3000}, {0, 3000}),
                      wall("Wall_4", {0, 3000}, {0, 0})};
  for (const char* name : {"Wall_3", "wall3", "WALL 3", "back", "the back wall", "north", "Northern wall"}) {
    ASSERT_NE(scene.find_wall(name), nullptr) << name;
    EXPECT_EQ(scene.find_wall(name)->id, "Wall_3") << name;
  }
  EXPECT_EQ(scene.find_wall("wall9"), nullptr);
  EXPECT_EQ(scene.find_wall("middle"), nullptr);
}

TEST(Openings, MustFitTheirWall) {
  Room room;
  room.height = 2500;
  room.walls = four_walls();
  Opening door;
  door.id = "door1";
  door.wall = "left";
  door.offset = 2200;
  room.openings = {door};
  const auto errors = check_openings(room);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].pointer, "/room/openings/0");
  EXPECT_THAT(errors[0].message, HasSubstr("3 m long"));
  room.openings[0].offset = 2100;
  EXPECT_TRUE(check_openings(room).empty());
  room.openings.push_back(room.openings[0]);
  room.openings[1].id = "door2";
  EXPECT_THAT(check_openings(room).at(0).message, HasSubstr("overlap"));
  room.openings[1].wall = "nowhere";
  EXPECT_EQ(check_openings(room).at(0).code, ErrorCode::kReference);
  room.openings.resize(1);
  room.openings[0].height = 2600;
  EXPECT_THAT(check_openings(room).at(0).message, HasSubstr("2.5 m high"));
}

}  // namespace
}  // namespace layoutbox
