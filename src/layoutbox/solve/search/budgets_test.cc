#include "layoutbox/solve/search/budgets.h"

#include <gtest/gtest.h>

namespace layoutbox::placement {
namespace {

// What a step takes grows with the things that are there: the work of hundreds is bounded, and less the more they are.
TEST(Budgets, HundredsOfThingsAreNotImprovedForEver) {
  const auto improvement = [](std::size_t things) { return budgets_for(100, things).improvement; };
  EXPECT_LT(improvement(20), improvement(60));
  EXPECT_LT(improvement(60), improvement(200));
  EXPECT_LE(improvement(500), improvement(200));
}

TEST(Budgets, TheSearchForSomethingLegalGrowsWithTheThings) {
  EXPECT_EQ(budgets_for(100, 10).finding, budgets_for(100, 20).finding);
  EXPECT_GE(budgets_for(100, 110).finding, 3 * budgets_for(100, 20).finding);
}

}  // namespace
}  // namespace layoutbox::placement
