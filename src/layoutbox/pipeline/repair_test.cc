// The loop between a planner and the solver, with a planner that has its scenes written down: no model, no network.
#include "layoutbox/pipeline/repair.h"

#include <gmock/gmock.h>

#include <deque>

#include "layoutbox/base/files.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Scripted final : public Planning {
 public:
  Result<Proposal> propose() override { return next(); }
  Result<Proposal> revise(const Feedback& feedback) override {
    heard.push_back(feedback);
    return next();
  }
  std::optional<Proposal> salvage() const override { return std::nullopt; }
  void note(ProposalOutcome result) override { outcomes.push_back(result.outcome); }
  int attempts() const override { return attempts_; }
  std::string record() const override { return "[]"; }
  std::string cost_in_words() const override { return "nothing"; }
  Error no_usable_scene() const override { return {ErrorCode::kNotFound, "nothing usable", {}, {}, {}}; }
  Result<std::string> describe_first_request() const override { return std::string(); }

  std::deque<Result<Proposal>> answers;
  std::vector<Feedback> heard;
  std::vector<std::string> outcomes;

 private:
  Result<Proposal> next() {
    ++attempts_;
    if (answers.empty()) return fail(ErrorCode::kNetwork, "no more scenes");
    auto answer = std::move(answers.front());
    answers.pop_front();
    return answer;
  }

  int attempts_ = 0;
};

Proposal scene_of_example(const char* name) {
  const std::string text = read_file(std::string(LAYOUTBOX_SOURCE_FOLDER) + "/examples/scenes/" + name).value();
  return {read_scene(text).value(), text, false, {}};
}

class Repair : public testing::Test {
 protected:
  Result<PlannedRoom> run() { return loop_.run(); }

  Scripted planning_;
  GenerateOptions options_;
  RepairLoop loop_{planning_, Catalog::builtin(), options_};
};

TEST_F(Repair, ASceneThatHasALayoutIsTaken) {
  planning_.answers = {scene_of_example("bedroom.json")};
  const auto room = run();
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_THAT(room->layout.relaxed, IsEmpty());
  EXPECT_THAT(planning_.outcomes, ElementsAre("solved"));
  EXPECT_THAT(planning_.heard, IsEmpty());
}

TEST_F(Repair, AConflictGoesBackWithItsReasonAndWaysOut) {
  planning_.answers = {scene_of_example("too-much.json"), scene_of_example("bedroom.json")};
  ASSERT_TRUE(run());
  EXPECT_THAT(planning_.outcomes, ElementsAre("conflict", "solved"));
  ASSERT_EQ(planning_.heard.size(), 1u);
  const Feedback& feedback = planning_.heard[0];
  EXPECT_EQ(feedback.kind, Feedback::Kind::kConflict);
  EXPECT_THAT(feedback.text, HasSubstr("There is no layout for this scene: "));
  EXPECT_THAT(feedback.text, HasSubstr("\nWays out, "));
  EXPECT_THAT(feedback.categories, Not(IsEmpty()));
  EXPECT_GE(feedback.may_go, 1u);
}

TEST_F(Repair, WhatIsWrongWithASceneGoesBack) {
  Proposal broken;
  broken.faults = {{ErrorCode::kSchema, "no room", "/room", {}, {}}};
  Proposal impossible = scene_of_example("bedroom.json");
  impossible.scene->room.walls.clear();
  impossible.scene->room.polygon = {{0, 0}, {4000, 3000}, {4000, 0}, {0, 3000}};
  planning_.answers = {broken, impossible, scene_of_example("bedroom.json")};
  ASSERT_TRUE(run());
  ASSERT_EQ(planning_.heard.size(), 2u);
  EXPECT_EQ(planning_.heard[0].kind, Feedback::Kind::kFaults);
  EXPECT_THAT(planning_.heard[0].faults, Contains(testing::Field(&Error::pointer, "/room")));
  EXPECT_THAT(planning_.heard[1].faults, Not(IsEmpty()));
  EXPECT_THAT(planning_.outcomes, ElementsAre("faults", "solved")) << "of scenes, not of answers without one";
}

TEST_F(Repair, TheSameSceneAgainEndsInTheBestOfBefore) {
  Proposal again = scene_of_example("too-much.json");
  again.repeated = true;
  planning_.answers = {scene_of_example("too-much.json"), again};
  const auto room = run();
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_THAT(room->layout.relaxed, Not(IsEmpty()));
  EXPECT_THAT(planning_.outcomes, ElementsAre("conflict", "same as before"));
}

TEST_F(Repair, APlannerThatGivesNothingEndsIt) {
  planning_.answers = std::deque<Result<Proposal>>(5, Proposal{});
  EXPECT_EQ(run().error().message, "nothing usable");
  EXPECT_EQ(planning_.attempts(), options_.repair.max_attempts);
  EXPECT_EQ(RepairLoop(planning_, Catalog::builtin(), options_).run().error().message, "nothing usable") << "no attempts are left";
}

TEST_F(Repair, ABrokenLineCostsNothingThatIsThere) {
  planning_.answers = {scene_of_example("too-much.json")};
  EXPECT_TRUE(run()) << "the scene before is better than nothing";
  Scripted stopped;
  stopped.answers = {scene_of_example("too-much.json"), fail(ErrorCode::kInterrupted, "stopped")};
  EXPECT_EQ(RepairLoop(stopped, Catalog::builtin(), options_).run().error().code, ErrorCode::kInterrupted);
}

TEST_F(Repair, APictureThatFailedIsSaid) {
  planning_.answers = {scene_of_example("bedroom.json"), scene_of_example("bedroom-bare.json")};
  ASSERT_TRUE(run());
  ASSERT_TRUE(loop_.run_again("its picture failed: no light"));
  EXPECT_EQ(planning_.heard.back().kind, Feedback::Kind::kFailure);
  EXPECT_EQ(planning_.heard.back().text, "its picture failed: no light");
}

}  // namespace
}  // namespace layoutbox
