// Our figures against those of an independent scorer (../shared/tools/score_layouts.py), where it is to be had.
// LAYOUTBOX_PYTHON names a Python with numpy and shapely; else python3.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "layoutbox/base/files.h"
#include "layoutbox/base/process.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/verify/test_room.h"

namespace layoutbox::judge {
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

void expect_same_figures(const nlohmann::json& scene, const Report& report, const std::string& about) {
  ASSERT_EQ(scene.at("error"), "") << about;
  const auto part = [&](const char* name) { return scene.at("counts").at(name).at("part").get<double>(); };
  const auto whole = [&](const char* name) { return scene.at("counts").at(name).at("whole").get<double>(); };
  const auto share = [&](const char* name) { return whole(name) > 0 ? part(name) / whole(name) : 1.0; };
  EXPECT_EQ(report.metrics.at("collisions"), part("COL_obj")) << about << scene.at("faults").dump();
  EXPECT_EQ(report.metrics.at("outOfBounds"), part("OOB_obj")) << about << scene.at("faults").dump();
  EXPECT_DOUBLE_EQ(report.metrics.at("support"), share("SUP")) << about << scene.at("faults").dump();
  EXPECT_DOUBLE_EQ(report.metrics.at("openingClearance"), share("OPEN")) << about << scene.at("faults").dump();
  // A pixel on the very edge of a turned box may fall either way.
  EXPECT_NEAR(report.metrics.at("navigability"), part("NAV"), 2e-4) << about;
  EXPECT_NEAR(report.metrics.at("accessibility"), share("ACC"), 2e-3) << about;
}

// Furniture thrown into a room: most of it collides, stands in the air or reaches through a wall.
class RandomRoom {
 public:
  explicit RandomRoom(unsigned seed) : random_(seed) {}

  Layout make() {
    TestRoom room(2 + 0.1 * number(0, 50), 2 + 0.1 * number(0, 40), 2.5);
    width_ = width_of(room.layout), depth_ = depth_of(room.layout);
    room.door("door1", "wall1", 0.4, 0.9).window("window1", "wall3", 0.3, 1.2, 0.9);
    if (number(0, 3) == 0) cut_corner(room.layout);
    const int count = number(1, 14);
    for (int i = 0; i < count; ++i) add(room, "o" + std::to_string(i));
    return room.layout;
  }

 private:
  struct Kind {
    const char* category;
    std::array<double, 3> size;
    std::vector<Side> used;  // as in the scorer's own table
  };

  int number(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }

  // An L: the far right quarter is missing.
  void cut_corner(Layout& layout) {
    const Mm x = width_ * 2 / 3, y = depth_ * 2 / 3;
    layout.room.polygon = {{0, 0}, {width_, 0}, {width_, y}, {x, y}, {x, depth_}, {0, depth_}};
    layout.room.walls.clear();
    for (std::size_t i = 0; i < 6; ++i) {
      Wall wall;
      wall.id = "wall" + std::to_string(i + 1);
      wall.start = layout.room.polygon[i], wall.end = layout.room.polygon[(i + 1) % 6];
      layout.room.walls.push_back(wall);
    }
    layout.room.openings[1].wall = "wall6";
    layout.room.openings[1].offset = 300;
  }

