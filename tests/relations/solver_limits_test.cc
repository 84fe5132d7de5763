// What the solver says of every relation at its limit, everything standing fixed: where it just holds it is claimed, where it is just
// broken it is a conflict that names it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/scene/layout_scene.h"
#include "layoutbox/solve/solver.h"
#include "limits.h"

namespace layoutbox::checks {
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

// The solver knows things at odd angles by the box around them: its limits are those of quarter turns.
bool turned_by_quarters(const Layout& layout) {
  return std::all_of(layout.objects.begin(), layout.objects.end(),
                     [](const PlacedObject& object) { return std::remainder(object.rotation_deg, 90) == 0; });
}

class SolverLimit : public testing::TestWithParam<Limit> {};

TEST_P(SolverLimit, JustHeldIsClaimed) {
  const Layout limit = furnished(GetParam(), 0);
  if (!GetParam().solver) GTEST_SKIP() << "taken tighter";
  if (!turned_by_quarters(limit)) GTEST_SKIP() << "stands at an odd angle";
  const auto layout = answer(fixed_scene(limit), OnConflict::kFail);
  ASSERT_TRUE(layout) << layout.error().message;
  ASSERT_EQ(layout->relations.size(), 1u);
  EXPECT_TRUE(layout->relations[0].held);
}

// Or who is fixed where it cannot be is left out.
TEST_P(SolverLimit, JustBrokenIsNeverClaimed) {
  const auto layout = answer(fixed_scene(furnished(GetParam(), 1)), OnConflict::kRelax);
  ASSERT_TRUE(layout) << layout.error().message;
  EXPECT_EQ(layout->status, LayoutStatus::kRelaxed);
  if (layout->find_object(GetParam().breaks.who) != nullptr) {
    for (const PlacedRelation& placed : layout->relations) EXPECT_FALSE(placed.held);
  }
  const bool listed = std::any_of(layout->relaxed.begin(), layout->relaxed.end(),
                                  [&](const Relaxation& r) { return r.relation == "c1" || r.relation == GetParam().breaks.who; });
  EXPECT_TRUE(listed);
}

INSTANTIATE_TEST_SUITE_P(All, SolverLimit, testing::ValuesIn(limits()), [](const auto& one) { return test_name(one.param.name); });

}  // namespace
}  // namespace layoutbox::checks
