// What the solver says of every relation at its limit, everything standing fixed: where it just holds it is claimed, where it is just
// broken it is a conflict that names it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/scene/layout_scene.h"
#include "layoutbox/solve/solver.h"
#include "limits.h"

namespace layoutbox::judge {
namespace {

SceneGraph fixed_scene(Layout layout) {
  for (PlacedObject& object : layout.objects) object.fixed = true;
  NormalizeOptions options;
  options.default_openings = false;
  auto scene = normalize_scene(scene_of(layout), Catalog::builtin(), options);
  EXPECT_TRUE(scene) << scene.error().message;
  return scene ? *std::move(scene) : SceneGraph{};
}

Result<Layout> answer(const SceneGraph& scene, OnConflict on_conflict) {
  SolveOptions options;
  options.improve = false;
  options.on_conflict = on_conflict;
  return solve(scene, Catalog::builtin(), options);
}

class SolverLimit : public testing::TestWithParam<Limit> {};

TEST_P(SolverLimit, JustHeldIsClaimedJustBrokenIsNamed) {
  if (!GetParam().solver) GTEST_SKIP() << "not a place where the solver lets it be";
  const SceneGraph held = fixed_scene(furnished(GetParam(), 0));
  const auto layout = answer(held, OnConflict::kFail);
  EXPECT_TRUE(layout) << layout.error().message;
  EXPECT_TRUE(!layout || layout->relations[0].held) << "held";
  const SceneGraph broken = fixed_scene(furnished(GetParam(), 1));
  const auto relaxed = answer(broken, OnConflict::kRelax);
  ASSERT_TRUE(relaxed) << relaxed.error().message;
  EXPECT_FALSE(relaxed->relations[0].held) << "broken";
  ASSERT_EQ(relaxed->relaxed.size(), 1u);
  EXPECT_EQ(relaxed->relaxed[0].relation, "c1");
  EXPECT_EQ(relaxed->conflicts.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(All, SolverLimit, testing::ValuesIn(limits()), [](const auto& one) { return test_name(one.param.name); });

}  // namespace
}  // namespace layoutbox::judge
