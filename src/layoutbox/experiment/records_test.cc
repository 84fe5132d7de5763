// What a run's line holds, ratings by people, and the styles that plans share.
#include "layoutbox/experiment/records.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "layoutbox/experiment/rooms_page.h"
#include "layoutbox/experiment/tables.h"

namespace layoutbox::experiment {
namespace {

using testing::HasSubstr;

TEST(Records, ALineComesBackAsItWas) {
  RunRecord record;
  record.scene = "a", record.method = "model@x", record.outcome = "solved";
  record.spent = {2, 900, 80, 0.25, true};
  record.seconds = {{"plan", 0.5}, {"solve", 0.25}};
  FourJudgements four;
  four.single = vlm::figures_of_counts({4, 1, 2, 0, 1, 0, {}, {}, {}, {}, {}});
  four.scene_score = 0.75;
  record.picture = {"judge", "picture", four, std::nullopt};
  RunRecord again;
  read_line(nlohmann::json::parse(line_of(record)), again);
  again.scene = record.scene, again.method = record.method;
  EXPECT_EQ(line_of(again), line_of(record));
  EXPECT_EQ(again.picture.cut_away->scene_score, 0.75);
  EXPECT_FALSE(again.picture.cut_away->prompt_score);
  EXPECT_EQ(record.folder(), "a.model_x.1");
}

TEST(Records, WhatAnswersTook) {
  const Spent spent =
      spent_on(R"([{"tokens": {"request": 10, "response": 5}, "cost": 0.5}, {"tokens": {"request": 1, "response": 2}, "cost": 0}])");
  EXPECT_EQ(spent.requests, 2);
  EXPECT_EQ(spent.request_tokens, 11);
  EXPECT_EQ(spent.response_tokens, 7);
  EXPECT_EQ(spent.cost, 0.5);
  EXPECT_TRUE(spent.cost_known);
  EXPECT_FALSE(spent_on(R"([{"tokens": {"request": 1, "response": 2}, "cost": null}])").cost_known);
  for (const char* none : {"", "{}", "[]", "no"}) EXPECT_EQ(spent_on(none).requests, 0) << none;
}

TEST(Ratings, AreReadAndCorrelated) {
  const auto ratings = read_ratings("id,score,kind,reason,prompt\n\"a, b\",7,place,\"it \"\"leans\"\"\",x\nc,2,,,\n", "one.csv");
  ASSERT_TRUE(ratings);
  EXPECT_EQ((*ratings)[0].room, "a, b");
  EXPECT_EQ((*ratings)[0].reason, "it \"leans\"");
  for (const char* broken : {"id,score\na,0\n", "id,score\na,ten\n", "id\na\n", "id,score\n"})
    EXPECT_FALSE(read_ratings(broken, "x")) << broken;
  std::vector<RunRecord> runs(4);
  Records records;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].ratings = {static_cast<double>(2 * i + 1), static_cast<double>(2 * i + 2)};
    runs[i].judgement.measures = {{"CNT", {static_cast<double>(i), 4}}, {"COL", {4.0 - static_cast<double>(i), 4}}};
    records.push_back(&runs[i]);
  }
  EXPECT_NEAR(rating_over(records)->value, 4.5, 1e-9);
  for (const RatingLink& link : rating_links(records)) {
    if (link.name == "CNT") {
      EXPECT_NEAR(*link.pearson, 1, 1e-9);
    }
    if (link.name == "COL") {
      EXPECT_NEAR(*link.spearman, -1, 1e-9);
    }
  }
  EXPECT_NEAR(*agreement_of({{"x", "a", 1}, {"x", "b", 2}, {"x", "c", 3}, {"y", "a", 4}, {"y", "b", 6}, {"y", "c", 9}}), 1, 1e-9);
  EXPECT_FALSE(agreement_of({{"x", "a", 1}}));
}

TEST(Ranks, EqualValuesShareTheirMean) {
  EXPECT_THAT(vlm::ranks_of(std::vector{3.0, 1.0, 3.0, 9.0}), testing::ElementsAre(2.5, 1, 2.5, 4));
}

TEST(PlanStyles, AreSaidOnce) {
  PlanStyles styles;
  const std::string line = "<polygon points=\"0,0 1,1\" fill=\"#fff\" stroke=\"#333\" stroke-width=\"0.18\"/>\n";
  EXPECT_EQ(styles.shared("<g>\n" + line + line),
            "<g>\n<polygon points=\"0,0 1,1\" class=k0 />\n<polygon points=\"0,0 1,1\" class=k0 />\n");
  EXPECT_EQ(styles.css(), ".k0{fill:#fff;stroke:#333;stroke-width:0.18;}");
  EXPECT_THAT(styles.shared("<text x=\"1\" fill=\"#d00000\">1</text>\n"), HasSubstr("fill=\"#d00000\""));
}

}  // namespace
}  // namespace layoutbox::experiment
