// Things at odd angles: the solver sees much of them by the upright box around, the verifier sees them as they stand; what the one says
// to hold the other must not refute.
//
//   LAYOUTBOX_RANDOM_ROUNDS  scenes (default 30)
//   LAYOUTBOX_RANDOM_SEED    of the first scene (default 1)
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "environment.h"
#include "layoutbox/catalog/normalize.h"
#include "layoutbox/solve/solver.h"
#include "layoutbox/verify/verify.h"
#include "synthetic.h"

namespace layoutbox::synthetic {
namespace {

// Relations that are said to hold and do not.
std::vector<std::string> false_claims(const Layout& layout) {
  std::vector<std::string> claims;
  const Report report = verify(layout, Catalog::builtin());
  for (std::size_t i = 0; i < layout.relations.size(); ++i) {
    const auto check = std::find_if(report.checks.begin(), report.checks.end(),
                                    [&](const Check& c) { return c.pointer == "/relations/" + std::to_string(i); });
    if (layout.relations[i].held && check != report.checks.end() && !check->passed) claims.push_back(check->message);
  }
  return claims;
}

// A scene in which some of what stands on the floor is fixed at an odd angle somewhere in the room.
SceneGraph turned_scene(std::uint64_t seed) {
  SceneOptions options;
  options.seed = seed, options.objects = 5, options.relations = 7, options.planted = false;
  SceneGraph scene = make_scene(options).scene;
  std::mt19937_64 random(seed);
  Point low = scene.room.polygon[0], high = low;
  for (const Point& p : scene.room.polygon) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  int left = 2;
  for (SceneObject& object : scene.objects) {
    if (left == 0 || object.mount.value_or(Catalog::builtin().entry_or_nearest(object.category).mount) != Mount::kFloor) continue;
    --left;
    const auto between = [&](Mm a, Mm b) { return a + static_cast<Mm>(random() % static_cast<std::uint64_t>(b - a + 1)); };
    object.fixed = true;
    object.hint.position = {
        {static_cast<double>(between(low.x + 500, high.x - 500)), static_cast<double>(between(low.y + 500, high.y - 500)), 0}};
    const int turn = random() % 3 == 0 ? between(1, 359) : 15 * between(1, 23);
    object.hint.rotation_deg = turn;
  }
  return scene;
}

TEST(Turned, NothingIsSaidToHoldThatDoesNot) {
  const std::uint64_t first = from_environment("LAYOUTBOX_RANDOM_SEED", 1), rounds = from_environment("LAYOUTBOX_RANDOM_ROUNDS", 30);
  int held = 0, solved = 0;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    SolveOptions options;
    options.seed = seed, options.effort = 10, options.improve = seed % 4 == 0;
    const SceneGraph scene = turned_scene(seed);
    const auto layout = solve(scene, Catalog::builtin(), options);
    if (!layout) continue;  // what is fixed overlaps
    ++solved;
    for (const std::string& claim : false_claims(*layout)) ADD_FAILURE() << claim;
    held +=
        static_cast<int>(std::count_if(layout->relations.begin(), layout->relations.end(), [](const PlacedRelation& r) { return r.held; }));
  }
  EXPECT_GT(solved, static_cast<int>(rounds) / 2);
  EXPECT_GT(held, static_cast<int>(rounds));
}

}  // namespace
}  // namespace layoutbox::synthetic
