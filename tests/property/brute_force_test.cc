// The solver against brute force on tiny rooms, in cells of half a metre: what can be is found, what cannot be is proven, and what is named
// as a conflict is one, and a smallest.
//
//   LAYOUTBOX_RANDOM_ROUNDS  a fourth of the rooms (default 100)
//   LAYOUTBOX_RANDOM_SEED    of the first room (default 1)
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>

#include "environment.h"
#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"
#include "tiny_room.h"

namespace layoutbox::placement {
namespace {

TEST(PropertyBruteForce, AgreesOnTinyRooms) {
  if (!describe_cp_sat_library()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  const std::uint64_t rounds = 4 * from_environment("LAYOUTBOX_RANDOM_ROUNDS", 100), first = from_environment("LAYOUTBOX_RANDOM_SEED", 1);
  int possible = 0, impossible = 0, conflicts = 0, minimal = 0, members = 0;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const TinyRoom s = random_room(seed);
    const SceneGraph scene = as_scene(s);
    const bool expected = exists(s, all_of(s));
    (expected ? possible : impossible)++;
    SolveOptions options;
    options.improve = false;
    const auto layout = solve(scene, Catalog::builtin(), options);
    ASSERT_TRUE(layout) << layout.error().message;
    EXPECT_EQ(layout->status == LayoutStatus::kSolved, expected) << (layout->conflicts.empty() ? "" : layout->conflicts[0].sentence);
    if (seed % 8 == 0) expect_sound(*layout);
    if (expected) continue;
    ASSERT_FALSE(layout->conflicts.empty());
    // The first is of the scene as it is; those after it are of what is left of it, and smallest in that.
    const Conflict& conflict = layout->conflicts[0];
    ++conflicts, minimal += conflict.minimal;
    expect_smallest(s, conflict, members);
    options.on_conflict = OnConflict::kFail;
    const auto refused = solve(scene, Catalog::builtin(), options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::kInfeasible) << refused.error().message;
  }
  std::printf("%d rooms with a layout, %d without; %d conflicts, %d of them smallest, of %d members\n", possible, impossible, conflicts,
              minimal, members);
  EXPECT_GT(possible, static_cast<int>(rounds) / 6);
  EXPECT_GT(impossible, static_cast<int>(rounds) / 6);
  EXPECT_GE(minimal * 10, conflicts * 9) << "conflicts are hardly ever shown to be smallest";
}

// Rooms with nothing but too many pieces: what is named is too many, and no fewer would be.
TEST(PropertyBruteForce, CrowdsAreSmallest) {
  if (!describe_cp_sat_library()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  const std::uint64_t rounds = from_environment("LAYOUTBOX_RANDOM_ROUNDS", 100), first = from_environment("LAYOUTBOX_RANDOM_SEED", 1);
  int conflicts = 0, minimal = 0, members = 0;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(static_cast<unsigned>(seed * 104729 + 7));
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    TinyRoom s;
    s.width = 3 + below(2), s.depth = 2 + below(2);
    for (int i = 0, n = 3 + below(2); i < n; ++i) s.sizes.push_back({1 + below(3), 1 + below(2)});
    if (exists(s, all_of(s))) continue;
    SolveOptions options;
    options.improve = false;
    options.on_conflict = seed % 2 == 0 ? OnConflict::kFail : OnConflict::kRelax;
    const auto layout = solve(as_scene(s), Catalog::builtin(), options);
    if (options.on_conflict == OnConflict::kFail) {
      ASSERT_FALSE(layout);
      EXPECT_EQ(layout.error().code, ErrorCode::kInfeasible) << layout.error().message;
      continue;
    }
    ASSERT_TRUE(layout) << layout.error().message;
    ASSERT_FALSE(layout->conflicts.empty());
    ++conflicts, minimal += layout->conflicts[0].minimal;
    expect_smallest(s, layout->conflicts[0], members);
  }
  std::printf("%d crowds, %d of them smallest, of %d members\n", conflicts, minimal, members);
  EXPECT_GT(conflicts, static_cast<int>(rounds) / 10);
  EXPECT_EQ(minimal, conflicts) << "a crowd is said to be no more than enough";
}

// One by a size, one by a sum of widths, one by a proof.
TEST(PropertyConflicts, ThreeKindsAreAllNamed) {
  if (!describe_cp_sat_library()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  SceneMaker maker(7000, 6000);
  maker.add("table").sized(7500, 6500, 700);
  maker.add("bed").sized(2600, 2000, 500).add("wardrobe").sized(4800, 600, 2000);
  maker.relate("againstWall", {"bed_1"}, {"wall3"}).relate("againstWall", {"wardrobe_1"}, {"wall3"});
  maker.add("sofa").add("plant").relate("leftOf", {"plant_1"}, {"sofa_1"}).relate("rightOf", {"plant_1"}, {"sofa_1"});
  const auto layout = solve(maker.make(), Catalog::builtin());
  ASSERT_TRUE(layout) << layout.error().message;
  ASSERT_EQ(layout->conflicts.size(), 3u);
  const auto named = [&](std::vector<std::string> relations, const std::string& object) {
    return std::any_of(layout->conflicts.begin(), layout->conflicts.end(), [&](const Conflict& c) {
      return c.minimal && c.relations == relations && (object.empty() || names(c.objects, object));
    });
  };
  EXPECT_TRUE(named({}, "table_1"));
  EXPECT_TRUE(std::any_of(layout->conflicts.begin(), layout->conflicts.end(), [&](const Conflict& c) {
    return c.minimal && names(c.relations, "c1") && names(c.relations, "c2") && names(c.objects, "wardrobe_1");
  }));
  EXPECT_TRUE(named({"c3", "c4"}, ""));
  SolveOptions options;
  options.on_conflict = OnConflict::kFail;
  const auto refused = solve(maker.make(), Catalog::builtin(), options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().details.size(), 3u);
}

// Pairs of pieces in one large room, each pair with an impossible wish of its own.
TEST(PropertyConflicts, IndependentOnesAreAllNamed) {
  if (!describe_cp_sat_library()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  using Pair = std::pair<const char*, const char*>;
  const std::vector<Pair> kClashing{{"leftOf", "rightOf"}, {"inFrontOf", "behind"}, {"parallel", "perpendicular"},
                                    {"nextTo", "far"},     {"touching", "near"},    {"sameOrientation", "perpendicular"}};
  const std::uint64_t rounds = from_environment("LAYOUTBOX_RANDOM_ROUNDS", 100) / 10, first = from_environment("LAYOUTBOX_RANDOM_SEED", 1);
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(static_cast<unsigned>(seed));
    const std::size_t count = 2 + random() % 3;
    SceneMaker maker(9000, 8000);
    std::vector<Pair> wishes;
    for (std::size_t k = 0; k < count; ++k) {
      const std::string a = "desk_" + std::to_string(k + 1), b = "sofa_" + std::to_string(k + 1);
      wishes.push_back(kClashing[random() % kClashing.size()]);
      maker.add("desk").add("sofa").relate(wishes.back().first, {a}, {b}).relate(wishes.back().second, {a}, {b});
    }
    SolveOptions options;
    options.improve = false;
    options.seed = seed;
    const auto layout = solve(maker.make(), Catalog::builtin(), options);
    ASSERT_TRUE(layout) << layout.error().message;
    EXPECT_EQ(layout->conflicts.size(), count);
    for (std::size_t k = 0; k < count; ++k) {
      const std::vector<std::string> both{"c" + std::to_string(2 * k + 1), "c" + std::to_string(2 * k + 2)};
      const bool named = std::any_of(layout->conflicts.begin(), layout->conflicts.end(), [&](const Conflict& conflict) {
        return conflict.minimal && std::is_permutation(both.begin(), both.end(), conflict.relations.begin(), conflict.relations.end());
      });
      EXPECT_TRUE(named) << wishes[k].first << " and " << wishes[k].second;
    }
    options.on_conflict = OnConflict::kFail;
    const auto refused = solve(maker.make(), Catalog::builtin(), options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().details.size(), count) << "all of them are details of the error";
  }
}

}  // namespace
}  // namespace layoutbox::placement
