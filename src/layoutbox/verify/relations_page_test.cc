// docs/relations.md says of every relation what the table says: its parameters, its defaults and its sentence.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {
namespace {

std::string trimmed(std::string text) {
  text.erase(0, text.find_first_not_of(' '));
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

// Rows of the page's tables by the name of their relation: | `name` | parameters | meaning | sentence | example |
std::map<std::string, std::vector<std::string>, std::less<>> rows_of_page() {
  std::map<std::string, std::vector<std::string>, std::less<>> rows;
  std::ifstream page(std::string(LAYOUTBOX_SOURCE_FOLDER) + "/docs/relations.md");
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| `")) continue;
    std::vector<std::string> cells;
    for (std::size_t at = 1; at < line.size();) {
      const std::size_t end = std::min(line.find('|', at), line.size());
      cells.push_back(trimmed(line.substr(at, end - at)));
      at = end + 1;
    }
    const std::string name = cells.front().substr(1, cells.front().size() - 2);
    EXPECT_FALSE(rows.contains(name)) << name << " has two rows";
    rows[name] = cells;
  }
  return rows;
}

TEST(RelationsPage, HasEveryRelationWithItsParametersAndSentence) {
  const auto rows = rows_of_page();
  EXPECT_EQ(rows.size(), relation_table().size());
  for (const RelationRow& row : relation_table()) {
    const auto found = rows.find(row.name);
    ASSERT_NE(found, rows.end()) << row.name << " has no row in docs/relations.md";
    ASSERT_EQ(found->second.size(), 5u) << row.name;
    EXPECT_EQ(found->second[1], row.parameters) << row.name;
    EXPECT_FALSE(found->second[2].empty()) << row.name;
    EXPECT_EQ(found->second[3], row.sentence) << row.name;
    EXPECT_FALSE(found->second[4].empty()) << row.name;
  }
}

// "gap=0.02, side" → gap: 0.02.
std::map<std::string, std::string> defaults_in(std::string text) {
  std::map<std::string, std::string> defaults;
  for (std::size_t comma = 0; !text.empty(); text.erase(0, comma == std::string::npos ? comma : comma + 1)) {
    comma = text.find(',');
    const std::string item = trimmed(text.substr(0, comma));
    if (const std::size_t is = item.find('='); is != std::string::npos) defaults[item.substr(0, is)] = item.substr(is + 1);
  }
  return defaults;
}

TEST(RelationsPage, SaysTheDefaultsInEffect) {
  for (const auto& [name, cells] : rows_of_page()) {
    const RelationFigures& figures = find_relation(name)->defaults;
    std::map<std::string, std::string> in_effect;
    const auto add_length = [&](const char* key, std::optional<Mm> length) {
      if (length) in_effect[key] = fmt::format("{}", m_from_mm(*length));
    };
    add_length("distance", figures.distance), add_length("min", figures.min), add_length("max", figures.max);
    add_length("gap", figures.gap), add_length("depth", figures.depth), add_length("width", figures.width);
    add_length("height", figures.height);
    if (figures.side) in_effect["side"] = name_of(*figures.side);
    if (figures.edge) in_effect["edge"] = name_of(*figures.edge);
    if (figures.axis) in_effect["axis"] = *figures.axis == Axis::kX ? "x" : *figures.axis == Axis::kY ? "y" : "z";
    EXPECT_EQ(defaults_in(cells[1]), in_effect) << name;
  }
}

}  // namespace
}  // namespace layoutbox
