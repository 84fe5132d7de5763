// Every row of the relation table has its limits and its examples, each once where one is enough: the cases held, just held, just broken,
// impossible, turned and mirrored follow from them.
#include <gtest/gtest.h>

#include <algorithm>

#include "examples.h"
#include "limits.h"

namespace layoutbox {
namespace {

TEST(RelationCases, EveryRowHasALimit) {
  for (const RelationRow& row : relation_table()) {
    const auto about = [&](const checks::Limit& limit) { return limit.type == row.type; };
    EXPECT_TRUE(std::any_of(checks::limits().begin(), checks::limits().end(), about))
        << row.name << ": add what just holds, and the move that breaks it, to tests/relations/*_limits.cc";
  }
}

TEST(RelationCases, EveryRowHasItsLimitSeenByTheSolver) {
  for (const RelationRow& row : relation_table()) {
    const auto about = [&](const checks::Limit& limit) { return limit.type == row.type && limit.solver; };
    EXPECT_TRUE(std::any_of(checks::limits().begin(), checks::limits().end(), about)) << row.name;
  }
}

TEST(RelationCases, EveryRowHasAScenePossibleAndAnImpossibleOne) {
  for (const RelationRow& row : relation_table()) {
    const auto& all = placement::examples();
    const auto about = [&](const placement::Example& example) { return example.relation == row.name; };
    ASSERT_EQ(std::count_if(all.begin(), all.end(), about), 1) << row.name << ": add it to tests/relations/*_examples.cc";
    const placement::Example& example = *std::find_if(all.begin(), all.end(), about);
    for (const auto fill : {example.possible, example.impossible}) {
      placement::SceneMaker maker(3000, 3000, 2600);
      fill(maker);
      const std::vector<Relation>& relations = maker.raw().relations;
      EXPECT_TRUE(std::any_of(relations.begin(), relations.end(), [&](const Relation& r) { return r.type == row.type; })) << row.name;
    }
  }
}

}  // namespace
}  // namespace layoutbox
