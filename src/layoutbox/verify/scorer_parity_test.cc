// Our figures against those of an independent scorer (../shared/tools/score_layouts.py), where it is to be had.
// LAYOUTBOX_PYTHON names a Python with numpy and shapely; else python3.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "layoutbox/base/files.h"
#include "layoutbox/base/process.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/verify/test_random_room.h"

namespace layoutbox::checks {
namespace {

namespace fs = std::filesystem;

const fs::path kShared = fs::path(LAYOUTBOX_SOURCE_FOLDER).parent_path() / "shared";

std::string python() {
  const char* named = std::getenv("LAYOUTBOX_PYTHON");
  return named != nullptr ? named : "python3";
}

std::string reason_to_skip() {
  if (!fs::exists(kShared / "tools" / "score_layouts.py")) return "the scorer is not there: " + (kShared / "tools").string();
  const auto outcome = run_process({python(), "-c", "import numpy, shapely"});
  if (!outcome || outcome->exit_status != 0) return python() + " has no numpy and shapely (LAYOUTBOX_PYTHON names another)";
  return {};
}

// Scores <folder>/<id>/layout.json for ids 0…count−1; the scorer's `scenes`, in that order.
nlohmann::json scores(const fs::path& folder, std::size_t count) {
  std::ofstream table(folder / "annotations.csv");
  table << "ID,Description,ObjCount,ObjAttr,OORel,OARel,Difficulty,SceneScope\n";
  for (std::size_t i = 0; i < count; ++i) table << i << ",a room,,,,,easy,single_room\n";
  table.close();
  const auto outcome = run_process({python(), (kShared / "tools" / "score_layouts.py").string(), (folder / "annotations.csv").string(),
                                    folder.string(), "--json", (folder / "scores.json").string()});
  EXPECT_TRUE(outcome && outcome->exit_status == 0) << (outcome ? outcome->output : outcome.error().message);
  std::ifstream file(folder / "scores.json");
  return nlohmann::json::parse(file).at("scenes");
}

// Figures that differ, in words.
std::vector<std::string> differences(const nlohmann::json& scene, const Report& report) {
  std::vector<std::string> found;
  const auto part = [&](const char* name) { return scene.at("counts").at(name).at("part").get<double>(); };
  const auto whole = [&](const char* name) { return scene.at("counts").at(name).at("whole").get<double>(); };
  const auto share = [&](const char* name) { return whole(name) > 0 ? part(name) / whole(name) : 1.0; };
  const auto compare = [&](const char* name, double theirs, double tolerance) {
    const double ours = report.metrics.at(name);
    if (!(std::abs(ours - theirs) <= tolerance)) found.push_back(fmt::format("{} {} here, {} there", name, ours, theirs));
  };
  compare("collisions", part("COL_obj"), 0);
  compare("outOfBounds", part("OOB_obj"), 0);
  compare("support", share("SUP"), 1e-12);
  compare("openingClearance", share("OPEN"), 1e-12);
  // A pixel on the very edge of a turned box may fall either way.
  compare("navigability", part("NAV"), 2e-4);
  compare("accessibility", share("ACC"), 2e-3);
  if (found.empty()) return found;
  found.push_back("faults here:");
  for (const Check& check : report.checks) {
    if (!check.passed) found.push_back("  " + check.name + " " + check.subject + ": " + check.message);
  }
  found.push_back("faults there: " + scene.at("faults").dump());
  return found;
}

TEST(ScorerParity, TheHandMadeExample) {
  if (const std::string reason = reason_to_skip(); !reason.empty()) GTEST_SKIP() << reason;
  const fs::path example = kShared / "data" / "paper" / "example" / "1" / "layout.json";
  const auto text = read_file(example);
  ASSERT_TRUE(text);
  const auto layout = read_layout(*text);
  ASSERT_TRUE(layout) << layout.error().message;
  const auto folder = TemporaryFolder::make("parity");
  ASSERT_TRUE(folder);
  ASSERT_TRUE(make_folder(folder->path() / "0") && write_file(folder->path() / "0" / "layout.json", *text));
  const Report report = verify(*layout, Catalog::builtin());
  EXPECT_EQ(differences(scores(folder->path(), 1).at(0), report), std::vector<std::string>{});
  EXPECT_TRUE(report.passed) << write_report(report);
}

TEST(ScorerParity, RandomLayouts) {
  if (const std::string reason = reason_to_skip(); !reason.empty()) GTEST_SKIP() << reason;
  const char* given = std::getenv("LAYOUTBOX_SEED");
  const unsigned seed = given != nullptr ? static_cast<unsigned>(std::strtoul(given, nullptr, 10)) : 1;
  const char* rounds = std::getenv("LAYOUTBOX_RANDOM_ROUNDS");
  const std::size_t count = rounds != nullptr ? std::min(std::strtoul(rounds, nullptr, 10), 2000ul) : 60;
  const auto folder = TemporaryFolder::make("parity");
  ASSERT_TRUE(folder);
  RandomRoom random(seed);
  std::vector<Layout> layouts;
  for (std::size_t i = 0; i < count; ++i) {
    // Through a file, so that both judge the same numbers.
    const std::string text = write_layout(random.make());
    const auto layout = read_layout(text);
    ASSERT_TRUE(layout) << layout.error().message << (layout.error().details.empty() ? "" : layout.error().details[0].message) << text;
    layouts.push_back(*layout);
    const fs::path place = folder->path() / std::to_string(i);
    ASSERT_TRUE(make_folder(place) && write_file(place / "layout.json", text));
  }
  const nlohmann::json scenes = scores(folder->path(), count);
  std::size_t rooms_that_differ = 0;
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_EQ(scenes.at(i).at("error"), "") << "room " << i;
    const std::vector<std::string> found = differences(scenes.at(i), verify(layouts[i], Catalog::builtin()));
    if (found.empty()) continue;
    ++rooms_that_differ;
    std::printf("seed %u, room %zu\n", seed, i);
    for (const std::string& line : found) std::printf("  %s\n", line.c_str());
  }
  std::printf("%zu of %zu rooms are judged alike\n", count - rooms_that_differ, count);
  // The rooms lie on a grid of 1 cm: what lies on a limit to the last digit may fall either way. What differs else is a fault of one of the
  // two.
  EXPECT_LE(rooms_that_differ * 200, count) << "seed " << seed;
}

}  // namespace
}  // namespace layoutbox::checks
