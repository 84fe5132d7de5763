// Questions, and what answers to them are worth.
#include <gtest/gtest.h>

#include "layoutbox/judge/vlm/vlm_judge.h"
#include "layoutbox/verify/test_room.h"

namespace layoutbox::vlm {
namespace {

Layout bedroom() {
  checks::TestRoom room;
  room.door("door1", "wall1", 0.4).window("window1", "wall3", 1.0);
  room.add("bed_1", "bed", {1.6, 2.0, 0.5}, {2.5, 3.0, 0, 0});
  room.add("stand_1", "nightstand", {0.45, 0.4, 0.5}, {1.4, 3.8, 0, 0});
  room.add("lamp_1", "table_lamp", {0.2, 0.2, 0.4}, {1.4, 3.8, 0.5, 0}, "stand_1");
  room.add("wardrobe_1", "wardrobe", {1.2, 0.6, 2.0}, {4.7, 1.5, 0, 270});
  room.relation(RelationType::kLeftOf, {"stand_1"}, {"bed_1"}).relation(RelationType::kOn, {"lamp_1"}, {"stand_1"});
  room.relation(RelationType::kAgainstWall, {"wardrobe_1"});
  return room.layout;
}

TEST(VlmQuestions, AsManyFalseAsTrue) {
  QuestionOptions options;
  options.singles = 5;
  options.multis = 3;
  for (options.seed = 1; options.seed <= 20; ++options.seed) {
    const std::vector<RoomQuestion> questions = draw_questions(bedroom(), Catalog::builtin(), options);
    int so = 0, multi = 0;
    for (const RoomQuestion& question : questions) {
      so += question.truth;
      multi += question.kind == QuestionKind::kMulti;
      EXPECT_EQ(question.truth, question.id.find("false") == std::string::npos) << question.text;
      EXPECT_EQ(question.text.find('{'), std::string::npos) << question.text;
      if (question.kind == QuestionKind::kSingle) {
        EXPECT_EQ(question.hops.size(), 1u);
        continue;
      }
      EXPECT_GE(question.hops.size(), 2u);
      EXPECT_LE(question.hops.size(), 4u);
      const auto held = std::count_if(question.hops.begin(), question.hops.end(), [](const Hop& hop) { return hop.holds; });
      EXPECT_EQ(held, static_cast<std::ptrdiff_t>(question.hops.size()) - !question.truth);
    }
    EXPECT_EQ(questions.size(), 16u);
    EXPECT_EQ(2 * so, static_cast<int>(questions.size()));
    EXPECT_EQ(multi, 6);
  }
}

TEST(VlmQuestions, TheSameSeedAsksTheSame) {
  const auto texts = [](std::uint64_t seed) {
    std::string text;
    for (const RoomQuestion& question : draw_questions(bedroom(), Catalog::builtin(), {seed, 3, 2})) text += question.text + "\n";
    return text;
  };
  EXPECT_EQ(texts(1), texts(1));
  EXPECT_NE(texts(1), texts(2));
}

TEST(VlmQuestions, WordsOfThings) {
  const Layout layout = bedroom();
  EXPECT_EQ(sentence_of(layout.relations[0].relation, layout), "the nightstand stands to the left of the bed");
  EXPECT_EQ(sentence_of(layout.relations[2].relation, layout), "the wardrobe stands with its back against a wall");
}

TEST(VlmQuestions, OneThingAloneIsNotAskedAbout) {
  checks::TestRoom room;
  room.add("bed_1", "bed", {1.6, 2.0, 0.5}, {2.5, 3.0, 0, 0});
  EXPECT_TRUE(draw_questions(room.layout, Catalog::builtin(), {}).empty());
}

std::vector<Answered> answers(int true_yes, int false_no, int false_yes, int true_no, int neither = 0) {
  std::vector<Answered> list;
  list.insert(list.end(), static_cast<std::size_t>(true_yes), {true, YesNo::kYes});
  list.insert(list.end(), static_cast<std::size_t>(false_no), {true, YesNo::kNo});
  list.insert(list.end(), static_cast<std::size_t>(false_yes), {false, YesNo::kYes});
  list.insert(list.end(), static_cast<std::size_t>(true_no), {false, YesNo::kNo});
  list.insert(list.end(), static_cast<std::size_t>(neither), {false, YesNo::kNeither});
  return list;
}

TEST(VlmFigures, AsInTextbooks) {
  // Cohen's own kind of table: 20 and 15 agreed, 5 and 10 not: kappa 0.4.
  const AnswerFigures figures = figures_of(answers(20, 10, 5, 15));
  EXPECT_NEAR(figures.accuracy->value, 0.7, 1e-12);
  EXPECT_NEAR(figures.precision->value, 0.8, 1e-12);
  EXPECT_NEAR(figures.recall->value, 2.0 / 3, 1e-12);
  EXPECT_NEAR(figures.kappa->value, 0.4, 1e-12);
  EXPECT_LT(figures.kappa->low, 0.4);
  // Wilson's interval of 35 of 50.
  EXPECT_NEAR(figures.accuracy->low, 0.5625, 5e-4);
  EXPECT_NEAR(figures.accuracy->high, 0.8090, 5e-4);
}

TEST(VlmFigures, WhoSaysYesToEverythingKnowsNothing) {
  const AnswerFigures figures = figures_of(answers(10, 0, 10, 0));
  EXPECT_EQ(figures.accuracy->value, 0.5);
  EXPECT_EQ(figures.recall->value, 1);
  EXPECT_EQ(figures.kappa->value, 0);
}

TEST(VlmFigures, NeitherIsWrongButNoAnswer) {
  const AnswerFigures figures = figures_of(answers(5, 0, 0, 3, 2));
  EXPECT_EQ(figures.accuracy->value, 0.8);
  EXPECT_EQ(figures.kappa->value, 1);
  EXPECT_EQ(figures.neither_rate->value, 0.2);
  EXPECT_FALSE(figures_of({}).accuracy);
}

TEST(VlmFigures, Correlation) {
  const std::vector<double> a{0.1, 0.5, 0.9}, up{1, 2, 3}, flat{1, 1, 1};
  EXPECT_NEAR(*correlation(a, up), 1, 1e-12);
  EXPECT_FALSE(correlation(a, flat));
  EXPECT_FALSE(correlation(std::span(a).first(2), std::span(up).first(2)));
}

TEST(VlmJudge, GeometryAnswersItsOwnQuestions) {
  const RoomAnswers room = answer_by_geometry("room", bedroom(), Catalog::builtin(), {});
  ASSERT_FALSE(room.questions.empty());
  const PanelFigures figures = figures_of_rooms({room});
  EXPECT_EQ(figures.all.accuracy->value, 1);
  EXPECT_EQ(figures.all.kappa->value, 1);
}

}  // namespace
}  // namespace layoutbox::vlm
