// The scene's own positions and turns: wishes that hold where nothing that is asked for says otherwise.
#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

Layout solved(const SceneMaker& maker, std::uint64_t seed) {
  SolveOptions options;
  options.seed = seed;
  options.prove = false;
  const auto layout = solve(maker.make(), Catalog::builtin(), options);
  EXPECT_TRUE(layout) << layout.error().message;
  if (!layout) return {};
  expect_sound(*layout);
  return *layout;
}

TEST(Hints, AnOffsetIsOnTheSideWhereThePositionsHaveIt) {
  for (const bool left : {true, false}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      SceneMaker maker(6000, 4000);
      maker.add("desk").at(3000, 2000, 0, 0, false).add("bookshelf").at(left ? 1500 : 4500, 2000, 0, 0, false);
      RelationParameters parameters;
      parameters.axis = Axis::kX;
      parameters.distance = 300;
      maker.relate("offset", {"bookshelf_1"}, {"desk_1"}, parameters);
      const Layout layout = solved(maker, seed);
      EXPECT_TRUE(holds(layout, "c1"));
      EXPECT_EQ(layout.find_object("bookshelf_1")->position[0] < layout.find_object("desk_1")->position[0], left) << "seed " << seed;
    }
  }
}

TEST(Hints, AnOffsetGoesToTheOtherSideWhereThereIsNoRoom) {
  SceneMaker maker(6000, 4000);
  maker.add("desk").at(700, 2000, 0, 0, true).add("wardrobe").at(300, 2000, 0, 0, false);
  RelationParameters parameters;
  parameters.axis = Axis::kX;
  parameters.distance = 300;
  maker.relate("offset", {"wardrobe_1"}, {"desk_1"}, parameters);
  const Layout layout = solved(maker, 1);
  EXPECT_TRUE(holds(layout, "c1"));
  EXPECT_GT(layout.find_object("wardrobe_1")->position[0], layout.find_object("desk_1")->position[0]);
}

TEST(Hints, ATurnHolds) {
  for (const double turn : {0.0, 90.0, 180.0, 270.0, 45.0, 200.0}) {
    SceneMaker maker(5000, 4000);
    maker.add("sofa").at(2500, 2000, 0, turn, false).add("tv_stand").add("armchair");
    const Layout layout = solved(maker, 1);
    EXPECT_DOUBLE_EQ(layout.find_object("sofa_1")->rotation_deg, turn);
  }
}

TEST(Hints, ARelationDecidesBeforeATurn) {
  SceneMaker maker(5000, 4000);
  maker.add("bed").at(1000, 2000, 0, 90, false).relate("againstWall", {"bed_1"}, {"wall3"});
  const Layout layout = solved(maker, 1);
  EXPECT_TRUE(holds(layout, "c1"));
  EXPECT_EQ(layout.find_object("bed_1")->rotation_deg, 0);
  EXPECT_EQ(layout.status, LayoutStatus::kSolved);
}

TEST(Hints, SoDoesLegality) {
  SceneMaker maker(1500, 3200);
  maker.add("bed").sized(1400, 2000, 500).at(750, 1600, 0, 90, false);  // across the room it does not fit
  const Layout layout = solved(maker, 1);
  const double turn = layout.find_object("bed_1")->rotation_deg;
  EXPECT_TRUE(turn == 0 || turn == 180) << turn;
}

}  // namespace
}  // namespace layoutbox::placement
