// Counts and relations against those of an independent scorer (../shared/tools/score_layouts.py), where it is to be had: rooms of furniture
// thrown about, and of each word that annotations use an entry or two. LAYOUTBOX_RANDOM_ROUNDS rooms (default 40).
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "layoutbox/base/files.h"
#include "layoutbox/base/process.h"
#include "layoutbox/embedded/catalog_data.h"
#include "layoutbox/judge/judge.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/verify/test_random_room.h"

namespace layoutbox {
namespace {

namespace fs = std::filesystem;

// LAYOUTBOX_SCORER names one that is elsewhere.
fs::path scorer() {
  const char* named = std::getenv("LAYOUTBOX_SCORER");
  return named != nullptr ? fs::path(named) : fs::path(LAYOUTBOX_SOURCE_FOLDER).parent_path() / "shared" / "tools" / "score_layouts.py";
}

std::string python_for_scorer() {
  const char* named = std::getenv("LAYOUTBOX_PYTHON");
  if (named != nullptr) return named;
  const fs::path own = fs::path(LAYOUTBOX_SOURCE_FOLDER) / "build/deps/tools/bin/python";
  return fs::exists(own) ? own.string() : "python3";
}

std::string why_no_scorer() {
  if (!fs::exists(scorer())) return "the scorer is not there: " + scorer().string();
  const auto outcome = run_process({python_for_scorer(), "-c", "import numpy, shapely"});
  if (!outcome || outcome->exit_status != 0) return python_for_scorer() + " has no numpy and shapely (LAYOUTBOX_PYTHON names another)";
  return {};
}

std::uint64_t asked_of_environment(const char* name, std::uint64_t otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr ? std::strtoull(value, nullptr, 10) : otherwise;
}

// A row of the table for a room: entries of each word, between kinds that are there.
class RandomAnnotation {
 public:
  explicit RandomAnnotation(std::uint64_t seed) : random_(seed), words_(nlohmann::json::parse(embedded::annotation_words_json)) {}

  std::string row(const std::string& id, const Layout& layout) {
    kinds_.clear();
    for (const PlacedObject& object : layout.objects) {
      if (std::find(kinds_.begin(), kinds_.end(), object.category) == kinds_.end()) kinds_.push_back(object.category);
    }
    std::string counts, pairs, places;
    for (const std::string& kind : kinds_) counts += "eq," + std::to_string(number(1, 3)) + "," + kind + ";";
    for (const auto& [check, words] : words_.at("objects").items()) {
      std::string names = kind() + "," + kind();
      const bool ring = check == "next" && number(0, 1) == 0;
      const std::string word = ring ? "surround" : any(words);
      if (ring) {
        const std::string chair = kind();
        names = kind() + "," + chair + ":0," + chair + ":1," + chair + ":2";
      } else if (number(0, 4) == 0) {
        names += "," + kind();
      }
      pairs += quantifier() + "," + word + ",0," + names + ";";
    }
    for (const auto& [list, elements] : std::map<std::string, std::vector<std::string>>{{"faces", {"wall", "door", "window"}},
                                                                                        {"wall", {"wall"}},
                                                                                        {"opening", {"door", "window"}},
                                                                                        {"ceiling", {"ceiling"}},
                                                                                        {"floor", {"floor"}},
                                                                                        {"room", {"room"}}}) {
      for (const auto& [check, words] : words_.at(list).items())
        places += quantifier() + "," + any(words) + "," + kind() + "," + any(elements) + ";";
    }
    return id + ",a room,\"" + counts + "\",,\"" + pairs + "\",\"" + places + "\",easy,single_room\n";
  }

 private:
  int number(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
  std::string kind() { return kinds_[static_cast<std::size_t>(number(0, static_cast<int>(kinds_.size()) - 1))]; }
  std::string quantifier() { return std::string(number(0, 2) ? "eq," : "ge,") + std::to_string(number(1, 2)); }
  std::string any(const std::vector<std::string>& list) {
    return list[static_cast<std::size_t>(number(0, static_cast<int>(list.size()) - 1))];
  }
  std::string any(const nlohmann::json& list) { return any(list.get<std::vector<std::string>>()); }

  std::mt19937_64 random_;
  nlohmann::json words_;
  std::vector<std::string> kinds_;
};

struct Compared {
  std::size_t entries = 0, differ = 0;
  std::string examples;
};

void compare(const nlohmann::json& scene, const Judgement& judgement, Compared& compared) {
  ASSERT_EQ(scene.at("error"), "") << judgement.name;
  const auto& entries = scene.at("entries");
  ASSERT_EQ(entries.size(), judgement.verdicts.size()) << judgement.name;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    ++compared.entries;
    if (entries[i].at("ok").get<bool>() == judgement.verdicts[i].holds) continue;
    ++compared.differ;
    compared.examples += "room " + judgement.name + ", " + judgement.verdicts[i].entry +
                         "\n  scorer: " + entries[i].at("why").get<std::string>() + "\n  judge:  " + judgement.verdicts[i].why + "\n";
  }
}

TEST(JudgeParity, CountsAndRelationsOfRandomRooms) {
  if (const std::string reason = why_no_scorer(); !reason.empty()) GTEST_SKIP() << reason;
  const std::uint64_t rounds = std::min<std::uint64_t>(asked_of_environment("LAYOUTBOX_RANDOM_ROUNDS", 40), 2000);
  const std::uint64_t seed = asked_of_environment("LAYOUTBOX_SEED", 1);
  const auto folder = TemporaryFolder::make("parity");
  ASSERT_TRUE(folder);
  checks::RandomRoom rooms(static_cast<unsigned>(seed));
  RandomAnnotation annotator(seed);
  std::string table = "ID,Description,ObjCount,ObjAttr,OORel,OARel,Difficulty,SceneScope\n";
  std::vector<Layout> layouts;
  for (std::uint64_t i = 0; i < rounds; ++i) {
    const std::string text = write_layout(rooms.make());
    const auto layout = read_layout(text);  // through a file, so that both judge the same numbers
    ASSERT_TRUE(layout);
    layouts.push_back(*layout);
    table += annotator.row(std::to_string(i), *layout);
    const fs::path place = folder->path() / std::to_string(i);
    ASSERT_TRUE(make_folder(place) && write_file(place / "layout.json", text));
  }
  ASSERT_TRUE(write_file(folder->path() / "annotations.csv", table));
  const auto outcome = run_process({python_for_scorer(), scorer().string(), (folder->path() / "annotations.csv").string(),
                                    folder->path().string(), "--json", (folder->path() / "scores.json").string()});
  ASSERT_TRUE(outcome && outcome->exit_status == 0) << (outcome ? outcome->output : outcome.error().message);
  std::ifstream file(folder->path() / "scores.json");
  const nlohmann::json scenes = nlohmann::json::parse(file).at("scenes");
  const auto annotations = scoring::read_annotations(table);
  ASSERT_TRUE(annotations) << annotations.error().message;
  Compared compared;
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    Asked asked;
    asked.annotation = (*annotations)[i];
    RoomFile room{std::to_string(i), "layout", layouts[i], {}};
    compare(scenes.at(i), judge_room(std::move(room), asked, Catalog::builtin()), compared);
  }
  std::printf("%zu of %zu entries of %zu rooms are judged alike\n%s", compared.entries - compared.differ, compared.entries, layouts.size(),
              compared.examples.c_str());
  // A point of the grid on the very edge of a box may fall either way; what differs else is a fault of one of the two.
  EXPECT_LE(compared.differ * 1000, compared.entries) << "seed " << seed;
}

}  // namespace
}  // namespace layoutbox
