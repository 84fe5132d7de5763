// What the solver makes of every relation: it holds where it can, and a conflict names it where it cannot, in the room as written, turned
// by quarter turns and mirrored. The verifier judges what is said to hold.
#include "examples.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "layoutbox/scene/test_turned.h"
#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox::placement {

const std::vector<Example>& examples() {
  static const std::vector<Example> kExamples = [] {
    std::vector<Example> all;
    for (const auto family :
         {paper_examples, room_examples, opening_examples, pair_examples, height_examples, group_examples, space_examples}) {
      const std::vector<Example> some = family();
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }();
  return kExamples;
}

namespace {

struct Turned {
  std::string how;
  SceneGraph scene;
};

// The scene in all eight ways a room can lie.
std::vector<Turned> all_ways(const SceneGraph& scene) {
  std::vector<Turned> ways;
  for (const bool mirror : {false, true}) {
    SceneGraph now = mirror ? mirrored(scene) : scene;
    for (int turns = 0; turns < 4; ++turns) {
      ways.push_back({(mirror ? "mirrored, " : "") + std::string("turned by ") + std::to_string(90 * turns) + " degrees", now});
      now = quarter_turned(std::move(now));
    }
  }
  return ways;
}

std::string failed_checks(const Layout& layout) {
  std::string text;
  for (const Check& check : verify(layout, Catalog::builtin()).checks) {
    if (!check.passed && check.required) text += check.subject + ": " + check.message + "\n";
  }
  return text;
}

class RelationExample : public testing::TestWithParam<Example> {
 protected:
  // The relation this is about: the first of its type.
  static const Relation& relation_of(const SceneGraph& scene, const std::string& name) {
    return *std::find_if(scene.relations.begin(), scene.relations.end(),
                         [&](const Relation& r) { return relation_row(r.type).name == name; });
  }
};

TEST_P(RelationExample, HoldsWhereItCan) {
  SceneMaker maker(5200, 4200, 2700);
  GetParam().possible(maker);
  for (const auto& [how, scene] : all_ways(maker.make())) {
    SCOPED_TRACE(how);
    SolveOptions options;
    options.improve = how == "turned by 0 degrees";
    const auto layout = solve(scene, Catalog::builtin(), options);
    ASSERT_TRUE(layout) << layout.error().message;
    expect_sound(*layout);
    EXPECT_EQ(layout->status, LayoutStatus::kSolved);
    for (const PlacedRelation& r : layout->relations) EXPECT_TRUE(r.held) << relation_row(r.relation.type).name;
    EXPECT_EQ(layout->objects.size(), scene.objects.size());
    EXPECT_EQ(failed_checks(*layout), "");
  }
}

// Ways to walk are looked at on layouts: no proof ever speaks of them.
bool is_proven(RelationType type) { return type != RelationType::kReachable; }

TEST_P(RelationExample, IsNamedWhereItCannot) {
  if (!describe_cp_sat_library()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  SceneMaker maker(3000, 3000, 2600);
  GetParam().impossible(maker);
  const SceneGraph written = maker.make();
  const std::string id = relation_of(written, GetParam().relation).id;
  const std::vector<Turned> ways = all_ways(written);
  for (const std::size_t way : {0, 1, 7}) {  // as written, turned, and turned and mirrored
    const auto& [how, scene] = ways[way];
    SCOPED_TRACE(how);
    SolveOptions options;
    options.improve = false;
    const auto layout = solve(scene, Catalog::builtin(), options);
    ASSERT_TRUE(layout) << layout.error().message;
    expect_sound(*layout);
    EXPECT_EQ(layout->status, LayoutStatus::kRelaxed);
    EXPECT_FALSE(layout->relaxed.empty());
    EXPECT_EQ(failed_checks(*layout), "");
    if (!is_proven(find_relation(GetParam().relation)->type)) continue;
    const bool named = std::any_of(layout->conflicts.begin(), layout->conflicts.end(), [&](const Conflict& conflict) {
      return conflict.minimal && std::find(conflict.relations.begin(), conflict.relations.end(), id) != conflict.relations.end();
    });
    EXPECT_TRUE(named) << (layout->conflicts.empty() ? "no conflict at all" : layout->conflicts[0].sentence);
  }
}

INSTANTIATE_TEST_SUITE_P(All, RelationExample, testing::ValuesIn(examples()),
                         [](const auto& one) { return std::string(one.param.relation); });

}  // namespace
}  // namespace layoutbox::placement
