// What the verifier says of every relation at its limit: held, held after a move of less than the slack, broken after a move of more; and
// the same in the room turned by quarter turns, and mirrored.
#include "limits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace layoutbox::checks {
namespace {

const Check& relation_check(const Report& report) { return *find_check(report, "relation"); }

class RelationLimit : public testing::TestWithParam<Limit> {};

void expect_limit(const Limit& limit, int turns, bool mirror) {
  struct Step {
    double share;
    bool held;
  };
  for (const Step step : {Step{0, true}, Step{0.2, true}, Step{1, false}}) {
    Layout layout = furnished(limit, step.share);
    if (mirror) layout = mirrored(std::move(layout));
    for (int i = 0; i < turns; ++i) layout = quarter_turned(std::move(layout));
    const Report report = verify(layout, Catalog::builtin());
    EXPECT_EQ(relation_check(report).passed, step.held) << (mirror ? "mirrored, " : "") << "turned by " << 90 * turns
                                                        << " degrees, moved by " << step.share << ": " << relation_check(report).message;
  }
}

TEST_P(RelationLimit, HeldJustHeldJustBroken) { expect_limit(GetParam(), 0, false); }

TEST_P(RelationLimit, InATurnedRoom) {
  for (const int turns : {1, 2, 3}) expect_limit(GetParam(), turns, false);
}

TEST_P(RelationLimit, InAMirroredRoom) {
  for (const int turns : {0, 1, 2, 3}) expect_limit(GetParam(), turns, true);
}

TEST_P(RelationLimit, TheMessageHasFigures) {
  const Report report = verify(furnished(GetParam(), 1), Catalog::builtin());
  EXPECT_THAT(relation_check(report).message, testing::StartsWith(std::string(relation_row(GetParam().type).name) + " does not hold: "));
}

INSTANTIATE_TEST_SUITE_P(All, RelationLimit, testing::ValuesIn(limits()), [](const auto& one) { return test_name(one.param.name); });

}  // namespace
}  // namespace layoutbox::checks