  void add(TestRoom& room, const std::string& id) {
    static const std::vector<Kind> kKinds{{"bed", {1.6, 2.0, 0.5}, {Side::kFront, Side::kLeft, Side::kRight}},
                                          {"desk", {1.2, 0.6, 0.75}, {Side::kFront}},
                                          {"wardrobe", {1.2, 0.6, 2.0}, {Side::kFront}},
                                          {"chair", {0.45, 0.45, 0.6}, {Side::kFront, Side::kBack, Side::kLeft, Side::kRight}},
                                          {"rug", {1.6, 1.2, 0.02}, {}},
                                          {"plant", {0.3, 0.3, 0.8}, {}},
                                          {"bookshelf", {0.8, 0.3, 1.8}, {Side::kFront}}};
    static constexpr std::array kTurns{0.0, 90.0, 180.0, 270.0, 0.0, 90.0, 33.0, 247.5};
    static constexpr std::array kLifts{0.0, 0.0, 0.0, 0.004, 0.02};
    const Kind& kind = kKinds[static_cast<std::size_t>(number(0, static_cast<int>(kKinds.size()) - 1))];
    Place place{0.01 * number(0, width_ / 10), 0.01 * number(0, depth_ / 10), kLifts[static_cast<std::size_t>(number(0, 4))],
                kTurns[static_cast<std::size_t>(number(0, 7))]};
    std::string on = "floor";
    if (!room.layout.objects.empty() && number(0, 3) == 0) {
      const PlacedObject& host = room.layout.objects[static_cast<std::size_t>(number(0, static_cast<int>(room.layout.objects.size()) - 1))];
      const double top = number(0, 1) == 0 || host.spaces.empty() ? host.size.height : host.spaces.front().min[2];
      place = {host.position[0] / 1000 + 0.01 * number(-40, 40), host.position[1] / 1000 + 0.01 * number(-20, 20),
               (host.position[2] + top) / 1000 + place.z, place.rotation};
      on = host.id;
      room.add(id, "book", {0.2, 0.15, 0.25}, place, on);
      return;
    }
    if (number(0, 6) == 0) {
      room.add(id, "painting", {0.6, 0.04, 0.5}, {0.01 * number(30, width_ / 10), depth_ / 1000.0 - 0.01 * number(1, 5), 1.5},
               room.layout.room.openings[1].wall);
      return;
    }
    room.add(id, kind.category, kind.size, place, on).used(kind.used);
    if (std::string(kind.category) == "desk") room.space("knees", {-0.55, -0.3, 0}, {0.55, 0.25, 0.68}, false);
    if (std::string(kind.category) == "bookshelf")
      room.space("low", {-0.38, -0.15, 0.1}, {0.38, 0.14, 0.9}).space("high", {-0.38, -0.15, 0.92}, {0.38, 0.14, 1.78});
  }

  std::mt19937 random_;
  Mm width_ = 0, depth_ = 0;
};

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
  expect_same_figures(scores(folder->path(), 1).at(0), report, "example 1");
  EXPECT_TRUE(report.passed) << write_report(report);
}

TEST(ScorerParity, RandomLayouts) {
  if (const std::string reason = reason_to_skip(); !reason.empty()) GTEST_SKIP() << reason;
  const char* given = std::getenv("LAYOUTBOX_SEED");
  const unsigned seed = given != nullptr ? static_cast<unsigned>(std::strtoul(given, nullptr, 10)) : 1;
  constexpr std::size_t kRooms = 60;
  const auto folder = TemporaryFolder::make("parity");
  ASSERT_TRUE(folder);
  RandomRoom random(seed);
  std::vector<Layout> layouts;
  for (std::size_t i = 0; i < kRooms; ++i) {
    // Through a file, so that both judge the same numbers.
    const std::string text = write_layout(random.make());
    const auto layout = read_layout(text);
    ASSERT_TRUE(layout) << layout.error().message << (layout.error().details.empty() ? "" : layout.error().details[0].message) << text;
    layouts.push_back(*layout);
    const fs::path place = folder->path() / std::to_string(i);
    ASSERT_TRUE(make_folder(place) && write_file(place / "layout.json", text));
  }
  const nlohmann::json scenes = scores(folder->path(), kRooms);
  for (std::size_t i = 0; i < kRooms; ++i) {
    expect_same_figures(scenes.at(i), verify(layouts[i], Catalog::builtin()),
                        "seed " + std::to_string(seed) + ", room " + std::to_string(i) + " ");
  }
}

}  // namespace
}  // namespace layoutbox::judge
