// What a run writes, under which names, who may write, and in what form.
#include <gmock/gmock.h>

#include "layoutbox/base/files.h"
#include "layoutbox/pipeline/artefacts.h"
#include "layoutbox/pipeline/batch_input.h"
#include "layoutbox/pipeline/folder_lock.h"
#include "layoutbox/pipeline/run_record.h"
#include "layoutbox/pipeline/tar.h"
#include "layoutbox/pipeline/variants.h"

namespace layoutbox {
namespace {

using testing::HasSubstr;

TEST(PreparePlan, NothingComesWithWhatAModelPlanned) {
  const Catalog& catalog = Catalog::builtin();
  auto plan = make_offline_planner(catalog)->plan("A bedroom with a bed and a desk.", {});
  ASSERT_TRUE(plan);
  const auto by_rules = prepare_plan(*plan, catalog, {});
  ASSERT_TRUE(by_rules);
  EXPECT_GT(by_rules->objects.size(), 2u);
  plan->by_model = true;
  const auto by_model = prepare_plan(*plan, catalog, {});
  ASSERT_TRUE(by_model);
  EXPECT_EQ(by_model->objects.size(), 2u);
}

// A desk with who sits behind it, and a recliner and a lamp across from it: no guessed study is deep enough.
TEST(Generate, ARoomThatNobodyMeasuredGrowsUntilAllHasAPlace) {
  const Catalog& catalog = Catalog::builtin();
  const auto planner = make_offline_planner(catalog);
  const std::string text =
      "Writing desk close to the window, chair tucked in behind it. A leather recliner is set across from the desk, with a floor lamp just "
      "behind the recliner.";
  GenerateOptions options;
  options.pictures = false;
  for (const bool measured : {false, true}) {
    const TemporaryFolder folder = TemporaryFolder::make("test").value();
    const std::string prompt = (measured ? "A study, 3.6 x 3.2 m. " : "A study. ") + text;
    const auto made = generate(prompt, *planner, catalog, folder.path() / "out", options);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(made->layout.relaxed.empty(), !measured);
    EXPECT_EQ(made->scene.room.polygon[2].x > 3600, !measured);
  }
}

// … nor is its furniture made smaller than usual for it.
TEST(Generate, ARoomThatNobodyMeasuredGrowsRatherThanItsFurnitureShrinks) {
  const Catalog& catalog = Catalog::builtin();
  const auto planner = make_offline_planner(catalog);
  GenerateOptions options;
  options.pictures = false;
  for (const char* prompt :
       {"A writer's den. Writing desk close to the window, chair tucked in behind it, typewriter and desk lamp on top. A leather recliner "
        "is "
        "set across from the desk, with a floor lamp just behind the recliner.",
        "A nap room. Six cots rest on a carpet in the center of the room. A rocking chair by the window faces the cots."}) {
    const TemporaryFolder folder = TemporaryFolder::make("test").value();
    const auto made = generate(prompt, *planner, catalog, folder.path() / "out", options);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_GT(made->layout.score_terms.at("sizes"), 0.6) << prompt;
  }
}

TEST(Artefacts, EveryNameOfTheTableIsAnOutput) {
  for (const Artefact& one : artefacts()) {
    EXPECT_TRUE(is_output_name(one.file)) << one.file;
    EXPECT_EQ(is_output_name(variant_name(std::string(one.file), 1)), one.each_variant) << one.file;
    EXPECT_TRUE(!one.packed || one.make != nullptr) << one.file << " is packed, and nothing here makes it";
  }
  for (const char* other : {"", "notes.txt", "scene.json.bak", "layout-2", "run-2.json"}) {
    EXPECT_FALSE(is_output_name(other)) << other;
  }
}

TEST(Artefacts, VariantsAreNumberedFromTwo) {
  EXPECT_EQ(variant_name("layout.json", 0), "layout.json");
  EXPECT_EQ(variant_name("layout.json", 1), "layout-2.json");
  EXPECT_EQ(variant_name("a.b/scene.glb", 2), "a.b/scene-3.glb");
}

TEST(FolderLocks, OneRunAtATime) {
  const TemporaryFolder folder = TemporaryFolder::make("test").value();
  {
    const auto first = FolderLock::acquire(folder.path());
    ASSERT_TRUE(first);
    EXPECT_EQ(FolderLock::acquire(folder.path()).error().code, ErrorCode::kIo);
  }
  EXPECT_TRUE(FolderLock::acquire(folder.path())) << "it ends with its owner";
}

TEST(Tar, HoldsWholeBlocksAndNothingOfThisMachine) {
  std::string tar, again;
  add_to_tar(tar, "0001.scene.json", "{}");
  add_to_tar(again, "0001.scene.json", "{}");
  EXPECT_EQ(tar, again);
  ASSERT_EQ(tar.size(), 1024u);
  EXPECT_EQ(tar.substr(0, 15), "0001.scene.json");
  EXPECT_EQ(tar.substr(257, 5), "ustar");
  EXPECT_EQ(tar.substr(512, 2), "{}");
  unsigned sum = 0;
  for (std::size_t i = 0; i < 512; ++i) sum += i >= 148 && i < 156 ? 32u : static_cast<unsigned char>(tar[i]);
  EXPECT_EQ(std::stoul(tar.substr(148, 6), nullptr, 8), sum);
  add_to_tar(tar, "empty", "");
  EXPECT_EQ(tar.size(), 1536u);
}

TEST(BatchInput, ALineThatIsWrongIsOneRoomLess) {
  const auto lines = read_batch(
      "{\"id\": \"a\", \"prompt\": \"A study.\", \"seed\": 7}\n{\"colour\": \"red\"}\n\n{\"id\": \"a\", \"prompt\": \"A hall.\"}\n");
  ASSERT_TRUE(lines) << lines.error().message;
  ASSERT_EQ(lines->size(), 3u);
  EXPECT_EQ((*lines)[0].seed, 7u);
  EXPECT_FALSE((*lines)[0].error);
  EXPECT_TRUE((*lines)[1].error);
  EXPECT_TRUE((*lines)[2].error) << "the id stands twice";
  EXPECT_EQ((*lines)[2].line, 4u);
  EXPECT_EQ(read_batch(" \n").error().code, ErrorCode::kEmpty);
}

TEST(BatchInput, TablesAndPlainTextAreRead) {
  const auto table = read_batch("id,text\none,\"A study, small.\"\n");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->at(0).prompt, "A study, small.");
  const auto plain = read_batch("A study.\nA hall.\n");
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->at(1).id, "0002");
}

TEST(RunRecord, IsOfTheSameRunOrNot) {
  const GenerateOptions options;
  GenerateOutcome outcome;
  outcome.layout.status = LayoutStatus::kSolved;
  outcome.report.passed = true;
  const std::string record = write_run_record("A study.", options, outcome, nullptr);
  EXPECT_EQ(state_of_same_run(record, "A study.", options), RunState::kDone);
  EXPECT_FALSE(state_of_same_run(record, "A hall.", options));
  EXPECT_FALSE(state_of_same_run("{", "A study.", options));
  GenerateOptions other;
  other.solve.seed = 2;
  EXPECT_FALSE(state_of_same_run(record, "A study.", other));
  const Error failure{ErrorCode::kNoSolver, "none", {}, "install it", {}};
  const std::string failed = write_run_record("A study.", options, outcome, &failure);
  EXPECT_FALSE(state_of_same_run(failed, "A study.", options));
  EXPECT_THAT(failed, HasSubstr("\"noSolver\""));
}

}  // namespace
}  // namespace layoutbox
