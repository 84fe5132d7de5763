// Random scenes against a judge that shares no code, large ones, and rooms of other shapes.
#include <gtest/gtest.h>

#include <random>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

// ------------------------------------------------------------------------------------------------------------- random scenes

TEST(RandomScenes, AreSoundAndClaimTruly) {
  const std::vector<std::string> kinds{"bed",   "desk",  "chair",    "sofa",       "wardrobe", "bookshelf",
                                       "plant", "table", "armchair", "nightstand", "rug",      "floor_lamp"};
  const std::vector<std::string> pairs{"leftOf", "rightOf", "inFrontOf", "nextTo", "near", "behind", "parallel", "facing", "perpendicular"};
  const std::vector<std::string> rooms{"againstWall", "corner", "inRegion"};
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const auto below = [&](std::size_t n) { return random() % n; };
    SceneMaker maker(static_cast<Mm>(3000 + 100 * below(40)), static_cast<Mm>(2500 + 100 * below(30)));
    for (std::size_t i = 0, n = 2 + below(8); i < n; ++i) maker.add(kinds[below(kinds.size())]);
    const std::vector<SceneObject> objects = maker.raw().objects;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      RelationParameters p;
      p.region = below(2) ? RoomRegion::kLeft : RoomRegion::kBack;
      if (below(3) == 0) maker.relate(rooms[below(rooms.size())], {objects[i].id}, {}, p);
      if (i > 0 && below(2) == 0) maker.relate(pairs[below(pairs.size())], {objects[i].id}, {objects[below(i)].id});
    }
    SolveOptions options;
    options.seed = seed;
    const auto layout = solve(maker.make(true), Catalog::builtin(), options);
    ASSERT_TRUE(layout) << "seed " << seed << ": " << layout.error().message;
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_sound(*layout);
    std::size_t given_up = 0;
    for (const PlacedRelation& r : layout->relations) given_up += r.relation.hard && !r.held;
    EXPECT_LE(given_up, layout->relaxed.size()) << "a relation that does not hold is not listed";
    if (layout->status == LayoutStatus::kSolved) {
      EXPECT_EQ(layout->objects.size(), objects.size());
    }
  }
}

TEST(ManyObjects, AHundredChairsInAHall) {
  const auto layout = solve(SceneMaker(14000, 12000).add("chair", 100).make(true), Catalog::builtin());
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->objects.size(), 100u);
}

TEST(OtherRooms, AnLShapeKeepsItsNotchFree) {
  const auto layout = solve(SceneMaker(std::vector<Point>{{0, 0}, {5000, 0}, {5000, 2500}, {2500, 2500}, {2500, 4500}, {0, 4500}})
                                .add("bed")
                                .add("sofa")
                                .add("wardrobe")
                                .add("desk")
                                .add("plant", 3)
                                .relate("corner", {"plant_1"})
                                .make(true),
                            Catalog::builtin());
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->status, LayoutStatus::kSolved);
  for (const PlacedObject& o : layout->objects) {
    for (const TestPoint& p : points_of(o, 6)) EXPECT_FALSE(p.x > 2501 && p.y > 2501) << o.id << " stands in the notch";
  }
}

// A round room as a polygon: windows and doors in its walls at an angle are kept free.
TEST(OtherRooms, OpeningsInWallsAtAnAngle) {
  const std::vector<Point> octagon{{1500, 0}, {3500, 0}, {5000, 1500}, {5000, 3500}, {3500, 5000}, {1500, 5000}, {0, 3500}, {0, 1500}};
  for (const std::optional<Mm> offset : {std::optional<Mm>(300), std::optional<Mm>()}) {
    const auto layout = solve(SceneMaker(octagon)
                                  .opening(OpeningType::kWindow, "wall2", offset, 1000, 900, 1200)
                                  .opening(OpeningType::kDoor, "wall4", offset)
                                  .add("bed")
                                  .add("wardrobe")
                                  .add("desk")
                                  .make(true),
                              Catalog::builtin());
    ASSERT_TRUE(layout);
    EXPECT_EQ(layout->status, LayoutStatus::kSolved);
    ASSERT_EQ(layout->room.openings.size(), 2u);
    for (const Opening& opening : layout->room.openings) EXPECT_TRUE(opening.offset) << opening.id;
    EXPECT_EQ(layout->room.openings[1].wall, "wall4");
  }
  // Where no wall runs along x or y, openings without a place take one all the same.
  const auto diamond = solve(SceneMaker(std::vector<Point>{{3000, 0}, {6000, 3000}, {3000, 6000}, {0, 3000}})
                                 .opening(OpeningType::kDoor, "", std::nullopt)
                                 .add("table")
                                 .make(true),
                             Catalog::builtin());
  ASSERT_TRUE(diamond);
  EXPECT_FALSE(diamond->room.openings[0].wall.empty());
}

}  // namespace
}  // namespace layoutbox::placement
