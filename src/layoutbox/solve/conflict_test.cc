// Scenes that cannot hold: what is in the way of what, and what is given up.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "layoutbox/scene/scene_json.h"
#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

TEST(Conflict, WidthsAlongAWall) {
  const SceneGraph scene = SceneMaker(3200, 3000)
                               .add("bed")
                               .sized(1600, 2000, 500)
                               .add("wardrobe")
                               .sized(2400, 600, 2000)
                               .relate("againstWall", {"bed_1"}, {"wall3"})
                               .relate("againstWall", {"wardrobe_1"}, {"wall3"})
                               .make();
  SolveOptions options;
  options.on_conflict = OnConflict::kFail;
  const auto failed = solve(scene, Catalog::builtin(), options);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::kInfeasible);
  ASSERT_EQ(failed.error().details.size(), 1u);
  EXPECT_EQ(failed.error().details[0].message,
            "the wardrobe (2.40 m) and the bed (1.60 m) both stand against the back wall, which is 3.20 m long, 0.80 m too little");

  const Layout layout = solved_soundly(scene);
  EXPECT_EQ(layout.status, LayoutStatus::kRelaxed);
  EXPECT_EQ(layout.objects.size(), 2u);
  ASSERT_EQ(layout.relaxed.size(), 1u);
  EXPECT_GT(layout.relaxed[0].by, 0);
}

TEST(Conflict, AnObjectLargerThanTheRoomIsLeftOutAndNamed) {
  const Layout layout = solved_soundly(SceneMaker(2000, 2000).add("chair").add("bed").sized(2500, 2600, 500).make());
  EXPECT_EQ(layout.status, LayoutStatus::kRelaxed);
  EXPECT_EQ(layout.objects.size(), 1u);
  ASSERT_EQ(layout.conflicts.size(), 1u);
  EXPECT_NE(layout.conflicts[0].sentence.find("2.50"), std::string::npos);
}

TEST(Conflict, SmallestSetIsNamed) {
  if (!describe_cp_sat_library()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  // The chair cannot be left of the table and right of it; the plant has nothing to do with it.
  const SceneGraph scene = SceneMaker(5000, 4000)
                               .add("table")
                               .add("chair")
                               .add("plant")
                               .relate("leftOf", {"chair_1"}, {"table_1"})
                               .relate("corner", {"plant_1"})
                               .relate("rightOf", {"chair_1"}, {"table_1"})
                               .make();
  const Layout layout = solved_soundly(scene);
  ASSERT_EQ(layout.conflicts.size(), 1u);
  EXPECT_THAT(layout.conflicts[0].relations, testing::UnorderedElementsAre("c1", "c3"));
  EXPECT_TRUE(layout.conflicts[0].minimal);
  EXPECT_EQ(layout.status, LayoutStatus::kRelaxed);
}

TEST(Conflict, IndependentOnesAreAllNamed) {
  if (!describe_cp_sat_library()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  const SceneGraph scene = SceneMaker(5000, 4000)
                               .add("table")
                               .add("chair")
                               .add("plant")
                               .relate("leftOf", {"chair_1"}, {"table_1"})
                               .relate("rightOf", {"chair_1"}, {"table_1"})
                               .relate("corner", {"plant_1"})
                               .relate("centerOfRoom", {"plant_1"})
                               .make();
  SolveOptions options;
  options.on_conflict = OnConflict::kFail;
  const auto failed = solve(scene, Catalog::builtin(), options);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::kInfeasible);
  ASSERT_EQ(failed.error().details.size(), 2u);
  const Layout layout = solved_soundly(scene);
  ASSERT_EQ(layout.conflicts.size(), 2u);
  std::vector<std::string> named = layout.conflicts[0].relations;
  named.insert(named.end(), layout.conflicts[1].relations.begin(), layout.conflicts[1].relations.end());
  EXPECT_THAT(named, testing::UnorderedElementsAre("c1", "c2", "c3", "c4"));
  EXPECT_TRUE(layout.conflicts[0].minimal && layout.conflicts[1].minimal);
}

// What lies outside our ways to place things but is not impossible is not called so.
TEST(Conflict, NotFoundIsNotCalledImpossible) {
  const std::vector<Point> octagon{{1500, 0}, {3500, 0}, {5000, 1500}, {5000, 3500}, {3500, 5000}, {1500, 5000}, {0, 3500}, {0, 1500}};
  const Layout layout = solved_soundly(
      SceneMaker(octagon).add("bed").add("nightstand").relate("centeredOnWall", {"bed_1", "nightstand_1"}, {"wall2"}).make());
  ASSERT_EQ(layout.relaxed.size(), 1u);
  EXPECT_THAT(layout.relaxed[0].why, testing::HasSubstr("no layout was found"));
  EXPECT_FALSE(holds(layout, "c1"));
}

TEST(Conflict, TheLighterOneIsGivenUp) {
  if (!describe_cp_sat_library()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  SceneMaker maker = SceneMaker(5000, 4000).add("plant").relate("corner", {"plant_1"}).relate("centerOfRoom", {"plant_1"});
  maker.raw().relations[0].weight = 20;
  const Layout layout = solved_soundly(maker.make());
  ASSERT_EQ(layout.relaxed.size(), 1u);
  EXPECT_EQ(layout.relaxed[0].relation, "c1");
  EXPECT_TRUE(holds(layout, "c2"));
}

TEST(Conflict, OriginalPositionsAreReportedAsSuch) {
  SolveOptions options;
  options.on_conflict = OnConflict::kOriginal;
  const auto layout = solve(SceneMaker(4000, 3000).add("chair").add("bed").sized(5000, 2000, 500).at(1500, 1200, 0, 90, false).make(),
                            Catalog::builtin(), options);
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->status, LayoutStatus::kFallback);
  EXPECT_EQ(layout->find_object("bed_1")->position[0], 1500);
  EXPECT_EQ(layout->find_object("chair_1")->position[0], 1000);
}

}  // namespace
}  // namespace layoutbox::placement
