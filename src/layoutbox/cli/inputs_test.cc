#include "layoutbox/cli/inputs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "layoutbox/base/files.h"
#include "layoutbox/cli/console.h"

namespace layoutbox::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

void expect_usage(const Status& status, const char* option, const char* words) {
  ASSERT_FALSE(status) << option << " was taken";
  EXPECT_EQ(status.error().code, ErrorCode::kUsage);
  EXPECT_EQ(status.error().pointer, option);
  EXPECT_THAT(status.error().message, HasSubstr(words));
  EXPECT_FALSE(status.error().hint.empty()) << "it is not said what to do";
}

TEST(RenderFlagsApply, WordsBecomeOptions) {
  RenderFlags flags;
  flags.quality = "final";
  flags.size = "640X480";
  flags.views = {"top", "iso", "top"};
  flags.corner = "SW";
  flags.turntable = "gif";
  flags.mask = true;
  RenderOptions options;
  ASSERT_TRUE(flags.apply(options));
  EXPECT_EQ(options.quality, Quality::kFinal);
  EXPECT_EQ(options.width, 640);
  EXPECT_EQ(options.height, 480);
  EXPECT_THAT(options.views, ElementsAre(view_from_name("top").value(), view_from_name("iso").value())) << "each once, in their order";
  EXPECT_EQ(options.corner, corner_from_name("SW").value());
  EXPECT_EQ(options.turntable, "gif");
  EXPECT_TRUE(options.object_mask);
}

TEST(RenderFlagsApply, WhatIsNoWordOfOursIsSaid) {
  const auto with = [](auto change) {
    RenderFlags flags;
    change(flags);
    RenderOptions options;
    return flags.apply(options);
  };
  expect_usage(with([](RenderFlags& f) { f.quality = "best"; }), "--quality", "'best'");
  expect_usage(with([](RenderFlags& f) { f.views = {"iso", "back"}; }), "--views", "'back'");
  expect_usage(with([](RenderFlags& f) { f.corner = "N"; }), "--corner", "'N'");
  expect_usage(with([](RenderFlags& f) { f.turntable = "avi"; }), "--turntable", "'avi'");
  for (const char* size : {"", "640", "640x", "x480", "640x480x2", "15x480", "640x16385", "-640x480", "640 x 480"}) {
    expect_usage(with([&](RenderFlags& f) { f.size = size; }), "--size", size);
  }
}

TEST(SolveFlagsApply, RepairNeedsAModel) {
  SolveFlags flags;
  flags.on_conflict = "repair";
  SolveOptions options;
  expect_usage(flags.apply(options, false), "--on-conflict", "language model");
  ASSERT_TRUE(flags.apply(options, true));
  EXPECT_EQ(options.on_conflict, OnConflict::kRelax);
  flags.on_conflict = "give-up";
  expect_usage(flags.apply(options, true), "--on-conflict", "'give-up'");
}

TEST(PlanFlagsApply, CompanionsComeUnlessTheyAreOff) {
  GenerateOptions options;
  PlanFlags flags;
  ASSERT_TRUE(flags.apply(options));
  EXPECT_TRUE(options.companions);
  flags.companions = "off";
  ASSERT_TRUE(flags.apply(options));
  EXPECT_FALSE(options.companions);
  flags.planner = "crystal ball";
  expect_usage(flags.apply(options), "--planner", "'crystal ball'");
}

TEST(PlanFlagsApply, ARoomInItsUnits) {
  GenerateOptions options;
  PlanFlags flags;
  flags.room = "400x320x260";
  flags.units = "cm";
  ASSERT_TRUE(flags.apply(options));
  EXPECT_EQ(options.normalize.room_size.width, 4000);
  EXPECT_EQ(options.normalize.room_size.height, 2600);
  flags.room = "wide";
  EXPECT_FALSE(flags.apply(options));
}

TEST(Seeds, OnlyWholeNumbers) {
  for (const char* word : {"-1", "", "1.5", "seven", "99999999999999999999"}) {
    CLI::App app;
    std::uint64_t seed = 1;
    add_seed_option(app, seed);
    std::vector<std::string> words{word, "--seed"};
    EXPECT_THROW(app.parse(words), CLI::Error) << word;
  }
  CLI::App app;
  std::uint64_t seed = 1;
  add_seed_option(app, seed);
  std::vector<std::string> words{"9999999999999999999", "--seed"};
  app.parse(words);
  EXPECT_EQ(seed, 9'999'999'999'999'999'999u);
}

TEST(Assets, BesideTheInputAndInTheFolderNamed) {
  EXPECT_THAT(asset_folders("rooms/a.json", "meshes"), ElementsAre(fs::path("meshes"), fs::path("rooms")));
  EXPECT_THAT(asset_folders("a.json", ""), ElementsAre(fs::path(".")));
  EXPECT_THAT(asset_folders("-", ""), ElementsAre(fs::path(".")));
}

TEST(Assets, AFolderWithoutAnIndexIsNoCatalogue) {
  const TemporaryFolder folder = TemporaryFolder::make("cli-test").value();
  PlanFlags flags;
  flags.assets = folder.path().string();
  const auto none = flags.load_catalog();
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("index.csv"));
  std::ofstream(folder.path() / "index.csv") << "category,file,width,depth,height\nthrone,throne.glb,0.8,0.8,1.6\n";
  const auto some = flags.load_catalog();
  ASSERT_TRUE(some) << some.error().message;
  EXPECT_TRUE(some->own);
  EXPECT_EQ(some->inputs.size(), 1u) << "what a run was made from";
}

TEST(ExitStatus, ByWhoseFaultItIs) {
  const auto status_of = [](ErrorCode code) { return exit_status(Error{code, "", {}, {}, {}}); };
  EXPECT_EQ(status_of(ErrorCode::kSchema), kWrongInput);
  EXPECT_EQ(status_of(ErrorCode::kInfeasible), kNotAsAsked);
  EXPECT_EQ(status_of(ErrorCode::kNoBlender), kWrongSurroundings);
  EXPECT_EQ(status_of(ErrorCode::kInterrupted), kStoppedByUser);
}

}  // namespace
}  // namespace layoutbox::cli
