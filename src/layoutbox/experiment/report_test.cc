// The report's page and chart, of records made up here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "layoutbox/experiment/charts.h"
#include "layoutbox/experiment/suite.h"

namespace layoutbox::experiment {
namespace {

using testing::HasSubstr;
using testing::Not;

RunRecord record(const std::string& method, double collisions, bool everything) {
  RunRecord run;
  run.scene = "a";
  run.method = method;
  run.outcome = "solved";
  run.judgement.measures = {{"CNT", {1, 1}}, {"COL", {collisions, 4}}, {"ACC", {1.2, 2}}};
  run.judgement.everything = everything;
  run.judgement.error = "no plan here";
  return run;
}

Suite suite() {
  Suite made;
  made.name = "made up";
  made.scenes.emplace_back();
  made.scenes.back().id = "a";
  made.scenes.back().prompt = "A bed & a <desk>.";
  return made;
}

TEST(ExperimentPage, OneFileThatSaysWhatIsMissing) {
  ExperimentOutcome outcome;
  outcome.records = {record("pipeline", 0, true), record("random", 2, false)};
  outcome.skipped = {"model: no model is at hand", "one-step: no model is at hand"};
  const std::string page = experiment_html(suite(), outcome, {});
  EXPECT_THAT(page, HasSubstr("A bed &amp; a &lt;desk&gt;."));
  EXPECT_THAT(page, HasSubstr("Not run, as no model is at hand: model, one-step."));
  EXPECT_THAT(page, HasSubstr("COL 50 %: objects that overlap another"));
  EXPECT_THAT(page, HasSubstr("ACC 60 %"));
  for (const char* elsewhere : {"http://", "https://", "<script", "<link"}) EXPECT_THAT(page, Not(HasSubstr(elsewhere)));
}

TEST(ExperimentChart, ADotAMethodAndMeasure) {
  ExperimentOutcome outcome;
  outcome.records = {record("pipeline", 0, true), record("random", 2, false)};
  const std::string chart = shares_chart(by_method(outcome));
  std::size_t dots = 0;
  for (std::size_t at = chart.find("<circle"); at != std::string::npos; at = chart.find("<circle", at + 1)) ++dots;
  EXPECT_EQ(dots, 8u);  // everything, CNT, COL, ACC of each
  EXPECT_THAT(chart, HasSubstr("COL (less)"));
}

}  // namespace
}  // namespace layoutbox::experiment
