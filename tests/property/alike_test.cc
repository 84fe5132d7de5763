// The same room mirrored, turned and shifted gets equally good answers: as many layouts, as many things given up, and on average the same
// score. (The search is no mirror image of itself: single rooms may differ a little.)
//
//   LAYOUTBOX_RANDOM_ROUNDS  a quarter of the scenes (default 100)
//   LAYOUTBOX_RANDOM_SEED    of the first scene (default 1)
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "environment.h"
#include "layoutbox/scene/test_turned.h"
#include "layoutbox/solve/solver.h"
#include "layoutbox/verify/verify.h"
#include "synthetic.h"

namespace layoutbox::synthetic {
namespace {

// In a shifted room a millimetre is a millimetre; relations that speak of the middle of odd lengths stay as they are.
constexpr Mm kShiftX = 1230, kShiftY = 2340;

std::map<std::string, SceneGraph> others(const SceneGraph& scene) {
  return {{"mirrored", mirrored(scene)},
          {"turned by 90 degrees", quarter_turned(scene)},
          {"turned by 180 degrees", quarter_turned(quarter_turned(scene))},
          {"mirrored and turned by 270 degrees", quarter_turned(quarter_turned(quarter_turned(mirrored(scene))))},
          {"shifted", shifted(scene, kShiftX, kShiftY)}};
}

struct Sum {
  int asked = 0, solved = 0, relaxed_relations = 0;
  double score = 0;

  void add(const Result<Layout>& layout) {
    ++asked;
    if (!layout) return;
    solved += layout->status == LayoutStatus::kSolved;
    relaxed_relations += static_cast<int>(layout->relaxed.size());
    score += layout->score;
  }
  double mean() const { return score / asked; }
};

TEST(PropertyAlike, MirroredTurnedAndShiftedRoomsGetEquallyGoodLayouts) {
  const std::uint64_t rounds = from_environment("LAYOUTBOX_RANDOM_ROUNDS", 100) / 4, first = from_environment("LAYOUTBOX_RANDOM_SEED", 1);
  Sum plain;
  std::map<std::string, Sum> sums;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    SceneOptions scene_options;
    scene_options.seed = seed;
    const SceneGraph scene = make_scene(scene_options).scene;
    SolveOptions options;
    options.effort = 60;
    plain.add(solve(scene, Catalog::builtin(), options));
    for (const auto& [how, other] : others(scene)) {
      const auto layout = solve(other, Catalog::builtin(), options);
      sums[how].add(layout);
      ASSERT_TRUE(layout) << how << ", seed " << seed << ": " << layout.error().message;
      for (const Check& check : verify(*layout, Catalog::builtin()).checks) {
        EXPECT_TRUE(check.passed || !check.required) << how << ", seed " << seed << ": " << check.subject << ": " << check.message;
      }
    }
  }
  std::printf("as written: %d of %d solved, %d given up, mean score %.4f\n", plain.solved, plain.asked, plain.relaxed_relations,
              plain.mean());
  // Chance alone: a share of a score's spread, less the more scenes there are.
  const double allowed = 0.15 / std::sqrt(static_cast<double>(plain.asked));
  for (const auto& [how, sum] : sums) {
    std::printf("%s: %d solved, %d given up, mean score %.4f\n", how.c_str(), sum.solved, sum.relaxed_relations, sum.mean());
    EXPECT_NEAR(sum.mean(), plain.mean(), allowed) << how;
    EXPECT_NEAR(sum.solved, plain.solved, 1 + plain.asked / 20) << how;
  }
}

}  // namespace
}  // namespace layoutbox::synthetic
