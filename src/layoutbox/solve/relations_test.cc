// Every relation: a scene in which it can hold gives a layout in which it holds, in four rooms that are the same room turned; and what
// the layout says is checked with the plain coordinates of the objects.
#include <gtest/gtest.h>

#include <algorithm>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

RelationParameters with(void (*set)(RelationParameters&)) {
  RelationParameters p;
  set(p);
  return p;
}

// ------------------------------------------------------------------------------------------- what it means, in plain coordinates

// The reference stands fixed, turned by quarters; the target must come to the side named in the reference's own frame.
class OwnFrame : public testing::TestWithParam<int> {};

TEST_P(OwnFrame, LeftIsTheLeftOfTheReference) {
  const int turn = GetParam();
  const struct {
    const char* relation;
    double x, y;  // where in the frame of the reference
  } sides[] = {{"leftOf", -1, 0}, {"rightOf", 1, 0}, {"inFrontOf", 0, -1}, {"behind", 0, 1}};
  for (const auto& side : sides) {
    const SceneGraph scene = SceneMaker(6000, 6000)
                                 .add("sofa")
                                 .at(3000, 3000, 0, turn, true)
                                 .add("plant")
                                 .sized(300, 300, 800)
                                 .relate(side.relation, {"plant_1"}, {"sofa_1"})
                                 .make();
    const auto layout = solve(scene, Catalog::builtin());
    ASSERT_TRUE(layout);
    const PlacedObject &sofa = *layout->find_object("sofa_1"), &plant = *layout->find_object("plant_1");
    const TestPoint p = in_frame_of(sofa, {plant.position[0], plant.position[1], 0});
    const double half[2] = {sofa.size.width / 2.0, sofa.size.depth / 2.0};
    if (side.x != 0) {
      EXPECT_GE(p.x * side.x, half[0] + 149) << side.relation << " at " << turn;
      EXPECT_LE(std::abs(p.y), half[1] + 1);
    } else {
      EXPECT_GE(p.y * side.y, half[1] + 149) << side.relation << " at " << turn;
      EXPECT_LE(std::abs(p.x), half[0] + 1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Quarters, OwnFrame, testing::Values(0, 90, 180, 270));

TEST(AgainstWall, EachWallTurnsTheBackToIt) {
  const double turns[4] = {180, 270, 0, 90};  // front, right, back, left wall
  for (int w = 0; w < 4; ++w) {
    const auto layout =
        solve(SceneMaker(4000, 3000).add("wardrobe").relate("againstWall", {"wardrobe_1"}, {"wall" + std::to_string(w + 1)}).make(),
              Catalog::builtin());
    ASSERT_TRUE(layout);
    const PlacedObject& wardrobe = layout->objects[0];
    EXPECT_EQ(wardrobe.rotation_deg, turns[w]);
    const double gap[4] = {wardrobe.position[1], 4000 - wardrobe.position[0], 3000 - wardrobe.position[1], wardrobe.position[0]};
    EXPECT_NEAR(gap[w], wardrobe.size.depth / 2.0, 20.5);
  }
}

TEST(Around, ChairsLookAtTheTableAndAreSpread) {
  const auto layout = solve(
      SceneMaker(4500, 4000)
          .add("dining_table")
          .add("dining_chair", 6)
          .relate("around", {"dining_chair_1", "dining_chair_2", "dining_chair_3", "dining_chair_4", "dining_chair_5", "dining_chair_6"},
                  {"dining_table_1"})
          .make(),
      Catalog::builtin());
  ASSERT_TRUE(layout);
  const PlacedObject& table = *layout->find_object("dining_table_1");
  for (const PlacedObject& o : layout->objects) {
    if (o.category != "dining_chair") continue;
    const double dx = table.position[0] - o.position[0], dy = table.position[1] - o.position[1];
    const double a = o.rotation_deg * kPi / 180, fx = std::sin(a), fy = -std::cos(a);
    EXPECT_GT(dx * fx + dy * fy, 0) << o.id << " looks away";
  }
}

// Free below as real ones are, or with compartments down to the floor.
TEST(Under, WhatPeopleKeepUnderThings) {
  const std::pair<const char*, const char*> pairs[] = {{"shoe", "entryway_bench"},  {"shoe", "sofa"},
                                                       {"shoe", "bench"},           {"shredder", "stand"},
                                                       {"basket", "console_table"}, {"storage_box", "bed"}};
  for (const auto& [thing, above] : pairs) {
    const std::string t = thing + std::string("_1"), r = above + std::string("_1");
    const auto layout = solve(SceneMaker(4000, 3500).add(above).add(thing).relate("under", {t}, {r}).make(), Catalog::builtin());
    ASSERT_TRUE(layout);
    expect_sound(*layout);
    EXPECT_TRUE(holds(*layout, "c1")) << thing << " under " << above;
  }
}

// What stands the wrong way under a bed lies there, stools go under a bench that has a shelf, a parrot is in its hanging cage.
TEST(Under, SuitcasesLieAndStoolsFindRoom) {
  const auto held = [](SceneMaker& maker, const char* relation) {
    const auto layout = solve(maker.make(), Catalog::builtin());
    if (!layout) return false;
    expect_sound(*layout);
    return holds(*layout, relation);
  };
  EXPECT_TRUE(held(SceneMaker(5000, 4000).add("bunk_bed").add("suitcase").relate("under", {"suitcase_1"}, {"bunk_bed_1"}), "c1"));
  EXPECT_TRUE(held(SceneMaker(5000, 4000).add("workbench").add("stool").relate("tuckedUnder", {"stool_1"}, {"workbench_1"}), "c1"));
  SceneMaker cage(5000, 4000);
  cage.add("bird_cage").mounted(Mount::kCeiling).add("bird").mounted(Mount::kSurface);
  EXPECT_TRUE(held(cage.relate("onCeiling", {"bird_cage_1"}).relate("in", {"bird_1"}, {"bird_cage_1"}), "c2"));
}

// A bench has two long sides alike; one that is told to face something turns its front there, as anybody reads the layout.
TEST(Facing, WhatHasNoFrontTurnsItsLongSideThere) {
  for (const char* wall : {"wall1", "wall2", "wall3", "wall4"}) {
    const auto layout = solve(SceneMaker(6000, 6000)
                                  .add("bench")
                                  .add("plinth")
                                  .relate("centeredOnWall", {"plinth_1"}, {wall})
                                  .relate("facing", {"bench_1"}, {"plinth_1"})
                                  .make(),
                              Catalog::builtin());
    ASSERT_TRUE(layout);
    const PlacedObject &bench = *layout->find_object("bench_1"), &plinth = *layout->find_object("plinth_1");
    const double a = bench.rotation_deg * kPi / 180, dx = plinth.position[0] - bench.position[0],
                 dy = plinth.position[1] - bench.position[1];
    EXPECT_GT((std::sin(a) * dx - std::cos(a) * dy) / std::hypot(dx, dy), 0.8) << wall;
  }
}

// What has no front may be said to look at the room, however it lies; and where it cannot turn to a thing, nothing is proven.
TEST(Facing, WhatHasNoFrontIsNoProof) {
  SceneMaker maker(2000, 4000);
  maker.add("bench").sized(1000, 3800, 450);
  const auto at_room = solve(SceneMaker(maker).relate("facing", {"bench_1"}, {"room"}).make(), Catalog::builtin());
  ASSERT_TRUE(at_room);
  EXPECT_EQ(at_room->status, LayoutStatus::kSolved);
  const auto layout =
      solve(maker.add("plinth").relate("facing", {"bench_1"}, {"plinth_1"}).relate("leftOf", {"plinth_1"}, {"bench_1"}).make(),
            Catalog::builtin());
  ASSERT_TRUE(layout);
  for (const Conflict& conflict : layout->conflicts) EXPECT_FALSE(conflict.minimal) << conflict.sentence;
}

TEST(In, BasketsAndBoxesInShelves) {
  for (const char* shelf : {"bookshelf", "cube_shelf", "toy_shelf", "shelf"}) {
    const std::string r = shelf + std::string("_1");
    SceneMaker maker(4000, 3500);
    maker.add(shelf).add("basket", 2).add("storage_box").add("book", 2);
    for (const char* thing : {"basket_1", "basket_2", "storage_box_1", "book_1", "book_2"}) maker.relate("in", {thing}, {r});
    const auto layout = solve(maker.make(), Catalog::builtin());
    ASSERT_TRUE(layout);
    expect_sound(*layout);
    EXPECT_EQ(layout->status, LayoutStatus::kSolved) << shelf;
  }
}

TEST(Impossible, IsSaidWithARelaxation) {
  const auto layout = solve(
      SceneMaker(3000, 3000).add("chair").add("plant").relate("far", {"plant_1"}, {"chair_1"}, with([](auto& p) { p.min = 6000; })).make(),
      Catalog::builtin());
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->status, LayoutStatus::kRelaxed);
  ASSERT_EQ(layout->relaxed.size(), 1u);
  EXPECT_EQ(layout->relaxed[0].relation, "c1");
  EXPECT_GT(layout->relaxed[0].by, 1);
  EXPECT_FALSE(layout->relations[0].held);
}

}  // namespace
}  // namespace layoutbox::placement
