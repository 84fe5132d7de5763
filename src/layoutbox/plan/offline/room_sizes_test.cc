// The table of room_sizes_test.txt: what each sentence says of the room's size, and of the sizes of the things in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <sstream>

#include "layoutbox/plan/planner.h"

namespace layoutbox {
namespace {

constexpr double kNear = 0.02;  // m; the table rounds feet

using ReadSize = std::array<std::optional<double>, 3>;  // width, depth, height in metres

ReadSize read_said(std::istream& words) {
  ReadSize said;
  for (std::optional<double>& side : said) {
    std::string word;
    if (words >> word && word != "-") side = std::stod(word);
  }
  return said;
}

void expect_near(const std::optional<double>& wanted, Mm got, const std::string& what) {
  if (wanted) {
    EXPECT_NEAR(m_from_mm(got), *wanted, kNear) << what;
  }
}

void expect_room(const Room& room, const std::string& wanted) {
  std::stringstream words(wanted);
  const ReadSize said = read_said(words);
  if (!said[0]) {
    EXPECT_TRUE(room.polygon.empty()) << "the room is given a size";
  } else {
    ASSERT_FALSE(room.polygon.empty()) << "the room is given no size";
    Mm width = 0, depth = 0;
    for (const auto& corner : room.polygon) width = std::max(width, corner.x), depth = std::max(depth, corner.y);
    expect_near(said[0], width, "the room's width");
    expect_near(said[1], depth, "the room's depth");
  }
  expect_near(said[2], room.height, "the room's height");
}

void expect_thing(const SceneGraph& scene, const std::string& wanted) {
  std::stringstream words(wanted);
  std::string name;
  words >> name;
  const ReadSize said = read_said(words);
  const auto object = std::ranges::find_if(scene.objects, [&](const SceneObject& o) { return o.name.ends_with(name); });
  ASSERT_NE(object, scene.objects.end()) << "no " << name;
  ASSERT_TRUE(object->size.has_value()) << name << " has no size";
  expect_near(said[0], object->size->usual.width, name + "'s width");
  expect_near(said[1], object->size->usual.depth, name + "'s depth");
  expect_near(said[2], object->size->usual.height, name + "'s height");
}

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? std::string{} : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

TEST(RoomSizes, AreReadAsWritten) {
  const std::unique_ptr<Planner> planner = make_offline_planner(Catalog::builtin());
  std::ifstream file(std::string(LAYOUTBOX_SOURCE_FOLDER) + "/src/layoutbox/plan/offline/room_sizes_test.txt");
  int rows = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::array<std::string, 3> parts;
    std::stringstream stream(line);
    for (std::string& part : parts) std::getline(stream, part, '|'), part = trimmed(part);
    SCOPED_TRACE(parts[0]);
    ++rows;
    const auto plan = planner->plan(parts[0], {});
    ASSERT_TRUE(plan.has_value());
    expect_room(plan->scene.room, parts[1]);
    std::stringstream things(parts[2]);
    for (std::string thing; std::getline(things, thing, ';');) {
      if (!trimmed(thing).empty()) expect_thing(plan->scene, trimmed(thing));
    }
  }
  EXPECT_GT(rows, 40);
}

}  // namespace
}  // namespace layoutbox
