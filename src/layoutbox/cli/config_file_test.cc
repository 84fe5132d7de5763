#include "layoutbox/cli/config_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "layoutbox/base/files.h"

namespace layoutbox::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A program of two commands; what `read` gives is what stands in `seed`, `name`, `views` after the file and the words.
class ConfigFiles : public ::testing::Test {
 protected:
  ConfigFiles() : folder_(TemporaryFolder::make("config-test").value()) {
    add_config_option(app_);
    CLI::App* make = app_.add_subcommand("make");
    make->add_option("--seed", seed_);
    make->add_option("--name", name_);
    make->add_option("--views", views_)->delimiter(',');
    app_.add_subcommand("look")->add_option("--corner", corner_);
  }

  // The error's text, or nothing.
  std::string read(const std::string& text, std::vector<std::string> words = {"make"}) {
    const auto file = folder_.path() / "options";
    std::ofstream(file) << text;
    words.insert(words.begin(), {"--config", file.string()});
    std::reverse(words.begin(), words.end());  // as CLI11 takes a vector
    try {
      app_.parse(words);
    } catch (const CLI::Error& error) {
      return error.what();
    }
    return {};
  }

  TemporaryFolder folder_;
  CLI::App app_;
  int seed_ = 1;
  std::string name_, corner_;
  std::vector<std::string> views_;
};

TEST_F(ConfigFiles, Toml) {
  EXPECT_EQ(read("seed = 3\nname = \"a room\"\nviews = [\"iso\", \"top\"]\n"), "");
  EXPECT_EQ(seed_, 3);
  EXPECT_EQ(name_, "a room");
  EXPECT_THAT(views_, ElementsAre("iso", "top"));
}

TEST_F(ConfigFiles, Json) {
  EXPECT_EQ(read(R"({"seed": 4, "views": ["iso", "top"], "name": null})"), "");
  EXPECT_EQ(seed_, 4);
  EXPECT_THAT(views_, ElementsAre("iso", "top"));
}

TEST_F(ConfigFiles, TheCommandLineBeatsTheFile) {
  EXPECT_EQ(read("seed = 3\n", {"make", "--seed", "7"}), "");
  EXPECT_EQ(seed_, 7);
}

TEST_F(ConfigFiles, ASectionHoldsForItsCommandAndBeatsWhatIsSaidForAll) {
  EXPECT_EQ(read("seed = 3\n[make]\nseed = 5\n[look]\ncorner = \"NE\"\n"), "");
  EXPECT_EQ(seed_, 5);
  EXPECT_EQ(corner_, "");
}

TEST_F(ConfigFiles, OptionsOfAnotherCommandAreLeftAlone) {
  EXPECT_EQ(read("corner = \"NE\"\nseed = 2\n"), "");
  EXPECT_EQ(seed_, 2);
}

TEST_F(ConfigFiles, WhatNoCommandKnowsIsAnErrorWithItsName) {
  EXPECT_THAT(read("sead = 3\n"), HasSubstr("'sead'"));
  EXPECT_THAT(read("[cook]\nseed = 3\n"), HasSubstr("'cook'"));
}

TEST_F(ConfigFiles, WhatIsNoFileOfOptionsIsAnError) {
  EXPECT_THAT(read("[1, 2]"), HasSubstr("a list"));
  EXPECT_THAT(read("{\"seed\": "), HasSubstr("configuration file"));
  EXPECT_THAT(read(R"({"make": {"seed": {"a": 1}}})"), HasSubstr("'seed'"));
}

}  // namespace
}  // namespace layoutbox::cli
